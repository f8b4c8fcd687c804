/** An analysis that a part asks the background worker for, and what became of it. */
import { createSignal, type Signal } from "solid-js";
import { Lost, Refused, sentences } from "../engine/client";
import type { ResultOut } from "../engine/types";
import { background } from "./background";
import type { Sheet } from "./sheet";

export type Task = { mode: "idle" | "runs" | "done" | "failed"; words: string; fraction: number; result: (ResultOut & { object: Record<string, unknown> }) | null; texts: string[]; trouble: string };
const IDLE: Task = { mode: "idle", words: "", fraction: NaN, result: null, texts: [], trouble: "" };

const tasks = new WeakMap<Sheet, Map<string, Signal<Task>>>();

/** The task of a kind on a sheet. */
export function taskOf(sheet: Sheet, kind: string): Signal<Task> {
  const own = tasks.get(sheet) ?? new Map<string, Signal<Task>>();
  tasks.set(sheet, own);
  const found = own.get(kind) ?? createSignal(IDLE);
  own.set(kind, found);
  return found;
}

/** Opens these sheets in the background worker and asks for an analysis of the first, under a name of its own. */
export async function perform(sheets: [Sheet, string][], kind: string, args: Record<string, unknown>): Promise<void> {
  const sheet = sheets[0]![0];
  const [, set] = taskOf(sheet, kind);
  const texts = sheets.map(([, text]) => text);
  set({ ...IDLE, mode: "runs", texts });
  try {
    for (const [k, [one, text]] of sheets.entries()) await background.call("open", { sheet: nameOf(one, k), path: one.path, text, files: [...one.files] }, { patience: 15_000 });
    const out = await background.call<ResultOut>(kind, { sheet: nameOf(sheet, 0), run: runOf(sheet, kind), ...args }, { tell: (words, fraction) => set((old) => ({ ...old, words, fraction })) });
    set((old) => ({ ...old, mode: "done", result: { ...out, object: JSON.parse(out.json) } }));
  } catch (error) {
    const stopped = error instanceof Lost && error.why === "stopped";
    const trouble = stopped ? "" : error instanceof Refused ? sentences(error) : `The engine broke down and was started again. ${(error as Error).message}`;
    set((old) => ({ ...old, mode: trouble ? "failed" : "idle", trouble }));
  }
}

/** By which the worker knows the kth bridge of a task: the same sheet may stand beside itself as it was. */
export const nameOf = (sheet: Sheet, k: number): string => (k === 0 ? sheet.id : `${sheet.id} beside ${k}`);
export const runOf = (sheet: Sheet, kind: string): string => `${kind}-${sheet.id}`;
