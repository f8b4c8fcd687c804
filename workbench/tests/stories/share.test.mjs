// Share: the bridge in the address, work kept on this machine, several bridges, without a network.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { end, headline, openExample, part, textOf, until, visit, world } from "../browser.mjs";

after(end);

test("a link holds the bridge and nothing is asked of a server for it", async () => {
  const { page, context, url } = await visit();
  await openExample(page, "bridgemill");
  const there = await headline(page);
  await page.getByRole("button", { name: /Copy a link/ }).click();
  await page.locator(".notice").waitFor();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  assert.ok(link.startsWith(`${url}#b=`), link.slice(0, 60));
  const text = await textOf(page);
  const other = await visit({ hash: link.slice(url.length) });
  const asked = [];
  other.page.on("request", (request) => asked.push(request.url()));
  assert.equal(await headline(other.page), there);
  assert.equal(await textOf(other.page), text);
  assert.ok(asked.every((one) => one.startsWith(url) || one.startsWith("blob:")));
  await other.context.close();
  await context.close();
});

test("several bridges stand side by side and are there again after the tab was closed", async () => {
  const { page, context } = await visit();
  await openExample(page, "bridgemill");
  await headline(page);
  await openExample(page, "viaduct");
  await headline(page);
  const rise = page.locator('.grip[data-path="span[1].rise"]');
  await rise.focus();
  await rise.press("ArrowUp");
  await until("kept", async () => /rise = "2.45\d* m"/.test(await textOf(page)));
  const text = await textOf(page);
  await page.waitForTimeout(700);
  const { url } = await world();
  await page.close();
  const again = await context.newPage();
  await again.goto(url);
  await headline(again);
  assert.equal(await again.locator(".tab").count(), 2);
  assert.equal(await textOf(again), text);
  await again.locator(".tab button").first().click();
  await until("the other bridge", async () => /Bridgemill/.test(await again.locator(".sheet-title").innerText()));
  await context.close();
});

test("after the first visit the page opens and computes without a network", async () => {
  const { page, context } = await visit();
  await page.evaluate(() => navigator.serviceWorker.ready);
  await until("everything is kept", async () => page.evaluate(async () => {
    const names = await caches.keys();
    if (names.length === 0) return false;
    const kept = await (await caches.open(names[0])).keys();
    return kept.some((request) => request.url.endsWith(".wasm"));
  }), 60);
  await context.setOffline(true);
  await page.reload();
  await openExample(page, "tiny");
  assert.ok((await headline(page)) > 0);
  await part(page, "Load");
  await context.setOffline(false);
  await context.close();
});
