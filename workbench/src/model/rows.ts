/** Rows of a spreadsheet as answers of a survey: names that engineers write, matched whole, so that "Thickness at the springing" is not taken for the ring's. */
import { meant } from "../units";
import type { Answers } from "./survey";

/** Answers by their key, in the order of the rows; what was no answer, with its number from 1 and why. */
export type Rows = { answers: Answers; left: { row: number; text: string; why: string }[] };

/** Names of each answer; small words and brackets are left out of what is compared. */
const NAMES: Record<string, string[]> = {
  name: ["name", "bridge", "bridge name", "name bridge", "structure", "structure name", "name structure"],
  spans: ["spans", "number spans", "no spans", "no. spans", "number arches", "no arches", "no. arches"],
  span: ["span", "clear span", "square span", "span length", "arch span", "span intrados", "clear span intrados"],
  rise: ["rise", "arch rise", "rise crown", "crown rise", "rise arch", "rise intrados", "clear rise"],
  thickness: ["thickness", "ring thickness", "thickness ring", "arch thickness", "thickness arch", "arch ring thickness", "thickness arch ring", "barrel thickness", "thickness barrel", "ring depth", "depth ring"],
  width: ["width", "barrel width", "width barrel", "arch width", "bridge width", "width bridge", "width between parapets", "width arch"],
  cover: ["cover", "fill depth", "depth fill", "fill depth crown", "depth fill crown", "cover crown", "cover over crown", "fill over crown", "crown cover", "fill crown", "depth cover", "cover depth"],
  unit: ["stone length", "length stone", "brick length", "length brick", "length stone along ring", "length stone or brick along ring", "voussoir length", "length voussoir"],
  backing: ["backing", "backing height", "height backing", "backing height above springings", "height backing above springings"],
  density: ["density", "masonry density", "density masonry", "unit weight", "masonry unit weight", "unit weight masonry", "weight masonry"],
  strength: ["strength", "masonry strength", "strength masonry", "compressive strength", "masonry compressive strength", "compressive strength masonry"],
  axle: ["axle", "axle load", "axle force", "axle weight", "load axle", "force axle"],
  reference: ["reference", "number", "bridge number", "bridge no", "bridge no.", "structure number", "structure no", "structure no.", "bridge reference", "number bridge", "number structure"],
  rings: ["rings", "number rings", "no rings", "no. rings"],
  bond: ["bond", "bond rings", "bond between rings", "cohesion between rings"],
  fill_density: ["fill density", "density fill", "fill unit weight", "unit weight fill", "weight fill"],
  skew: ["skew", "skew angle", "angle skew"],
  lost_mortar: ["joints without mortar", "mortar loss", "lost mortar", "depth mortar loss"],
  condition: ["condition", "barrel condition", "condition barrel"],
  pier_width: ["pier width", "width pier", "pier thickness", "thickness pier"],
  pier_height: ["pier height", "height pier"],
};
const SMALL = /\b(?:of|the|an?|at|to|in|its|per)\b/g;
/** Those that every span or pier may have. */
const EACH = ["span", "rise", "thickness", "pier_width", "pier_height"];
const HEADS = /^(?:values?|measured|numbers?|results?|quantit(?:y|ies)|amounts?|units?|answers?|dimensions?)$/i;

/** The answer that a name means: "Rise, span 2" is rise_2; "" for none. */
export function keyOf(name: string): string {
  const plain = name.toLowerCase().replace(/[([].*?[)\]]/g, " ").replace(/[_,;:=]/g, " ").replace(/\s+/g, " ").trim();
  const phrase = (text: string): string => text.replace(SMALL, " ").replace(/\s+/g, " ").trim();
  const found = (text: string): string => Object.keys(NAMES).find((key) => NAMES[key]!.includes(phrase(text))) ?? "";
  const whole = found(plain);
  if (whole !== "") return whole;
  const own = /\b(?:(span|pier|arch)\s*)?(\d{1,2})\b/.exec(plain);
  if (!own) return "";
  const [place, part, number] = [own[0], own[1], Number(own[2])];
  const rest = plain.replace(place, " ");
  // "Span 2" is the span of the second arch, "pier 2 width" the width of the second pier.
  const key = found(`${part ?? ""} ${rest}`) || found(`${rest} ${part ?? ""}`) || found(rest);
  if (part !== undefined && key.startsWith("pier") !== (part === "pier")) return "";
  if (!EACH.includes(key) || number < 1 || number > 20) return "";
  return number === 1 ? key : `${key}_${number}`;
}

/** The cells of a line; a cell in quotation marks may hold what separates them. */
function cellsOf(line: string): string[] {
  const between = line.includes("\t") ? "\t" : line.includes(";") ? ";" : ",";
  const cells: string[] = [];
  for (let rest = line; ; ) {
    const quoted = /^\s*"((?:[^"]|"")*)"\s*/.exec(rest);
    const end = quoted && (rest.length === quoted[0].length || rest[quoted[0].length] === between) ? quoted[0].length : rest.indexOf(between);
    const at = end < 0 ? rest.length : end;
    cells.push((quoted && at === quoted[0].length ? quoted[1]!.replace(/""/g, '"') : rest.slice(0, at)).trim());
    if (at >= rest.length) return cells;
    rest = rest.slice(at + 1);
  }
}

/** What a table says; a number without a unit has the one that its field shows. */
export function rowsOf(text: string, unitOf: (key: string) => string): Rows {
  const answers: Answers = {};
  const left: Rows["left"] = [];
  text.split(/\r\n?|\n/).forEach((line, k) => {
    const [name = "", value = "", more = ""] = cellsOf(line);
    // Headings, empty lines, and the line over the columns.
    if (name === "" || value === "" || HEADS.test(value)) return;
    const leave = (why: string): unknown => left.push({ row: k + 1, text: `${name}: ${value}${more === "" ? "" : ` ${more}`}`, why });
    const key = keyOf(name);
    if (key === "") return leave("no question of the survey has this name");
    if (answers[key] !== undefined) return leave("the same was answered above");
    if (["name", "reference", "condition"].includes(key)) return void (answers[key] = value);
    if (!/\d/.test(value)) return leave("no number");
    if (/^[+-]?[1-9]\d{0,2}(?:,\d{3})+(?!\d)/.test(value) || /^\d/.test(more)) return leave("a comma that may stand for thousands or for a decimal point");
    const head = /[([]\s*([^)\]\d][^)\]]*)[)\]]/.exec(name)?.[1]?.trim() ?? "";
    const unit = /^[a-z°]/i.test(more) ? more : /^(?:m|mm|cm|ft|in|kg|t|k?N|[MGk]?Pa|N|psi|ksi|lbf?|pcf|kip|tonf?)(?:$|[/\s^\d²³])/.test(head) ? head : unitOf(key);
    answers[key] = meant(value, unit);
  });
  return { answers, left };
}
