/** Verdict: whole analyses as the command makes them, their report, and every file that the command would write. */
import { createMemo, createSignal, For, onCleanup, Show, type JSX } from "solid-js";
import { Lost, Refused, sentences } from "../engine/client";
import type { PlaceInText, Reading, ResultOut } from "../engine/types";
import { download } from "../drawing/film";
import { assumedIn } from "../model/assumed";
import type { Entry, ResultFolder } from "../model/archive";
import { analyse, background } from "../model/background";
import { overItsWidth } from "../model/carried";
import { judgedBy } from "../model/judged";
import { library, version } from "../model/library";
import { sought } from "../model/structure";
import type { Sheet } from "../model/sheet";
import { trade, type Assessed } from "../model/verdict";
import { liveEngine } from "../model/live";
import { say } from "../model/workspace";
import { system } from "../shell/settings";
import { figures, inSystem, lineLoad, place, words } from "../units";
import { plainly, typeset } from "../wording";
import { goToText } from "./BridgePanel";
import { JudgeFile } from "./Judge";

type Kind = { call: string; title: string; about: string; offered: (reading: Reading, text: string) => boolean; args: Record<string, unknown> };

const KINDS: Kind[] = [
  { call: "assess", title: "Assessment with report", about: "Every check that the file asks for, and the verdict", offered: (r) => r.kind === "bridge", args: {} },
  { call: "collapse", title: "Collapse load", about: "By the method of the file", offered: (r, text) => r.kind === "blocks" || ((r.sections?.loads ?? 0) > 0 && sought(text) === "load"), args: { choice: "{}" } },
  { call: "collapse", title: "Least thickness", about: "Of rings that just stand, with their hinges and line of thrust", offered: (r, text) => r.kind === "bridge" && sought(text) === "thickness", args: { choice: "{}" } },
  { call: "collapse", title: "Movement of a support", about: "As far as the bridge stands, and the movement that brings it down", offered: (r, text) => r.kind === "bridge" && sought(text) === "support-movement", args: { choice: "{}" } },
  { call: "sweep", title: "Load moved along the bridge", about: "The least load, or vehicles of a rule", offered: (r) => (r.sections?.loads ?? 0) > 0 || r.sections?.sweep === true, args: { choice: "{}", step: NaN } },
  { call: "cases", title: "Named cases side by side", about: "Each case of the file", offered: (r) => (r.sections?.cases ?? 0) > 0, args: { choice: "{}" } },
  { call: "respond", title: "Passage of a train", about: "Displacements, strains and stresses", offered: (r) => r.sections?.passage === true, args: {} },
];

type Verdict = {
  mode: "idle" | "runs" | "done" | "failed";
  kind: Kind | null;
  words: string;
  fraction: number;
  result: (ResultOut & { report: string | null; object: Record<string, unknown> }) | null;
  text: string;
  trouble: string;
  /** The files of a folder of results that was opened, and what it is called; none of an analysis made here. */
  opened: { name: string; files: Entry[] } | null;
};

const verdicts = new WeakMap<Sheet, ReturnType<typeof createSignal<Verdict>>>();
function verdictOf(sheet: Sheet) {
  let found = verdicts.get(sheet);
  if (!found) {
    found = createSignal<Verdict>({ mode: "idle", kind: null, words: "", fraction: NaN, result: null, text: "", trouble: "", opened: null });
    verdicts.set(sheet, found);
  }
  return found;
}

const runName = (sheet: Sheet): string => `verdict-${sheet.id}`;

async function run(sheet: Sheet, kind: Kind): Promise<void> {
  const [, set] = verdictOf(sheet);
  const text = sheet.text();
  scrolled.delete(sheet);
  set({ mode: "runs", kind, words: "", fraction: NaN, result: null, text, trouble: "", opened: null });
  try {
    const out = await analyse(sheet, kind.call, { run: runName(sheet), ...kind.args }, (stage, fraction) => set((old) => ({ ...old, words: stage, fraction })));
    let report: string | null = null;
    if (out.files.includes("report.html")) {
      report = new TextDecoder().decode(await background.call<Uint8Array>("file", { run: runName(sheet), name: "report.html" }));
    }
    set((old) => ({ ...old, mode: "done", result: { ...out, report, object: JSON.parse(out.json) } }));
  } catch (error) {
    const trouble = error instanceof Refused ? sentences(error) : error instanceof Lost && error.why === "stopped" ? "" : error instanceof Lost && error.why === "slow" ? "The engine did not answer, was stopped and started again." : `The engine broke down and was started again. ${(error as Error).message}`;
    set((old) => ({ ...old, mode: trouble ? "failed" : "idle", trouble }));
  }
}

