// From a survey sheet to a verdict: several spans, what the bridge is judged by, and the words that are said on the way.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { end, headline, openExample, part, serious, shot, survey, textOf, until, visit } from "../browser.mjs";

after(end);

/** Without vehicles all that go with the rule stay ticked; otherwise those of a load model that are named, or all of it. */
const judged = async (page, field, [traffic, rule, model, ...vehicles]) => {
  await field("Traffic over the bridge").selectOption(traffic);
  await field("Judged by").selectOption(rule);
  assert.ok(await field("All that go with the rule").isChecked(), "a rule brings its vehicles");
  if (model === undefined) return;
  await field("All that go with the rule").uncheck();
  if (vehicles.length === 0) return page.getByRole("checkbox", { name: new RegExp(`^${model}, all`) }).check();
  await page.getByText(`Some of ${model}`, { exact: true }).click();
  for (const vehicle of vehicles) await page.getByRole("checkbox", { name: vehicle }).check();
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
  await judged(page, field, ["road", "cs-454", "CS 454 axles", "CS 454 single axle, 11.5 t"]);
  await until("the file has both", async () => /\[sweep\]\nrule = "cs-454"\nvehicles = \["cs454-single"\]/.test(await textOf(page)));
  await shot(page, "survey-judge-1280-light");
  await part(page, "Verdict");
  // Asked once: the survey has answered.
  assert.equal(await page.locator("#judge-traffic").count(), 0);
  assert.equal(await assessed(page), "Undetermined");
  await page.getByRole("region", { name: "Warnings and assumptions" }).getByText(/^Missing: load cases of CS 454 left out/).waitFor();
  await part(page, "Bridge");
  await judged(page, field, ["road", "cs-454", "CS 454 axles"]);
  await until("all axles of the rule", async () => /rule = "cs-454"\n# every vehicle/.test(await textOf(page)));
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
  assert.match(await page.getByTestId("governs").innerText(), /^CS 454 bogie, 2 x 10 t governs: factor 0\.\d+/);
  await shot(page, "verdict-words-1280-light");
  await page.setViewportSize({ width: 390, height: 844 });
  await page.getByTestId("governs").scrollIntoViewIfNeeded();
  await shot(page, "verdict-words-390-light");
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "nothing is cut on a phone");
  assert.deepEqual(complaints.filter((one) => !/^Blocked script execution/.test(one)), []);
  await context.close();
});

