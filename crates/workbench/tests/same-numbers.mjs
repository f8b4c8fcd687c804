// Every example by the engine in WebAssembly and by the command: the same words, and numbers as close as the platforms' sines allow.
//
//     node crates/workbench/tests/same-numbers.mjs target/release/extrados [FOLDER/NAME...]
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { engine, example, root } from "./engine.mjs";

/** Sines, angles and their like come from the C library in the command and from Rust's own in the module, and may differ in their last bit; so
 * do the coordinates of blocks, by some 1e-16 of the bridge. Limit analysis carries that on as round-off of its solvers. */
const ROUND_OFF = 1e-9;
/** Forces of joints that do not move, and the mechanism, which is the multipliers of those programs, are certain to the root of the 1e-9 to which the
 * programs are solved. */
const ROOT = 1e-4;
/** Without dilation a load is the end of an iteration from several starts, whose ends are one where they agree to 1e-4; forces and mechanism of such an
 * end are one of several that carry nearly the same. */
const ITERATED = 1e-4;
const OF_SEVERAL = 0.02;
/** What is left of a balance of forces, and how often a solver went round, is round-off itself. */
const NO_ANSWERS = /residual|violation|iterations|unbalanced|energy_drift|spread/;
/** Discrete elements come to rest where forces are balanced to a tolerance, some steps earlier or later: loads are the same, displacements and stresses
 * agree to a hundredth of the largest. */
const AT_REST = 0.01;
const LOADS = /load|headline/;

/** What only the command knows. */
const OF_THE_COMMAND = ["wall_seconds", "threads", "out", "files"];

const [program, ...only] = process.argv.slice(2);
const wanted = [
  ...["case-1", "case-2", "case-4", "whole", "parabola", "pressure"].map((name) => ["bridgemill", `${name}.toml`, "limit"]),
  ...["tiny", "two-span", "two-ring", "defects", "viaduct", "skew-railway"].map((name) => [name, "bridge.toml", "limit"]),
  ["packhorse", "bridge.toml", "limit"],
  ["prestwood", "limit.toml", "limit"],
  ["semicircle", "ring.toml", ""],
  ["settlement", "bridge.toml", ""],
  ["drawing", "bridge.toml", "limit"],
  ["bridgemill", "case-1.toml", "dem"],
  ["bridgemill", "case-1.toml", "path"],
  ["two-span", "bridge.toml", "path"],
].filter(([folder, name]) => only.length === 0 || only.includes(`${folder}/${name}`));

/** Every number below a value with the keys that lead to it, and the value with its numbers taken out. */
function taken(value, key, numbers) {
  if (typeof value === "number") {
    numbers.push([key, value]);
    return null;
  }
  if (Array.isArray(value)) return value.map((one) => taken(one, key, numbers));
  if (value && typeof value === "object") {
    return Object.fromEntries(Object.entries(value).map(([name, one]) => [name, taken(one, `${key}.${name}`, numbers)]));
  }
  // Sentences hold numbers too, rounded.
  return value;
}

function bound(method, level, key) {
  if (NO_ANSWERS.test(key)) return Infinity;
  const load = LOADS.test(key) && !/thrust/.test(key);
  if (method === "dem") return load && !/limit_load/.test(key) ? 0 : AT_REST;
  if (!level || /associated_load|upper_bound/.test(key)) return load || /bound/.test(key) ? ROUND_OFF : ROOT;
  return load || /bound/.test(key) ? ITERATED : OF_SEVERAL;
}

let failed = 0;
const scratch = mkdtempSync(join(tmpdir(), "extrados-same-"));
for (const [folder, name, method] of wanted) {
  const path = `examples/${folder}/${name}`;
  const out = join(scratch, `${folder}-${name}-${method}`);
  const flags = method ? ["--method", method] : [];
  let refused = null;
  try {
    execFileSync(program, ["collapse", path, "--out", out, "--quiet", ...flags], { cwd: root, stdio: "pipe" });
  } catch (error) {
    // Answers have exit codes of their own.
    refused = error;
  }
  const document = example(folder, name);
  let result;
  try {
    result = engine.collapse(document, JSON.stringify(method ? { method } : {}), () => undefined);
  } catch (error) {
    if (error.name !== "Refusal") throw error;
    const theirs = refused?.stderr?.toString() ?? "";
    const same = theirs.includes(error.code);
    console.log(`${same ? "same" : "DIFFERENT"}  ${path} ${method}: refused, ${error.code}`);
    failed += same ? 0 : 1;
    continue;
  }
  const [mine, theirs] = [JSON.parse(result.json), JSON.parse(readFileSync(join(out, "result.json"), "utf8"))];
  OF_THE_COMMAND.forEach((key) => delete theirs[key]);
  const numbers = [[], []];
  const words = [mine, theirs].map((value, k) => JSON.stringify(taken(value, "", numbers[k])));
  let [worst, where, exact] = [0, "", 0];
  const scale = new Map();
  for (const [key, value] of numbers[1]) scale.set(key, Math.max(scale.get(key) ?? 1e-300, Math.abs(value)));
  const beyond = [];
  for (let k = 0; k < Math.min(numbers[0].length, numbers[1].length); k++) {
    const [key, value] = numbers[1][k];
    const apart = Math.abs(numbers[0][k][1] - value) / scale.get(key);
    exact += apart === 0 ? 1 : 0;
    const most = bound(method, theirs.friction === "non-associated", key);
    if (most < Infinity && apart > worst) [worst, where] = [apart, key];
    if (apart > most) beyond.push(`${key}: ${numbers[0][k][1]} and ${value}`);
  }
  const same = words[0] === words[1] && numbers[0].length === numbers[1].length && beyond.length === 0;
  const told = `${exact} of ${numbers[1].length} numbers to the last bit, the others within ${worst.toExponential(1)} ${where}`;
  console.log(`${same ? "same" : "DIFFERENT"}  ${path} ${method}: ${mine.status}, ${told}`);
  if (!same) {
    failed += 1;
    beyond.slice(0, 5).forEach((line) => console.log(`    ${line}`));
    if (words[0] !== words[1]) {
      const at = [...words[0]].findIndex((char, k) => char !== words[1][k]);
      console.log(`    words: ${words[0].slice(at - 60, at + 120)}\n    and:   ${words[1].slice(at - 60, at + 120)}`);
    }
  }
  result.free();
  document.free();
}
rmSync(scratch, { recursive: true });
if (failed > 0) {
  console.error(`${failed} of ${wanted.length} are different`);
  process.exit(1);
}
