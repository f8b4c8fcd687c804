/** Files that are dropped on the page or chosen: bridges open, drawings are drawn and become block models, folders of results are shown, records lie beside the
 * open bridge. */
import { Refused } from "../engine/client";
import { resultFolder, unzip, type Entry, type ResultFolder } from "../model/archive";
import { liveEngine, poke } from "../model/live";
import { keepFiles } from "../model/storage";
import { active, MOST_FILE, MOST_TEXT, open, say, setPart } from "../model/workspace";
import { setTab } from "../parts/BridgePanel";
import { showFolder } from "../parts/Verdict";

const clean = (name: string): string => name.replace(/[^\w.\- ()]/g, "_").slice(0, 100);

/** Files of a drop, with those in its folders; each with its name below what was dropped. */
export async function filesOf(data: DataTransfer | null): Promise<File[]> {
  const entries = [...(data?.items ?? [])].map((item) => item.webkitGetAsEntry?.() ?? null);
  if (!entries.some((entry) => entry?.isDirectory)) return [...(data?.files ?? [])];
  const found: File[] = [];
  const visit = async (entry: FileSystemEntry, path: string): Promise<void> => {
    if (found.length > MOST_IN_FOLDER) return;
    if (entry.isFile) {
      const file = await new Promise<File>((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject));
      found.push(new File([file], path + file.name, { type: file.type }));
      return;
    }
    const reader = (entry as FileSystemDirectoryEntry).createReader();
    for (;;) {
      const some = await new Promise<FileSystemEntry[]>((resolve, reject) => reader.readEntries(resolve, reject));
      if (some.length === 0) return;
      for (const one of some) await visit(one, `${path}${entry.name}/`);
    }
  };
  for (const entry of entries) if (entry) await visit(entry, "");
  return found;
}

/** More files than this are no folder of results. */
const MOST_IN_FOLDER = 2000;

/** The results among files: a zip of them, or a folder with its result.json. */
async function resultsIn(files: File[]): Promise<{ name: string; folder: ResultFolder } | null> {
  const bytes = async (file: File): Promise<Uint8Array> => new Uint8Array(await file.arrayBuffer());
  const zip = files.find((file) => /\.zip$/i.test(file.name));
  if (zip) {
    const folder = resultFolder(await unzip(await bytes(zip)));
    if (!folder) throw new Error("There is no result.json in it.");
    return { name: zip.name, folder };
  }
  const of = (file: File): string => file.webkitRelativePath || file.name;
  if (!files.some((file) => /(^|\/)result\.json$/.test(of(file)))) return null;
  const entries: Entry[] = await Promise.all(files.map(async (file) => ({ name: of(file), bytes: await bytes(file) })));
  const folder = resultFolder(entries);
  return folder && { name: of(files[0]!).split("/")[0] ?? "result.json", folder };
}

/** Shows results beside the bridge that lies in their folder, or beside the open one. */
function showResults(name: string, folder: ResultFolder): void {
  const bridge = folder.bridge;
  const own = bridge ? new TextDecoder().decode(bridge.bytes) : null;
  const there = active();
  const sheet = own !== null && there?.text() !== own ? open({ path: clean(bridge!.name.split("/").pop()!), text: own }) : there;
  if (!sheet) return say(`${name} has no bridge file in it. Open the bridge first; then its results can be dropped on it.`, true);
  const of = folder.object["bridge"];
  if (own === null && typeof of === "string" && of !== sheet.reading[0]()?.name) {
    return say(`${name} has results of “${of}” and no bridge file in it, and “${sheet.name()}” is open. Open the bridge file of “${of}” first; then its results can be dropped on it.`, true);
  }
  showFolder(sheet, name, folder);
  setPart("verdict");
  if (own === null) say(`${name} has no bridge file in it: whether it belongs to the file of ${sheet.name()} as it stands here is not known.`);
}

export async function openFiles(files: File[]): Promise<void> {
  const archive = files.find((file) => /\.zip$/i.test(file.name));
  if (archive && archive.size > MOST_FILE) return say(`${archive.name} has ${(archive.size / 1e6).toFixed(0)} MB; ${MOST_FILE / 1e6} MB is the most that is opened.`, true);
  try {
    const results = await resultsIn(files);
    if (results) return showResults(results.name, results.folder);
  } catch (error) {
    return say(`${archive?.name ?? "The folder"} cannot be opened. ${(error as Error).message}`, true);
  }
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
      setPart("bridge");
      setTab("drawn");
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
