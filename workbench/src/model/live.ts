/** Keeps the live worker at the newest text and the newest place of the load: one call at a time, what was overtaken is dropped. */
import { batch } from "solid-js";
import { Engine, Lost, Refused } from "../engine/client";
import type { LiveAnswer, PlacingAbout, ReadingOut, Refusal } from "../engine/types";
import type { Sheet } from "./sheet";
import { say } from "./workspace";
import { wantZone } from "./zone";

/** A text that takes longer to read than this [ms] is not read on. */
const PATIENCE = 10_000;

const engine = new Engine("live");
export const liveEngine = engine;
engine.onLost = (error) => {
  // An engine that never came is told of where it is waited for.
  if (error.why === "stopped" || /could not be (loaded|started)/.test(error.message)) return;
  say(`The engine ${error.why === "slow" ? "did not answer and was stopped" : "ended unexpectedly"}; it is started again. Nothing that you typed is lost.`, true);
  // What it held is opened in the next one, also where nobody waits for an answer.
  void pump();
};

type Held = { sheet: Sheet; text: string; files: number; generation: number };
type Placed = { held: Held; vehicle: string; rule: string; leftward: boolean };

let active: Sheet | null = null;
let held: Held | null = null;
let placed: Placed | null = null;
let answered: { placed: Placed; x: number } | null = null;
/** The answer that settles an open one, once the load has rested. */
let settled: LiveAnswer | null = null;
let resting: ReturnType<typeof setTimeout> | undefined;
let rested = false;
let zoned: LiveAnswer | null = null;
let running = false;
const sets = new Map<string, { literal: string; mark: string; failed: ((error: Refusal) => void) | undefined }>();
/** What broke the engine: it is not tried again until something changes. */
const broken = new Map<string, number>();
let quiet: ReturnType<typeof setTimeout> | undefined;

export function lookAt(sheet: Sheet): void {
  active = sheet;
  void pump();
}
export function poke(): void {
  void pump();
}
/** One quantity by its path; comments and everything else of the text stay. A newer value of the same path replaces an older one. */
export function setQuantity(path: string, literal: string, mark = "", failed?: (error: Refusal) => void): void {
  sets.set(path, { literal, mark: mark || `set ${path}`, failed });
  void pump();
}

function said(error: unknown): Refusal {
  if (error instanceof Refused) return { message: error.message, code: error.code, help: error.help };
  if (error instanceof Lost) {
    return error.why === "slow"
      ? { code: "", message: "Reading this file takes too long, and was stopped.", help: "Undo the last change, or make the bridge smaller. Your text is kept." }
      : { code: "", message: `The engine broke down and was started again: ${error.message.split("\n")[0]}`, help: "Your text is kept. Undo the last change; if it happens again, please report it with this file." };
  }
  return { code: "", message: String(error), help: "" };
}

function take(sheet: Sheet, out: ReadingOut): void {
  batch(() => {
    sheet.trouble[1](null);
    sheet.reading[1](out.reading);
    // A drawing stays while a file has errors, so that a slip of typing does not empty the sheet.
    if (out.picture) sheet.picture[1](out.picture);
    sheet.quantities[1](out.quantities);
    sheet.says(out.survey, out.text);
  });
}

function isBroken(key: string): boolean {
  return (broken.get(key) ?? 0) >= 2;
}
function note(key: string, error: unknown): boolean {
  if (!(error instanceof Lost)) return false;
  held = null;
  placed = null;
  answered = null;
  broken.set(key, (broken.get(key) ?? 0) + (error.why === "slow" ? 2 : 1));
  if (broken.size > 64) broken.delete(broken.keys().next().value!);
  return true;
}

async function pump(): Promise<void> {
  if (running) return;
  running = true;
  try {
    for (let round = 0; round < 10_000; round += 1) {
      if (!active || !(await step(active))) break;
    }
  } finally {
    running = false;
  }
}