/** Shows a folder of results as if it had been made here: its numbers, report, figures and files. */
export function showFolder(sheet: Sheet, name: string, folder: ResultFolder): void {
  const words = new TextDecoder();
  const of = (suffix: RegExp): Entry[] => folder.files.filter((file) => suffix.test(file.name));
  const schema = String(folder.object["schema"]).replace(/^extrados\.|\/\d+$/g, "");
  const call = /sweep/.test(schema) ? "sweep" : schema;
  const kind = KINDS.find((one) => one.call === call) ?? { call, title: schema.replace(/-/g, " ").replace(/^./, (c) => c.toUpperCase()), about: "", offered: () => false, args: {} };
  const report = folder.files.find((file) => file.name === "report.html");
  const figures = of(/\.svg$/).map((file) => ({ name: file.name.replace(/\.svg$/, ""), svg: words.decode(file.bytes) }));
  scrolled.delete(sheet);
  verdictOf(sheet)[1]({
    mode: "done", kind, words: "", fraction: NaN, trouble: "", text: sheet.text(), opened: { name, files: folder.files },
    result: { status: String(folder.object["status"] ?? ""), json: folder.json, picture: "null", figures, files: folder.files.map((file) => file.name), report: report ? words.decode(report.bytes) : null, object: folder.object },
  });
}

/** Opens the text of the file where it says what a number of the report rests on. */
async function goToInput(sheet: Sheet, path: string): Promise<void> {
  const found = await liveEngine.call<PlaceInText | null>("placeOf", { text: sheet.text(), path }).catch(() => null);
  if (!found) return say(`The file says nothing of ${path}: the number rests on what the program takes then.`);
  goToText(found);
  say(found.written ? `${found.path} is marked in the text of the file.` : `The file does not write ${path}; its table is marked.`);
}

/** Where the report was when somebody left it for an input. */
const scrolled = new WeakMap<Sheet, number>();

const LEAD = "#input:";

/** Prints the units of a report, and makes every number of it that names its input a link that leads there. The frame runs no script, not even listeners from outside in every
 * browser: its links change its fragment, and the page looks at that. */
function lead(inside: Document): void {
  const style = inside.createElement("style");
  style.textContent =
    "a.lead { color: inherit; text-decoration: underline dotted 1px; text-underline-offset: 3px; } a.lead:hover { text-decoration-style: solid; } " +
    "@media print { a.lead { text-decoration: none; } }";
  inside.head.append(style);
  const texts = inside.createTreeWalker(inside.body, NodeFilter.SHOW_TEXT);
  for (let text = texts.nextNode(); text; text = texts.nextNode()) {
    if (!text.parentElement?.closest("code, pre")) text.nodeValue = typeset(text.nodeValue ?? "");
  }
  for (const holder of inside.querySelectorAll<HTMLElement>("[data-input]")) {
    const cell = holder.tagName === "TR" ? (holder.children[1] as HTMLElement | undefined) : holder;
    const path = holder.dataset["input"] ?? "";
    if (!cell || path === "" || cell.textContent?.trim() === "") continue;
    const link = inside.createElement("a");
    link.className = "lead";
    link.href = LEAD + encodeURIComponent(path);
    link.title = `Go to ${path} in the file`;
    link.append(...cell.childNodes);
    cell.append(link);
  }
}

/** The report in a frame that runs no script; its own page has its own policy. */
function Report(props: { sheet: Sheet; html: string; hold: (frame: HTMLIFrameElement) => void }): JSX.Element {
  let frame!: HTMLIFrameElement;
  const fill = (): void => {
    const inside = frame.contentDocument;
    const window = frame.contentWindow as (Window & typeof globalThis) | null;
    if (!inside || !window) return;
    // Parsed by the frame, whose policy lets a report have its styles.
    const parsed = new window.DOMParser().parseFromString(props.html, "text/html");
    for (const element of parsed.querySelectorAll("script, iframe, object, embed, link, base, meta, form")) element.remove();
    inside.replaceChild(inside.adoptNode(parsed.documentElement), inside.documentElement);
    lead(inside);
    window.scrollTo(0, scrolled.get(props.sheet) ?? 0);
  };
  const asked = setInterval(() => {
    const window = frame.contentWindow;
    const hash = window?.location.hash ?? "";
    if (!window || !hash.startsWith(LEAD)) return;
    scrolled.set(props.sheet, window.scrollY);
    window.history.replaceState(null, "", window.location.pathname);
    void goToInput(props.sheet, decodeURIComponent(hash.slice(LEAD.length)));
  }, 100);
  onCleanup(() => clearInterval(asked));
  return (
    <iframe
      ref={(made) => {
        frame = made;
        props.hold(made);
      }}
      class="report"
      title="Report of the assessment"
      sandbox="allow-same-origin allow-modals"
      src="./report.html"
      onLoad={fill}
    />
  );
}

