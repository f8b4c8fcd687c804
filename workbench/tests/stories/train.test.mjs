// Train: it crosses, sensors record, measured records lie over them.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { end, openExample, part, shot, textOf, until, visit } from "../browser.mjs";

after(end);

test("a train crosses the railway arch; a sensor is placed on a stone; a measured table lies over the record", async () => {
  const { page, complaints, context } = await visit();
  await openExample(page, "railway-arch", "update-table-1.toml").catch(async () => openExample(page, "railway-arch"));
  await part(page, "Train");
  await until("the file is read", () => page.getByRole("button", { name: "Let the train cross" }).first().isEnabled());
  await page.getByRole("button", { name: "Let the train cross" }).first().click();
  await until("positions are solved", async () => Number(/Position (\d+)/.exec((await page.getByTestId("passage-state").textContent().catch(() => "")) ?? "")?.[1] ?? 0) > 25, 500);
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
