/** What a load per metre of width means for the whole of it. */
import { metresOf } from "../drawing/handles";
import { force, shown, words, type System } from "../units";
import type { Quantity } from "../engine/types";
import type { Sheet } from "./sheet";

/** A length as it is written, in the units of the page where it is in others. */
const said = (quantity: Quantity, system: System): string => {
  const one = shown(quantity.text, system);
  const metres = metresOf(quantity);
  const other = system === "metric" && metres !== null && /(ft|in|yd)\s*$/.test(quantity.text);
  return other ? `${Number(metres.toPrecision(4))} m` : system === "metric" ? quantity.text : `${one.text} ${one.unit}`.trim();
};

/** A load [N/m] in words: over the whole width for loads that lie across it; on the axle for an axle, which presses on its effective width alone. */
export function overItsWidth(sheet: Sheet, load: number, system: System): string {
  const own = (key: string) => sheet.quantities[0]().filter((one) => new RegExp(`^load\\[\\d+\\]\\.${key}$`).test(one.path));
  const narrow = own("effective_width");
  const across = sheet.reading[0]()?.width_m ?? null;
  if (narrow.length === 0) return across ? `${words(force(load * across, system))} over the whole width` : system === "metric" ? "per metre of width" : "per foot of width";
  const loads = sheet.reading[0]()?.sections?.loads ?? 0;
  const width = loads === 1 && own("axle_force").length === 1 ? metresOf(narrow[0]!) : null;
  // Several axles or loads share a width each: their sum is the force on no width there is.
  return width === null ? "all loads of the file, each over its own width" : `${words(force(load * width, system))} on the axle, over its ${said(narrow[0]!, system)}`;
}
