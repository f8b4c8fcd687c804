/** Files that are dropped on the page or chosen: bridges open, drawings become bridges, records lie beside the open bridge. */
import { Refused } from "../engine/client";
import { liveEngine, poke } from "../model/live";
import { keepFiles } from "../model/storage";
import { active, MOST_FILE, MOST_TEXT, open, say } from "../model/workspace";

const clean = (name: string): string => name.replace(/[^\w.\- ()]/g, "_").slice(0, 100);

export async function openFiles(files: File[]): Promise<void> {
  const bridges = files.filter((file) => /\.toml$/i.test(file.name));
  const drawings = files.filter((file) => /\.dxf$/i.test(file.name));
  const others = files.filter((file) => !bridges.includes(file) && !drawings.includes(file));
  for (const file of files) {
    const most = /\.toml$/i.test(file.name) ? MOST_TEXT : MOST_FILE;
    if (file.size > most) {
      say(`${file.name} has ${(file.size / 1e6).toFixed(0)} MB; ${most / 1e6} MB is the most that is opened.`, true);
      return;
    }
  }
  const companions: [string, Uint8Array][] = [];
  for (const file of [...others, ...(bridges.length > 0 ? drawings : [])]) companions.push([clean(file.name), new Uint8Array(await file.arrayBuffer())]);
  for (const file of bridges) open({ path: clean(file.name), text: await file.text() }, companions);
  if (bridges.length > 0) return;
  for (const file of drawings) {
    const name = clean(file.name);
    const bytes = new Uint8Array(await file.arrayBuffer());
    try {
      const text = await liveEngine.call<string>("fromDxf", { name, bytes: bytes.slice() }, { patience: 30_000 });
      open({ path: name.replace(/\.dxf$/i, ".toml"), text }, [[name, bytes]]);
    } catch (error) {
      say(`${file.name} is no drawing that can be used. ${(error as Error).message}${error instanceof Refused ? ` ${error.help}` : ""}`, true);
    }
  }
  if (drawings.length > 0) return;
  const sheet = active();
  if (companions.length === 0) return;
  if (!sheet) {
    say("Open the bridge first; then its records can be dropped on it.", true);
    return;
  }
  for (const [name, bytes] of companions) sheet.put(name, bytes);
  void keepFiles(sheet.id, [...sheet.files]);
  poke();
  say(`${companions.map(([name]) => name).join(", ")} now ${companions.length === 1 ? "lies" : "lie"} beside ${sheet.path}.`);
}
