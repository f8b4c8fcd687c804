// Everything without a pointer, and what axe finds in both themes.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, test } from "node:test";
import { end, headline, openExample, part, until, visit } from "../browser.mjs";

after(end);
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

const focused = (page) => page.evaluate(() => document.activeElement?.getAttribute("aria-label") ?? document.activeElement?.textContent?.trim() ?? "");

async function tabTo(page, name, most = 80) {
  for (let k = 0; k < most; k += 1) {
    if ((await focused(page)).startsWith(name)) {
      const outline = await page.evaluate(() => {
        const style = getComputedStyle(document.activeElement);
        return style.outlineStyle !== "none" && Number.parseFloat(style.outlineWidth) >= 1;
      });
      assert.ok(outline, `the focus on "${name}" is seen`);
      return;
    }
    await page.keyboard.press("Tab");
  }
  throw new Error(`Tab does not reach "${name}"`);
}

test("a bridge is opened, changed, loaded and undone by keys alone", async () => {
  const { page, complaints, context } = await visit({ calm: true });
  await page.locator("[data-example]").first().waitFor();
  await tabTo(page, "Bridgemill");
  await page.keyboard.press("Enter");
  const before = await headline(page);
  await page.keyboard.press("Tab");
  await tabTo(page, "Rise of span 1", 120);
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("ArrowUp");
  await until("the answer follows the handle", async () => (await headline(page)) !== before);
  await page.keyboard.press("Control+z");
  await until("undo", async () => (await headline(page)) === before);
  await tabTo(page, "2Load", 200);
  await page.keyboard.press("Enter");
  await tabTo(page, "Place of the load", 120);
  const place = await page.getByTestId("place").textContent();
  await page.keyboard.press("ArrowRight");
  await until("the load moves a step", async () => (await page.getByTestId("place").textContent()) !== place);
  await page.keyboard.press("Home");
  await until("and to the end of the road", async () => Number(await page.locator(".grip.load").getAttribute("aria-valuenow")) === Number(await page.locator(".grip.load").getAttribute("aria-valuemin")));
  // Tab leaves the editor as it leaves every field.
  await part(page, "Bridge");
  await page.getByRole("tab", { name: "Form" }).focus();
  await page.keyboard.press("ArrowRight");
  await page.locator(".cm-content").waitFor();
  await page.locator(".cm-content").focus();
  await page.keyboard.press("Tab");
  assert.equal(await page.locator(".cm-content").evaluate((element) => element.getRootNode().activeElement === element), false);
  assert.deepEqual(complaints, []);
  await context.close();
});

test("axe finds nothing serious in any part, light and dark, wide and narrow", async () => {
  for (const [width, theme] of [[1280, "light"], [1280, "dark"], [390, "light"], [390, "dark"]]) {
    const { page, context } = await visit({ width, height: 820, theme });
    await page.locator("[data-example]").first().waitFor();
    const found = [];
    const look = async (where) => {
      await page.evaluate(axe);
      const serious = await page.evaluate(async () => {
        const { violations } = await window.axe.run(document, { resultTypes: ["violations"] });
        return violations.filter((one) => one.impact === "serious" || one.impact === "critical").map((one) => `${one.id}: ${one.nodes.slice(0, 3).map((node) => node.target.join(" ")).join(" | ")}`);
      });
      found.push(...serious.map((one) => `${where} ${width} ${theme}: ${one}`));
    };
    await look("open");
    await openExample(page, "bridgemill");
    await headline(page);
    await look("bridge");
    await page.getByRole("tab", { name: "Text" }).click();
    await page.locator(".cm-content").waitFor();
    await look("text");
    for (const name of ["Load", "Collapse", "Train", "Verdict"]) {
      await part(page, name);
      await page.waitForTimeout(400);
      await look(name);
    }
    assert.deepEqual(found, []);
    await context.close();
  }
});

test("every stop of the survey and of the verdict is seen, in the order in which it is read", async () => {
  for (const width of [1280, 390]) {
    const { page, complaints, context } = await visit({ width, height: width === 390 ? 844 : 800, calm: true });
    await page.getByRole("button", { name: "Ten survey numbers" }).click();
    await headline(page);
    await page.getByLabel("Traffic over the bridge").selectOption("road");
    await page.getByLabel("Judged by").selectOption("cs-454");
    const walk = async (steps) => {
      const stops = [];
      for (let k = 0; k < steps; k += 1) {
        const stop = await page.evaluate(() => {
          const one = document.activeElement;
          const shown = [one, one.closest(".entry")].filter(Boolean).some((element) => {
            const style = getComputedStyle(element);
            return style.outlineStyle !== "none" && Number.parseFloat(style.outlineWidth) >= 1;
          });
          const { left, right, top, bottom } = one.getBoundingClientRect();
          const covered = [[left + 4, top + 4], [right - 4, bottom - 4]].some(([x, y]) => {
            const there = document.elementFromPoint(x, y);
            return !there || !(one.contains(there) || there.contains(one));
          });
          return { name: one.getAttribute("aria-label") ?? one.labels?.[0]?.textContent ?? one.textContent.trim(), shown, covered, wide: left < 0 || right > innerWidth, in: one.closest("#panel") !== null };
        });
        if (!stop.in) break;
        stops.push(stop);
        await page.keyboard.press("Tab");
      }
      for (const one of stops) assert.ok(one.shown && !one.covered && !one.wide, `${width}: the focus on "${one.name}" is seen: ${JSON.stringify(one)}`);
      return stops.map((one) => one.name);
    };
    await page.getByLabel("Name of the bridge").focus();
    const names = await walk(80);
    assert.deepEqual(names.slice(0, 6), ["Name of the bridge", "Number of the structure", "Number of spans", "Span", "Unit: Span", "Rise"]);
    const at = (name) => names.findIndex((one) => one.startsWith(name));
    const order = ["Axle", "Unit: Axle", "Paste rows", "Traffic over", "Judged by", "All that go", "CS 454 axles, all 6", "Some of CS 454"].map(at);
    assert.ok(order.every((one, k) => one > 0 && (k === 0 || one > order[k - 1])), `${order}: ${names}`);
    // And back up again, where a drawing that stays in its place may hide what lies behind it.
    await page.getByLabel("Judged by").focus();
    for (let k = 0; k < 14; k += 1) await page.keyboard.press("Shift+Tab");
    await walk(1);
    // A box is ticked by the space bar.
    await page.getByRole("checkbox", { name: /^CS 454 axles, all 6/ }).focus();
    await page.keyboard.press("Space");
    assert.equal(await page.getByRole("checkbox", { name: /^CS 454 axles, all 6/ }).isChecked(), false);
    await part(page, "Verdict");
    await page.getByRole("button", { name: /^Assessment with report/ }).focus();
    // By the keys, as who uses them comes there.
    await page.keyboard.press("Tab");
    await page.keyboard.press("Shift+Tab");
    assert.match((await walk(20)).join(" | "), /^Assessment with report.*Collapse load.*Load moved.*The bridge file/);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "nothing is cut");
    assert.deepEqual(complaints, []);
    await context.close();
  }
});
