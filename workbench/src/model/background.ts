/** A second worker for what takes longer: the envelope, whole analyses. It yields to nothing and may be ended at any time. */
import type { Envelope } from "../drawing/answer";
import { Engine } from "../engine/client";
import type { PlacingAbout, ResultOut } from "../engine/types";
import type { Sheet } from "./sheet";

export const background = new Engine("background");
export const envelopes = new Engine("envelope");

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

async function run(): Promise<void> {
  running = true;
  while (wanted) {
    const mine: Wanted = wanted;
    const { sheet } = mine;
    try {
      await envelopes.call("open", { sheet: sheet.id, path: sheet.path, text: sheet.text(), files: [...sheet.files] }, { patience: 15_000 });
      const about = await envelopes.call<PlacingAbout>(
        "place",
        { sheet: sheet.id, vehicle: sheet.vehicle[0](), rule: sheet.vehicle[0]() === "" ? "" : sheet.rule[0](), leftward: sheet.leftward[0]() },
        { patience: 30_000 },
      );
      const count = 81;
      const xs = Float64Array.from({ length: count }, (_, k) => about.from + ((about.to - about.from) * k) / (count - 1));
      const factors = new Float64Array(count).fill(NaN);
      const known = new Uint8Array(count);
      let left = order(count);
      while (left.length > 0 && wanted === mine) {
        const found = await envelopes.call<Float64Array>(
          "factors",
          { sheet: sheet.id, xs: Float64Array.from(left, (k) => xs[k]!), budget: 120 },
          { patience: 60_000 },
        );
        const done = found.length / 4;
        if (done === 0) break;
        for (let n = 0; n < done; n += 1) {
          factors[left[n]!] = found[4 * n]!;
          known[left[n]!] = 1;
        }
        left = left.slice(done);
        if (wanted === mine) sheet.envelope[1]({ xs, factors: factors.slice(), known: known.slice() } satisfies Envelope);
      }
    } catch {
      // The live worker says what is wrong with the file; an envelope that is missing says enough here.
    }
    if (wanted === mine) wanted = null;
  }
  running = false;
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
