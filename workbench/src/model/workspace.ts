/** Every bridge that is open, and what is kept of them on this machine against a closed tab. */
import { batch, createSignal } from "solid-js";
import { Sheet, type Kept } from "./sheet";
import { filesOf, forgetFiles, keepFiles } from "./storage";

export type Part = "bridge" | "load" | "collapse" | "train" | "verdict" | "cases" | "compare";

const KEY = "extrados.workspace.1";
/** Texts beyond this are not opened: no bridge needs them. */
export const MOST_TEXT = 2_000_000;
export const MOST_FILE = 60_000_000;
const MOST_SHEETS = 12;

export const [sheets, setSheets] = createSignal<Sheet[]>([]);
export const [activeId, setActiveId] = createSignal("");
export const [part, setPart] = createSignal<Part>("bridge");
export const [notice, setNotice] = createSignal<{ text: string; bad: boolean } | null>(null);

export function active(): Sheet | null {
  return sheets().find((sheet) => sheet.id === activeId()) ?? null;
}

export function open(kept: Partial<Kept> & { path: string; text: string }, files: [string, Uint8Array][] = []): Sheet | null {
  if (kept.text.length > MOST_TEXT) {
    say(`${kept.path} is longer than ${MOST_TEXT / 1e6} million characters; no bridge file is. It was not opened.`, true);
    return null;
  }
  if (sheets().length >= MOST_SHEETS) {
    say(`${MOST_SHEETS} bridges are open. Close one first.`, true);
    return null;
  }
  const sheet = new Sheet(kept);
  for (const [name, bytes] of files) sheet.put(name, bytes);
  batch(() => {
    setSheets([...sheets(), sheet]);
    setActiveId(sheet.id);
  });
  if (files.length > 0) void keepFiles(sheet.id, files);
  return sheet;
}

export function close(id: string): void {
  const list = sheets();
  const at = list.findIndex((sheet) => sheet.id === id);
  if (at < 0) return;
  const rest = list.filter((sheet) => sheet.id !== id);
  batch(() => {
    setSheets(rest);
    if (activeId() === id) setActiveId((rest[Math.max(0, at - 1)] ?? rest[0])?.id ?? "");
  });
  void forgetFiles(id);
}

let leaving: ReturnType<typeof setTimeout> | undefined;

/** Words over the page; what is no trouble leaves once it could be read. */
export function say(text: string, bad = false): void {
  clearTimeout(leaving);
  setNotice({ text, bad });
  if (!bad) leaving = setTimeout(() => setNotice((now) => (now?.text === text ? null : now)), 12_000);
}

export function keep(): void {
  try {
    localStorage.setItem(KEY, JSON.stringify({ sheets: sheets().map((sheet) => sheet.kept()), active: activeId(), part: part() }));
  } catch {
    // A full or forbidden store: the work is still in this tab.
  }
}

/** What was kept; anything that does not look like it is passed over. */
export async function restore(): Promise<boolean> {
  let found: unknown;
  try {
    found = JSON.parse(localStorage.getItem(KEY) ?? "null");
  } catch {
    return false;
  }
  if (typeof found !== "object" || found === null || !Array.isArray((found as { sheets?: unknown }).sheets)) return false;
  const { sheets: list, active: id, part: where } = found as { sheets: Kept[]; active?: string; part?: Part };
  for (const kept of list.slice(0, MOST_SHEETS)) {
    if (typeof kept?.text !== "string" || typeof kept.path !== "string" || typeof kept.id !== "string") continue;
    const sheet = open(kept);
    if (sheet) for (const [name, bytes] of await filesOf(kept.id)) sheet.put(name, bytes);
  }
  if (sheets().some((sheet) => sheet.id === id)) setActiveId(id!);
  if (where && ["bridge", "load", "collapse", "train", "verdict", "cases", "compare"].includes(where)) setPart(where);
  return sheets().length > 0;
}