/** A drawing of the engine as an image: nothing in it can run or reach out. */
export function Svg(props: { svg: string; name: string }): JSX.Element {
  const url = createMemo(() => {
    const made = URL.createObjectURL(new Blob([props.svg], { type: "image/svg+xml" }));
    onCleanup(() => URL.revokeObjectURL(made));
    return made;
  });
  return <img src={url()} alt={props.name.replace(/-/g, " ")} />;
}

/** A figure as a file: as it is drawn, or as a picture twice as fine as on the screen. */
export function SaveFigure(props: { svg: string; name: string }): JSX.Element {
  const name = () => props.name.split("/").pop()!;
  const png = (): void => {
    const url = URL.createObjectURL(new Blob([props.svg], { type: "image/svg+xml" }));
    const image = new Image();
    image.onload = () => {
      const canvas = document.createElement("canvas");
      canvas.width = 2 * (image.naturalWidth || 1200);
      canvas.height = 2 * (image.naturalHeight || 800);
      canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
      canvas.toBlob((blob) => blob && download(blob, `${name()}.png`));
      URL.revokeObjectURL(url);
    };
    image.src = url;
  };
  return (
    <span class="saves">
      <button type="button" class="link" aria-label={`Save ${name()} as SVG`} onClick={() => download(new TextEncoder().encode(props.svg), `${name()}.svg`, "image/svg+xml")}>SVG</button>
      <button type="button" class="link" aria-label={`Save ${name()} as PNG`} onClick={png}>PNG</button>
    </span>
  );
}

let frame: HTMLIFrameElement | null = null;

export function VerdictScene(props: { sheet: Sheet }): JSX.Element {
  const verdict = () => verdictOf(props.sheet)[0]();
  return (
    <div class="scene sheet-of-paper" classList={{ blank: !verdict().result }} tabindex="0" role="region" aria-label="Result">
      <Show
        when={verdict().result}
        fallback={
          <div class="veil">
            <Show
              when={verdict().mode === "runs"}
              fallback={
                <div>
                  <p>Choose what is computed. It is the same analysis as by the command, with the same numbers.</p>
                  <Show when={verdict().trouble}>
                    <p class="complaint" role="alert">{verdict().trouble}</p>
                  </Show>
                </div>
              }
            >
              <div role="status">
                <p>{verdict().kind?.title}: {verdict().words || "begins"} …</p>
                <div class="bar"><i style={{ transform: `scaleX(${Number.isFinite(verdict().fraction) ? verdict().fraction : 0.05})` }} /></div>
              </div>
            </Show>
          </div>
        }
      >
        {(result) => (
          <Show when={result().report} fallback={
            <div class="figures">
              <For each={result().figures}>{(figure) => (
                <figure>
                  <Svg svg={figure.svg} name={figure.name} />
                  <figcaption>{figure.name.replace(/[-/]/g, " ")} <SaveFigure svg={figure.svg} name={figure.name} /></figcaption>
                </figure>
              )}</For>
            </div>
          }>
            {(html) => <Report sheet={props.sheet} html={html()} hold={(made) => (frame = made)} />}
          </Show>
        )}
      </Show>
    </div>
  );
}

const STATUS: Record<string, string> = {
  adequate: "Adequate",
  inadequate: "Not adequate",
  undetermined: "Undetermined",
  collapsed: "Carried",
  completed: "Completed",
};

/** A line of a text, from 1, as a stretch of it. */
function lineOf(text: string, line: number): { start: number; end: number } {
  const lines = text.split("\n");
  const start = lines.slice(0, line - 1).reduce((sum, one) => sum + one.length + 1, 0);
  return { start, end: start + (lines[line - 1]?.length ?? 0) };
}

