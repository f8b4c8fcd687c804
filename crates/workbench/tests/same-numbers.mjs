// Every example by the engine in WebAssembly and by the command: the same words, and numbers as close as the platforms' sines allow.
//
//     node crates/workbench/tests/same-numbers.mjs target/release/extrados [--quick] [FOLDER/NAME...]
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
/** The load with dilation is the lower of two bounds that each run proves. A program ends where the two meet to 1e-9 of its scaled load, wherever
 * between them that is: two runs are apart by no more than their bounds, and those by no more than this. */
const PROVEN_GAP = 1e-8;
/** What is left of a balance of forces, how often a solver went round and how many programs it took, by which solver, is round-off itself; which of
 * several cases that are alike is named as the extreme one of a section too. A point of a mesh yields once it has reached its surface by however little. */
const NO_ANSWERS = /residual|violation|iterations|unbalanced|energy_drift|spread|vehicles\.cases|by_interior_point|extremes\.case|yielding_elements/;
/** Forces of a section at collapse under vehicles are those of one of several states that carry the same. */
const STATES = /sections\.extremes/;
/** Discrete elements come to rest where forces are balanced to a tolerance, some steps earlier or later: loads are the same, displacements and stresses
 * agree to a hundredth of the largest. */
const AT_REST = 0.01;
const LOADS = /load|headline/;

/** A passage is solved to the `tolerance` of its file, 1e-6 of its forces: so far two of them may be apart, with all that is compared with records, as
 * shares of the peaks that were measured. */
const PASSAGE = 1e-6;
const ERRORS = /error/;
/** What data can tell of a parameter, and of the error of the model, is sampled, until 10,000 samples are as good as independent: two runs whose inputs differ in a last bit draw
 * differently. The standard error of a correlation is then 0.01, that of a standard deviation 0.007 of it and that of an end of a 95 % interval, where
 * the density of a normal distribution is 0.058, 0.027 of a standard deviation. Of a difference of two runs they are the root of two larger, and four
 * of them hold all that is compared here. */
const SAMPLED = (4 * Math.SQRT2) / Math.sqrt(10_000);
const POSTERIOR = /standard_deviation|interval_95|correlation(?!s)|model_error/;

/** What only the command knows: its clock, its folder. */
const OF_THE_COMMAND = ["wall_seconds", "threads", "version", "out", "files", "stages", "input_hash", "evaluations_taken_up"];
function ofTheCommand(result) {
  OF_THE_COMMAND.forEach((key) => delete result[key]);
  for (const search of result.searches ?? []) delete search.seconds;
}

/** Bridges that are their own mirror image, with their length [m]: a vehicle carries as much as its image that travels the other way, and which of
 * both is named as the worst is round-off. */
const MIRRORED = { "bridgemill/assess.toml": 18.3, "road-bridge/bridge.toml": 9.0 };

/** Left out by `--quick`: up to minutes each, and another example goes through the same code; `.ci/wasm` holds the passage as well. */
const SLOW = ["bridgemill/assess.toml", "bridgemill/case-4.toml", "viaduct/bridge.toml sweep ", "skew-railway/bridge.toml", "road-bridge/bridge.toml", "defects/bridge.toml", "railway-arch/passage.toml", "railway-arch/update.toml"];

const [program, ...words] = process.argv.slice(2);
const quick = words.includes("--quick");
const only = words.filter((word) => word !== "--quick");
const collapse = (method) => ["collapse", method];
const wanted = [
  ...["case-1", "case-2", "case-4", "whole", "parabola", "pressure"].map((name) => ["bridgemill", `${name}.toml`, ...collapse("limit")]),
  ...["tiny", "two-span", "two-ring", "defects", "viaduct", "skew-railway"].map((name) => [name, "bridge.toml", ...collapse("limit")]),
  ["packhorse", "bridge.toml", ...collapse("limit")],
  ["prestwood", "limit.toml", ...collapse("limit")],
  ["semicircle", "ring.toml", ...collapse("")],
  ["settlement", "bridge.toml", ...collapse("")],
  ["drawing", "bridge.toml", ...collapse("limit")],
  ["bridgemill", "case-1.toml", ...collapse("dem")],
  ["bridgemill", "case-1.toml", ...collapse("path")],
  ["two-span", "bridge.toml", ...collapse("path")],
  ["bridgemill", "case-1.toml", "sweep", "limit"],
  ["bridgemill", "hb-45.toml", "sweep", "limit"],
  ["tiny", "bridge.toml", "sweep", "limit"],
  ["two-span", "bridge.toml", "sweep", "limit"],
  ["packhorse", "cases.toml", "cases", ""],
  ["viaduct", "bridge.toml", "sweep", "limit"],
  ["viaduct", "bridge.toml", "sweep", ""],
  ["tiny", "bridge.toml", "assess", ""],
  ["bridgemill", "assess.toml", "assess", ""],
  ["railway-arch", "passage.toml", "respond", ""],
  ["railway-arch", "update.toml", "update", ""],
]
  .filter(([folder, name, ...asked]) => !quick || ![`${folder}/${name}`, [`${folder}/${name}`, ...asked].join(" ")].some((one) => SLOW.includes(one)))
  .filter(([folder, name, kind]) => only.length === 0 || only.includes(`${folder}/${name}`) || only.includes(kind));

