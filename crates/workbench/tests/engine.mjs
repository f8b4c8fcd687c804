// The engine in Node.js, as a worker of the page has it.
import { readFileSync } from "node:fs";
import { join } from "node:path";

export const root = join(import.meta.dirname, "../../..");
const place = join(root, "workbench/src/engine/pkg");
export const engine = await import(join(place, "extrados_workbench.js"));
engine.initSync({ module: readFileSync(join(place, "extrados_workbench_bg.wasm")) });
engine.start((message) => console.error(message));

/** An example as a document at the path that the command is given, with the files beside it. */
export function example(folder, name) {
  const listed = JSON.parse(engine.examples()).find((one) => one.name === folder);
  const text = (file) => new TextDecoder().decode(engine.example_file(folder, file));
  const document = new engine.Document(`examples/${folder}/${name}`, text(name));
  for (const { name: other } of listed.files) {
    if (other !== name) document.put(`examples/${folder}/${other}`, engine.example_file(folder, other));
  }
  return document;
}

/** Seconds of processor time of this process, compilation of the module included. */
export function seconds() {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1e6;
}