export function VerdictBlock(props: { sheet: Sheet }): JSX.Element {
  const verdict = () => verdictOf(props.sheet)[0]();
  const object = () => verdict().result?.object ?? null;
  const load = () => {
    const value = object()?.["headline_kn_per_m"];
    return typeof value === "number" ? value * 1e3 : null;
  };
  const rule = createMemo(() => {
    const known = library();
    const code = known && verdict().result ? judgedBy(verdict().text, known) : "";
    return known?.rules.find((one) => one.code === code)?.title ?? code;
  });
  const assumed = createMemo(() => (verdict().result ? assumedIn(verdict().text) : []));
  const whole = () => typeof object()?.["headline_kn"] === "number";
  const notes = createMemo(() => {
    const found = object();
    if (!found) return [];
    const list: { kind: string; text: string; line?: number }[] = [];
    const texts = (key: string): string[] => ((found[key] as string[] | undefined) ?? []).map((text) => plainly(inSystem(text, system())));
    const missing = texts("missing");
    for (const text of missing) list.push({ kind: "warn", text: `Missing: ${text}` });
    if (assumed().length > 0) list.push({ kind: "", text: typeset(inSystem(`Assumed by the file, measured by nobody: ${assumed().join("; ")}.`, system())) });
    for (const one of (found["warnings"] as { message?: string; line?: number }[] | undefined) ?? []) list.push({ kind: "warn", text: `${one.line ? `Line ${one.line}: ` : ""}${plainly(inSystem(one.message ?? "", system()))}`, ...(one.line ? { line: one.line } : {}) });
    // What the command says beside the verdict, in the same words.
    for (const text of texts("beside")) list.push({ kind: "", text: `Beside the verdict: ${text}` });
    for (const text of texts("assumptions")) list.push({ kind: "", text });
    // What is missing is said once.
    return list.filter((one) => !missing.includes(one.text));
  });
  const status = () => verdict().result?.status ?? "";
  // Of a load that was moved, the least: a vehicle's factor, or the load of the file.
  const least = () => {
    const found = object()?.["governing"] as { position_m?: number; load_factor?: number; adequacy_factor?: number } | undefined;
    const factor = found?.adequacy_factor ?? found?.load_factor;
    return typeof found?.position_m === "number" && typeof factor === "number"
      ? { value: figures(factor, 3), unit: found.adequacy_factor === undefined ? "× the load" : "× the vehicle", says: `the least along the road, at ${words(place(found.position_m, system()))}` }
      : null;
  };
  // Of rings of which the least thickness was sought, that thickness.
  const thinnest = () => {
    const metres = object()?.["minimum_thickness_m"];
    const moved = object()?.["collapse_movement_m"];
    if (typeof moved === "number") return { value: figures(system() === "metric" ? 1e3 * moved : moved / 0.0254, 4), unit: system() === "metric" ? "mm" : "in", says: "the movement at which it falls" };
    const ratio = object()?.["minimum_thickness_over_mean_radius"];
    if (typeof metres !== "number") return null;
    return { value: figures(system() === "metric" ? 1e3 * metres : metres / 0.0254, 4), unit: system() === "metric" ? "mm" : "in", says: typeof ratio === "number" ? `the least thickness that stands, ${figures(ratio, 4)} of the mean radius` : "the least thickness that stands" };
  };
  const told = createMemo(() => (verdict().kind?.call === "assess" && object() ? trade(object() as Assessed) : null));
  const governing = () => {
    const factor = object()?.["adequacy_factor"] ?? object()?.["load_factor"];
    return typeof factor === "number" ? factor : null;
  };
  return (
    <section class="block" classList={{ telling: told() !== null }} aria-label="Answer" id="answer" tabindex="-1">
      <div>
        <span class="cap">{verdict().kind?.title ?? "Verdict"}</span>
        <Show when={load() !== null} fallback={
          <Show when={least() ?? thinnest()} fallback={<>
              <span class="headline words" data-testid="verdict">{told()?.says ?? STATUS[status()] ?? (status() || "–")}</span>
              <Show when={told()}>
                {(found) => (
                  <>
                    <Show when={found().governs}>{(words) => <div class="under" data-testid="governs"><b>{typeset(words())}</b></div>}</Show>
                    <For each={found().carries}>{(words) => <div class="under" data-testid="carries">{words}</div>}</For>
                    <Show when={found().with}>{(words) => <div class="under soft" data-testid="head">{plainly(words())}</div>}</Show>
                  </>
                )}
              </Show>
              <Show when={/^(in)?adequate$/.test(status()) && assumed().length > 0}>
                <div class="under" data-testid="on-assumptions">If what nobody measured is as assumed: the notes name it.</div>
              </Show>
            </>}>
            {(found) => (
              <>
                <span class="headline num" data-testid="verdict">
                  {found().value}
                  <span class="unit">{found().unit}</span>
                </span>
                <span class="under">{found().says}</span>
              </>
            )}
          </Show>
        }>
          <span class="headline num" data-testid="verdict">
            {lineLoad(load()!, system()).value}
            <span class="unit">{lineLoad(load()!, system()).unit}</span>
          </span>
          <Show when={whole()}><span class="under">{overItsWidth(props.sheet, load()!, system())}</span></Show>
        </Show>
      </div>
      <div>
        <span class="cap">By</span>
        <b>{String(object()?.["headline_from"] ?? verdict().kind?.about ?? "")}</b>
        <Show when={told() === null && status()}><div class="under">Status: {status()}</div></Show>
        <Show when={verdict().kind?.call === "assess" && rule()}><div class="under">{rule()}</div></Show>
        <Show when={governing() !== null}><div class="under">Factor on the load {figures(governing()!, 3)}</div></Show>
        <Show when={verdict().opened}>{(opened) => <div class="under" data-testid="opened">Opened from {opened().name}</div>}</Show>
        <Show when={verdict().result}><div class="under soft" data-testid="version">Extrados {String(object()?.["version"] ?? version() ?? "")}{verdict().opened && version() && object()?.["version"] !== version() ? `; this page is ${version()}` : ""}</div></Show>
      </div>
      <div class="notes" tabindex="0" role="region" aria-label="Warnings and assumptions">
        <span class="cap">Warnings and assumptions</span>
        <ul>
          <Show when={verdict().result && verdict().text !== props.sheet.text()}><li class="warn">The bridge has changed since this was {verdict().opened ? "opened" : "computed"}.</li></Show>
          <For each={notes()} fallback={<li>None so far.</li>}>{(one) => (
            <li class={one.kind}>
              <Show when={one.line} fallback={one.text}>{(line) => <button type="button" class="link" onClick={() => goToText(lineOf(props.sheet.text(), line()))}>{one.text}</button>}</Show>
            </li>
          )}</For>
        </ul>
      </div>
    </section>
  );
}