test("an assessment without a rule asks for it where it ends, in a survey and in any file", async () => {
  for (const [width, theme] of [[1280, "dark"], [390, "light"]]) {
    const { page, complaints, context } = await visit({ width, theme, height: width === 390 ? 844 : 800 });
    const field = await survey(page);
    await field("Thickness of the ring").fill("0.35");
    await part(page, "Verdict");
    assert.equal(await assessed(page), "Undetermined: nothing was compared");
    assert.equal(await page.getByTestId("on-assumptions").count(), 0);
    assert.match(await page.locator(".block .notes").textContent(), /Missing: no rule for strength: “Verdict” asks for rule and vehicles, and so does a survey/);
    await page.getByText("The file names no rule that judges the bridge").waitFor();
    await judged(page, field, ["rail", "nr-civ-025", "Route Availability", /^RA10:/]);
    await field("Traffic over the bridge").scrollIntoViewIfNeeded();
    await shot(page, `verdict-judge-${width}-${theme}`);
    assert.deepEqual(await serious(page), []);
    await page.getByRole("button", { name: "Write it into the file" }).click();
    await until("it is in the file", async () => /rule = "nr-civ-025"/.test(await textOf(page)));
    assert.equal(await page.locator("#judge-traffic").count(), 0);
    assert.equal(await assessed(page), "Not adequate for RA10");
    assert.match(await page.getByTestId("governs").innerText(), /^RA10: 20 units.* governs: factor 0\.\d+, 1\.00 is asked for$/);
    assert.match(await page.getByTestId("carries").innerText(), /^Route Availability: less than RA10$/);
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
  await judged(page, (name) => page.getByLabel(name, { exact: true }), ["road", "cs-454", "CS 454 axles", "CS 454 single axle, 11.5 t"]);
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

test("vehicles are ticked: all of the rule, several, none; the file has the codes", async () => {
  for (const [width, theme] of [[1280, "light"], [390, "dark"]]) {
    const { page, complaints, context } = await visit({ width, theme, height: width === 390 ? 844 : 800 });
    const field = await survey(page);
    await judged(page, field, ["road", "cs-454"]);
    await until("the rule alone", async () => /\[sweep\]\nrule = "cs-454"\n# every vehicle of the library that goes with the rule[^\n]*\n/.test(await textOf(page)));
    assert.ok(await page.getByRole("checkbox", { name: /^CS 454 axles, all 6/ }).isChecked(), "what the rule brings is ticked");
    assert.ok(!(await page.getByRole("checkbox", { name: /^HB, all 4/ }).isChecked()), "abnormal loads are moved where they are named");
    assert.ok(!(await page.getByRole("checkbox", { name: /^British weight restrictions, all/ }).isChecked()), "and what it does not bring is not");
    await page.getByText("Some of British weight restrictions", { exact: true }).click();
    await page.getByRole("checkbox", { name: /^40 t/ }).check();
    await until("several", async () => /vehicles = \["cs-454", "gb-40t"\]/.test(await textOf(page)));
    assert.ok(!(await field("All that go with the rule").isChecked()));
    await field("All that go with the rule").scrollIntoViewIfNeeded();
    await shot(page, `survey-vehicles-${width}-${theme}`);
    assert.deepEqual(await serious(page), []);
    await field("All that go with the rule").check();
    await until("all again", async () => /# every vehicle/.test(await textOf(page)));
    await field("All that go with the rule").uncheck();
    await until("none is no rule", async () => !/\[sweep\]/.test(await textOf(page)));
    await page.getByText("Nothing is ticked").waitFor();
    // A rule for road and rail names the road's vehicles.
    await field("Judged by").selectOption("en-1991-2");
    await until("road alone", async () => /rule = "en-1991-2"\nvehicles = \["lm1", "lm2"\]/.test(await textOf(page)));
    await page.reload();
    await headline(page);
    assert.ok(await field("All that go with the rule").isChecked(), "kept on this machine");
    assert.deepEqual(complaints, []);
    await context.close();
  }
});

test("the name stands over the drawing, units are those of engineers, and what is usual stands at the field", async () => {
  for (const [width, theme] of [[1280, "dark"], [390, "light"]]) {
    const { page, complaints, context } = await visit({ width, theme, height: width === 390 ? 844 : 800 });
    const field = await survey(page);
    await field("Name of the bridge").fill("Mill Lane, Upton");
    await until("it is the title of the sheet", async () => (await page.locator(".sheet-title").textContent()) === "Mill Lane, Upton");
    assert.match(await page.title(), /^Mill Lane, Upton/);
    assert.match(await textOf(page), /name = "Mill Lane, Upton"/);
    await field("Density of the masonry").fill("22 kN/m3");
    await until("a weight per volume", async () => /density = "22 kN\/m3"\n/.test(await textOf(page)));
    await page.getByText("22 kN/m³ is 2243 kg/m³ at g = 9.81 m/s².").waitFor();
    await field("Density of the masonry").fill("23");
    await field("Unit: Density of the masonry").selectOption("kN/m^3");
    await until("by its unit", async () => /density = "23 kN\/m\^3"\n/.test(await textOf(page)));
    await field("Axle").fill("11.5");
    await field("Unit: Axle").selectOption("t");
    await until("an axle in tonnes", async () => /axle_force = "11.5 t"\n/.test(await textOf(page)));
    await page.getByText("11.5 t weighs 112.8 kN at g = 9.81 m/s².").waitFor();
    assert.equal(await page.locator(".panel-body .complaint").count(), 0);
    await field("Thickness of the ring").focus();
    await page.getByText("Usually 1/40 to 1/10 of the span.").waitFor();
    await field("Strength of the masonry").focus();
    await page.getByText("Usually 0.5 MPa to 400 MPa.").waitFor();
    await page.getByText(/Of the library: .*brick.* 3 to 10 MPa/).waitFor();
    await shot(page, `survey-units-${width}-${theme}`);
    // Feet and pounds all through, and back with nothing lost.
    await page.getByRole("button", { name: "Units: metric. Change" }).click();
    assert.equal(await field("Span").getAttribute("placeholder"), "19.7");
    assert.equal(await field("Unit: Span").inputValue(), "ft");
    await field("Thickness of the ring").fill("18");
    await field("Unit: Thickness of the ring").selectOption("in");
    await until("inches", async () => /thickness = "18 in"\n/.test(await textOf(page)));
    await until("the others with it", async () => /span = "19.685 ft"  # assumed/.test(await textOf(page)));
    assert.match(await textOf(page), /contact_length = "0.984 ft"/);
    await until("what is assumed as well", async () => /over its 7\.546 ft[\s\S]*layer density 119 lb\/ft³/.test(await page.locator(".block").innerText()));
    assert.equal(await page.locator(".panel-body .complaint").count(), 0);
    await page.getByRole("tab", { name: "Findings", exact: true }).waitFor();
    await field("Width of the barrel").focus();
    await page.getByText(/Usually 3\.28 ft to 131 ft\./).waitFor();
    assert.equal(await field("Axle").inputValue(), "11.5 t");
    await shot(page, `survey-imperial-${width}-${theme}`);
    const panel = await page.locator(".panel-body").innerText();
    assert.ok(!/\d (?:m|mm|MPa|kN)\b/.test(panel), `metric left: ${/.{30}\d (?:m|mm|MPa|kN)\b/.exec(panel)?.[0]}`);
    await page.getByRole("button", { name: "Units: imperial. Change" }).click();
    assert.equal(await field("Thickness of the ring").inputValue(), "18 in");
    assert.equal(await field("Unit: Density of the masonry").inputValue(), "kN/m^3");
    assert.deepEqual(await serious(page), []);
    assert.deepEqual(complaints, []);
    await context.close();
  }
});

test("rows of a spreadsheet are pasted into the survey, and what was not understood is told", async () => {
  for (const [width, theme] of [[1280, "light"], [390, "light"]]) {
    const { page, complaints, context } = await visit({ width, theme, height: width === 390 ? 844 : 800 });
    const field = await survey(page);
    const table = "Item\tValue\nBridge name\tMill Lane\nClear span\t7.20 m\nRise (mm)\t1650\nRing thickness\t0.55\nFill depth\t400 mm\nSkew\t12 deg\nParapet\t1.1 m\nUnit weight of masonry\t22 kN/m3\n";
    await page.evaluate((text) => navigator.clipboard.writeText(text), table);
    await field("Span").focus();
    await page.keyboard.press("Control+v");
    await until("the file follows", async () => /name = "Mill Lane"[\s\S]*span = "7.20 m"[\s\S]*rise = "1650 mm"[\s\S]*thickness = "0.55 m"[\s\S]*thickness = "400 mm"[\s\S]*density = "22 kN\/m3"/.test(await textOf(page)));
    assert.equal(await field("Span").inputValue(), "7.20");
    assert.equal(await field("Rise").inputValue(), "1650");
    assert.equal(await field("Unit: Rise").inputValue(), "mm");
    const told = page.locator(".told");
    assert.match(await told.innerText(), /^7 rows taken: Name of the bridge Mill Lane; Span 7\.20 m;/);
    assert.match(await told.innerText(), /Not understood:\s*row 8, “Parapet: 1.1 m”: no question of the survey has this name/);
    await told.scrollIntoViewIfNeeded();
    await shot(page, `survey-rows-${width}-${theme}`);
    // One value goes into its field as ever, and a table may be typed as well.
    await page.evaluate(() => navigator.clipboard.writeText("8.1"));
    await field("Span").fill("");
    await field("Span").focus();
    await page.keyboard.press("Control+v");
    await until("one value", async () => /span = "8.1 m"/.test(await textOf(page)));
    await page.getByText("Paste rows from a spreadsheet").click();
    await field("Rows of a spreadsheet").fill("rise, 2 m\nheight of the parapet, 1 m");
    await page.getByRole("button", { name: "Fill in the fields" }).click();
    await until("typed rows", async () => /rise = "2 m"/.test(await textOf(page)));
    assert.match(await told.innerText(), /^1 row taken: Rise 2 m\./);
    assert.deepEqual(await serious(page), []);
    assert.deepEqual(complaints, []);
    await context.close();
  }
});
