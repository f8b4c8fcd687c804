// How fast the picture follows the hand. Measured by the browser's own timings; the figures are printed, bounds are held where the machine is idle
// enough to tell (EXTRADOS_SPEED=strict), for a wall clock among other work tells little.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { end, headline, openExample, part, until, visit } from "../browser.mjs";

after(end);
const strict = process.env.EXTRADOS_SPEED === "strict";
const quantile = (list, q) => [...list].sort((a, b) => a - b)[Math.min(list.length - 1, Math.floor(q * list.length))];

async function drag(page) {
  await page.evaluate(() => {
    window.seen = { frames: [], answers: [], long: [], painting: [], moves: 0 };
    addEventListener("pointermove", () => (window.seen.moves += 1), true);
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries()) {
        if (entry.name === "frame") {
          window.seen.frames.push(entry.startTime);
          window.seen.painting.push(entry.duration);
        }
        if (entry.name === "pointer-to-picture") window.seen.answers.push(entry.duration);
      }
    }).observe({ type: "measure" });
    new PerformanceObserver((list) => window.seen.long.push(...list.getEntries().map((entry) => entry.duration))).observe({ type: "longtask" });
  });
  const box = await page.locator(".grip.load").boundingBox();
  const scene = await page.locator(".scene").boundingBox();
  await page.mouse.move(box.x + 28, box.y + 30);
  await page.mouse.down();
  // There and back for eight seconds, a new place about every 16 ms.
  const from = scene.x + 0.25 * scene.width;
  const reach = 0.5 * scene.width;
  const begin = Date.now();
  while (Date.now() - begin < 8000) {
    const phase = ((Date.now() - begin) / 4000) * 2 * Math.PI;
    await page.mouse.move(from + reach * (0.5 - 0.5 * Math.cos(phase)), box.y + 30);
    await page.waitForTimeout(8);
  }
  await page.mouse.up();
  return page.evaluate(() => window.seen);
}

// The load of the file, then a vehicle, which a viaduct of three spans answers more slowly.
for (const [name, vehicle] of [["bridgemill", ""], ["bridgemill", "hb-45"], ["viaduct", ""], ["viaduct", "ra10"]]) {
  test(`dragging ${vehicle || "the load of the file"} over ${name}`, async () => {
    const { page, context } = await visit();
    await openExample(page, name);
    await part(page, "Load");
    await headline(page);
    if (vehicle) {
      await page.locator("#vehicle").selectOption(vehicle);
      await until("the vehicle is answered", async () => /the vehicle/.test(await page.getByTestId("headline").innerText().catch(() => "")));
    }
    // The envelope has done its work, so that the drag is measured alone.
    await until("the envelope is whole", async () => {
      const text = await page.getByTestId("least").textContent().catch(() => "");
      return text.includes("Least") && !text.includes("places");
    }, 400).catch(() => undefined);
    const seen = await drag(page);
    const gaps = seen.frames.slice(1).map((time, k) => time - seen.frames[k]);
    const rate = 1000 / quantile(gaps, 0.5);
    const late = quantile(seen.answers, 0.95);
    const long = seen.long.filter((duration) => duration > 100);
    console.log(
      `${name} ${vehicle}: ${rate.toFixed(0)} pictures a second (median), pointer to picture ${quantile(seen.answers, 0.5).toFixed(0)} ms (median), ${late.toFixed(0)} ms (95 %), ` +
        `${seen.moves} movements of the hand, ${seen.answers.length} of them answered in a picture, painting ${quantile(seen.painting, 0.5).toFixed(1)} ms (median), ${seen.long.length} long tasks, ${long.length} above 100 ms`,
    );
    assert.ok(seen.answers.length > 10, "answers follow");
    if (strict) {
      assert.ok(rate >= 30, `${rate} pictures a second`);
      assert.ok(late < 50, `${late} ms`);
      assert.equal(long.length, 0);
    }
    await context.close();
  });
}

test("1984 particles are watched while they are stepped", async () => {
  const { page, context } = await visit();
  await openExample(page, "bridgemill", "case-3.toml");
  await headline(page).catch(() => undefined);
  await part(page, "Collapse");
  await page.getByRole("button", { name: "Load until it falls" }).click();
  await until("the fill is packed", async () => Number(/of (\d+)/.exec(await page.locator("label[for=scrub]").innerText())[1]) > 3, 500);
  await page.evaluate(() => {
    window.seen = { frames: [], painting: [], long: [] };
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries()) {
        if (entry.name !== "frame") continue;
        window.seen.frames.push(entry.startTime);
        window.seen.painting.push(entry.duration);
      }
    }).observe({ type: "measure" });
    new PerformanceObserver((list) => window.seen.long.push(...list.getEntries().map((entry) => entry.duration))).observe({ type: "longtask" });
  });
  await page.waitForTimeout(10_000);
  const seen = await page.evaluate(() => window.seen);
  const gaps = seen.frames.slice(1).map((time, k) => time - seen.frames[k]);
  console.log(
    `case 3: ${(1000 / quantile(gaps, 0.5)).toFixed(0)} pictures a second (median), painting ${quantile(seen.painting, 0.5).toFixed(0)} ms (median), ` +
      `${seen.long.filter((duration) => duration > 100).length} long tasks above 100 ms in 10 s`,
  );
  assert.ok(seen.frames.length > 10);
  if (strict) assert.ok(1000 / quantile(gaps, 0.5) >= 20);
  await context.close();
});

test("first picture, weight", async () => {
  const begin = Date.now();
  const { page, context } = await visit();
  await page.locator("[data-example]").first().waitFor();
  console.log(`first page with the engine's examples: ${Date.now() - begin} ms from navigation, Chromium's first contentful paint ${await page.evaluate(() => performance.getEntriesByName("first-contentful-paint")[0]?.startTime.toFixed(0))} ms`);
  await context.close();
});
