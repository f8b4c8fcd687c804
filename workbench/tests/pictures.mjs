// Pictures for the documentation: `node tests/pictures.mjs` after a build. One moves: an animated PNG, put together from screenshots.
import { writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { crc32, deflateSync, inflateSync } from "node:zlib";
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

/** Pixels of a PNG as Chromium writes it: eight bits a channel, not interlaced. */
function pixels(png) {
  const all = chunks(png);
  const header = all.find(([type]) => type === "IHDR")[1];
  const width = header.readUInt32BE(0);
  const height = header.readUInt32BE(4);
  const channels = header[9] === 6 ? 4 : 3;
  const raw = inflateSync(Buffer.concat(all.filter(([type]) => type === "IDAT").map(([, data]) => data)));
  const stride = width * channels;
  const out = Buffer.alloc(stride * height);
  for (let y = 0; y < height; y += 1) {
    const filter = raw[y * (stride + 1)];
    for (let x = 0; x < stride; x += 1) {
      const value = raw[y * (stride + 1) + 1 + x];
      const a = x >= channels ? out[y * stride + x - channels] : 0;
      const b = y > 0 ? out[(y - 1) * stride + x] : 0;
      const c = x >= channels && y > 0 ? out[(y - 1) * stride + x - channels] : 0;
      const p = a + b - c;
      const paeth = Math.abs(p - a) <= Math.abs(p - b) && Math.abs(p - a) <= Math.abs(p - c) ? a : Math.abs(p - b) <= Math.abs(p - c) ? b : c;
      out[y * stride + x] = value + [0, a, b, (a + b) >> 1, paeth][filter];
    }
  }
  return { width, height, channels, out };
}

/** Pictures with the 255 commonest colours of all of them, the others by the nearest: a fourth of the size. */
function paletted(pictures) {
  const decoded = pictures.map(pixels);
  const counts = new Map();
  const key = (out, at) => ((out[at] >> 2) << 12) | ((out[at + 1] >> 2) << 6) | (out[at + 2] >> 2);
  const exact = new Map();
  for (const { channels, out } of decoded) {
    for (let at = 0; at < out.length; at += channels) {
      const one = key(out, at);
      counts.set(one, (counts.get(one) ?? 0) + 1);
      if (!exact.has(one)) exact.set(one, [out[at], out[at + 1], out[at + 2]]);
    }
  }
  const colours = [...counts].sort((a, b) => b[1] - a[1]).slice(0, 255).map(([one]) => [(one >> 12) & 63, (one >> 6) & 63, one & 63]);
  const nearest = new Map();
  const index = (one) => {
    if (!nearest.has(one)) {
      const rgb = [(one >> 12) & 63, (one >> 6) & 63, one & 63];
      let best = 0;
      let least = Infinity;
      colours.forEach((colour, k) => {
        const distance = colour.reduce((sum, part, n) => sum + (part - rgb[n]) ** 2, 0);
        if (distance < least) [least, best] = [distance, k];
      });
      nearest.set(one, best);
    }
    return nearest.get(one);
  };
  const palette = Buffer.from(colours.flatMap(([r, g, b]) => exact.get((r << 12) | (g << 6) | b)));
  return decoded.map(({ width, height, channels, out }) => {
    const rows = Buffer.alloc((width + 1) * height);
    for (let y = 0; y < height; y += 1) for (let x = 0; x < width; x += 1) rows[y * (width + 1) + 1 + x] = index(key(out, (y * width + x) * channels));
    const header = Buffer.alloc(13);
    header.writeUInt32BE(width, 0);
    header.writeUInt32BE(height, 4);
    header.set([8, 3, 0, 0, 0], 8);
    return Buffer.concat([pictures[0].subarray(0, 8), chunk("IHDR", header), chunk("PLTE", palette), chunk("IDAT", deflateSync(rows, { level: 9 })), chunk("IEND", Buffer.alloc(0))]);
  });
}

/** Pictures of one size and palette, shown one after the other for ever (PNG specification, third edition, section 11.3.6). */
function animated(pictures, milliseconds) {
  const words = (...numbers) => {
    const data = Buffer.alloc(4 * numbers.length);
    numbers.forEach((number, k) => data.writeUInt32BE(number, 4 * k));
    return data;
  };
  const first = chunks(pictures[0]);
  const header = first.find(([type]) => type === "IHDR")[1];
  const parts = [pictures[0].subarray(0, 8), chunk("IHDR", header), chunk("acTL", words(pictures.length, 0)), ...first.filter(([type]) => type === "PLTE").map(([type, data]) => chunk(type, data))];
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
  const count = 14;
  for (let k = 0; k < count; k += 1) {
    const share = 0.5 - 0.5 * Math.cos((2 * Math.PI * k) / count);
    await page.mouse.move(box.x + 28 + 215 * share, box.y + 30);
    await page.waitForTimeout(350);
    pictures.push(await page.screenshot({ clip }));
  }
  await page.mouse.up();
  writeFileSync(join(out, "workbench-drag.png"), animated(paletted(pictures), 180));
  await page.context().close();
}

for (const [name, theme] of [["workbench-load", "light"], ["workbench-load-dark", "dark"]]) {
  const page = await visit({ colorScheme: theme });
  await openExample(page, "viaduct");
  await part(page, "Load");
  await headline(page);
  await until("an envelope", async () => (await page.getByTestId("least").count()) > 0, 300);
  await page.waitForTimeout(theme === "light" ? 20_000 : 12_000);
  writeFileSync(join(out, `${name}.png`), paletted([await page.locator(".middle").screenshot()])[0]);
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
  writeFileSync(join(out, "workbench-collapse.png"), paletted([await page.locator(".middle").screenshot()])[0]);
  await page.context().close();
}

{
  const page = await visit({ viewport: { width: 390, height: 780 } });
  await openExample(page, "bridgemill");
  await part(page, "Load");
  await headline(page);
  await page.waitForTimeout(5000);
  writeFileSync(join(out, "workbench-phone.png"), paletted([await page.screenshot()])[0]);
}
await end();
