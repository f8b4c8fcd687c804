/** How long pictures take from the pointer on, for whoever listens to the browser's own timings. */
let count = 0;

export function fromPointer(name: string, start: number): void {
  try {
    performance.measure(name, { start, end: performance.now() });
    count += 1;
    if (count % 256 === 0) performance.clearMeasures(name);
  } catch {
    // Timings are for tests.
  }
}
