/** Answers of a survey sheet and the file that they make. */
import { Lost, Refused, sentences } from "../engine/client";
import { liveEngine } from "./live";
import type { SurveyFinding, SurveyOut } from "../engine/types";
import type { Sheet } from "./sheet";

export type Answers = Record<string, string>;
/** What is wrong with an answer or doubtful; no key where it is none of them. */
export type Wrong = { key: string; text: string; doubtful?: boolean };

const TITLES: Record<string, string> = {
  name: "Name of the bridge",
  spans: "Number of spans",
  span: "Span",
  rise: "Rise",
  thickness: "Thickness of the ring",
  width: "Width of the barrel",
  cover: "Cover over the crown",
  unit: "Length of a stone along the ring",
  backing: "Height of backing",
  density: "Density of the masonry",
  strength: "Strength of the masonry",
  axle: "Axle",
  pier_width: "Width of the pier",
  pier_height: "Height of the pier",
};

/** An answer in words: "rise_2" is "Rise, span 2". */
export function titleOf(key: string): string {
  const [, base, k] = /^(.*?)(?:_(\d+))?$/.exec(key)!;
  const title = TITLES[base!] ?? key;
  return k === undefined ? title : base!.startsWith("pier") ? title.replace("the pier", `pier ${k}`) : `${title}, span ${k}`;
}

/** Whether the file has been changed since by something else than the answers. */
export function isElsewhere(sheet: Sheet): boolean {
  return sheet.surveyed[0]() !== "" && sheet.surveyed[0]() !== sheet.text();
}

/** The number of spans that are answered for; 1 where that is no number. */
export function spansOf(answers: Answers): number {
  const count = Number(answers["spans"] ?? "1");
  return Number.isInteger(count) && count >= 1 && count <= 20 ? count : 1;
}

let newest = 0;

/** Writes the file anew from these answers; what is wrong with them, undefined where newer ones have overtaken them. */
export async function write(sheet: Sheet, answers: Answers, mark: string): Promise<Wrong[] | undefined> {
  const mine = ++newest;
  for (let tries = 0; ; tries += 1) {
    try {
      const { text, findings } = await liveEngine.call<SurveyOut>("fromSurvey", { answers }, { patience: 5000 });
      if (mine !== newest) return undefined;
      if (text !== null) {
        sheet.surveyed[1](text);
        sheet.change(text, mark);
      }
      return findings.map((one) => told(one));
    } catch (error) {
      if (mine !== newest) return undefined;
      // A worker that died takes no answer with it: the next one is asked.
      if (error instanceof Lost && tries === 0) continue;
      return [{ key: "", text: error instanceof Refused ? sentences(error) : String((error as Error).message) }];
    }
  }
}

/** A finding in words, at its answer. */
export function told({ key, severity, message, help }: SurveyFinding): Wrong {
  const what = message.slice(key.length);
  if (what === " is missing") return { key, text: "The drawing waits for this number: nothing is assumed in its place." };
  return { key, text: sentences({ message: what.replace(/^: /, ""), help }), doubtful: severity === "warning" };
}
