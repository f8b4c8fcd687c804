// From a survey sheet to a verdict: several spans, what the bridge is judged by, and the words that are said on the way.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, test } from "node:test";
import { end, headline, openExample, part, shot, textOf, until, visit } from "../browser.mjs";

after(end);
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

async function serious(page) {
  await page.evaluate(axe);
  return page.evaluate(async () => {
    const { violations } = await window.axe.run(document, { resultTypes: ["violations"] });
    return violations.filter((one) => one.impact === "serious" || one.impact === "critical").map((one) => `${one.id}: ${one.nodes.map((node) => node.target.join(" ")).join(" | ")}`);
  });
}

const survey = async (page) => {
  await page.getByRole("button", { name: "Ten survey numbers" }).click();
  await headline(page);
  return (name) => page.getByLabel(name, { exact: true });
};

const judged = async (page, field, [traffic, rule, vehicles]) => {
  await field("Traffic over the bridge").selectOption(traffic);
  await field("Judged by").selectOption(rule);
  await field("Vehicles that must be carried").selectOption(vehicles);
};

const assessed = async (page) => {
  await page.getByRole("button", { name: /^Assessment with report/ }).click();
  await page.frameLocator("iframe.report").locator("h1").waitFor({ timeout: 300_000 });
  return (await page.getByTestId("verdict").innerText()).trim();
};

