/** What passes between page and engine; PROTOCOL.md is the reference. SI units throughout. */

export type Point = [number, number];
export type Pose = { translation: Point; rotation: number };

export type Example = {
  name: string;
  about: string;
  main: string;
  command: "collapse" | "respond" | "cases";
  files: { name: string; about: string }[];
};
export type Word = { word: string; doc: string };
export type Field = {
  key: string;
  kind: "quantity" | "quantities" | "number" | "whole" | "word" | "text" | "truth" | "table" | "tables" | "other";
  doc: string;
  need: "required" | "optional" | "default";
  default: string | null;
  words: Word[];
  example: string;
};
export type Section = { path: string; list: boolean; fields: Field[] };
export type Card = { code: string; title: string; text: string };
export type Finding = {
  code: string;
  severity: "error" | "warning" | "note";
  message: string;
  label: string;
  note: string | null;
  help: string | null;
  start: number;
  end: number;
  line: number;
  column: number;
};
export type Reading = {
  kind: "bridge" | "blocks";
  usable: boolean;
  name: string;
  width_m: number | null;
  sections: {
    loads: number;
    /** What they are called in the file, "load 1" where they have no name. */
    load_names: string[];
    sweep: boolean;
    passage: boolean;
    update: boolean;
    assess: boolean;
    vary: boolean;
    cases: number;
    particles: boolean;
    continuum: boolean;
    /** A word of `method` in [analysis]. */
    method: string;
    /** What each method does not know of the bridge, in words. */
    not_known?: Record<string, string | null>;
    analysis: "load" | "thickness" | "support-movement";
    stiffness?: boolean;
    spans?: number;
  } | null;
  refusal: { code: string; message: string; help: string } | null;
  findings: Finding[];
  inputs: string[];
};
export type Quantity = {
  path: string;
  value: string;
  by_default: boolean;
  doc: string;
  text: string;
  number: number | null;
  unit: string;
  words: Word[];
  least: number | null;
  most: number | null;
  start: number | null;
  end: number | null;
};
/** What is wrong with an answer of a survey, or doubtful. */
export type SurveyFinding = { key: string; severity: "error" | "warning"; message: string; help: string };
/** What a survey's file says: its text, null where an answer is refused; its answers, null where it cannot be read. */
export type SurveyOut = { text: string | null; answers: Record<string, string> | null; findings: SurveyFinding[] };
/** `usual` follows the word "usually"; empty where nothing is known. */
export type Question = { key: string; doc: string; unit: string; example: string; assumed: string; usual: string };
/** The ten numbers, the first three of which are those of a span; how many spans; and what is asked of a pier between them. */
export type Questions = {
  ten: Question[];
  spans: Question;
  pier: Question[];
  /** What a survey may know besides; and what is answered in words, each with what is asked. */
  more: Question[];
  words: [string, string][];
};

export type Shape = { outline: Point[]; role: string; held: boolean };
export type Hinge = { point: Point; edge: string; between: [number, number]; rotation: number };
export type Measure = "Span" | "Rise" | "Thickness" | "Height" | "Width" | "Depth";
export type Dimension = { measure: Measure; from: Point; to: Point };
export type Picture = {
  title: string;
  shapes: Shape[];
  particles: { centre: Point; radius: number; layer: number }[];
  layers: string[];
  fill: Point[];
  bands: { name: string; size: string; outlines: Point[][] }[];
  defects: { words: string; line: Point[] }[];
  case: string | null;
  surface: Point[];
  surface_loads: [Point, number][];
  loads: { at: Point; force: Point }[];
  mechanism: Pose[] | null;
  hinges: Hinge[];
  sliding: Point[];
  thrust_lines: { point: Point; thrust: number }[][];
  path: { load: number; displacement: Point; iterations: number; unbalanced_ratio: number; at_rest: boolean }[];
  dimensions: Dimension[];
  collapse_load: number | null;
  last_stable: number | null;
  stalls: boolean;
  moves_supports: boolean;
};

export type PlacingAbout = {
  name: string;
  /** Title of the rule that gives factors and spread; empty for the file's own loads. */
  rule?: string;
  /** False where the bridge does not stand under its own weight. */
  stands?: boolean;
  /** The factors that act on the loads, in words. */
  factors: string;
  axles: { force: number; offset: number }[];
  from: number;
  to: number;
  fast: boolean;
  assumptions: string[];
};
export type AnswerWords = {
  status: string;
  factor: number | null;
  dilatant_factor: number | null;
  lower_bound: number | null;
  upper_bound: number | null;
  load: number | null;
  friction: "associated" | "non-associated";
  slides: boolean;
  /** True where less may be carried without dilation, which has not been asked yet. */
  open?: boolean;
  hinges: Hinge[];
  sliding: Point[];
  /** Of a vehicle: first and last of the axles that count at this place, and the one that bears a further factor. */
  stands: [number, number] | null;
  critical: number | null;
};
/** The answer at one place, as typed arrays that the worker hands over. */
export type LiveAnswer = {
  x: number;
  words: AnswerWords;
  thrust: Float64Array;
  thrustStarts: Uint32Array;
  mechanism: Float64Array;
  centroids: Float64Array;
  loads: Float64Array;
  axles: Float64Array;
  milliseconds: number;
};

export type Refusal = { message: string; code: string; help: string };

export type Library = { models: LibraryModel[]; rules: LibraryRule[] };
export type LibraryModel = {
  code: string;
  title: string;
  ways: string;
  vehicles: { code: string; title: string }[];
  /** Codes of the rules that say how the model is used. */
  rules: string[];
  source: string;
  confidence: string;
  /** Whether a rule that names no vehicles leaves it out. */
  only_by_name: boolean;
  longest_span: number | null;
};
/** `judges` where a verdict can come of it: its factor on live loads gives safety and has a source. */
export type LibraryRule = { code: string; title: string; ways: string[]; judges: boolean };

export type Source = { text: string; date: string; confidence: "read" | "calculated" | "recalled" | "assumed"; note: string };
export type MaterialValue = { key: string; least: string; usual: string; most: string; source: Source };
export type Material = { code: string; title: string; tables: string[]; values: MaterialValue[] };
/** Where the text says what a path names; `written` is false where only its table is there. */
export type PlaceInText = { start: number; end: number; path: string; written: boolean };

export type ReadingOut = {
  reading: Reading;
  picture: Picture | null;
  quantities: Quantity[];
  text: string;
  /** Null where the file is no survey's. */
  survey: SurveyOut | null;
};
export type ResultOut = {
  status: string;
  json: string;
  picture: string;
  figures: { name: string; svg: string }[];
  files: string[];
};
