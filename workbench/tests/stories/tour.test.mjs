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

test("a survey of a viaduct in feet: what is assumed is told, a mass counts by its weight, the axle counts over its own width, the phone shows it", async () => {
  const { page, complaints, context } = await visit();
  await page.getByRole("button", { name: "Ten survey numbers" }).click();
  const field = (name) => page.getByLabel(name, { exact: true });
  // What the survey does not say stays open, and stands among the assumptions.
  assert.equal(await field("Strength of the masonry").inputValue(), "");
  const notes = page.getByRole("region", { name: "Warnings and assumptions" });
  await notes.getByText(/Assumed by the file:.*masonry compressive strength 5 MPa/).waitFor();
  await field("Strength of the masonry").fill("8");
  await until("the survey says it now", async () => !/compressive strength/.test(await notes.innerText()));
  for (const [name, value] of Object.entries({ Span: "30 ft", Rise: "9 ft", "Thickness of the ring": "18 in", "Width of the barrel": "26 ft", "Cover over the crown": "2 ft" })) await field(name).fill(value);
  await until("the file has feet", async () => /span = "30 ft"/.test(await textOf(page)));
  assert.equal((await page.locator(".field", { has: page.locator("#q-span") }).locator(".unit").count()), 0);
  // The load that nobody has moved is at the quarter point of the new span.
  await until("the load follows the span", async () => /^2\.29/.test(await page.getByTestId("place").innerText()));
  // A mass counts by its weight.
  await field("Axle").fill("25 t");
  await until("the axle is weighed", async () => /axle_force = "25 t"/.test(await textOf(page)));
  const weighed = await headline(page);
  await field("Axle").fill("245");
  await until("the axle is taken", async () => /245 kN/.test(await textOf(page)));
  // What is assumed beside feet is in feet.
  const width = 0.3048 * Number(/effective_width = "([\d.]+) ft"/.exec(await textOf(page))[1]);
  const perMetre = await headline(page);
  assert.ok(Math.abs(perMetre / weighed - 1) < 1e-3, `${weighed} and ${perMetre}`);
  const onAxle = Number(/([\d.]+)\s*kN on the axle/.exec(await page.locator(".block").innerText())[1]);
  // Both are shown with four figures.
  assert.ok(Math.abs(onAxle / (perMetre * width) - 1) < 1e-3, `${onAxle} kN on ${width} m, ${perMetre} kN/m`);

  await page.getByRole("tab", { name: "Form" }).click();
  await page.getByRole("button", { name: "Add a span and its pier" }).click();
  await notes.getByText(/pier width 1\.5 m/).waitFor();
  await page.getByRole("button", { name: "Where is it least?" }).click();
  await page.getByRole("button", { name: /governing place/ }).waitFor({ timeout: 120_000 });
  await page.locator("#vehicle").selectOption("lm71");
  await until("a factor", async () => /the vehicle/.test(await page.getByTestId("headline").innerText()));
  await page.setViewportSize({ width: 390, height: 844 });
  await page.getByTestId("least").waitFor();
  const box = await page.locator(".block > div").first().boundingBox();
  assert.ok(box.width < 250, `the answer takes ${box.width} of 390 px`);
  await shot(page, "survey-vehicle-390");
  assert.deepEqual(complaints, []);
  await context.close();
});

test("a survey says nothing of how joints give: the page offers to assume it, and the bridge falls", async () => {
  const { page, complaints, context } = await visit({ calm: true });
  await page.getByRole("button", { name: "Ten survey numbers" }).click();
  await headline(page);
  await part(page, "Collapse");
  await page.getByRole("button", { name: "Load until it falls" }).click();
  await page.getByLabel("The file does not say how its joints give. Assume it for").waitFor();
  await page.getByRole("button", { name: "Write it into the file" }).click();
  await until("the file says what is assumed", async () => /normal_stiffness = "2\.\d+ GPa\/m"  # assumed: a tenth of 8 GPa/.test(await textOf(page)));
  await page.getByRole("button", { name: "Load until it falls" }).click();
  await until("the blocks bear load", async () => (await headline(page, "run-headline")) > 0);
  await part(page, "Verdict");
  await page.getByRole("button", { name: /Load moved along the bridge/ }).click();
  await until("the least is told", async () => /× the load/.test(await page.getByTestId("verdict").innerText()));
  await page.getByText("the least along the road, at").waitFor();
  assert.deepEqual(complaints, []);
  await context.close();
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
  // A slip: a rise above half the span is told in words at its number, and can be taken back.
  await part(page, "Bridge");
  const words = page.locator(".panel-body .complaint:not(.doubt)");
  await page.getByLabel("Rise", { exact: true }).fill("19");
  await until("words", async () => (await words.count()) === 1 && (await words.innerText()).length > 10);
  assert.equal(await page.getByLabel("Rise", { exact: true }).getAttribute("aria-invalid"), "true");
  await page.locator("#answer[data-old]").waitFor();
  await page.getByLabel("Rise", { exact: true }).fill("1.9");
  await until("the words go", async () => (await words.count()) === 0 && (await page.locator("#answer[data-old]").count()) === 0);
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save the bridge file" }).click();
  assert.equal((await download).suggestedFilename(), "bridge.toml");
  assert.deepEqual(complaints, []);
  await context.close();
});
