// A bridge without a load, one that does not stand, and values that cannot be.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { end, openExample, part, serious, shot, until, visit } from "../browser.mjs";

after(end);

test("the least thickness of a ring is found where the file asks for it", async () => {
  const { page, complaints, context } = await visit();
  await openExample(page, "semicircle");
  await part(page, "Load");
  const block = page.locator("#answer");
  await until("what is asked for stands in place of a load", async () => /least thickness/.test(await block.innerText()));
  assert.equal(await page.getByLabel("Load", { exact: true }).locator("option:checked").textContent(), "Choose a vehicle …");
  assert.ok((await page.locator("#vehicle option:disabled").count()) > 1, "vehicles that are not for such spans cannot be chosen");
  assert.equal(await page.getByRole("button", { name: "How much each one matters" }).isVisible(), false);
  await block.getByRole("button", { name: /find it under Verdict/ }).click();
  await page.getByRole("button", { name: /Least thickness/ }).click();
  await until("the ratio of Milankovitch stands there", async () => /0\.1075/.test(await page.locator("#answer").innerText()), 120);
  assert.match(await page.getByTestId("verdict").innerText(), /^1[\s\u2009]?06[78]/);
  await page.waitForTimeout(500);
  await shot(page, "thinnest-1280-light");
  assert.deepEqual(await serious(page), []);
  assert.deepEqual(complaints, []);
  await context.close();
});

test("a bridge that does not stand says so in the place of its load, and a wrong value is told at its field", async () => {
  const { page, complaints, context } = await visit();
  await openExample(page, "tiny");
  const field = page.locator('input[data-path="span[1].thickness"]');
  const rise = page.locator('input[data-path="span[1].rise"]');
  await rise.fill("1.9 m");
  await rise.blur();
  await field.fill("100 mm");
  await field.blur();
  await until("the headline says so", async () => /does not stand/i.test(await page.getByTestId("headline").innerText().catch(() => "")), 60);
  await shot(page, "falls-1280-light");
  await field.fill("abc");
  await field.blur();
  await until("the field is marked", async () => (await field.getAttribute("aria-invalid")) === "true");
  await field.fill("0");
  await field.blur();
  await until("the field is marked still", async () => (await field.getAttribute("aria-invalid")) === "true");
  assert.match(await page.locator(".field.wrong .complaint").first().innerText(), /thickness/i);
  assert.equal(await page.locator('select[id="f-span-1--profile"]').inputValue(), "segmental");
  await shot(page, "wrong-field-1280-light");
  assert.deepEqual(complaints, []);
  await context.close();
});
