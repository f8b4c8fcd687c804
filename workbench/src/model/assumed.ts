/** Values that a bridge file says are assumed, by a remark on their line: `density = "1900 kg/m^3"  # assumed: …`. */
import { tablesOf } from "./structure";

const LINE = /^[ \t]*([\w-]+)[ \t]*=[ \t]*("[^"\n]*"|[^#\n]*?)[ \t]*#[ \t]*assumed\b:?[ \t]*([^\n]*)/gim;
const TITLES: Record<string, string> = { cover: "layer", span: "ring" };

/** Each as "masonry compressive strength 5 MPa", in the order of the text; those that a span or pier has from the first one stand together. */
export function assumedIn(text: string): string[] {
  const tables = tablesOf(text);
  const seen = new Map<string, number>();
  return tables.flatMap((table) => {
    const k = (seen.get(table.name) ?? 0) + 1;
    seen.set(table.name, k);
    const many = tables.filter((other) => other.name === table.name).length > 1;
    const title = many ? `${table.name === "cover" ? "layer" : table.name} ${k}` : (TITLES[table.name] ?? table.name.replace(/[._]/g, " "));
    const lines = [...text.slice(table.start, table.end).matchAll(LINE)].map(([, key, value, remark]) => ({ key: key!.replace(/_/g, " "), value: value!.replace(/"/g, ""), like: /^as (?:span|pier) 1\b/.exec(remark!)?.[0] ?? "" }));
    const like = lines.filter((line) => line.like !== "");
    return [
      ...(like.length > 0 ? [`${title} ${like[0]!.like} (${like.map((line) => line.key).join(", ")})`] : []),
      ...lines.filter((line) => line.like === "").map(({ key, value }) => `${title} ${key} ${value}`),
    ];
  });
}
