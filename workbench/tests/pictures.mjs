// Pictures for the documentation: `node tests/pictures.mjs` after a build. One moves: an animated PNG, put together from screenshots.
import { writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { crc32 } from "node:zlib";
import { end, headline, openExample, part, until, world } from "./browser.mjs";

const out = join(dirname(fileURLToPath(import.meta.url)), "..", "..", "docs", "images");

/** Chunks of a PNG as [type, data]. */
function chunks(png) {
  const list = [];
  for (let at = 8; at < png.length; ) {
    const length = png.readUInt32BE(at);
    list.push([png.toString("latin1", at + 4, at + 8), png.subarray(at + 8, at + 8 + length)]);
    at += 12 + length;
  }
  return list;
}

function chunk(type, data) {
  const body = Buffer.concat([Buffer.from(type, "latin1"), data]);
  const head = Buffer.alloc(4);
  head.writeUInt32BE(data.length);
  const tail = Buffer.alloc(4);
  tail.writeUInt32BE(crc32(body));
  return Buffer.concat([head, body, tail]);
}

/** Pictures of one size, shown one after the other for ever (PNG specification, third edition, section 11.3.6). */
function animated(pictures, milliseconds) {
  const words = (...numbers) => {
    const data = Buffer.alloc(4 * numbers.length);
    numbers.forEach((number, k) => data.writeUInt32BE(number, 4 * k));
    return data;
  };
  const first = chunks(pictures[0]);
  const header = first.find(([type]) => type === "IHDR")[1];
  const parts = [pictures[0].subarray(0, 8), chunk("IHDR", header), chunk("acTL", words(pictures.length, 0))];
  let sequence = 0;
  pictures.forEach((picture, k) => {
    const delay = Buffer.alloc(6);
    delay.writeUInt16BE(milliseconds, 0);
    delay.writeUInt16BE(1000, 2);
    parts.push(chunk("fcTL", Buffer.concat([words(sequence++), header.subarray(0, 8), words(0, 0), delay])));
    for (const [type, data] of chunks(picture)) {
      if (type !== "IDAT") continue;
      parts.push(k === 0 ? chunk("IDAT", data) : chunk("fdAT", Buffer.concat([words(sequence++), data])));
    }
  });
  parts.push(chunk("IEND", Buffer.alloc(0)));
  return Buffer.concat(parts);
}

const { browser, url } = await world();
async function visit(options) {
  const context = await browser.newContext({ viewport: { width: 1180, height: 720 }, ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(120_000);
  await page.goto(url);
  return page;
}

// The load is dragged there and back; the least along the road is known.
{
  const page = await visit({ deviceScaleFactor: 0.75 });
  await openExample(page, "bridgemill");
  await part(page, "Load");
  await headline(page);
  await until("the envelope is whole", async () => {
    const text = await page.getByTestId("least").textContent().catch(() => "");
    return text.includes("Least") && !text.includes("places");
  }, 300);
  const scene = await page.locator(".middle").boundingBox();
  const clip = { x: scene.x, y: scene.y + 36, width: scene.width, height: scene.height - 36 };
  const pictures = [];
  const grip = page.locator(".grip.load");
  const box = await grip.boundingBox();
  await page.mouse.move(box.x + 28, box.y + 30);
  await page.mouse.down();
  const count = 20;
  for (let k = 0; k < count; k += 1) {
    const share = 0.5 - 0.5 * Math.cos((2 * Math.PI * k) / count);
    await page.mouse.move(box.x + 28 + 215 * share, box.y + 30);
    await page.waitForTimeout(350);
    pictures.push(await page.screenshot({ clip }));
  }
  await page.mouse.up();
  writeFileSync(join(out, "workbench-drag.png"), animated(pictures, 140));
  await page.context().close();
}

for (const [name, theme] of [["workbench-load", "light"], ["workbench-load-dark", "dark"]]) {
  const page = await visit({ colorScheme: theme });
  await openExample(page, "viaduct");
  await part(page, "Load");
  await headline(page);
  await until("an envelope", async () => (await page.getByTestId("least").count()) > 0, 300);
  await page.waitForTimeout(theme === "light" ? 20_000 : 12_000);
  await page.locator(".middle").screenshot({ path: join(out, `${name}.png`) });
  await page.context().close();
}

{
  const page = await visit({});
  await openExample(page, "bridgemill");
  await headline(page);
  await part(page, "Collapse");
  await page.getByRole("button", { name: "Load until it falls" }).click();
  await page.locator("#speed").fill("30");
  await page.locator("#times").fill("7");
  await until("it ends", async () => /Ended/.test(await page.locator(".block").innerText()), 400);
  await page.locator(".middle").screenshot({ path: join(out, "workbench-collapse.png") });
  await page.context().close();
}

{
  const page = await visit({ viewport: { width: 390, height: 780 } });
  await openExample(page, "bridgemill");
  await part(page, "Load");
  await headline(page);
  await page.waitForTimeout(5000);
  await page.screenshot({ path: join(out, "workbench-phone.png") });
}
await end();
