// Hostile input does nothing worse than a message, and a worker that dies takes nothing with it.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { deflateRawSync } from "node:zlib";
import { end, headline, openExample, part, textOf, until, visit } from "../browser.mjs";

after(end);

const fragment = (shared) => `#b=${deflateRawSync(Buffer.from(JSON.stringify(shared)), { level: 9 }).toString("base64url")}`;
const SCRIPT = '<img src=x onerror="window.hurt=1"><script>window.hurt=1</script><svg onload="window.hurt=1">';

const TINY = (name, extra = "") => `[bridge]
name = '${name}'
width = "3 m"

[[span]]
profile = "segmental"
span = "4 m"
rise = "1 m"
thickness = "0.35 m"
voussoirs = 20
${extra}
[[cover]]
layer = "fill"
thickness = "0.3 m"
density = "1800 kg/m^3"

[masonry]
density = "2200 kg/m^3"
compressive_strength = "5 MPa"

[joint]
friction_angle = "31 deg"
cohesion = "0 kPa"

[dispersal]
rule = "uniform"
slope = "2:1"

[[load]]
name = '${name}'
kind = "knife-edge"
force = "1 kN/m"
length = "0.3 m"
at = "1/4 of span 1"

[analysis]
method = "limit"
`;

async function alive(page) {
  assert.equal(await page.evaluate(() => window.hurt), undefined, "no script of the input has run");
  assert.equal(await page.evaluate(() => document.querySelectorAll(".desk img[src='x'], .desk script").length), 0);
  if (!(await page.locator("dialog").isVisible())) await page.getByRole("button", { name: "Open a bridge" }).first().click();
  await page.locator("[data-example=tiny]").waitFor();
  await page.keyboard.press("Escape");
  await until("the dialog is closed", async () => !(await page.locator("dialog").isVisible()));
}

test("scripts in names stay letters, in the drawing, the form, the report", async () => {
  const { page, complaints, context } = await visit({ hash: fragment({ path: "a.toml", text: TINY(SCRIPT.replaceAll("'", "")) }) });
  await headline(page);
  await part(page, "Verdict");
  await page.getByRole("button", { name: /^Assessment with report/ }).click();
  await page.locator("iframe.report, .figures img, .complaint").first().waitFor({ timeout: 240_000 });
  await page.waitForTimeout(1000);
  await page.getByRole("button", { name: /^Collapse load/ }).click();
  await page.locator(".figures img").first().waitFor({ timeout: 240_000 });
  await alive(page);
  assert.deepEqual(complaints.filter((one) => /dialog/.test(one)), []);
  await context.close();
});

test("a million spans, a million voussoirs, deep nesting, long texts and numbers end in words", async () => {
  const texts = [
    TINY("a", "repeat = 1000000"),
    TINY("b").replace("voussoirs = 20", "voussoirs = 100000000"),
    `a = ${"[".repeat(100_000)}${"]".repeat(100_000)}`,
    `${"[a.".repeat(1)}${"b.".repeat(50_000)}c]\n`,
    `x = "${"y".repeat(900_000)}"`,
    TINY("c").replace('"4 m"', '"1e308 m"').replace('"1 m"', '"-0 m"'),
    TINY("d").replace('span = "4 m"', 'span = "nan m"'),
    "\u0000\uffff\ud800 [[[",
  ];
  for (const [k, text] of texts.entries()) {
    const { page, context } = await visit({ hash: fragment({ path: `h${k}.toml`, text }) });
    await until(`words about text ${k}`, async () => (await page.locator(".block .notes li.err, .block .notes li.warn, .notice").count()) > 0, 60);
    await alive(page);
    // The page still works for a decent bridge.
    await openExample(page, "tiny");
    assert.ok((await headline(page)) > 0);
    await context.close();
  }
});

test("bombs and rubbish in the address are named and not opened", async () => {
  const bomb = `#b=${deflateRawSync(Buffer.alloc(150_000_000, 0x30), { level: 9 }).toString("base64url")}`;
  for (const hash of [bomb.slice(0, 190_000), "#b=AAAA", `#b=${"A".repeat(300_000)}`, "#b=%00%00", fragment({ path: 1, text: 2 }), fragment(["a"])]) {
    const { page, context } = await visit({ hash });
    await page.locator(".notice").waitFor();
    await alive(page);
    await context.close();
  }
});

test("drawings, tables and files that are none are named", async () => {
  const { page, context } = await visit();
  await openExample(page, "tiny");
  await headline(page);
  const drop = (name, content) =>
    page.evaluate(
      ([name, content]) => {
        const data = new DataTransfer();
        data.items.add(new File([content], name));
        document.querySelector(".desk").dispatchEvent(new DragEvent("drop", { bubbles: true, cancelable: true, dataTransfer: data }));
      },
      [name, content],
    );
  await drop("evil.dxf", `0\nSECTION\n2\n<script>window.hurt=1</script>\n${"0\nINSERT\n2\nA\n".repeat(20_000)}`);
  await page.locator(".notice[role=alert]").waitFor();
  await drop("evil.csv", `time [s],${SCRIPT}\n${"1e999,NaN\n".repeat(1000)}`);
  await until("the table lies beside the bridge", async () => /evil\.csv/.test(await page.locator(".notice").innerText()));
  await drop("huge.toml", "#".repeat(2_100_000));
  await until("the size is named", async () => /MB/.test(await page.locator(".notice").innerText()));
  await alive(page);
  await context.close();
});

test("a worker that dies is replaced, and the document is still there", async () => {
  const { page, context } = await visit();
  await openExample(page, "bridgemill");
  const before = await headline(page);
  const text = await textOf(page);
  // The engine panics, as a defect of ours would make it.
  const lost = await page.evaluate(() => {
    const fail = new CustomEvent("extrados-test-fail");
    dispatchEvent(fail);
    return true;
  });
  assert.ok(lost);
  await page.waitForTimeout(500);
  const rise = page.locator('.grip[data-path="span[1].rise"]');
  await rise.focus();
  await rise.press("ArrowUp");
  await until("the new worker answers", async () => (await headline(page)) !== before);
  assert.notEqual(await textOf(page), text);
  assert.match(await textOf(page), /sandstone voussoirs/);
  await context.close();
});
