// The tour of two minutes, lived through; and ten minutes of somebody new, from a survey sheet to a first answer.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { end, headline, part, shot, textOf, until, visit } from "../browser.mjs";

after(end);

test("every stop of the tour can be done as it says, and it notices", async () => {
  const { page, complaints, context } = await visit({ calm: true });
  await page.getByRole("button", { name: "Tour of two minutes" }).last().click();
  const tour = page.getByRole("dialog", { name: /.+/ }).filter({ hasText: "of 6" });
  await tour.waitFor();
  await headline(page);
  const next = () => tour.getByRole("button", { name: "Next" }).click();
  const done = () => until("the tour notices", async () => /Done/.test(await tour.innerText()));
  const rise = page.locator('.grip[data-path="span[1].rise"]');
  await rise.focus();
  await rise.press("ArrowUp");
  await done();
  await shot(page, "tour-1280-light");
  await next();
  await page.getByRole("tab", { name: "Text" }).click();
  await done();
  assert.match(await textOf(page), /# /);
  await next();
  const load = page.locator(".grip.load");
  await load.focus();
  for (let k = 0; k < 4; k += 1) await load.press("ArrowRight");
  await done();
  await next();
  assert.match(await tour.innerText(), /title block/i);
  await next();
  await page.getByRole("button", { name: "Load until it falls" }).click();
  await until("the tour notices the fall", async () => /Done/.test(await tour.innerText()), 120);
  await next();
  assert.match(await tour.innerText(), /Take it with you/);
  await tour.getByRole("button", { name: "To work" }).click();
  assert.equal(await tour.count(), 0);
  assert.deepEqual(complaints, []);
  await context.close();
});

test("a tour begun before the engine is there waits for it, and an engine that never comes is told", async () => {
  let go;
  const held = new Promise((resolve) => (go = resolve));
  const later = async (page) => page.route("**/*.wasm", async (route) => {
    await held;
    await route.continue();
  });
  const { page, complaints, context } = await visit({ before: later });
  await page.getByRole("dialog", { name: "Open a bridge" }).getByRole("button", { name: "Tour of two minutes" }).click();
  await page.getByRole("main").getByText("The engine is being loaded").waitFor();
  go();
  assert.ok((await headline(page)) > 0);
  assert.equal(await page.locator(".sheet-title").innerText(), "Bridgemill, case 1");
  assert.deepEqual(complaints, []);
  await context.close();

  // No service worker either, which would fetch it by itself.
  const without = await visit({ serviceWorkers: "block", before: (page) => page.route("**/*.wasm", (route) => route.abort()) });
  await without.page.getByRole("dialog").getByText("The engine could not be loaded").waitFor();
  // Chromium names each request that failed; the page itself must not break.
  assert.deepEqual(without.complaints.filter((one) => !/ERR_FAILED/.test(one)), []);
  await without.context.close();
});

test("somebody new: ten numbers, an answer, its least place, a file to keep", async () => {
  const { page, complaints, context } = await visit();
  await page.getByRole("button", { name: "Ten survey numbers" }).click();
  const sheet = { Span: "7.5", Rise: "1.9", "Thickness of the ring": "0.4", "Width of the barrel": "4.2", "Cover over the crown": "0.6", "Height of backing": "0.8", Axle: "115" };
  for (const [name, value] of Object.entries(sheet)) await page.getByLabel(name, { exact: true }).fill(value);
  await until("the file has them", async () => /span = "7.5 m"/.test(await textOf(page)) && /115 kN/.test(await textOf(page)));
  assert.ok((await headline(page)) > 0);
  await part(page, "Load");
  await page.getByRole("button", { name: /governing place/ }).waitFor({ timeout: 120_000 });
  await page.getByRole("button", { name: /governing place/ }).click();
  assert.ok((await headline(page)) > 0);
  // A slip: a rise above half the span is told in words, and can be taken back.
  await part(page, "Bridge");
  await page.getByLabel("Rise", { exact: true }).fill("19");
  await until("words", async () => (await page.locator(".block .notes li.err").count()) > 0);
  await page.getByLabel("Rise", { exact: true }).fill("1.9");
  await until("the words go", async () => (await page.locator(".block .notes li.err").count()) === 0);
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save the bridge file" }).click();
  assert.equal((await download).suggestedFilename(), "bridge.toml");
  assert.deepEqual(complaints, []);
  await context.close();
});
