// Folders of results that are opened, and a load that falls where it was put.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { end, headline, openExample, part, saved, shot, until, visit } from "../browser.mjs";

after(end);

test("results of the command open beside their bridge, and name the version that made them", async () => {
  const { page, complaints, context } = await visit();
  await openExample(page, "tiny");
  await headline(page);
  await part(page, "Verdict");
  await page.getByRole("button", { name: /^Collapse load/ }).click();
  await page.locator(".figures img").first().waitFor({ timeout: 240_000 });
  const load = await page.getByTestId("verdict").innerText();
  const zip = await saved(page, () => page.getByRole("button", { name: "Everything, as a zip" }).click());
  const json = await saved(page, () => page.locator(".files button").filter({ hasText: "result.json" }).click());
  await context.close();

  const next = await visit();
  await next.page.getByRole("dialog").getByRole("button", { name: "Close" }).click();
  const drop = async (files) => {
    const data = await next.page.evaluateHandle((files) => {
      const data = new DataTransfer();
      for (const [name, bytes] of files) data.items.add(new File([new Uint8Array(bytes)], name));
      return data;
    }, files);
    await next.page.dispatchEvent(".desk", "drop", { dataTransfer: data });
  };
  await drop([["tiny.zip", [...zip]]]);
  await next.page.locator(".figures img").first().waitFor();
  assert.equal(await next.page.getByTestId("verdict").innerText(), load);
  assert.match(await next.page.getByTestId("opened").innerText(), /tiny\.zip/);
  assert.match(await next.page.getByTestId("version").innerText(), /^Extrados \d+\.\d+\.\d+/);
  await shot(next.page, "opened-1280-light");
  await part(next.page, "Bridge");
  await headline(next.page);
  // Of another version, and without its bridge: beside the one that is open.
  const other = JSON.stringify({ ...JSON.parse(json.toString()), version: "0.0.9" });
  await drop([["result.json", [...Buffer.from(other)]]]);
  await until("its version", async () => /^Extrados 0\.0\.9; this page is /.test(await next.page.getByTestId("version").innerText()));
  await drop([["broken.zip", [1, 2, 3]]]);
  await next.page.getByText("broken.zip cannot be opened. It is no zip archive").waitFor();
  assert.deepEqual([...complaints, ...next.complaints], []);
  await next.context.close();
});

test("a collapse loads the bridge where its load was put", async () => {
  const { page, complaints, context } = await visit({ calm: true });
  await openExample(page, "bridgemill");
  await headline(page);
  await part(page, "Load");
  await page.locator(".grip.load").focus();
  for (let k = 0; k < 4; k += 1) await page.keyboard.press("ArrowRight");
  const place = (await page.getByTestId("place").innerText()).trim();
  await part(page, "Collapse");
  await page.getByRole("button", { name: "Load until it falls" }).click();
  await page.getByTestId("run-place").waitFor({ timeout: 120_000 });
  assert.ok((await page.getByTestId("run-place").innerText()).includes(place), place);
  await until("blocks bear load", async () => (await headline(page, "run-headline")) > 0, 120);
  await shot(page, "collapse-where-1280-light");
  assert.deepEqual(complaints, []);
  await context.close();
});
