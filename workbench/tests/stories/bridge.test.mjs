// Bridge: from survey numbers or an example to a drawing; form, text and handles are one document.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { end, headline, openExample, part, shot, textOf, until, visit } from "../browser.mjs";

after(end);

test("ten survey numbers are drawn while they are typed", async () => {
  const { page, complaints, context } = await visit();
  await page.getByRole("button", { name: "Ten survey numbers" }).click();
  const span = page.getByLabel("Span", { exact: true });
  await span.fill("8");
  await page.getByLabel("Rise", { exact: true }).fill("2");
  await until("the file has the numbers", async () => /span = "8 m"/.test(await textOf(page)) && /rise = "2 m"/.test(await textOf(page)));
  await until("the drawing says so", async () => (await page.locator("canvas[role=img]").getAttribute("aria-label")).includes("8\u2009000"));
  assert.ok((await headline(page)) > 0);
  await shot(page, "survey-1280-light");
  assert.deepEqual(complaints, []);
  await context.close();
});

test("form, text and handles change one document, and undo takes back what any of them did", async () => {
  const { page, complaints, context } = await visit();
  await openExample(page, "bridgemill");
  const before = await headline(page);
  const start = await textOf(page);

  // The form, by path: comments stay.
  const thickness = page.locator('input[data-path="span[1].thickness"]');
  await thickness.fill("0.8");
  await thickness.press("Enter");
  await until("the text follows the form", async () => /thickness = "0.8 m"/.test(await textOf(page)));
  assert.match(await textOf(page), /# sandstone voussoirs/);
  await until("a thicker ring carries more", async () => (await headline(page)) > before);

  // A handle, by keys.
  const rise = page.locator('.grip[data-path="span[1].rise"]');
  await rise.focus();
  await rise.press("ArrowUp");
  await until("the text follows the handle", async () => /rise = "2.86\d* m"/.test(await textOf(page)));

  // A handle, by hand.
  const span = page.locator('.grip[data-path="span[1].span"]');
  const box = await span.boundingBox();
  await page.mouse.move(box.x + 22, box.y + 22);
  await page.mouse.down();
  await page.mouse.move(box.x + 42, box.y + 22, { steps: 6 });
  await page.mouse.up();
  await until("the text follows the hand", async () => Number(/\nspan = "([\d.]+) m"/.exec(await textOf(page))[1]) > 18.4);

  // The text.
  await page.getByRole("tab", { name: "Text" }).click();
  const editor = page.locator(".cm-content");
  await editor.click();
  await page.keyboard.press("Control+Home");
  await page.keyboard.type("# by hand\n");
  await until("the document follows the text", async () => (await textOf(page)).startsWith("# by hand"));
  await shot(page, "text-1280-light");

  for (let k = 0; k < 12 && (await textOf(page)) !== start; k += 1) await page.getByRole("button", { name: "Undo" }).click();
  assert.equal(await textOf(page), start);
  await page.getByRole("button", { name: "Redo" }).click();
  assert.notEqual(await textOf(page), start);
  assert.deepEqual(complaints, []);
  await context.close();
});

test("a material of the library is written with its source beside it", async () => {
  const { page, complaints, context } = await visit();
  await openExample(page, "bridgemill");
  const before = await headline(page);
  const start = await textOf(page);
  const masonry = page.locator("details.group").filter({ has: page.locator("summary", { hasText: /^Masonry/ }) });
  await masonry.getByText("From the library of materials").click();
  await masonry.getByLabel("Material").selectOption({ label: "Random rubble in lime mortar" });
  assert.match(await masonry.innerText(), /recalled: BD 21/);
  await shot(page, "materials-1280-light");
  await masonry.getByRole("button", { name: "Write into the file" }).click();
  await until("the file has the values", async () => /density = "2200 kg\/m\^3"\s+# not measured: library, rubble, 2000/.test(await textOf(page)));
  assert.match(await textOf(page), /compressive_strength = "4 MPa"\s+# not measured: library, rubble.*recalled: BD 21/);
  await until("another strength carries another load", async () => (await headline(page)) !== before);
  await page.getByRole("button", { name: "Undo" }).click();
  assert.equal(await textOf(page), start, "one step takes it back");
  assert.deepEqual(complaints, []);
  await context.close();
});

test("a mistake is told at its place in the engineer's words, and the drawing stays", async () => {
  const { page, context } = await visit();
  await openExample(page, "tiny");
  await headline(page);
  await page.getByRole("tab", { name: "Text" }).click();
  await page.locator(".cm-content").click();
  await page.keyboard.press("Control+End");
  await page.keyboard.type("\n[masonri]\ndensity = \"2 GPa\"\n");
  await page.getByRole("tab", { name: /Findings \(\d/ }).click();
  await page.locator(".finding").first().waitFor();
  assert.match(await page.locator(".panel-body").innerText(), /masonri/);
  assert.ok(await page.locator("canvas[role=img]").isVisible());
  await shot(page, "findings-1280-light");
  await context.close();
});

test("parts are visited in any order, and show the bridge again", async () => {
  const { page, complaints, context } = await visit();
  await openExample(page, "tiny");
  const before = await headline(page);
  for (const name of ["Train", "Load", "Collapse", "Bridge", "Verdict", "Load", "Train", "Bridge", "Load"]) {
    await part(page, name);
    await until(`${name} is there`, async () => (await page.locator(".index [aria-current]").innerText()).includes(name));
  }
  assert.equal(await headline(page), before);
  assert.ok(await page.locator(".grip.load").isVisible());
  assert.deepEqual(complaints, []);
  await context.close();
});

test("several spans, imperial units, both themes, a phone", async () => {
  for (const [width, height, theme] of [[1280, 800, "light"], [1280, 800, "dark"], [390, 844, "light"], [390, 844, "dark"]]) {
    const { page, complaints, context } = await visit({ width, height, theme, touch: width < 800 });
    await openExample(page, "viaduct");
    await headline(page);
    await shot(page, `viaduct-${width}-${theme}`);
    await page.getByRole("button", { name: /^Units/ }).click();
    await until("feet", async () => (await page.locator("canvas[role=img]").getAttribute("aria-label")).includes("′"));
    await page.getByRole("button", { name: /^Units/ }).click();
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth > innerWidth), false, "nothing hangs out sideways");
    if (width < 800) await part(page, "Load");
    assert.deepEqual(complaints, []);
    await context.close();
  }
});
