// Cases and two bridges side by side, drawings that are dropped, vehicles on wheels, figures as files.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { dropped, end, headline, openExample, part, saved, serious, shot, textOf, until, visit } from "../browser.mjs";

after(end);
const fits = (page) => page.evaluate(() => document.documentElement.scrollWidth <= innerWidth);

test("cases stand side by side, and a bridge beside what it was", async () => {
  for (const [width, theme] of [[1280, "light"], [390, "dark"]]) {
    const { page, complaints, context } = await visit({ width, theme, height: width === 390 ? 844 : 800 });
    await openExample(page, "tiny");
    const before = await headline(page);
    await part(page, "Cases");
    await page.getByText("The file has none").waitFor();
    await page.getByLabel("Name of the case").fill("as it is");
    await page.getByRole("button", { name: "Write it into the file" }).click();
    await page.getByRole("button", { name: "Write it into the file" }).click();
    await until("two cases", async () => (await textOf(page)).match(/\[\[case\]\]/g)?.length === 2);
    await page.getByRole("button", { name: "Compute every case" }).click();
    await page.getByTestId("cases").waitFor({ timeout: 240_000 });
    const rows = await page.getByTestId("cases").locator("tbody tr").allInnerTexts();
    assert.equal(rows.length, 2);
    assert.match(rows[1], /governs/);
    await page.locator(".beside .figures img").first().waitFor();
    await shot(page, `cases-${width}-${theme}`);
    assert.deepEqual(await serious(page), []);
    assert.ok(await fits(page));
    // A change beside what was opened.
    await part(page, "Bridge");
    await page.getByRole("tab", { name: "Form" }).click();
    const thickness = page.locator('input[data-path="span[1].thickness"]');
    await thickness.fill("0.5");
    await thickness.press("Enter");
    await until("it answers", async () => (await headline(page)) !== before);
    await part(page, "Compare");
    await page.getByRole("button", { name: "Compare", exact: true }).last().click();
    await page.getByTestId("numbers").waitFor({ timeout: 240_000 });
    assert.match(await page.getByTestId("differences").innerText(), /span\[1\]\.thickness|span\.thickness/);
    assert.match(await page.getByTestId("compared").innerText(), /^The second carries .* more/);
    await shot(page, `compare-${width}-${theme}`);
    assert.deepEqual(await serious(page), []);
    assert.ok(await fits(page));
    assert.deepEqual(complaints, []);
    await context.close();
  }
});

test("a dropped drawing is drawn at once, then asked for what it lacks, and collapses", async () => {
  const source = await visit();
  await openExample(source.page, "tiny");
  await headline(source.page);
  await part(source.page, "Verdict");
  await source.page.getByRole("button", { name: /^Collapse load/ }).click();
  const file = source.page.locator(".files button").filter({ hasText: /model\.dxf$/ }).first();
  await file.waitFor({ timeout: 240_000 });
  const dxf = (await saved(source.page, () => file.click())).toString("latin1");
  await source.context.close();
  for (const [width, theme] of [[1280, "light"], [390, "dark"]]) {
    const { page, complaints, context } = await visit({ width, theme, height: width === 390 ? 844 : 800 });
    await page.getByRole("dialog").getByRole("button", { name: "Close" }).click();
    await dropped(page, "arch.dxf", dxf);
    await page.locator("canvas[role=img]").waitFor();
    const lacks = page.getByTestId("lacks");
    await lacks.getByText(/density of VOUSSOIR.*friction in the joints.*what holds the blocks.*a load/).waitFor();
    await shot(page, `drawn-${width}-${theme}`);
    assert.deepEqual(await serious(page), []);
    assert.ok(await fits(page));
    const names = await page.locator('select[id^="d-library"]').count();
    for (let k = 0; k < names; k += 1) await page.locator(`#d-library-${k}`).selectOption({ label: "Squared sandstone in lime mortar" });
    await page.getByLabel("Friction angle of the joints").fill("31");
    await page.getByLabel("Friction angle of the joints").press("Tab");
    await page.getByRole("checkbox", { name: /^ABUTMENT/ }).check();
    await page.getByRole("button", { name: "Put it on the blocks" }).click();
    await lacks.getByText("Nothing is missing.").waitFor();
    assert.match(await textOf(page), /role = "support"/);
    await shot(page, `drawn-asked-${width}-${theme}`);
    await page.getByRole("button", { name: "To the verdict" }).click();
    await page.getByRole("button", { name: /^Collapse load/ }).click();
    await page.locator(".figures img").first().waitFor({ timeout: 240_000 });
    assert.deepEqual(complaints, []);
    await context.close();
  }
});

test("a vehicle stands on wheels, its critical axle is marked, the curve is on the sheet, and what is drawn is saved", async () => {
  for (const [width, theme] of [[1280, "light"], [390, "dark"]]) {
    const { page, complaints, context } = await visit({ width, theme, height: width === 390 ? 844 : 800 });
    await openExample(page, "tiny");
    await headline(page);
    await part(page, "Load");
    await page.getByLabel("Load", { exact: true }).selectOption("cs454-bogie-8");
    await page.getByLabel("Factors and spread by").selectOption("cs-454");
    await headline(page);
    await page.getByTestId("least").waitFor({ timeout: 240_000 });
    const grip = page.locator(".grip.load");
    await grip.focus();
    const box = await page.locator("#scene .scene").boundingBox();
    for (const key of ["Home", "End"]) {
      await page.keyboard.press(key);
      const at = await grip.boundingBox();
      assert.ok(at.x + 22 >= box.x && at.x + 22 <= box.x + box.width, `${key}: every place of the load is on the sheet`);
    }
    const [from, to] = await Promise.all(["aria-valuemin", "aria-valuemax"].map(async (name) => Number(await grip.getAttribute(name))));
    await page.getByLabel("Place of the load along the bridge").fill(String((from + to) / 2));
    await page.waitForTimeout(600);
    await shot(page, `wheels-${width}-${theme}`);
    const png = await saved(page, () => page.getByRole("button", { name: "Save the drawing as PNG" }).click());
    assert.deepEqual([...png.subarray(1, 4)], [...Buffer.from("PNG")]);
    const svg = await saved(page, () => page.getByRole("button", { name: "Save the bridge as SVG" }).click());
    assert.match(svg.toString(), /<svg/);
    assert.deepEqual(await serious(page), []);
    assert.deepEqual(complaints, []);
    await context.close();
  }
});
