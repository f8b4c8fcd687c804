/** A collapse that is stepped in a worker of its own and recorded, so that it can be watched again and gone on from. */
import { batch, createSignal } from "solid-js";
import { Engine, Lost, Refused, sentences } from "../engine/client";
import type { Picture } from "../engine/types";
import { analyse } from "./background";
import type { Sheet } from "./sheet";
import { loadAt } from "./variants";

export const stage = new Engine("stage");

export type Frame = {
  ended: string;
  load: number;
  steps: number;
  unbalanced: number;
  poses: Float64Array;
  particles: Float32Array;
  contacts: Float32Array;
  chains: Float32Array;
  stresses: Float32Array;
  path: Float64Array;
};
type Started = Frame & { picture: Picture; stepCentroids: Float64Array };

/** Most that recorded frames may take [bytes]; older ones are thinned beyond it. */
const MOST_BYTES = 160e6;
const MOST_STATES = 24;

function sizeOf(frame: Frame): number {
  return frame.poses.byteLength + frame.particles.byteLength + frame.contacts.byteLength + frame.chains.byteLength + frame.stresses.byteLength + 200;
}

export type Mode = "idle" | "setting-up" | "running" | "paused" | "ended" | "failed";

export class Run {
  readonly mode = createSignal<Mode>("idle");
  readonly words = createSignal({ stage: "", fraction: NaN });
  readonly trouble = createSignal("");
  readonly picture = createSignal<Picture | null>(null);
  /** Number of frames; the frames themselves are in `frames`. */
  readonly count = createSignal(0);
  readonly shown = createSignal(0);
  readonly speed = createSignal(200);
  /** Limit load of the same blocks [N/m]; null before it is known, and where particles make them other blocks. */
  readonly limit = createSignal<number | null>(null);
  centroids: Float64Array = new Float64Array(0);
  frames: Frame[] = [];
  /** Where the load stands [m], where that is not the file's place; NaN where it was moved and the run has it in the file's place. */
  readonly at = createSignal<number | null>(null);
  /** The text that is loaded, and that of the sheet when the run began. */
  text = "";
  of = "";
  choice = "{}";
  #states: { frame: Frame; bytes: Uint8Array }[] = [];
  #bytes = 0;
  #token = 0;
  #stopping = false;

  constructor(readonly sheet: Sheet) {}

  async start(choice: string): Promise<void> {
    const mine = ++this.#token;
    this.reset();
    this.choice = choice;
    const x = this.sheet.x[0]();
    // A load that somebody moved is loaded where it stands.
    const wanted = this.sheet.vehicle[0]() === "" && x !== null && x !== this.sheet.stood;
    const moved = wanted ? loadAt(this.sheet.text(), x) : null;
    this.at[1](moved !== null ? x : wanted ? NaN : null);
    this.of = this.sheet.text();
    this.text = moved ?? this.of;
    this.mode[1]("setting-up");
    try {
      await stage.call("open", { sheet: this.sheet.id, path: this.sheet.path, text: this.text, files: [...this.sheet.files] }, { patience: 20_000 });
      const first = await stage.call<Started>("step", { sheet: this.sheet.id, choice }, {
        tell: (words, fraction) => this.words[1]({ stage: words, fraction }),
      });
      if (mine !== this.#token) return;
      this.centroids = first.stepCentroids;
      batch(() => {
        this.picture[1](first.picture);
        this.#record(first);
        this.mode[1]("running");
      });
      if (first.particles.length === 0) void this.#findLimit(mine);
      await this.#loop(mine);
    } catch (error) {
      this.#fail(mine, error);
    }
  }

  async #findLimit(mine: number): Promise<void> {
    try {
      const out = await analyse(this.sheet, "collapse", { run: "limit-of-run", choice: '{"method":"limit"}', instead: this.text });
      const load = (JSON.parse(out.json) as { headline_kn_per_m?: number | null }).headline_kn_per_m;
      if (mine === this.#token || this.frames.length > 0) this.limit[1](typeof load === "number" ? load * 1e3 : null);
    } catch {
      // Another analysis took the worker; the run stands by itself and says that it does.
    }
  }

  #fail(mine: number, error: unknown): void {
    if (mine !== this.#token) return;
    if (error instanceof Lost && error.why === "stopped") {
      this.mode[1](this.frames.length > 0 ? "ended" : "idle");
      return;
    }
    batch(() => {
      this.trouble[1](error instanceof Refused ? sentences(error) : `The engine broke down and was started again. ${(error as Error).message}`);
      this.mode[1](this.frames.length > 0 ? "ended" : "failed");
    });
  }

  async #loop(mine: number): Promise<void> {
    this.#stopping = false;
    let states = 0;
    while (mine === this.#token && !this.#stopping) {
      const begin = performance.now();
      const frame = await stage.call<Frame>("advance", { budget: this.speed[0]() >= 5000 ? 90 : 30, most: this.speed[0]() });
      if (mine !== this.#token) return;
      const follows = this.shown[0]() >= this.count[0]() - 1;
      batch(() => {
        this.#record(frame);
        if (follows) this.shown[1](this.frames.length - 1);
        if (frame.ended !== "") this.mode[1]("ended");
      });
      if (frame.ended !== "") return;
      states += 1;
      if (states % 60 === 0) await this.#keepState(frame);
      // A picture a frame of the screen at most; without a screen (a hidden tab) the run goes on slowly.
      const rest = 16 - (performance.now() - begin);
      await new Promise((resolve) => (document.hidden ? setTimeout(resolve, 30) : rest > 1 ? requestAnimationFrame(() => resolve(null)) : setTimeout(resolve, 0)));
    }
  }

  async #keepState(frame: Frame): Promise<void> {
    const bytes = await stage.call<Uint8Array | undefined>("state");
    if (!bytes) return;
    this.#states.push({ frame, bytes });
    if (this.#states.length > MOST_STATES) this.#states = this.#states.filter((_, k) => k % 2 === 0);
  }

  #record(frame: Frame): void {
    this.frames.push(frame);
    this.#bytes += sizeOf(frame);
    if (this.#bytes > MOST_BYTES) {
      const last = this.frames.length - 1;
      this.frames = this.frames.filter((_, k) => k % 2 === 0 || k === last);
      this.#bytes = this.frames.reduce((sum, one) => sum + sizeOf(one), 0);
    }
    this.count[1](this.frames.length);
    this.shown[1]((at) => Math.min(at, this.frames.length - 1));
  }