export function saveBridge(sheet: Sheet): void {
  download(new TextEncoder().encode(sheet.text()), sheet.path, "application/toml");
}

export function VerdictPanel(props: { sheet: Sheet }): JSX.Element {
  const verdict = () => verdictOf(props.sheet)[0]();
  const stem = () => props.sheet.path.replace(/\.\w+$/, "");
  const [busy, setBusy] = createSignal("");
  const get = async (name: string): Promise<void> => {
    setBusy(name);
    const opened = verdict().opened?.files.find((file) => file.name === name);
    try {
      if (opened) download(opened.bytes, name.split("/").pop()!);
      else if (name === "") download(await background.call<Uint8Array>("zip", { run: runName(props.sheet) }), `${stem()}.zip`, "application/zip");
      else download(await background.call<Uint8Array>("file", { run: runName(props.sheet), name }), name.split("/").pop()!);
    } catch (error) {
      say(`${name || "The archive"} could not be made: ${(error as Error).message}`, true);
    }
    setBusy("");
  };
  return (
    <div class="panel-body" tabindex="-1">
      <h2>Compute</h2>
      <div class="choices spaced">
        <For each={KINDS.filter((kind) => props.sheet.reading[0]() && kind.offered(props.sheet.reading[0]()!, props.sheet.text()))}>
          {(kind) => (
            <button type="button" disabled={verdict().mode === "runs" || !props.sheet.reading[0]()?.usable} onClick={() => void run(props.sheet, kind)}>
              <b>{kind.title}</b>
              <span>{kind.about}</span>
            </button>
          )}
        </For>
      </div>
      <Show when={verdict().mode === "runs"}>
        <button type="button" class="btn" onClick={() => background.stop()}>Stop</button>
      </Show>
      <Show when={system() === "imperial"}><p class="soft">The report, its figures and files are in metric units, as the command writes them.</p></Show>
      <JudgeFile sheet={props.sheet} />
      <Show when={verdict().result?.report}>
        <div class="row spaced">
          <button type="button" class="btn" onClick={() => frame?.contentWindow?.print()}>Print the report</button>
        </div>
      </Show>
      <h2 class="spaced">Files</h2>
      <div class="row">
        <button type="button" class="btn small" onClick={() => saveBridge(props.sheet)}>The bridge file, {props.sheet.path}</button>
        <Show when={verdict().result && !verdict().opened}>
          <button type="button" class="btn small" disabled={busy() !== ""} onClick={() => void get("")}>Everything, as a zip</button>
        </Show>
      </div>
      <Show when={verdict().result}>
        {(result) => (
          <ul class="files">
            <For each={result().files}>
              {(name) => (
                <li>
                  <button type="button" class="link" disabled={busy() !== ""} onClick={() => void get(name)}>{name}</button>
                </li>
              )}
            </For>
          </ul>
        )}
      </Show>
      <p class="soft">The command gives the same numbers for the same file: <code>extrados {verdict().kind?.call === "sweep" ? "collapse --sweep" : (verdict().kind?.call ?? "assess")} {props.sheet.path}</code></p>
    </div>
  );
}
