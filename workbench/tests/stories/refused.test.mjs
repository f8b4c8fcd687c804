// What is refused: it is told at its field, the answer of the values before is shown as such, and nothing typed is lost, also with a worker.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { end, headline, openExample, part, serious, shot, textOf, until, visit } from "../browser.mjs";

after(end);
const old = (page) => page.locator("#answer[data-old]");
const survey = async (page) => {
  await page.getByRole("button", { name: "Ten survey numbers" }).click();
  await headline(page);
  return (name) => page.getByLabel(name, { exact: true });
};

test("a value that no bridge has is a finding at its field, and the answer before it is greyed and says so", async () => {
  for (const [width, theme] of [[1280, "light"], [1280, "dark"], [390, "light"], [390, "dark"]]) {
    const { page, complaints, context } = await visit({ width, theme, height: width === 390 ? 844 : 800 });
    const field = await survey(page);
    const before = await headline(page);
    const text = await textOf(page);
    const cover = field("Cover over the crown");
    const usual = await cover.inputValue();
    await cover.fill("-0.5");
    await old(page).waitFor();
    assert.equal(await cover.getAttribute("aria-invalid"), "true");
    const described = await cover.getAttribute("aria-describedby");
    const said = await page.locator(`#${described.split(" ").at(-1)}`).innerText();
    assert.match(said, /out of its possible range.*0 m/s);
    assert.equal(await headline(page), before);
    assert.equal(await textOf(page), text, "the file stays as it was");
    assert.match(await page.getByTestId("old").innerText(), /values before/);
    assert.match(await page.locator("#answer").getAttribute("aria-label"), /values before/);
    if (width === 390) assert.match(await page.locator(".sheet-answer").getAttribute("class"), /\bold\b/);
    await cover.scrollIntoViewIfNeeded();
    await shot(page, `refused-cover-${width}-${theme}`);
    assert.deepEqual(await serious(page), []);
    // What was typed stays where it was, also after the page was left.
    await page.reload();
    await old(page).waitFor();
    assert.equal(await field("Cover over the crown").inputValue(), "-0.5");
    assert.equal(await field("Cover over the crown").getAttribute("aria-invalid"), "true");
    await field("Cover over the crown").fill(usual);
    await until("the answer is one again", async () => (await old(page).count()) === 0);
    assert.equal(await headline(page), before);
    assert.deepEqual(complaints, []);
    await context.close();
  }
});

test("every number of a survey that is out of range is told at its own field", async () => {
  const { page, complaints, context } = await visit();
  const field = await survey(page);
  await field("Number of spans").fill("2");
  await field("Width of the pier").fill("1.2");
  await field("Height of the pier").fill("4");
  await until("nothing is refused", async () => (await page.locator(".panel-body [aria-invalid=true]").count()) === 0);
  // Every name is one.
  const ids = await page.locator(".panel-body input[id^=q-]:not(.text)").evaluateAll((all) => all.map((one) => one.id));
  assert.ok(ids.length >= 15, `${ids}`);
  for (const id of ids) {
    const entry = page.locator(`#${id}`);
    const usual = await entry.inputValue();
    await entry.fill("-1");
    await until(`${id} is refused`, async () => (await entry.getAttribute("aria-invalid")) === "true");
    const invalid = await page.locator(".panel-body [aria-invalid=true]").evaluateAll((all) => all.map((one) => one.id));
    assert.deepEqual(invalid, [id], "it alone");
    const described = await entry.getAttribute("aria-describedby");
    assert.ok((await page.locator(`#${described.split(" ").at(-1)}`).innerText()).length > 10, id);
    await entry.fill(usual);
    await until(`${id} is taken`, async () => (await entry.getAttribute("aria-invalid")) === "false");
  }
  // Unusual is told, and is no refusal.
  await field("Density of the masonry").fill("22");
  await page.locator(".complaint.doubt").waitFor();
  assert.equal(await old(page).count(), 0);
  assert.deepEqual(complaints, []);
  await context.close();
});