/** Does the first thing that is out of date. Tells whether there was one. */
async function step(sheet: Sheet): Promise<boolean> {
  const text = sheet.text();
  const files = sheet.filesVersion();
  const textKey = `text ${sheet.id} ${files} ${text}`;

  if (!held || held.sheet !== sheet || held.text !== text || held.files !== files || held.generation !== engine.generation) {
    if (isBroken(textKey)) return false;
    const whole = !held || held.sheet !== sheet || held.files !== files || held.generation !== engine.generation;
    if (whole && held && held.sheet !== sheet && held.generation === engine.generation) {
      await engine.call("forget", { sheet: held.sheet.id }).catch(() => undefined);
    }
    placed = null;
    try {
      const out = whole
        ? await engine.call<ReadingOut>("open", { sheet: sheet.id, path: sheet.path, text, files: [...sheet.files] }, { patience: PATIENCE })
        : await engine.call<ReadingOut>("text", { sheet: sheet.id, text }, { patience: PATIENCE });
      held = { sheet, text, files, generation: engine.generation };
      if (sheet.text() === text) take(sheet, out);
    } catch (error) {
      const lost = note(textKey, error);
      if (!lost || isBroken(textKey)) {
        sheet.trouble[1](said(error));
        if (!lost) broken.set(textKey, 2);
      }
    }
    return true;
  }

  const next = sets.entries().next();
  if (!next.done) {
    const [path, { literal, mark, failed }] = next.value;
    sets.delete(path);
    try {
      const out = await engine.call<ReadingOut>("set", { sheet: sheet.id, path, literal }, { patience: PATIENCE });
      held = { ...held, text: out.text };
      placed = null;
      batch(() => {
        sheet.change(out.text, mark);
        take(sheet, out);
      });
    } catch (error) {
      const key = `set ${path} ${literal}`;
      // What was typed is not lost with a worker: the next one is given it, once.
      if (note(key, error) && !isBroken(key)) {
        if (!sets.has(path)) sets.set(path, { literal, mark, failed });
      } else {
        failed?.(said(error));
      }
    }
    return true;
  }

  const reading = sheet.reading[0]();
  // While a file has errors the answer before them stays, and is shown as such.
  if (reading && !reading.usable && reading.kind === "bridge") return false;
  if (!reading?.usable || !sheet.picture[0]() || reading.kind !== "bridge") {
    if (sheet.answer[0]()) batch(() => {
      sheet.answer[1](null);
      sheet.zone[1](null);
      sheet.about[1](null);
    });
    return false;
  }

  const vehicle = sheet.vehicle[0]();
  // A rule without a vehicle would ask for one.
  const rule = vehicle === "" ? "" : sheet.rule[0]();
  const leftward = sheet.leftward[0]();
  const placeKey = `place ${vehicle} ${rule} ${leftward} ${textKey}`;
  if (!placed || placed.held !== held || placed.vehicle !== vehicle || placed.rule !== rule || placed.leftward !== leftward) {
    if (isBroken(placeKey)) return false;
    try {
      const about = await engine.call<PlacingAbout>("place", { sheet: sheet.id, vehicle, rule, leftward }, { patience: 20_000 });
      placed = { held, vehicle, rule, leftward };
      answered = null;
      batch(() => {
        sheet.placeTrouble[1](null);
        sheet.about[1](about);
        const x = sheet.x[0]();
        // A load of the file that nobody has moved stands where the file puts it, also once its span has changed.
        const moved = x !== null && (x !== sheet.stood || vehicle !== "");
        if (!moved || x < about.from || x > about.to) {
          sheet.stood = startOf(about, moved ? x : null, vehicle === "" ? (sheet.picture[0]()?.surface_loads[0]?.[0]?.[0] ?? null) : null);
          sheet.x[1](sheet.stood);
        }
      });
    } catch (error) {
      if (!note(placeKey, error) || isBroken(placeKey)) {
        broken.set(placeKey, 2);
        batch(() => {
          sheet.placeTrouble[1](said(error));
          sheet.answer[1](null);
          sheet.zone[1](null);
          sheet.about[1](null);
        });
      }
    }
    return true;
  }

  const x = sheet.x[0]();
  if (x !== null && (!answered || answered.placed !== placed || answered.x !== x)) {
    const atKey = `at ${x} ${placeKey}`;
    if (isBroken(atKey)) return false;
    const now = placed;
    try {
      const answer = await engine.call<LiveAnswer>("at", { sheet: sheet.id, x, quick: true }, { patience: 180_000 });
      answered = { placed: now, x };
      rested = false;
      batch(() => {
        sheet.placeTrouble[1](null);
        sheet.answer[1](answer);
        sheet.zone[1](null);
      });
    } catch (error) {
      if (!note(atKey, error) || isBroken(atKey)) {
        broken.set(atKey, 2);
        answered = { placed: now, x };
        batch(() => {
          sheet.placeTrouble[1](said(error));
          sheet.answer[1](null);
        });
      }
    }
    return true;
  }

  // An open answer is settled once the load has rested for a moment.
  const open = sheet.answer[0]();
  if (open?.words.open && x !== null && open.x === x && settled !== open) {
    if (!rested) {
      clearTimeout(resting);
      resting = setTimeout(() => {
        rested = true;
        void pump();
      }, 100);
      return false;
    }
    settled = open;
    try {
      const answer = await engine.call<LiveAnswer>("at", { sheet: sheet.id, x, quick: false }, { patience: 180_000 });
      if (sheet.answer[0]() === open) sheet.answer[1](answer);
    } catch (error) {
      note(`at ${x} ${placeKey}`, error);
    }
    return true;
  }

  // The zone costs more than the line: only where the load has come to rest.
  const answer = sheet.answer[0]();
  if (answer && answer !== zoned && answer.words.factor !== null) {
    zoned = answer;
    clearTimeout(quiet);
    quiet = setTimeout(() => wantZone({ sheet, answer, vehicle, rule, leftward, key: placeKey }), 160);
  }
  return false;
}

/** Where a load first stands: where it was, where the file places its own, else a quarter of the way. */
function startOf(about: PlacingAbout, before: number | null, own: number | null): number {
  return Math.min(about.to, Math.max(about.from, before ?? own ?? about.from + 0.25 * (about.to - about.from)));
}
