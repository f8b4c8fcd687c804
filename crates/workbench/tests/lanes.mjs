// The places of an envelope shared by several workers, as the page does: the same numbers, and what is gained on this machine.
//
//     node crates/workbench/tests/lanes.mjs
import { availableParallelism } from "node:os";
import { isMainThread, parentPort, Worker, workerData } from "node:worker_threads";
import { engine, example } from "./engine.mjs";

const CASES = [
  ["bridgemill", "case-1.toml", "", ""],
  ["viaduct", "bridge.toml", "", "characteristic"],
  ["viaduct", "bridge.toml", "lm1", "characteristic"],
];
const COUNT = 81;
/** Each place is a program of its own that starts from the mechanisms of the places before: the same to the round-off of its solver. */
const ROUND_OFF = 1e-9;

if (!isMainThread) {
  const [folder, name, vehicle, rule] = CASES[workerData];
  const placing = new engine.Placing(example(folder, name), vehicle, rule, false);
  const { from, to } = JSON.parse(placing.about());
  parentPort.on("message", (k) => {
    const begin = performance.now();
    const factor = placing.factor(from + ((to - from) * k) / (COUNT - 1))[0];
    parentPort.postMessage([k, factor, performance.now() - begin]);
  });
  parentPort.postMessage(null);
} else {
  const envelope = (which, lanes) =>
    new Promise((resolve, reject) => {
      const left = Array.from({ length: COUNT }, (_, k) => k);
      const found = new Float64Array(COUNT);
      let [done, ready, begin] = [0, 0, 0];
      const workers = Array.from({ length: lanes }, () => new Worker(new URL(import.meta.url), { workerData: which }));
      const next = (worker) => left.length > 0 && worker.postMessage(left.shift());
      for (const worker of workers) {
        worker.on("error", reject);
        worker.on("message", (said) => {
          if (said === null) {
            ready += 1;
            if (ready < lanes) return;
            begin = performance.now();
            workers.forEach(next);
            return;
          }
          found[said[0]] = said[1];
          done += 1;
          if (done < COUNT) return next(worker);
          const took = performance.now() - begin;
          void Promise.all(workers.map((one) => one.terminate())).then(() => resolve([found, took]));
        });
      }
    });
  let failed = false;
  for (const [which, [folder, name, vehicle]] of CASES.entries()) {
    const [one, alone] = await envelope(which, 1);
    const [two, shared] = await envelope(which, 2);
    let [worst, exact] = [0, 0];
    for (let k = 0; k < COUNT; k++) {
      exact += Object.is(one[k], two[k]) ? 1 : 0;
      worst = Math.max(worst, Number.isNaN(one[k]) && Number.isNaN(two[k]) ? 0 : Math.abs(one[k] / two[k] - 1));
    }
    const same = worst <= ROUND_OFF;
    failed ||= !same;
    console.log(
      `${same ? "same" : "DIFFERENT"}  ${folder}/${name} ${vehicle}: ${exact} of ${COUNT} factors to the last bit, the others within ${worst.toExponential(1)}; ` +
        `${alone.toFixed(0)} ms by one worker, ${shared.toFixed(0)} ms by two, of ${availableParallelism()} processors`,
    );
  }
  process.exit(failed ? 1 : 0);
}
