/** A train that crosses, position by position, recorded for the time slider. */
import { batch, createSignal } from "solid-js";
import { Lost, Refused, sentences } from "../engine/client";
import type { Point } from "../engine/types";
import { stage } from "./run";
import type { Sheet } from "./sheet";

export type Sensor = { name: string; quantity: string; about: string; unit: string; scale: number; at: Point | null };
export type Mesh = {
  nodes: Point[];
  quads: [number, number, number, number][];
  zone_of: number[];
  zones: { name: string; made_of: string; quads: number }[];
  surface: Point[];
  springings: [Point, Point][];
  remark: string;
};
export type Moment = { displacements: Float32Array; joints: Float32Array; axles: Float64Array };
type Set = { count: number; places: Float64Array; sensors: Sensor[]; mesh: Mesh };
type Step = Moment & { ended: string; done: number; values: Float64Array };

/** Most that recorded moments may take [bytes]. */
const MOST_BYTES = 140e6;

export type Records = {
  name: string;
  channels: { name: string; unit: string; scale: number; left_out?: unknown }[];
  times: number[];
  values: number[][];
  findings: { code: string; severity: string; message: string; help: string }[];
};

export class Passage {
  readonly mode = createSignal<"idle" | "setting-up" | "running" | "paused" | "ended" | "failed">("idle");
  readonly words = createSignal({ stage: "", fraction: NaN });
  readonly trouble = createSignal("");
  readonly set = createSignal<Set | null>(null);
  readonly done = createSignal(0);
  readonly shown = createSignal(0);
  readonly ended = createSignal("");
  readonly measured = createSignal<Records | null>(null);
  /** Moments by position; positions between are shown by the last one before. */
  moments = new Map<number, Moment>();
  values: Float64Array[] = [];
  text = "";
  #token = 0;
  #stopping = false;
  #every = 1;

  constructor(readonly sheet: Sheet) {}

  async start(): Promise<void> {
    const mine = ++this.#token;
    this.moments.clear();
    this.values = [];
    this.#every = 1;
    this.text = this.sheet.text();
    batch(() => {
      this.set[1](null);
      this.done[1](0);
      this.shown[1](0);
      this.trouble[1]("");
      this.ended[1]("");
      this.mode[1]("setting-up");
    });
    try {
      await stage.call("open", { sheet: this.sheet.id, path: this.sheet.path, text: this.text, files: [...this.sheet.files] }, { patience: 20_000 });
      const set = await stage.call<Set>("pass", { sheet: this.sheet.id }, { tell: (words, fraction) => this.words[1]({ stage: words, fraction }) });
      if (mine !== this.#token) return;
      const each = set.mesh.nodes.length * 8 + 24_000;
      this.#every = Math.max(1, Math.ceil((set.count * each) / MOST_BYTES));
      batch(() => {
        this.set[1](set);
        this.mode[1]("running");
      });
      await this.#loop(mine);
    } catch (error) {
      this.#fail(mine, error);
    }
  }

  #fail(mine: number, error: unknown): void {
    if (mine !== this.#token) return;
    batch(() => {
      if (!(error instanceof Lost && error.why === "stopped")) {
        this.trouble[1](error instanceof Refused ? sentences(error) : `The engine broke down and was started again. ${(error as Error).message}`);
      }
      this.mode[1](this.values.length > 0 ? "ended" : this.trouble[0]() ? "failed" : "idle");
    });
  }

  async #loop(mine: number): Promise<void> {
    this.#stopping = false;
    while (mine === this.#token && !this.#stopping) {
      const step = await stage.call<Step>("passOn", { positions: 1 });
      if (mine !== this.#token) return;
      const follows = this.shown[0]() >= this.done[0]() - 1;
      const at = step.done - 1;
      this.values[at] = step.values;
      if (at % this.#every === 0 || step.ended !== "") this.moments.set(at, { displacements: step.displacements, joints: step.joints, axles: step.axles });
      batch(() => {
        this.done[1](step.done);
        if (follows) this.shown[1](Math.max(0, at));
        if (step.ended !== "") {
          this.ended[1](step.ended);
          this.mode[1]("ended");
        }
      });
      if (step.ended !== "") return;
      await new Promise((resolve) => setTimeout(resolve, 0));
    }
  }

  momentAt(position: number): Moment | undefined {
    for (let k = position; k >= 0; k -= 1) {
      const found = this.moments.get(k);
      if (found) return found;
    }
    return undefined;
  }

  pause(): void {
    this.#stopping = true;
    this.mode[1]("paused");
  }
  resume(): void {
    const mine = ++this.#token;
    this.mode[1]("running");
    void this.#loop(mine).catch((error) => this.#fail(mine, error));
  }
  stop(): void {
    this.#token += 1;
    stage.stop();
    this.mode[1](this.values.length > 0 ? "ended" : "idle");
  }

  async measure(name: string, bytes: Uint8Array): Promise<void> {
    try {
      this.measured[1](await stage.call<Records>("records", { name, bytes }, { patience: 20_000 }));
    } catch (error) {
      this.trouble[1](`${name} could not be read as records: ${(error as Error).message}`);
    }
  }
}

const passages = new WeakMap<Sheet, Passage>();
export function passageOf(sheet: Sheet): Passage {
  let passage = passages.get(sheet);
  if (!passage) {
    passage = new Passage(sheet);
    passages.set(sheet, passage);
  }
  return passage;
}

/** A sensor as a table of the bridge file, at a place of the drawing. */
export function sensorTable(name: string, kind: string, direction: string, face: string, x: number, y: number): string {
  const plain = name.replace(/["\\\p{Cc}]/gu, "").slice(0, 60);
  return [
    `name = "${plain}"`,
    `kind = "${kind}"`,
    ...(kind === "displacement" ? [`direction = "${direction}"`] : []),
    `x = "${x.toFixed(3)} m"`,
    `y = "${y.toFixed(3)} m"`,
    ...(kind === "displacement" && face === "intrados" ? [] : [`face = "${face}"`]),
  ].join("\n");
}
