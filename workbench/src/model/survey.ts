/** Answers of a survey and the file that they stand in: the file is the truth, and what it says stands in the fields. */
import { batch } from "solid-js";
import { Lost, Refused, sentences } from "../engine/client";
import { liveEngine } from "./live";
import type { SurveyFinding, SurveyOut } from "../engine/types";
import type { Sheet, Wrong } from "./sheet";

export type { Wrong };

export type Answers = Record<string, string>;

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
  reference: "Number of the structure",
  rings: "Number of rings",
  bond: "Bond between the rings",
  fill: "Kind of fill",
  fill_density: "Density of the fill",
  skew: "Skew",
  lost_mortar: "Joints without mortar",
  condition: "Condition",
};

/** An answer in words: "rise_2" is "Rise, span 2". */
export function titleOf(key: string): string {
  const [, base, k] = /^(.*?)(?:_(\d+))?$/.exec(key)!;
  const title = TITLES[base!] ?? key;
  return k === undefined ? title : base!.startsWith("pier") ? title.replace("the pier", `pier ${k}`) : `${title}, span ${k}`;
}

/** The number of spans that are answered for; 1 where that is no number. */
export function spansOf(answers: Answers): number {
  const count = Number(answers["spans"] ?? "1");
  return Number.isInteger(count) && count >= 1 && count <= 20 ? count : 1;
}

/** Whether a file was made from a survey, by its first line. */
export const isSurvey = (text: string): boolean => text.startsWith("# From a survey sheet.");

/** What the fields of a survey show: what the file says, and what is refused. */
export function answersOf(sheet: Sheet): Answers {
  const drafts = sheet.drafts[0]();
  return { ...(sheet.survey[0]()?.answers ?? {}), ...drafts };
}

/** What is wrong with answers or doubtful, of those that are refused or of all that the file has. */
export function wrongOf(sheet: Sheet): Wrong[] {
  return sheet.refusedAnswers[0]() ?? (sheet.survey[0]()?.findings ?? []).map(told);
}

let newest = 0;

/** Gives answers to the file, beside those that are refused so far. What the file says besides stays. */
export async function give(sheet: Sheet, changes: Answers, mark: string): Promise<void> {
  const mine = ++newest;
  const drafts = { ...sheet.drafts[0](), ...changes };
  sheet.drafts[1](drafts);
  const refused = (wrong: Wrong[]): void => {
    batch(() => {
      sheet.refusedAnswers[1](wrong);
      sheet.refuse("survey", true);
    });
  };
  for (let tries = 0; ; ) {
    const before = sheet.text();
    try {
      const out = await liveEngine.call<SurveyOut | null>("survey", { text: before, answers: drafts }, { patience: 5000 });
      if (mine !== newest) return;
      // Something else wrote meanwhile: the answers go into what stands there now.
      if (sheet.text() !== before) continue;
      if (out === null) return refused([{ key: "", text: "The file is no survey’s any more: its first line has been changed. “Form” and “Text” change the bridge." }]);
      const { text } = out;
      if (text === null) return refused(out.findings.map(told));
      return batch(() => {
        sheet.surveyed = text;
        sheet.survey[1](out);
        sheet.drafts[1]({});
        sheet.refusedAnswers[1](null);
        sheet.refuse("survey", false);
        sheet.change(text, mark);
      });
    } catch (error) {
      if (mine !== newest) return;
      // A worker that died takes no answer with it: the next one is asked.
      if (error instanceof Lost && ++tries === 1) continue;
      return refused([{ key: "", text: error instanceof Refused ? sentences(error) : String((error as Error).message) }]);
    }
  }
}

/** A finding in words, at its answer. */
export function told({ key, severity, message, help }: SurveyFinding): Wrong {
  const what = message.slice(key.length);
  if (what === " is missing") return { key, text: "The drawing waits for this number: nothing is assumed in its place." };
  return { key, text: sentences({ message: what.replace(/^: /, ""), help }), doubtful: severity === "warning" };
}
