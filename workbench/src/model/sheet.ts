/** One bridge on the board: its text, which is the truth, and what the engine has said of it so far. */
import { batch, createSignal } from "solid-js";
import type { Envelope } from "../drawing/answer";
import type { LiveAnswer, Picture, PlacingAbout, Quantity, Reading, Refusal, SurveyOut } from "../engine/types";

type Past = { text: string; mark: string; at: number };

/** Steps that are kept for undoing. */
const MOST_STEPS = 400;
/** Changes of one kind within this time [ms] are one step. */
const TOGETHER = 900;

export type Kept = {
  id: string;
  path: string;
  text: string;
  vehicle: string;
  rule: string;
  leftward: boolean;
  x: number | null;
  /** Answers of a survey that are refused, and stand in their fields alone. */
  drafts?: Record<string, string>;
};

/** What is wrong with an answer of a survey or doubtful; no key where it is none of them. */
export type Wrong = { key: string; text: string; doubtful?: boolean };

export class Sheet {
  readonly id: string;
  readonly path: string;
  readonly files = new Map<string, Uint8Array>();

  #text = createSignal("");
  #files = createSignal(0);
  #name = "";
  #past: Past[] = [];
  #future: string[] = [];
  #lastMark = "";
  #lastAt = 0;
  #steps = createSignal({ back: 0, forth: 0 });

  readonly reading = createSignal<Reading | null>(null);
  readonly picture = createSignal<Picture | null>(null);
  readonly quantities = createSignal<Quantity[]>([]);
  /** Why there is no reading, where there is none. */
  readonly trouble = createSignal<Refusal | null>(null);
  /** Where something was typed that is refused, and not yet mended: a field, the survey. */
  readonly refused = createSignal<string[]>([]);

  readonly vehicle = createSignal("");
  readonly rule = createSignal("");
  readonly leftward = createSignal(false);
  readonly x = createSignal<number | null>(null);
  readonly about = createSignal<PlacingAbout | null>(null);
  readonly answer = createSignal<LiveAnswer | null>(null);
  readonly zone = createSignal<Float64Array | null>(null);
  readonly envelope = createSignal<Envelope | null>(null);
  /** What the envelope was asked for. */
  envelopeKey = "";
  /** Where the page itself put the load. */
  stood: number | null = null;
  /** How often the load has been moved by hand. */
  moves = 0;
  readonly placeTrouble = createSignal<Refusal | null>(null);

  /** What the file says to the questions of a survey; null where it is no survey's. */
  readonly survey = createSignal<SurveyOut | null>(null);
  /** Answers that the file has not, for they are refused; the text that was written from answers last, and how often another one came. */
  readonly drafts = createSignal<Record<string, string>>({});
  surveyed = "";
  /** The text as it was opened. */
  readonly opened: string;
  readonly elsewhere = createSignal(0);
  /** What is wrong with answers that are refused; null where none is. */
  readonly refusedAnswers = createSignal<Wrong[] | null>(null);

  constructor(kept: Partial<Kept> & { path: string; text: string }) {
    this.id = kept.id ?? crypto.randomUUID();
    this.path = kept.path;
    this.#text[1](kept.text);
    this.opened = kept.text;
    if (kept.vehicle) this.vehicle[1](kept.vehicle);
    if (kept.rule) this.rule[1](kept.rule);
    if (kept.leftward) this.leftward[1](true);
    if (kept.drafts && typeof kept.drafts === "object") {
      this.drafts[1](Object.fromEntries(Object.entries(kept.drafts).filter(([, value]) => typeof value === "string")));
      this.surveyed = kept.text;
      this.refuse("survey", Object.keys(this.drafts[0]()).length > 0);
    }
    if (typeof kept.x === "number" && Number.isFinite(kept.x)) this.x[1](kept.x);
  }

  text(): string {
    return this.#text[0]();
  }
  /** What the file says to the questions of a survey now. Where something else than the survey wrote it, it stands in the fields as well. */
  says(survey: SurveyOut | null, text: string): void {
    batch(() => {
      this.survey[1](survey);
      if (text === this.surveyed) return;
      this.surveyed = text;
      this.drafts[1]({});
      this.refusedAnswers[1](null);
      this.refuse("survey", false);
      this.elsewhere[1]((count) => count + 1);
    });
  }
  /** What was typed at a place is refused, or no longer. */
  refuse(where: string, is: boolean): void {
    this.refused[1]((list) => (list.includes(where) === is ? list : is ? [...list, where] : list.filter((one) => one !== where)));
  }
  /** Whether what stands on the sheet is of values before those that were typed last. */
  isOld(): boolean {
    const reading = this.reading[0]();
    return this.refused[0]().length > 0 || this.trouble[0]() !== null || (reading !== null && !reading.usable);
  }
  /** Counts changes of the companions. */
  filesVersion(): number {
    return this.#files[0]();
  }
  name(): string {
    const name = this.reading[0]()?.name;
    if (name) this.#name = name;
    // While a value is wrong, a bridge keeps the name that it had.
    return name || this.#name || this.path;
  }

  put(name: string, bytes: Uint8Array): void {
    this.files.set(name, bytes);
    this.#files[1]((count) => count + 1);
  }

  /** Writes the text; changes with the same mark in quick succession are one step of undo. */
  change(text: string, mark: string): void {
    const before = this.#text[0]();
    if (text === before) return;
    const now = performance.now();
    const same = mark !== "" && mark === this.#lastMark && now - this.#lastAt < TOGETHER;
    batch(() => {
      if (!same) {
        this.#past.push({ text: before, mark, at: now });
        if (this.#past.length > MOST_STEPS) this.#past.shift();
      }
      this.#future = [];
      this.#lastMark = mark;
      this.#lastAt = now;
      this.#text[1](text);
      this.#count();
    });
  }

  undo(): void {
    const step = this.#past.pop();
    if (!step) return;
    batch(() => {
      this.#future.push(this.#text[0]());
      this.#lastMark = "";
      this.#text[1](step.text);
      this.#count();
    });
  }

  redo(): void {
    const text = this.#future.pop();
    if (text === undefined) return;
    batch(() => {
      this.#past.push({ text: this.#text[0](), mark: "", at: 0 });
      this.#lastMark = "";
      this.#text[1](text);
      this.#count();
    });
  }

  steps(): { back: number; forth: number } {
    return this.#steps[0]();
  }
  #count(): void {
    this.#steps[1]({ back: this.#past.length, forth: this.#future.length });
  }

  kept(): Kept {
    return {
      id: this.id,
      path: this.path,
      text: this.text(),
      vehicle: this.vehicle[0](),
      rule: this.rule[0](),
      leftward: this.leftward[0](),
      x: this.x[0](),
      drafts: this.drafts[0](),
    };
  }
}
