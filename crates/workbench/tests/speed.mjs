// How fast the engine is in WebAssembly, by processor time: the block engine beside the native one in the same run, steps of particles, a load at
// a place.
//
//     node crates/workbench/tests/speed.mjs target/release/extrados [--quick]
import { execFileSync } from "node:child_process";
import { engine, example, seconds } from "./engine.mjs";

const [program, ...words] = process.argv.slice(2);
let failed = false;

function told(what, value, unit, passes = true) {
  console.log(`${passes ? "     " : "SLOW "} ${what}: ${value.toPrecision(3)} ${unit}`);
  failed ||= !passes;
}

/** Processor time of a child that runs a command line [s], and what it prints. */
function child(words) {
  const script = 'TIMEFORMAT="%U %S"; time "$@" >/dev/null';
  const all = execFileSync("bash", ["-c", `{ ${script}; } 2>&1 | tail -1`, "bash", ...words], { encoding: "utf8" });
  const [user, system] = all.trim().split(" ").map(Number);
  return user + system;
}

function stepped(document, choice) {
  const run = new engine.Stepping(document, choice, () => undefined);
  const begin = seconds();
  while (run.advance(4096) === "");
  const spent = seconds() - begin;
  const steps = run.steps;
  run.free();
  return [spent, steps];
}

// Case 1 to collapse; a first run lets the browser's compiler come to its end.
// With the damping of the native measure, so that both go the same way.
const arch = example("bridgemill", "case-1.toml");
arch.set_text(arch.text().replace('damping = "local"', 'damping = "adaptive"').replace(/^damping_share.*$/m, ""));
stepped(arch, '{"method": "dem"}');
const [mine, steps] = stepped(arch, '{"method": "dem"}');
const five = child([program, "bench", "arch", "--repeats", "5", "--threads", "1"]);
const one = child([program, "bench", "arch", "--repeats", "1", "--threads", "1"]);
const native = (five - one) / 4;
// Both take as many steps, but for some that coming to rest takes more or less.
told("case 1 to collapse, WebAssembly", mine, "s of processor time");
told("case 1 to collapse, native", native, "s of processor time");
told("steps in a second", steps / mine, "");
told("speed of WebAssembly over native", native / mine, "(at least 0.5)", native / mine >= 0.5);

// Loads at places.
function places(document, vehicle, rule, name, count = 200) {
  const begin = seconds();
  const placing = new engine.Placing(document, vehicle, rule, false);
  const { from, to } = JSON.parse(placing.about());
  told(`${name}: prepared in`, 1e3 * (seconds() - begin), "ms");
  const each = [];
  for (let k = 0; k <= count; k++) {
    const start = performance.now();
    placing.at(from + ((to - from) * k) / count).free();
    each.push(performance.now() - start);
  }
  // On the way back, what is asked while the load rests, then what is asked while it moves. Where joints slide, the load without dilation takes up to a
  // thousand times as long: a mean would tell of these few places alone.
  for (const [ask, words] of [["at", "a place with forces and mechanism"], ["quickly", "the same under the pointer"]]) {
    const spent = [];
    for (let k = 0; k <= count; k++) {
      const before = seconds();
      placing[ask](to - ((to - from) * k) / count).free();
      spent.push(1e3 * (seconds() - before));
    }
    spent.sort((a, b) => a - b);
    told(`${name}: ${words}, median of ${count + 1}`, spent[count / 2], "ms of processor time");
    told(`${name}: ${words}, slowest; ${spent.filter((one) => one > 100).length} above 100 ms`, spent[count], "ms of processor time");
  }
  each.sort((a, b) => a - b);
  told(`${name}: slowest of the first pass`, each[count], "ms of wall clock");
  placing.free();
}
places(example("bridgemill", "case-1.toml"), "", "", "knife edge on Bridgemill");
places(example("bridgemill", "vehicles.toml"), "hb-45", "", "HB vehicle on Bridgemill", 40);
// The first vehicle of the file's sweep: RA1, four axles; nothing but a measure, of a minute.
if (!words.includes("--quick")) places(example("viaduct", "bridge.toml"), "ra1", "characteristic", "RA1 on three spans", 40);

// Particles.
const begin = seconds();
const filled = new engine.Stepping(example("bridgemill", "case-3.toml"), "{}", () => undefined);
told("case 3: packed and at rest in", seconds() - begin, "s of processor time");
const count = 2000;
filled.advance(200);
const start = seconds();
filled.advance(count);
const spent = seconds() - start;
const look = seconds();
for (let k = 0; k < 20; k++) {
  filled.advance(1);
  filled.poses();
  filled.particles();
  filled.contacts();
  filled.chains();
}
told(`case 3, ${filled.particles().length / 5} particles: steps in a second`, count / spent, "");
told("case 3: a step with everything that is drawn", (1e3 * (seconds() - look)) / 20, "ms (at most 50)", (seconds() - look) / 20 < 0.05);
process.exit(failed ? 1 : 0);