test("a slip in the form and in the text greys the answer until it is mended", async () => {
  const { page, context } = await visit();
  await openExample(page, "tiny");
  const before = await headline(page);
  await page.getByRole("tab", { name: "Form" }).click();
  const rise = page.locator('input[data-path="span[1].rise"]');
  const usual = await rise.inputValue();
  await rise.fill("-1");
  await rise.press("Enter");
  await old(page).waitFor();
  assert.equal(await headline(page), before);
  await rise.fill(usual);
  await rise.press("Enter");
  await until("the answer is one again", async () => (await old(page).count()) === 0);
  assert.equal(await headline(page), before);
  await context.close();
});

/** Keeps every worker that the page starts, so that a story can end it. */
const keepWorkers = (page) =>
  page.addInitScript(() => {
    const Own = self.Worker;
    self.kept = [];
    self.Worker = class extends Own {
      constructor(url, options) {
        super(url, options);
        self.kept.push({ name: options?.name ?? "", worker: this });
      }
    };
  });

/** Ends the newest worker of a name in whatever it does, once it lives, as the system would: no event tells of it. */
async function ended(page, name) {
  const lives = (name) => navigator.locks.query().then(({ held }) => held.some((lock) => lock.name.startsWith(`extrados ${name} `)));
  await until(`${name} lives`, () => page.evaluate(lives, name));
  await page.evaluate((name) => self.kept.findLast((kept) => kept.name === name).worker.terminate(), name);
}

test("a worker that ends is told of and replaced, and what was typed is there", async () => {
  const { page, context } = await visit({ before: keepWorkers });
  const field = await survey(page);
  const before = await headline(page);
  await field("Thickness of the ring").fill("0.5");
  await until("it is in the file", async () => /thickness = "0.5 m"/.test(await textOf(page)));
  await ended(page, "live");
  const notice = page.locator(".notice[role=alert]");
  await notice.waitFor();
  assert.match(await notice.innerText(), /started again\. Nothing that you typed is lost/);
  await shot(page, "worker-ended-1280-light");
  assert.equal(await field("Thickness of the ring").inputValue(), "0.5");
  await field("Thickness of the ring").fill("0.6");
  await until("the new worker answers", async () => /thickness = "0.6 m"/.test(await textOf(page)) && (await headline(page)) !== before);
  // In the middle of typing.
  await ended(page, "live");
  await field("Rise").fill("1.4");
  await until("nothing typed is lost", async () => /rise = "1.4 m"[\s\S]*thickness = "0.6 m"/.test(await textOf(page)));
  assert.equal(await old(page).count(), 0);
  await context.close();
});

test("a worker that ends during a long analysis is told of, and the analysis runs again", async () => {
  const { page, context } = await visit({ before: keepWorkers });
  await openExample(page, "bridgemill");
  const before = await headline(page);
  await part(page, "Verdict");
  await page.getByRole("button", { name: /^Collapse load/ }).click();
  await page.getByRole("button", { name: "Stop", exact: true }).waitFor();
  await ended(page, "background");
  await until("it is told", async () => /broke down and was started again\. The worker ended/.test(await page.locator("body").innerText()));
  assert.equal(await page.getByRole("button", { name: "Stop", exact: true }).count(), 0);
  await shot(page, "analysis-ended-1280-light");
  await page.getByRole("button", { name: /^Collapse load/ }).click();
  await page.locator(".figures img").first().waitFor({ timeout: 240_000 });
  await part(page, "Bridge");
  assert.equal(await headline(page), before);
  await context.close();
});

test("a vehicle under the rule of the file has its factors, and the page names them", async () => {
  for (const [width, theme] of [[1280, "light"], [1280, "dark"], [390, "light"], [390, "dark"]]) {
    const { page, context } = await visit({ width, theme, height: width === 390 ? 844 : 800 });
    await openExample(page, "tiny");
    await headline(page);
    assert.match(await page.getByTestId("factors").innerText(), /^nominal/);
    await part(page, "Load");
    await page.getByLabel("Load", { exact: true }).selectOption("cs454-single");
    await page.getByLabel("Factors and spread by").selectOption("cs-454");
    await until("the factors are named", async () => /impact 1\.8 on the critical axle/.test(await page.getByTestId("factors").innerText()));
    await headline(page);
    await shot(page, `factors-${width}-${theme}`);
    await context.close();
  }
});