/** The command line of each kind, and the call of the engine. */
const DAY = "2026-01-01";
const KINDS = {
  collapse: [["collapse"], (document, choice) => engine.collapse(document, choice, () => undefined)],
  sweep: [["collapse", "--sweep"], (document, choice) => engine.sweep(document, choice, NaN, () => undefined)],
  cases: [["cases"], (document, choice) => engine.cases(document, choice, () => undefined)],
  respond: [["respond"], (document) => engine.respond(document, () => undefined)],
  update: [["update"], (document) => engine.update(document, () => undefined)],
  assess: [["assess"], (document) => engine.assess(document, DAY, () => undefined)],
};

/** How far the bounds of a run are apart, as a share of the upper one. */
function gap({ associated_load_kn_per_m: lower, upper_bound_kn_per_m: upper }) {
  const share = 1 - lower / upper;
  return share >= 0 && share <= PROVEN_GAP ? share : 0;
}

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
  // Sentences hold numbers too, rounded; those of what was sampled are no closer than it.
  return typeof value === "string" && /^\.told/.test(key) ? value.replace(/\d+(\.\d+)?/g, "#") : value;
}

/** A result of a bridge of this length [m] as of the vehicle's way that comes first from either end. */
function unmirrored(value, length) {
  if (typeof value === "string") return value.replace(/travelling to the (left|right)/g, "travelling").replace(/first axle at [\d.]+ m/g, "first axle");
  if (Array.isArray(value)) return value.map((one) => unmirrored(one, length));
  if (!value || typeof value !== "object") return value;
  return Object.fromEntries(
    Object.entries(value).map(([key, one]) => {
      if (key === "position_m" && typeof one === "number") return [key, Math.min(one, length - one)];
      if (key === "direction") return [key, "either"];
      return [key, unmirrored(one, length)];
    }),
  );
}

/** Hinges of two results without those that one of them alone counts and that turn by less than a mechanism is certain to, beside its largest turn. */
function certain(mine, theirs) {
  const name = ({ between, edge }) => `${between} ${edge}`;
  const [one, other] = [mine, theirs].map(({ hinges = [] }) => new Set(hinges.map(name)));
  for (const result of [mine, theirs].filter((each) => each.hinges)) {
    const most = Math.max(...result.hinges.map(({ rotation }) => Math.abs(rotation)));
    result.hinges = result.hinges.filter((hinge) => (one.has(name(hinge)) && other.has(name(hinge))) || Math.abs(hinge.rotation) > OF_SEVERAL * most);
  }
}

function bound(kind, method, level, key, gaps, scale) {
  if (NO_ANSWERS.test(key)) return Infinity;
  if (kind === "update" && POSTERIOR.test(key)) return SAMPLED;
  if (kind === "respond" || kind === "update") return ERRORS.test(key) ? PASSAGE / scale : PASSAGE;
  if (/associated_load/.test(key) && !/non_associated/.test(key)) return ROUND_OFF + gaps;
  if (STATES.test(key)) return OF_SEVERAL;
  const load = LOADS.test(key) && !/thrust/.test(key);
  if (method === "dem") return load && !/limit_load/.test(key) ? 0 : AT_REST;
  if (!level || /associated_load|upper_bound/.test(key)) return load || /bound/.test(key) ? ROUND_OFF : ROOT;
  return load || /bound/.test(key) ? ITERATED : OF_SEVERAL;
}

let failed = 0;
const scratch = mkdtempSync(join(tmpdir(), "extrados-same-"));
for (const [folder, name, kind, method] of wanted) {
  const begin = Date.now();
  const [command, call] = KINDS[kind];
  const path = `examples/${folder}/${name}`;
  const out = join(scratch, `${folder}-${name}-${kind}-${method}`);
  const flags = method ? ["--method", method] : [];
  let refused = null;
  try {
    execFileSync(program, [...command, path, "--out", out, "--quiet", ...flags], { cwd: root, stdio: "pipe" });
  } catch (error) {
    // Answers have exit codes of their own.
    refused = error;
  }
  const document = example(folder, name);
  let result;
  try {
    result = call(document, JSON.stringify(method ? { method } : {}));
  } catch (error) {
    if (error.name !== "Refusal") throw error;
    const theirs = refused?.stderr?.toString() ?? "";
    const same = theirs.includes(error.code);
    console.log(`${same ? "same" : "DIFFERENT"}  ${path} ${kind} ${method}: refused, ${error.code}`);
    failed += same ? 0 : 1;
    continue;
  }
  const length = MIRRORED[`${folder}/${name}`];
  const [mine, theirs] = [result.json, readFileSync(join(out, "result.json"), "utf8")].map((text) => {
    const read = JSON.parse(text);
    ofTheCommand(read);
    return length === undefined ? read : unmirrored(read, length);
  });
  if (theirs.friction === "non-associated") certain(mine, theirs);
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
    const most = bound(kind, method, theirs.friction === "non-associated", key, Math.max(gap(mine), gap(theirs)), scale.get(key));
    if (most < Infinity && apart > worst) [worst, where] = [apart, key];
    if (apart > most) beyond.push(`${key}: ${numbers[0][k][1]} and ${value}`);
  }
  const same = words[0] === words[1] && numbers[0].length === numbers[1].length && beyond.length === 0;
  const told = `${exact} of ${numbers[1].length} numbers to the last bit, the others within ${worst.toExponential(1)} ${where}`;
  console.log(`${same ? "same" : "DIFFERENT"}  ${path} ${kind} ${method}: ${mine.status}, ${told}, ${Math.round((Date.now() - begin) / 1000)} s`);
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
