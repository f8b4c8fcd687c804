/** A worker with one instance of the engine. It answers one call after the other and keeps what calls refer to by name. */
import { isOpen, standIn } from "../model/drawn";
import init, * as engine from "./pkg/extrados_workbench.js";
import type { LiveAnswer, PlacingAbout, ReadingOut, ResultOut, SurveyOut } from "./types";

type Call = { id: number; call: string; args: Record<string, unknown> };
const scope = self as unknown as DedicatedWorkerGlobalScope;

const documents = new Map<string, engine.Document>();
const results = new Map<string, engine.Result>();
let placed: { sheet: string; placing: engine.Placing } | null = null;
let stepping: engine.Stepping | null = null;
let passing: engine.Passing | null = null;

function documentOf(sheet: unknown): engine.Document {
  const document = documents.get(sheet as string);
  if (!document) throw refusal("The worker does not hold this bridge.");
  return document;
}

function refusal(message: string): Error {
  const error = new Error(message);
  error.name = "Refusal";
  return error;
}

/** A drawing whose materials nobody has named yet is drawn all the same: by values that stand in for them and give no number. */
function drawn(document: engine.Document): ReadingOut["picture"] {
  const text = document.text();
  if (!isOpen(text)) return null;
  const stand = new engine.Document("drawing.toml", standIn(text));
  const picture = JSON.parse(stand.picture());
  stand.free();
  return picture;
}

function reading(document: engine.Document): ReadingOut {
  return {
    reading: JSON.parse(document.reading()),
    picture: JSON.parse(document.picture()) ?? drawn(document),
    quantities: JSON.parse(document.quantities()),
    text: document.text(),
    survey: JSON.parse(engine.survey_changed(document.text(), "{}")),
  };
}

function unplace(): void {
  placed?.placing.free();
  placed = null;
}

function placing(sheet: unknown): engine.Placing {
  if (!placed || placed.sheet !== sheet) throw refusal("No load stands on this bridge.");
  return placed.placing;
}

/** Results that are kept for their files; older ones go. */
const MOST_RESULTS = 6;

function resultOf(run: string): engine.Result {
  const found = results.get(run);
  if (!found) throw refusal("This result is no longer held; compute it again.");
  return found;
}

function published(result: engine.Result, name: string): ResultOut {
  results.get(name)?.free();
  results.delete(name);
  results.set(name, result);
  if (results.size > MOST_RESULTS) {
    const oldest = results.keys().next().value!;
    results.get(oldest)?.free();
    results.delete(oldest);
  }
  return {
    status: result.status,
    json: result.json,
    picture: result.picture,
    figures: JSON.parse(result.figures),
    files: JSON.parse(result.files()),
  };
}

/** Values whose buffers are handed over and not copied. */
class Moved<T> {
  constructor(
    readonly value: T,
    readonly buffers: ArrayBufferLike[],
  ) {}
}

function moved<T extends object>(value: T): Moved<T> {
  const buffers = Object.values(value)
    .filter((entry) => ArrayBuffer.isView(entry))
    .map((entry) => (entry as ArrayBufferView).buffer);
  return new Moved(value, [...new Set(buffers)]);
}

