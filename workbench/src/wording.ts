/** What the engine says to everybody, in the words of the page: units as they are printed, and its own controls in the place of pages of the documentation and keys of the file. */

const RAISED = ["⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"];

/** "kg/m^3" as kg/m³, anywhere in a text. What goes into a file stays as it is written there. */
export function typeset(text: string): string {
  return text.replace(/(?<=[A-Za-zΩ%])\^(-?)(\d)(?!\d)/g, (_all, minus: string, digit: string) => (minus ? "⁻" : "") + RAISED[Number(digit)]);
}

/** Where the page has a control for what a key of the file says. */
const CONTROLS: [RegExp, string][] = [
  [/\b(?:method|`method`) = "path" in \[analysis\]/g, "“Deformable joints”, in the table of methods under Load,"],
  [/\bthe file has no \[sweep\] of vehicles/g, "no rule and no vehicles are chosen: “Verdict” asks for them, and so does a survey"],
  [/\bno rule for strength: write rule = [^;]* in \[sweep\]; or adequacy_factor with its source in \[assess\]/g, "no rule for strength: “Verdict” asks for rule and vehicles, and so does a survey"],
];

/** A note of the engine. A page of the documentation is not at hand here; what it says stands in the note. */
export function plainly(text: string): string {
  const own = CONTROLS.reduce((words, [key, control]) => words.replace(key, control), text);
  return typeset(own.replace(/\s*\(docs\/[^)]*\)/g, "").replace(/(?:[;,:]|\.)?\s*(?:see )?docs\/[\w/.-]+\.md[^.;]*(?=[.;]|$)/g, ""));
}