test("several spans are drawn while they are typed; a pier is asked for and not assumed, what the others have is", async () => {
  for (const [width, theme] of [[1280, "light"], [1280, "dark"], [390, "light"], [390, "dark"]]) {
    const { page, complaints, context } = await visit({ width, theme, height: width === 390 ? 844 : 800 });
    const field = await survey(page);
    const drawn = () => page.locator("canvas[role=img]").getAttribute("aria-label");
    await field("Number of spans").fill("3");
    await until("both numbers of the pier are asked for", async () => (await page.getByText("The drawing waits for this number: nothing is assumed in its place.").count()) === 2);
    assert.ok(!/\[\[pier\]\]/.test(await textOf(page)), "no pier that nobody saw");
    await field("Width of the pier").fill("1.2");
    await field("Height of the pier").fill("4");
    await until("both piers are in the file", async () => (await textOf(page)).match(/\[\[pier\]\]/g)?.length === 2);
    await until("and nothing is complained of", async () => (await page.locator(".panel-body .complaint").count()) === 0);
    await field("Rise, span 3").fill("1.2");
    await until("the third span has its own rise", async () => /rise = "1.2 m"\n/.test(await textOf(page)));
    await field("Span, span 3").fill("5");
    await until("and its own span, which is drawn", async () => (await drawn()).includes("5\u2009000"));
    const text = await textOf(page);
    assert.equal(text.match(/rise = "1.50 m"  # assumed: as span 1/g).length, 1);
    assert.equal(text.match(/height = "4 m"  # assumed: as pier 1/g).length, 1);
    await until("it is said beside the answer", async () => /span 2 as span 1 \(span, rise, thickness\).*span 3 as span 1 \(thickness\)/.test(await page.locator(".block .notes").textContent()));
    await page.getByRole("textbox", { name: "Width of pier 2" }).fill("wide");
    await page.locator(".others .complaint").waitFor();
    await page.getByRole("textbox", { name: "Width of pier 2" }).fill("1.5");
    await until("it is taken", async () => /width = "1.5 m"\n/.test(await textOf(page)));
    await field("Width of the pier").scrollIntoViewIfNeeded();
    await shot(page, `survey-spans-${width}-${theme}`);
    assert.deepEqual(await serious(page), []);
    // Fewer spans take their numbers out of the file, and not off the sheet.
    await field("Number of spans").fill("1");
    await until("one span again", async () => !/\[\[pier\]\]/.test(await textOf(page)));
    assert.deepEqual(complaints, []);
    await context.close();
  }
});

test("a survey that names rule and vehicles ends in a verdict that says on what it rests", async () => {
  const { page, complaints, context } = await visit();
  const field = await survey(page);
  await field("Thickness of the ring").fill("0.6");
  // Nothing is chosen for the engineer; a rule without safety cannot be chosen.
  assert.equal(await field("Traffic over the bridge").inputValue(), "");
  await field("Traffic over the bridge").selectOption("rail");
  assert.ok(await field("Judged by").locator('option[value="irs-bridge-rules"]').isDisabled());
  assert.equal(await field("Judged by").locator('option[value="cs-454"]').count(), 0);
  // One axle of a rule is not all that the rule asks for.
  await judged(page, field, ["road", "cs-454", "cs454-single"]);
  await until("the file has both", async () => /\[sweep\]\nrule = "cs-454"\nvehicles = \["cs454-single"\]/.test(await textOf(page)));
  await shot(page, "survey-judge-1280-light");
  await part(page, "Verdict");
  // Asked once: the survey has answered.
  assert.equal(await page.locator("#judge-traffic").count(), 0);
  assert.equal(await assessed(page), "Undetermined");
  await page.getByRole("region", { name: "Warnings and assumptions" }).getByText(/^Missing: load cases of CS 454 left out/).waitFor();
  await part(page, "Bridge");
  await judged(page, field, ["road", "cs-454", "cs-454"]);
  await until("all axles of the rule", async () => /vehicles = \["cs-454"\]/.test(await textOf(page)));
  await part(page, "Verdict");
  assert.equal(await assessed(page), "Adequate");
  assert.match(await page.getByTestId("on-assumptions").innerText(), /nobody measured/);
  const report = await page.frameLocator("iframe.report").locator("body").innerText();
  assert.ok(/To be confirmed on site[\s\S]*2200 kg\/m³/.test(report) && !/[a-z]\^\d/.test(report), "what is assumed is to be confirmed, units are printed");
  const notes = page.getByRole("region", { name: "Warnings and assumptions" });
  await notes.getByText(/measured by nobody:.*masonry density 2200 kg\/m³.*joint friction angle 30 deg/).waitFor();
  assert.match(await page.locator(".block").innerText(), /CS 454, masonry arches/);
  await shot(page, "verdict-survey-1280-light");
  // A thinner ring fails, and is said to.
  await part(page, "Bridge");
  await field("Thickness of the ring").fill("0.35");
  await until("a thinner ring", async () => /thickness = "0.35 m"/.test(await textOf(page)));
  assert.match(await textOf(page), /rule = "cs-454"/);
  await part(page, "Verdict");
  assert.equal(await assessed(page), "Not adequate");
  assert.deepEqual(complaints.filter((one) => !/^Blocked script execution/.test(one)), []);
  await context.close();
});

test("an assessment without a rule asks for it where it ends, in a survey and in any file", async () => {
  for (const [width, theme] of [[1280, "dark"], [390, "light"]]) {
    const { page, complaints, context } = await visit({ width, theme, height: width === 390 ? 844 : 800 });
    const field = await survey(page);
    await field("Thickness of the ring").fill("0.35");
    await part(page, "Verdict");
    assert.equal(await assessed(page), "Undetermined");
    assert.equal(await page.getByTestId("on-assumptions").count(), 0);
    assert.match(await page.locator(".block .notes").textContent(), /Missing: no rule for strength: “Verdict” asks for rule and vehicles, and so does a survey/);
    await page.getByText("The file names no rule that judges the bridge").waitFor();
    await judged(page, field, ["rail", "nr-civ-025", "ra10"]);
    await field("Traffic over the bridge").scrollIntoViewIfNeeded();
    await shot(page, `verdict-judge-${width}-${theme}`);
    assert.deepEqual(await serious(page), []);
    await page.getByRole("button", { name: "Write it into the file" }).click();
    await until("it is in the file", async () => /rule = "nr-civ-025"/.test(await textOf(page)));
    assert.equal(await page.locator("#judge-traffic").count(), 0);
    assert.equal(await assessed(page), "Not adequate");
    // The survey has the answer as well, and goes on writing the file.
    await part(page, "Bridge");
    assert.equal(await field("Judged by").inputValue(), "nr-civ-025");
    await field("Rise").fill("1.4");
    await until("both are there", async () => /rise = "1.4 m"[\s\S]*rule = "nr-civ-025"/.test(await textOf(page)));
    assert.deepEqual(complaints.filter((one) => !/^Blocked script execution/.test(one)), []);
    await context.close();
  }
  // A file that never was a survey.
  const { page, context } = await visit();
  await openExample(page, "two-span");
  await headline(page);
  await part(page, "Verdict");
  await judged(page, (name) => page.getByLabel(name, { exact: true }), ["road", "cs-454", "cs454-single"]);
  await page.getByRole("button", { name: "Write it into the file" }).click();
  await until("it is in the file", async () => /\[sweep\]\nrule = "cs-454"\nvehicles = \["cs454-single"\]/.test(await textOf(page)));
  assert.match(await textOf(page), /slender pier/);
  await context.close();
});

test("the page names its own controls, and units as they are printed", async () => {
  const { page, context } = await visit();
  await survey(page);
  const notes = page.getByRole("region", { name: "Warnings and assumptions" });
  await notes.getByText(/“Deformable joints”, in the table of methods under Load/).waitFor();
  const said = async (where) => {
    const text = await page.locator("body").innerText();
    assert.ok(!/docs\//.test(text), `${where}: a page of the documentation: ${/.{40}docs\/.{40}/.exec(text)?.[0]}`);
    assert.ok(!/[a-z]\^\d/.test(text), `${where}: ${/.{20}[a-z]\^\d.{10}/.exec(text)?.[0]}`);
  };
  await said("survey");
  await page.getByRole("tab", { name: "Form" }).click();
  await page.getByText("Show values that the file leaves to their defaults").click();
  await page.locator(".library summary").first().click();
  await page.locator(".library select").first().selectOption({ index: 1 });
  await said("form");
  await part(page, "Load");
  await page.getByRole("cell", { name: /^Deformable joints/ }).waitFor();
  await said("load");
  await context.close();
});