/** What calls pass; each reads its own. */
type Args = {
  sheet: string;
  before: string;
  path: string;
  text: string;
  files: [string, Uint8Array][];
  literal: string;
  vehicle: string;
  rule: string;
  leftward: boolean;
  x: number;
  quick: boolean;
  xs: Float64Array;
  factor: number;
  budget: number;
  most: number;
  run: string;
  name: string;
  choice: string;
  step: number;
  settings: string[];
  state: Uint8Array;
  positions: number;
  bytes: Uint8Array;
  example: string;
  file: string;
  code: string;
  table: string;
  material: string;
  keys: string[];
  answers: Record<string, string | number>;
};
type Handler = (args: Args, tell: (stage: string, fraction: number) => void) => unknown;
const handlers: Record<string, Handler> = {
  build: () => engine.build(),
  fail: ({ text }) => engine.fail(text),
  examples: () => JSON.parse(engine.examples()),
  exampleFile: ({ example, file }) => engine.example_file(example, file),
  schema: () => JSON.parse(engine.schema()),
  keys: () => JSON.parse(engine.keys()),
  explain: ({ code }) => JSON.parse(engine.explain(code)),
  library: () => JSON.parse(engine.library()),
  materials: () => JSON.parse(engine.materials()),
  withMaterial: ({ text, table, material, keys }) => engine.with_material(text, table, material, keys),
  placeOf: ({ text, path }) => JSON.parse(engine.place(text, path)),
  questions: () => JSON.parse(engine.survey_questions()),
  surveyStart: () => engine.survey_start(),
  /** The file of a survey with answers in it. */
  survey: ({ text, answers }): SurveyOut | null => JSON.parse(engine.survey_changed(text, JSON.stringify(answers))),
  fromDxf: ({ name, bytes }) => engine.from_dxf(name, bytes),
  records: ({ name, bytes }) => JSON.parse(engine.records(name, bytes)),

  open: ({ sheet, path, text, files }) => {
    if (placed?.sheet === sheet) unplace();
    documents.get(sheet)?.free();
    const document = new engine.Document(path, text);
    documents.set(sheet, document);
    for (const [name, bytes] of files) document.put(name, bytes);
    return reading(document);
  },
  text: ({ sheet, text }) => {
    const document = documentOf(sheet);
    document.set_text(text);
    return reading(document);
  },
  set: ({ sheet, path, literal }) => {
    const document = documentOf(sheet);
    document.set(path, literal);
    return reading(document);
  },
  drawing: ({ sheet }) => documentOf(sheet).drawing(),
  forget: ({ sheet }) => {
    if (placed?.sheet === sheet) unplace();
    documents.get(sheet)?.free();
    documents.delete(sheet);
  },

  place: ({ sheet, vehicle, rule, leftward }): PlacingAbout => {
    unplace();
    const made = new engine.Placing(documentOf(sheet), vehicle, rule, leftward);
    placed = { sheet, placing: made };
    return JSON.parse(made.about());
  },
  /** While a load moves the quick answer will do, which says where it is open. */
  at: ({ sheet, x, quick }): Moved<LiveAnswer> => {
    const begin = performance.now();
    const there = placing(sheet) as engine.Placing & { quickly?: (x: number) => engine.Answer };
    const answer = quick && there.quickly ? there.quickly(x) : there.at(x);
    const value: LiveAnswer = {
      x,
      words: JSON.parse(answer.json),
      thrust: answer.thrust,
      thrustStarts: answer.thrust_starts,
      mechanism: answer.mechanism,
      centroids: answer.centroids,
      loads: answer.loads,
      axles: answer.axles,
      milliseconds: 0,
    };
    answer.free();
    value.milliseconds = performance.now() - begin;
    return moved(value);
  },
  zone: ({ sheet, x, factor }) => placing(sheet).zone(x, factor),
  /** Four numbers a place. */
  factors: ({ sheet, xs }) => {
    const made = placing(sheet);
    const found = new Float64Array(4 * xs.length);
    xs.forEach((x, k) => found.set(made.factor(x), 4 * k));
    return found;
  },

  collapse: ({ sheet, run, choice }, tell) => published(engine.collapse(documentOf(sheet), choice, tell), run),
  sweep: ({ sheet, run, choice, step }, tell) => published(engine.sweep(documentOf(sheet), choice, step, tell), run),
  cases: ({ sheet, run, choice }, tell) => published(engine.cases(documentOf(sheet), choice, tell), run),
  compare: ({ sheet, before, run, choice }, tell) => published(engine.compare(documentOf(sheet), documentOf(before), choice, tell), run),
  respond: ({ sheet, run }, tell) => published(engine.respond(documentOf(sheet), tell), run),
  update: ({ sheet, run }, tell) => published(engine.update(documentOf(sheet), tell), run),
  judge: ({ sheet, run }, tell) => published(engine.judge(documentOf(sheet), tell), run),
  assess: ({ sheet, run }, tell) => published(engine.assess(documentOf(sheet), new Date().toISOString().slice(0, 10), tell), run),
  vary: ({ sheet, run, settings, choice }, tell) =>
    published(engine.vary(documentOf(sheet), JSON.stringify(settings), choice, tell), run),
  file: ({ run, name }) => resultOf(run).file(name),
  zip: ({ run }) => resultOf(run).zip(),

  step: ({ sheet, choice }, tell) => {
    stepping?.free();
    stepping = null;
    stepping = new engine.Stepping(documentOf(sheet), choice, tell);
    return { ...frame(""), picture: JSON.parse(stepping.picture()), stepCentroids: stepping.centroids() };
  },
  /** Steps for a slice of time and tells what stands there. */
  advance: ({ budget, most }) => {
    if (!stepping) throw refusal("No run has been started.");
    const begin = performance.now();
    let ended = "";
    let batch = 16;
    let done = 0;
    while (ended === "" && done < most) {
      const from = performance.now();
      const now = Math.min(batch, most - done);
      ended = stepping.advance(now);
      done += now;
      const took = performance.now() - from;
      if (performance.now() - begin >= budget) break;
      const left = budget - (performance.now() - begin);
      batch = Math.max(1, Math.min(4096, Math.floor((now * Math.min(left, 12)) / Math.max(took, 0.02))));
    }
    return moved(frame(ended));
  },
  state: () => stepping?.state(),
  resume: ({ state }) => {
    if (!stepping) throw refusal("No run has been started.");
    stepping.restore(state);
    return moved(frame(""));
  },

  pass: ({ sheet }, tell) => {
    passing?.free();
    passing = null;
    passing = new engine.Passing(documentOf(sheet), tell);
    return {
      count: passing.count,
      places: passing.places(),
      sensors: JSON.parse(passing.sensors()),
      mesh: JSON.parse(passing.mesh()),
    };
  },
  passOn: ({ positions }) => {
    if (!passing) throw refusal("No passage has been started.");
    const ended = passing.advance(positions);
    return moved({
      ended,
      done: passing.done,
      values: passing.values(),
      displacements: passing.displacements(),
      joints: passing.joints(),
      axles: passing.axles(),
    });
  },
  passEnd: ({ run }, tell) => {
    if (!passing) throw refusal("No passage has been started.");
    const ended = passing;
    passing = null;
    return published(ended.finish(tell), run);
  },
};

