/** A second worker for what takes longer: the envelope, whole analyses. It yields to nothing and may be ended at any time. */
import type { Envelope } from "../drawing/answer";
import { Engine } from "../engine/client";
import type { PlacingAbout, ResultOut } from "../engine/types";
import type { Sheet } from "./sheet";

export const background = new Engine("background");
/** An envelope is shared by several workers where the machine has cores to spare beside the live worker and the page. */
export const envelopes = Array.from({ length: Math.max(1, Math.min(4, (navigator.hardwareConcurrency || 1) - 2)) }, (_, k) => new Engine(`envelope ${k + 1}`));

type Wanted = { sheet: Sheet; key: string };
let wanted: Wanted | null = null;
let running = false;

/** Coarse places first, so that the whole curve stands early and grows finer. */
export function order(count: number): number[] {
  const seen = new Uint8Array(count);
  const list: number[] = [];
  for (let stride = 16; stride >= 1; stride /= 2) {
    for (let k = 0; k < count; k += stride) {
      if (!seen[k]) {
        seen[k] = 1;
        list.push(k);
      }
    }
  }
  return list;
}

/** Asks for the envelope of what stands on the sheet now; an older question is given up. */
export function wantEnvelope(sheet: Sheet, key: string): void {
  wanted = { sheet, key };
  if (!running) void run();
}
export function forgetEnvelope(): void {
  wanted = null;
}

/** Places that a call is asked for take about this long [ms]: a newer question is heard after it. */
const SLICE = 120;

async function run(): Promise<void> {
  running = true;
  while (wanted) {
    const mine: Wanted = wanted;
    const lanes = envelopes.map((engine) => new Lane(engine, mine));
    try {
      const [about] = await Promise.all(lanes.map((lane) => lane.begin()));
      const count = 81;
      const xs = Float64Array.from({ length: count }, (_, k) => about!.from + ((about!.to - about!.from) * k) / (count - 1));
      const factors = new Float64Array(count).fill(NaN);
      const known = new Uint8Array(count);
      const left = order(count);
      const take = (found: Map<number, number>): void => {
        for (const [k, factor] of found) {
          factors[k] = factor;
          known[k] = 1;
        }
        if (wanted === mine) mine.sheet.envelope[1]({ xs, factors: factors.slice(), known: known.slice() } satisfies Envelope);
      };
      await Promise.all(lanes.map((lane) => lane.work(xs, left, take)));
    } catch {
      // The live worker says what is wrong with the file; an envelope that is missing says enough here.
    }
    if (wanted === mine) wanted = null;
  }
  running = false;
}

/** One of the workers that share the places of an envelope. */
class Lane {
  #size = 1;

  constructor(
    readonly engine: Engine,
    readonly mine: Wanted,
  ) {}

  async begin(): Promise<PlacingAbout> {
    const { sheet } = this.mine;
    await this.engine.call("open", { sheet: sheet.id, path: sheet.path, text: sheet.text(), files: [...sheet.files] }, { patience: 15_000 });
    const rule = sheet.vehicle[0]() === "" ? "" : sheet.rule[0]();
    return this.engine.call<PlacingAbout>("place", { sheet: sheet.id, vehicle: sheet.vehicle[0](), rule, leftward: sheet.leftward[0]() }, { patience: 30_000 });
  }

  /** Takes places off the front of the list that all lanes share, until none is left or another envelope is wanted. */
  async work(xs: Float64Array, left: number[], take: (found: Map<number, number>) => void): Promise<void> {
    while (left.length > 0 && wanted === this.mine) {
      const places = left.splice(0, this.#size);
      const begin = performance.now();
      const found = await this.engine.call<Float64Array>("factors", { sheet: this.mine.sheet.id, xs: Float64Array.from(places, (k) => xs[k]!) }, { patience: 60_000 });
      const each = (performance.now() - begin) / places.length;
      this.#size = Math.max(1, Math.min(2 * this.#size, Math.floor(SLICE / Math.max(each, 1))));
      take(new Map(places.map((k, n) => [k, found[4 * n]!])));
    }
  }
}

/** A whole analysis in the background worker, which holds the sheet as it is now, or another text `instead`. */
export async function analyse(
  sheet: Sheet,
  call: string,
  args: Record<string, unknown>,
  tell?: (stage: string, fraction: number) => void,
): Promise<ResultOut> {
  const { instead, ...rest } = args;
  const text = typeof instead === "string" ? instead : sheet.text();
  await background.call("open", { sheet: sheet.id, path: sheet.path, text, files: [...sheet.files] }, { patience: 15_000 });
  return background.call<ResultOut>(call, { sheet: sheet.id, ...rest }, tell ? { tell } : {});
}