  pause(): void {
    this.#stopping = true;
    this.mode[1]("paused");
  }

  resume(): void {
    const mine = ++this.#token;
    this.shown[1](this.count[0]() - 1);
    this.mode[1]("running");
    void this.#loop(mine).catch((error) => this.#fail(mine, error));
  }

  /** One picture further. */
  async stepOnce(): Promise<void> {
    const mine = ++this.#token;
    try {
      const frame = await stage.call<Frame>("advance", { budget: 200, most: Math.max(1, this.speed[0]()) });
      if (mine !== this.#token) return;
      batch(() => {
        this.#record(frame);
        this.shown[1](this.frames.length - 1);
        this.mode[1](frame.ended === "" ? "paused" : "ended");
      });
    } catch (error) {
      this.#fail(mine, error);
    }
  }

  /** Goes on from the last kept state at or before the picture that is shown; what came after it is forgotten. */
  async goOnFromHere(): Promise<void> {
    const steps = this.frames[this.shown[0]()]?.steps ?? 0;
    const kept = [...this.#states].reverse().find((state) => state.frame.steps <= steps);
    const mine = ++this.#token;
    if (!kept) {
      await this.start(this.choice);
      return;
    }
    try {
      await stage.call("resume", { state: kept.bytes });
      if (mine !== this.#token) return;
      this.frames = this.frames.filter((frame) => frame.steps <= kept.frame.steps);
      this.#states = this.#states.filter((state) => state.frame.steps <= kept.frame.steps);
      batch(() => {
        this.count[1](this.frames.length);
        this.shown[1](this.frames.length - 1);
        this.mode[1]("running");
      });
      await this.#loop(mine);
    } catch (error) {
      this.#fail(mine, error);
    }
  }

  stop(): void {
    this.#token += 1;
    stage.stop();
    this.mode[1](this.frames.length > 0 ? "ended" : "idle");
  }

  reset(): void {
    this.frames = [];
    this.#states = [];
    this.#bytes = 0;
    batch(() => {
      this.count[1](0);
      this.shown[1](0);
      this.trouble[1]("");
      this.limit[1](null);
      this.picture[1](null);
      this.words[1]({ stage: "", fraction: NaN });
    });
  }
}

const runs = new WeakMap<Sheet, Run>();
export function runOf(sheet: Sheet): Run {
  let run = runs.get(sheet);
  if (!run) {
    run = new Run(sheet);
    runs.set(sheet, run);
  }
  return run;
}
