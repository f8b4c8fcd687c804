// Load: the arrow is dragged and the bridge answers.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { end, headline, openExample, part, shot, until, visit } from "../browser.mjs";

after(end);

test("a load that is dragged carries its thrust line, its number and its envelope along", async () => {
  const { page, complaints, context } = await visit();
  await openExample(page, "bridgemill");
  await part(page, "Load");
  await headline(page);
  const before = await page.getByTestId("place").textContent();
  const grip = page.locator(".grip.load");
  const box = await grip.boundingBox();
  await page.mouse.move(box.x + 28, box.y + 30);
  await page.mouse.down();
  for (let k = 1; k <= 20; k += 1) await page.mouse.move(box.x + 28 + 8 * k, box.y + 30);
  await page.mouse.up();
  assert.notEqual(await page.getByTestId("place").textContent(), before);
  await until("the envelope is whole", async () => {
    const text = await page.getByTestId("least").textContent().catch(() => "");
    return text.includes("Least") && !text.includes("places");
  }, 240);
  await page.getByRole("button", { name: /governing place/ }).click();
  await until("the headline is the least of the envelope", async () => {
    const least = Number.parseFloat(/road ([\d.]+)/.exec((await page.getByTestId("least").textContent()).replace(/\u2009/g, ""))[1]);
    return Math.abs((await headline(page)) / least - 1) < 0.002;
  });
  await page.waitForTimeout(1200);
  await shot(page, "load-1280-light");
  await page.getByRole("button", { name: "Dark sheet" }).click();
  await shot(page, "load-1280-dark");
  await until("the answer is spoken", async () => /carried/.test(await page.getByTestId("spoken").textContent()));
  assert.deepEqual(complaints, []);
  await context.close();
});

test("a vehicle of the library stands on the bridge, with its assumptions", async () => {
  const { page, complaints, context } = await visit();
  await openExample(page, "viaduct");
  await part(page, "Load");
  await headline(page);
  await page.getByLabel("Load", { exact: true }).selectOption({ index: 5 });
  await until("the title block says whose factor it is", async () => (await page.locator(".block").innerText()).includes("vehicle"));
  assert.ok((await headline(page)) > 0);
  assert.ok((await page.locator(".block .notes li").count()) > 0);
  await page.waitForTimeout(3000);
  await shot(page, "vehicle-1280-light");
  assert.deepEqual(complaints, []);
  await context.close();
});

test("other methods give their answers beside the rigid one, and a slider moves the bridge", async () => {
  const { page, complaints, context } = await visit();
  await openExample(page, "tiny");
  await part(page, "Load");
  const before = await headline(page);
  await page.getByRole("button", { name: "Run Rigid blocks" }).click();
  await until("a number stands there", async () => /kN\/m/.test(await page.locator("table.plain").innerText()), 120);
  const slider = page.locator(".slider input").first();
  await slider.focus();
  for (let k = 0; k < 12; k += 1) await slider.press("ArrowRight");
  await until("the answer follows", async () => (await headline(page)) !== before);
  await page.getByRole("button", { name: "How much each one matters" }).click();
  await page.locator(".tornado-row").first().waitFor({ timeout: 180_000 });
  await page.locator(".tornado").scrollIntoViewIfNeeded();
  await shot(page, "tornado-1280-light");
  assert.deepEqual(complaints, []);
  await context.close();
});

test("on a phone the load follows the finger", async () => {
  const { page, complaints, context } = await visit({ width: 390, height: 844, touch: true });
  await openExample(page, "bridgemill");
  await part(page, "Load");
  await headline(page);
  const before = await page.getByTestId("place").textContent();
  const box = await page.locator(".grip.load").boundingBox();
  const client = await context.newCDPSession(page);
  const touch = (type, x) => client.send("Input.dispatchTouchEvent", { type, touchPoints: type === "touchEnd" ? [] : [{ x, y: box.y + 30 }] });
  await touch("touchStart", box.x + 28);
  for (let k = 1; k <= 10; k += 1) await touch("touchMove", box.x + 28 + 6 * k);
  await touch("touchEnd", 0);
  await until("the load has moved", async () => (await page.getByTestId("place").textContent()) !== before);
  await page.waitForTimeout(1500);
  await shot(page, "load-390-light");
  assert.deepEqual(complaints, []);
  await context.close();
});
