// A real Chromium on the built page. EXTRADOS_WORKBENCH_URL names a server that runs already (`extrados workbench --no-browser`).
import { existsSync, mkdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { serve } from "./serve.mjs";

const here = dirname(fileURLToPath(import.meta.url));
export const SHOTS = join(here, "shots");
mkdirSync(SHOTS, { recursive: true });

const CHROMIUM = process.env.EXTRADOS_BROWSER ?? "/usr/bin/chromium";
const FLAGS = [
  "--headless",
  "--no-sandbox",
  "--disable-gpu",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

let shared = null;

export async function world() {
  if (shared) return shared;
  const built = join(here, "..", "dist");
  if (!process.env.EXTRADOS_WORKBENCH_URL && !existsSync(join(built, "index.html"))) throw new Error("npm run build comes first");
  const { server, url } = process.env.EXTRADOS_WORKBENCH_URL ? { server: null, url: process.env.EXTRADOS_WORKBENCH_URL } : await serve(built);
  const browser = await chromium.launch({ executablePath: CHROMIUM, args: FLAGS });
  shared = { browser, url, server };
  return shared;
}

export async function end() {
  await shared?.browser.close();
  shared?.server?.close();
  shared = null;
}

/** A page of its own, with everything that it complained of; `before` is called before it is opened. */
export async function visit({ width = 1280, height = 800, theme = "light", hash = "", calm = false, touch = false, serviceWorkers = "allow", before = async () => undefined } = {}) {
  const { browser, url } = await world();
  const context = await browser.newContext({
    viewport: { width, height },
    colorScheme: theme,
    reducedMotion: calm ? "reduce" : "no-preference",
    hasTouch: touch,
    acceptDownloads: true,
    serviceWorkers,
    permissions: ["clipboard-read", "clipboard-write"],
  });
  const page = await context.newPage();
  page.setDefaultTimeout(60_000);
  const complaints = [];
  page.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("dialog", (dialog) => {
    complaints.push(`dialog: ${dialog.message()}`);
    void dialog.dismiss();
  });
  await before(page);
  await page.goto(url + hash);
  return { page, context, complaints, url };
}

export async function openExample(page, name, file = "") {
  if (!(await page.locator("dialog").isVisible().catch(() => false))) await page.getByRole("button", { name: "Open a bridge" }).first().click();
  const card = page.locator(".choice").filter({ has: page.locator(`[data-example="${name}"]`) });
  await card.waitFor();
  if (file === "") await card.locator(`[data-example="${name}"]`).click();
  else {
    await card.locator("summary").click();
    await card.getByRole("button", { name: file, exact: true }).click();
  }
  await page.locator(".scene canvas").first().waitFor();
}

export const part = (page, name) => page.getByRole("navigation", { name: "Parts" }).getByRole("button", { name }).click();

/** Drops a file on the page, as from the desktop. */
export async function dropped(page, name, text) {
  const data = await page.evaluateHandle(([name, text]) => {
    const data = new DataTransfer();
    data.items.add(new File([text], name));
    return data;
  }, [name, text]);
  await page.dispatchEvent(".desk", "drop", { dataTransfer: data });
}

/** The number of the headline, once there is one. */
export async function headline(page, id = "headline") {
  const place = page.getByTestId(id);
  await place.waitFor();
  for (let k = 0; k < 600; k += 1) {
    const text = (await place.textContent()).replace(/\s/g, "");
    const number = Number.parseFloat(text.replace("−", "-"));
    if (Number.isFinite(number)) return number;
    await page.waitForTimeout(100);
  }
  throw new Error("no headline");
}

export async function shot(page, name) {
  await page.waitForTimeout(250);
  await page.screenshot({ path: join(SHOTS, `${name}.png`) });
}

/** Until a condition holds, or not within its time. */
export async function until(what, condition, seconds = 60) {
  const end = Date.now() + 1000 * seconds;
  for (;;) {
    if (await condition()) return;
    if (Date.now() > end) throw new Error(`not within ${seconds} s: ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
}

/** The text of the bridge file, from the editor's state as it is kept. */
export const textOf = (page) =>
  page.evaluate(() => {
    dispatchEvent(new Event("pagehide"));
    const kept = JSON.parse(localStorage.getItem("extrados.workspace.1"));
    return kept.sheets.find((sheet) => sheet.id === kept.active).text;
  });

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** What axe calls serious or worse on the page as it stands. */
export async function serious(page) {
  await page.evaluate(axe);
  return page.evaluate(async () => {
    const { violations } = await window.axe.run(document, { resultTypes: ["violations"] });
    return violations.filter((one) => one.impact === "serious" || one.impact === "critical").map((one) => `${one.id}: ${one.nodes.map((node) => node.target.join(" ")).join(" | ")}`);
  });
}

/** The bytes of what a click saves. */
export const saved = async (page, click) => {
  const download = page.waitForEvent("download");
  await click();
  return readFileSync(await (await download).path());
};

/** Begins a survey; gives its fields by their names. */
export const survey = async (page) => {
  await page.getByRole("button", { name: "Ten survey numbers" }).click();
  await headline(page);
  return (name) => page.getByLabel(name, { exact: true });
};