function frame(ended: string) {
  const run = stepping!;
  return {
    ended,
    load: run.load,
    steps: run.steps,
    unbalanced: run.unbalanced,
    poses: run.poses(),
    particles: run.particles(),
    contacts: run.contacts(),
    chains: run.chains(),
    stresses: run.stresses(),
    path: run.path(),
  };
}

let ready: Promise<void> | null = null;

scope.onmessage = async (event: MessageEvent<Call | { module: WebAssembly.Module; life: string }>) => {
  if ("module" in event.data) {
    const { module, life } = event.data;
    // Held as long as the worker lives: whoever waits for it learns of any end, also one of which no event tells. It is held before anything is
    // computed, for a long first analysis would keep the answer to this request waiting until its own end.
    const { locks } = scope.navigator;
    const held = new Promise<void>((resolve) => {
      if (!locks) return resolve();
      locks
        .request(life, () => {
          scope.postMessage({ lives: true });
          resolve();
          return new Promise(() => undefined);
        })
        .catch(() => resolve());
    });
    ready = held.then(() => init({ module_or_path: module })).then(() => engine.start((message: string) => scope.postMessage({ panic: message })));
    return;
  }
  const { id, call, args } = event.data;
  try {
    await ready;
    const handler = handlers[call];
    if (!handler) throw refusal(`The worker knows no call "${call}".`);
    const value = handler(args as unknown as Args, (stage, fraction) => {
      scope.postMessage({ tell: { id, stage, fraction } });
    });
    if (value instanceof Moved) scope.postMessage({ id, ok: true, value: value.value }, value.buffers as Transferable[]);
    else scope.postMessage({ id, ok: true, value });
  } catch (error) {
    const thrown = error as Error & { code?: string; help?: string };
    if (thrown.name === "Refusal") {
      scope.postMessage({ id, ok: false, refusal: { message: thrown.message, code: thrown.code ?? "", help: thrown.help ?? "" } });
    } else {
      scope.postMessage({ id, ok: false, broken: String(thrown.message ?? thrown) });
    }
  }
};
