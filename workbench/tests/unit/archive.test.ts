import { deflateRawSync } from "node:zlib";
import { expect, test } from "vitest";
import { resultFolder, unzip } from "../../src/model/archive";

const bytes = (text: string): Uint8Array => new TextEncoder().encode(text);

/** An archive of these files, as any program makes one; the first is deflated. */
function zipped(files: [string, string][]): Uint8Array {
  const parts: Buffer[] = [];
  const list: Buffer[] = [];
  let at = 0;
  files.forEach(([name, text], k) => {
    const raw = k === 0 ? deflateRawSync(text) : Buffer.from(text);
    const head = Buffer.alloc(26);
    head.writeUInt16LE(20, 0);
    head.writeUInt16LE(k === 0 ? 8 : 0, 4);
    head.writeUInt32LE(raw.length, 14);
    head.writeUInt32LE(text.length, 18);
    head.writeUInt16LE(name.length, 22);
    const local = Buffer.concat([Buffer.from("PK\x03\x04", "latin1"), head, Buffer.from(name), raw]);
    const rest = Buffer.alloc(14);
    rest.writeUInt32LE(at, 10);
    list.push(Buffer.concat([Buffer.from("PK\x01\x02\x14\x00", "latin1"), head, rest, Buffer.from(name)]));
    parts.push(local);
    at += local.length;
  });
  const whole = Buffer.concat(list);
  const end = Buffer.alloc(18);
  end.writeUInt16LE(files.length, 6);
  end.writeUInt32LE(whole.length, 8);
  end.writeUInt32LE(at, 12);
  return new Uint8Array(Buffer.concat([...parts, whole, Buffer.from("PK\x05\x06", "latin1"), end]));
}

test("stored and deflated files come out as they went in, and what is no archive is told", async () => {
  const archive = zipped([["out/result.json", '{"schema": 1}\n'.repeat(50)], ["out/bridge.toml", "[bridge]\n"]]);
  const entries = await unzip(archive);
  expect(entries.map(({ name }) => name)).toEqual(["out/result.json", "out/bridge.toml"]);
  expect(new TextDecoder().decode(entries[0]!.bytes)).toBe('{"schema": 1}\n'.repeat(50));
  expect(new TextDecoder().decode(entries[1]!.bytes)).toBe("[bridge]\n");
  await expect(unzip(bytes("no archive"))).rejects.toThrow("no zip");
  await expect(unzip(archive.slice(0, archive.length - 30))).rejects.toThrow();
  const broken = archive.slice();
  broken[45] = broken[45]! ^ 0xff;
  await expect(unzip(broken)).rejects.toThrow();
});

test("a folder is one of results by its result.json, wherever that lies", () => {
  const json = bytes('{"schema": "extrados.collapse/1", "status": "collapsed"}');
  const found = resultFolder([{ name: "a/out/result.json", bytes: json }, { name: "a/out/path.csv", bytes: bytes("") }, { name: "a/mine.toml", bytes: bytes("") }])!;
  expect(found.files.map(({ name }) => name)).toEqual(["result.json", "path.csv"]);
  expect(found.bridge!.name).toBe("a/mine.toml");
  expect(resultFolder([{ name: "path.csv", bytes: bytes("") }])).toBe(null);
  expect(() => resultFolder([{ name: "result.json", bytes: bytes('{"schema": "other/1"}') }])).toThrow("no result of Extrados");
});
