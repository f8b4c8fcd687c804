// Verdict: the report as by the command, every file, the same numbers.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { end, headline, openExample, part, saved, shot, textOf, until, visit } from "../browser.mjs";

after(end);

const named = (page, name) => saved(page, () => page.getByRole("button", { name, exact: typeof name === "string" }).click());

test("an assessment gives a report that prints, and files to take away", async () => {
  const { page, complaints, context } = await visit();
  await openExample(page, "tiny");
  await headline(page);
  await part(page, "Verdict");
  await page.getByRole("button", { name: /^Assessment with report/ }).click();
  const report = page.frameLocator("iframe.report");
  await report.locator("h1").waitFor({ timeout: 300_000 });
  assert.ok((await report.locator("svg, img").count()) > 0, "figures are in the report");
  const styled = await report.locator("h1").evaluate((element) => getComputedStyle(element).fontFamily);
  assert.ok(!/^"?Times/.test(styled), "the report has its style");
  await page.waitForTimeout(500);
  await shot(page, "verdict-1280-light");
  // A number leads to its place in the file, by key or by hand, and back again.
  const value = report.locator("#inputs ~ div a.lead").filter({ hasText: "m" }).first();
  const title = await value.getAttribute("title");
  await value.focus();
  await page.keyboard.press("Enter");
  await page.locator("[data-testid=editor]").waitFor();
  await page.locator(".notice").waitFor();
  assert.match(await page.locator(".notice, [role=status]").allInnerTexts().then((all) => all.join(" ")), new RegExp(`${/Go to (\S+) in/.exec(title)[1].replace(/[.[\]]/g, "\\$&")} is marked`));
  await shot(page, "verdict-input-1280-light");
  await part(page, "Verdict");
  await report.locator("h1").waitFor();
  const leads = await report.locator("a.lead").count();
  assert.ok(leads >= 8, `${leads} numbers lead to their input`);
  const html = (await named(page, "report.html")).toString();
  assert.match(html, /<!doctype html>/i);
  const bridge = (await named(page, /^The bridge file/)).toString();
  assert.equal(bridge, await textOf(page));
  const zip = await named(page, /as a zip/);
  assert.equal(zip.subarray(0, 2).toString(), "PK");
  // The frame refuses what the driver of this test runs in it, as it refuses every script.
  assert.deepEqual(complaints.filter((one) => !/^Blocked script execution in '[^']*\/report\.html'/.test(one)), []);
  await context.close();
});

test("a collapse load has figures, DXF and VTU", async () => {
  const { page, complaints, context } = await visit();
  await openExample(page, "tiny");
  await headline(page);
  await part(page, "Verdict");
  await page.getByRole("button", { name: /^Collapse load/ }).click();
  await page.locator(".figures img").first().waitFor({ timeout: 240_000 });
  await until("figures are drawn", () => page.locator(".figures img").first().evaluate((image) => image.complete && image.naturalWidth > 0));
  const names = await page.locator(".files li").allInnerTexts();
  for (const ending of [".json", ".svg", ".dxf", ".vtu"]) assert.ok(names.some((name) => name.endsWith(ending)), `${ending} among ${names.join(", ")}`);
  const result = JSON.parse((await named(page, "result.json")).toString());
  assert.ok(Math.abs(result.headline_kn_per_m - (await headline(page, "verdict"))) < 0.06);
  await shot(page, "verdict-collapse-1280-light");
  assert.deepEqual(complaints, []);
  await context.close();
});
