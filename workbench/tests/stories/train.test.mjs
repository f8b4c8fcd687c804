// Train: it crosses, sensors record, measured records lie over them.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, test } from "node:test";
import { dropped, end, openExample, part, shot, textOf, until, visit } from "../browser.mjs";

after(end);

test("a train crosses the railway arch; a sensor is placed on a stone; a measured table lies over the record", async () => {
  const { page, complaints, context } = await visit();
  await openExample(page, "railway-arch", "update-table-1.toml").catch(async () => openExample(page, "railway-arch"));
  await part(page, "Train");
  await until("the file is read", () => page.getByRole("button", { name: "Let the train cross" }).first().isEnabled());
  await page.getByRole("button", { name: "Let the train cross" }).first().click();
  await until("positions are solved", async () => Number(/Position (\d+)/.exec((await page.getByTestId("passage-state").textContent().catch(() => "")) ?? "")?.[1] ?? 0) > 14, 500);
  await page.getByRole("button", { name: "Pause" }).click();
  await page.locator("#time").fill("12");
  assert.match(await page.getByTestId("passage-state").textContent(), /Position 13 /);
  await shot(page, "train-1280-light");
  const table = page.getByRole("button", { name: /\.csv$/ }).first();
  if (await table.count()) {
    await table.click();
    await until("the measured record is drawn", async () => /Dashed: measured/.test(await page.locator(".panel-body").innerText()));
    await shot(page, "train-measured-1280-light");
  }
  const before = ((await textOf(page)).match(/\[\[sensor\]\]/g) ?? []).length;
  await page.getByRole("button", { name: "Place a sensor on the drawing" }).click();
  const box = await page.locator(".scene").boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  await until("the file has one more sensor", async () => ((await textOf(page)).match(/\[\[sensor\]\]/g) ?? []).length === before + 1);
  assert.deepEqual(complaints, []);
  await context.close();
});

// An update takes minutes in a browser: with EXTRADOS_QUICK it is left out.
const quick = process.env.EXTRADOS_QUICK === "true";
test("measured records are dropped on the page, and the update is run to its end", { skip: quick && "minutes" }, async () => {
  const { page, complaints, context } = await visit();
  // The bridge file alone: it names records that are not there yet.
  const folder = join(import.meta.dirname, "../../../examples/railway-arch");
  const bridge = readFileSync(join(folder, "update.toml"), "utf8");
  await dropped(page, "update.toml", bridge);
  await part(page, "Train");
  const update = page.getByRole("button", { name: "Update", exact: true });
  await until("the file is read", () => update.isEnabled());
  await update.click();
  await until("what is missing is named", async () => /table-6\.csv/.test(await page.locator(".panel-body .complaint").innerText()));
  await dropped(page, "monday.csv", readFileSync(join(folder, "table-6.csv"), "utf8"));
  await page.getByRole("button", { name: "Let the update read monday.csv" }).click();
  assert.match(await textOf(page), /^place = "monday.csv"/m);
  await until("the file is read anew", () => update.isEnabled());
  await update.click();
  await page.getByTestId("update-status").waitFor({ timeout: 500_000 });
  assert.match(await page.getByTestId("update-status").innerText(), /Ended: completed/);
  // The records were computed with the moduli of Table 6: voussoirs 13.2 GPa, which they tell to 0.5 %.
  const row = (await page.getByTestId("parameters").locator("tbody tr").first().innerText()).replace(/\s+/g, " ");
  const value = Number(/voussoirs.*? ([\d.]+) GPa/.exec(row)?.[1]);
  assert.ok(Math.abs(value / 13.2 - 1) < 5e-3, row);
  const [low, high] = /([\d.]+) to ([\d.]+)/.exec(row).slice(1).map(Number);
  assert.ok(low < value && value < high, row);
  assert.ok((await page.getByTestId("parameters").locator("svg.interval rect").count()) >= 4, "intervals are drawn");
  const history = page.getByRole("img", { name: /measured, before the update and after it/ });
  await history.scrollIntoViewIfNeeded();
  await page.getByLabel("Records of").selectOption({ index: 3 });
  await shot(page, "update-1280-light");
  await page.setViewportSize({ width: 390, height: 844 });
  await history.scrollIntoViewIfNeeded();
  await shot(page, "update-390-light");
  assert.deepEqual(complaints, []);
  await context.close();
});
