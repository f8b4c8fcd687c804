/** Values that a bridge file says are assumed, by a remark on their line: `density = "1900 kg/m^3"  # assumed: …`. */
import { tablesOf } from "./structure";

const LINE = /^[ \t]*([\w-]+)[ \t]*=[ \t]*("[^"\n]*"|[^#\n]*?)[ \t]*#[ \t]*assumed\b/gim;
const TITLES: Record<string, string> = { cover: "layer", span: "ring" };

/** Each as "masonry compressive strength 5 MPa", in the order of the text. */
export function assumedIn(text: string): string[] {
  return tablesOf(text).flatMap((table) =>
    [...text.slice(table.start, table.end).matchAll(LINE)].map(([, key, value]) =>
      `${TITLES[table.name] ?? table.name.replace(/[._]/g, " ")} ${key!.replace(/_/g, " ")} ${value!.replace(/"/g, "")}`,
    ),
  );
}
