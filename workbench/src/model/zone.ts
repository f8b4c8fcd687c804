/** The zone of the line of thrust, in a worker of its own: on long bridges it takes far longer than the answer, which must not wait for it. */
import { Engine } from "../engine/client";
import type { LiveAnswer } from "../engine/types";
import type { Sheet } from "./sheet";

const engine = new Engine("zone");
/** A zone that takes longer [ms] is not asked for again on the same bridge with the same load. */
const PATIENCE = 8_000;

type Wanted = { sheet: Sheet; answer: LiveAnswer; vehicle: string; rule: string; leftward: boolean; key: string };
let wanted: Wanted | null = null;
let running = false;
let held: { key: string; generation: number } | null = null;
const slow = new Set<string>();

/** Asks for the zone under half of what is carried; a newer question takes the place of one that waits. */
export function wantZone(question: Wanted): void {
  wanted = question;
  if (!running) void run();
}

async function run(): Promise<void> {
  running = true;
  while (wanted) {
    const { sheet, answer, vehicle, rule, leftward, key } = wanted;
    wanted = null;
    if (sheet.answer[0]() !== answer || slow.has(key)) continue;
    try {
      if (held?.key !== key || held.generation !== engine.generation) {
        await engine.call("open", { sheet: sheet.id, path: sheet.path, text: sheet.text(), files: [...sheet.files] }, { patience: PATIENCE });
        await engine.call("place", { sheet: sheet.id, vehicle, rule, leftward }, { patience: PATIENCE });
        held = { key, generation: engine.generation };
      }
      const factor = 0.5 * (answer.words.factor ?? 0);
      const zone = await engine.call<Float64Array>("zone", { sheet: sheet.id, x: answer.x, factor }, { patience: PATIENCE });
      if (sheet.answer[0]() === answer) sheet.zone[1](zone);
    } catch {
      // The line of thrust is there; the band about it is left out.
      held = null;
      slow.add(key);
      if (slow.size > 64) slow.delete(slow.values().next().value!);
    }
  }
  running = false;
}
