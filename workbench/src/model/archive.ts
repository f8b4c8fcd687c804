/** What lies in a zip: stored or deflated files, as archives of results have them. */

export type Entry = { name: string; bytes: Uint8Array };

/** Files beyond this in all [bytes] are not unpacked: no folder of results is so large. */
const MOST = 400e6;

const END = 0x06054b50;
const CENTRAL = 0x02014b50;
const LOCAL = 0x04034b50;

async function inflated(bytes: Uint8Array): Promise<Uint8Array> {
  const stream = new Blob([bytes as BlobPart]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Every file of an archive. Throws in words where it cannot be read. */
export async function unzip(bytes: Uint8Array): Promise<Entry[]> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let end = bytes.length - 22;
  while (end >= 0 && bytes.length - end < 66_000 && view.getUint32(end, true) !== END) end -= 1;
  if (end < 0 || bytes.length - end >= 66_000) throw new Error("It is no zip archive, or not all of one.");
  const count = view.getUint16(end + 10, true);
  const words = new TextDecoder();
  const entries: Entry[] = [];
  let at = view.getUint32(end + 16, true);
  let whole = 0;
  for (let k = 0; k < count; k += 1) {
    if (at + 46 > bytes.length || view.getUint32(at, true) !== CENTRAL) throw new Error("Its list of files is broken.");
    const [method, packed, size] = [view.getUint16(at + 10, true), view.getUint32(at + 20, true), view.getUint32(at + 24, true)];
    const [nameLength, extra, comment, local] = [view.getUint16(at + 28, true), view.getUint16(at + 30, true), view.getUint16(at + 32, true), view.getUint32(at + 42, true)];
    const name = words.decode(bytes.subarray(at + 46, at + 46 + nameLength));
    at += 46 + nameLength + extra + comment;
    if (name.endsWith("/")) continue;
    whole += size;
    if (whole > MOST) throw new Error(`Unpacked it is larger than ${MOST / 1e6} MB.`);
    if (local + 30 > bytes.length || view.getUint32(local, true) !== LOCAL) throw new Error(`${name} in it is broken.`);
    const begin = local + 30 + view.getUint16(local + 26, true) + view.getUint16(local + 28, true);
    const raw = bytes.subarray(begin, begin + packed);
    if (method !== 0 && method !== 8) throw new Error(`${name} in it is packed in a way that is not known here.`);
    const own = method === 0 ? raw.slice() : await inflated(raw);
    if (own.length !== size) throw new Error(`${name} in it is not whole.`);
    entries.push({ name, bytes: own });
  }
  return entries;
}

/** A folder of results among files, by where its result.json lies. */
export type ResultFolder = { json: string; object: Record<string, unknown>; files: Entry[]; bridge: Entry | null };

/** The folder of results that these files are, its names from where result.json lies; null where there is none. */
export function resultFolder(files: Entry[]): ResultFolder | null {
  const found = files.filter(({ name }) => /(^|\/)result\.json$/.test(name)).sort((a, b) => a.name.length - b.name.length)[0];
  if (!found) return null;
  const folder = found.name.slice(0, -"result.json".length);
  const own = files.filter(({ name }) => name.startsWith(folder)).map(({ name, bytes }) => ({ name: name.slice(folder.length), bytes }));
  const json = new TextDecoder().decode(found.bytes);
  let object: unknown;
  try {
    object = JSON.parse(json);
  } catch {
    throw new Error("Its result.json is no JSON.");
  }
  if (typeof object !== "object" || object === null || !/^extrados\.[\w-]+\/\d+$/.test(String((object as { schema?: unknown }).schema))) throw new Error("Its result.json is no result of Extrados.");
  const bridge = own.find(({ name }) => /^[^/]+\.toml$/i.test(name)) ?? files.find(({ name }) => /\.toml$/i.test(name)) ?? null;
  return { json, object: object as Record<string, unknown>, files: own, bridge };
}
