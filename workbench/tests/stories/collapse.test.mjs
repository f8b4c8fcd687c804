// Collapse: stepped live, paused, scrubbed back, gone on from, saved.
import assert from "node:assert/strict";
import { readFileSync, statSync } from "node:fs";
import { after, test } from "node:test";
import { end, headline, openExample, part, shot, until, visit } from "../browser.mjs";

after(end);
const pictures = async (page) => Number(/of (\d+)/.exec(await page.locator("label[for=scrub]").innerText())[1]);

test("Bridgemill falls while one watches; the curve grows; back and on again ends in the same load", async () => {
  const { page, complaints, context } = await visit();
  await openExample(page, "bridgemill");
  await headline(page);
  await part(page, "Collapse");
  await page.getByRole("button", { name: "Load until it falls" }).click();
  await until("pictures come", async () => (await pictures(page)) > 40, 120);
  await page.getByRole("button", { name: "Pause" }).click();
  const paused = await pictures(page);
  await page.waitForTimeout(400);
  assert.ok((await pictures(page)) <= paused + 1, "a paused run stands");
  await page.getByRole("button", { name: "One picture on" }).click();
  await until("one picture more", async () => (await pictures(page)) > paused);
  await page.locator("#times").fill("13");
  await page.locator("#scrub").fill("10");
  await shot(page, "collapse-scrubbed-1280-light");
  await page.getByRole("button", { name: "Go on from here" }).click();
  await page.locator("#speed").fill("40");
  await until("it ends", async () => /Ended/.test(await page.locator(".block").innerText()), 400);
  assert.match(await page.locator(".block").innerText(), /collapsed/);
  // Published: 204.82 kN/m is the last stable step.
  assert.ok(Math.abs((await headline(page, "run-headline")) - 204.8) < 0.15, await page.getByTestId("run-headline").textContent());
  await page.locator("#times").fill("0");
  await shot(page, "collapse-1280-light");
  await page.getByRole("button", { name: "Dark sheet" }).click();
  await shot(page, "collapse-1280-dark");

  const picture = page.waitForEvent("download");
  await page.getByRole("button", { name: /Save this picture/ }).click();
  const png = await (await picture).path();
  assert.equal(readFileSync(png).subarray(1, 4).toString(), "PNG");
  const film = page.waitForEvent("download", { timeout: 240_000 });
  await page.getByRole("button", { name: /Save the film/ }).click();
  const webm = await (await film).path();
  assert.ok(statSync(webm).size > 5_000, `${statSync(webm).size} bytes`);
  assert.equal(readFileSync(webm).subarray(0, 4).toString("hex"), "1a45dfa3");
  assert.deepEqual(complaints, []);
  await context.close();
});
