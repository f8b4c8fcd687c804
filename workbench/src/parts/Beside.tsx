/** Answers side by side: the named cases of a bridge, and two bridges. */
import { createMemo, createSignal, For, Show, type JSX } from "solid-js";
import { download } from "../drawing/film";
import { background } from "../model/background";
import { nameOf, perform, runOf, taskOf } from "../model/task";
import type { Sheet } from "../model/sheet";
import { countOf, inserted } from "../model/structure";
import { say, sheets } from "../model/workspace";
import { system } from "../shell/settings";
import { figures, force, inSystem, lineLoad, place, small, stress, words, type Said } from "../units";
import { plainly, typeset } from "../wording";
import { setTab } from "./BridgePanel";
import { SaveFigure, Svg } from "./Verdict";
import { setPart } from "../model/workspace";

type Kind = "cases" | "compare";
const TITLE: Record<Kind, string> = { cases: "Cases side by side", compare: "Two bridges side by side" };

type OneCase = { name: string; acts: string; load_factor: number | null; result: { status: string; headline_kn_per_m?: number | null } };
type Compared = {
  verdict: string;
  cautions: string[];
  differences: { path: string; before: string | null; after: string | null }[];
  numbers: { name: string; before: number | null; after: number | null; change_percent: number | null }[];
  assumptions_before_only: string[];
  assumptions_after_only: string[];
  before_file: string;
  after_file: string;
};

const number = (value: number | null | undefined, digits = 4): string => (typeof value === "number" ? figures(value, digits) : "–");
/** What a number of a result is called, and how it is shown: "last_stable_load_kn_per_m" is "Last stable load". */
function worded(name: string): { title: string; show: (value: number | null) => string } {
  const [, base, unit] = /^(.*?)_(kn_per_m|kn|mpa|mm|m)$/.exec(name) ?? [null, name, ""];
  const plain = base!.replace(/_/g, " ").replace("headline", "carried load");
  const said: Record<string, (value: number) => Said> = {
    kn_per_m: (value) => lineLoad(1e3 * value, system()),
    kn: (value) => force(1e3 * value, system()),
    mpa: (value) => stress(1e6 * value, system()),
    mm: (value) => small(1e-3 * value, system()),
    m: (value) => place(value, system()),
  };
  const bare = (value: number): string => (Number.isInteger(value) && Math.abs(value) < 1e6 ? String(value) : figures(value, 4));
  return { title: plain.charAt(0).toUpperCase() + plain.slice(1), show: (value) => (value === null ? "–" : said[unit!] ? words(said[unit!]!(value)) : bare(value)) };
}

/** Rows that say each number once: the load that leads a result is one of those below it. */
function rows(numbers: Compared["numbers"]): Compared["numbers"] {
  const unit = (name: string): string => /_(kn_per_m|kn)$/.exec(name)?.[1] ?? name;
  return numbers.filter((one, k) => !one.name.startsWith("headline") || !numbers.some((other, j) => j !== k && unit(other.name) === unit(one.name) && other.before === one.before && other.after === one.after));
}

/** The table, and the drawings of every answer below it. */
export function BesideScene(props: { sheet: Sheet; kind: Kind }): JSX.Element {
  const task = () => taskOf(props.sheet, props.kind)[0]();
  const cases = () => (task().result?.object["cases"] as OneCase[] | undefined) ?? [];
  const compared = () => task().result?.object as unknown as Compared;
  const names = (): string[] => (compared().before_file === compared().after_file ? ["as opened", "now"] : [compared().before_file, compared().after_file]);
  return (
    <div class="scene sheet-of-paper" classList={{ blank: !task().result }} tabindex="0" role="region" aria-label={TITLE[props.kind]}>
      <Show
        when={task().result}
        fallback={
          <div class="veil">
            <Show when={task().mode === "runs"} fallback={
              <div>
                <p>{props.kind === "cases" ? "Every case of the file by the same analysis, and which of them governs." : "What two files say differently, and what that changes."}</p>
                <Show when={task().trouble}><p class="complaint" role="alert">{task().trouble}</p></Show>
              </div>
            }>
              <div role="status">
                <p>{task().words || "Begins"} …</p>
                <div class="bar"><i style={{ transform: `scaleX(${Number.isFinite(task().fraction) ? task().fraction : 0.05})` }} /></div>
              </div>
            </Show>
          </div>
        }
      >
        {(result) => (
          <div class="beside">
            <Show when={props.kind === "cases"}>
              <table class="plain" data-testid="cases">
                <caption class="unseen">Load factors of the cases</caption>
                <thead><tr><th scope="col">Case</th><th scope="col">What acts</th><th scope="col" class="right">Load factor</th><th scope="col" class="right">Carried</th><th scope="col">Ended</th></tr></thead>
                <tbody>
                  <For each={cases()}>
                    {(one) => (
                      <tr classList={{ leads: one.name === result().object["governing_case"] }}>
                        <th scope="row">{one.name}{one.name === result().object["governing_case"] ? ", governs" : ""}</th>
                        <td>{one.acts}</td>
                        <td class="right num">{number(one.load_factor)}</td>
                        <td class="right num">{typeof one.result.headline_kn_per_m === "number" ? words(lineLoad(1e3 * one.result.headline_kn_per_m, system())) : "–"}</td>
                        <td>{one.result.status}</td>
                      </tr>
                    )}
                  </For>
                </tbody>
              </table>
            </Show>
            <Show when={props.kind === "compare"}>
              <table class="plain" data-testid="numbers">
                <caption class="unseen">Numbers of both</caption>
                <thead><tr><th scope="col">Number</th><th scope="col" class="right">{names()[0]}</th><th scope="col" class="right">{names()[1]}</th><th scope="col" class="right">Change</th></tr></thead>
                <tbody>
                  <For each={rows(compared().numbers)}>
                    {(one) => <tr><th scope="row">{worded(one.name).title}</th><td class="right num">{worded(one.name).show(one.before)}</td><td class="right num">{worded(one.name).show(one.after)}</td><td class="right num">{one.change_percent === null ? "" : `${one.change_percent > 0 ? "+" : ""}${number(one.change_percent, 3)} %`}</td></tr>}
                  </For>
                </tbody>
              </table>
              <h2>What the files say differently</h2>
              <table class="plain" data-testid="differences">
                <caption class="unseen">Differences of the files</caption>
                <thead><tr><th scope="col">Value</th><th scope="col">{names()[0]}</th><th scope="col">{names()[1]}</th></tr></thead>
                <tbody>
                  <For each={compared().differences.slice(0, 200)}>{(one) => <tr><th scope="row">{one.path}</th><td>{typeset(one.before ?? "not there")}</td><td>{typeset(one.after ?? "not there")}</td></tr>}</For>
                </tbody>
              </table>
            </Show>
            <div class="figures">
              <For each={result().figures}>
                {(figure) => (
                  <figure>
                    <Svg svg={figure.svg} name={figure.name} />
                    <figcaption>{figure.name.replace(/[-/]/g, " ")} <SaveFigure svg={figure.svg} name={figure.name} /></figcaption>
                  </figure>
                )}
              </For>
            </div>
          </div>
        )}
      </Show>
    </div>
  );
}

export function BesideBlock(props: { sheet: Sheet; kind: Kind }): JSX.Element {
  const task = () => taskOf(props.sheet, props.kind)[0]();
  const object = () => task().result?.object ?? null;
  const notes = createMemo(() => {
    const found = object();
    if (!found) return [];
    const texts = (key: string): string[] => (found[key] as string[] | undefined) ?? [];
    return [
      ...texts("cautions").map((text) => ({ kind: "warn", text: plainly(text) })),
      ...((found["warnings"] as { message?: string }[] | undefined) ?? []).map((one) => ({ kind: "warn", text: plainly(one.message ?? "") })),
      ...texts("assumptions_before_only").map((text) => ({ kind: "", text: `Only the first assumes: ${plainly(text)}` })),
      ...texts("assumptions_after_only").map((text) => ({ kind: "", text: `Only the second assumes: ${plainly(text)}` })),
    ];
  });
  return (
    <section class="block" aria-label="Answer" id="answer" tabindex="-1">
      <div>
        <span class="cap">{TITLE[props.kind]}</span>
        <Show when={props.kind === "cases"} fallback={<span class="headline words long" data-testid="compared">{object() ? inSystem(String(object()!["verdict"]), system()).replace(/^./, (c) => c.toUpperCase()) : "–"}</span>}>
          <span class="headline num" data-testid="least-case">{number((object()?.["load_factor_at_most"] as number | null | undefined) ?? null)}<span class="unit">{object() ? "least load factor" : ""}</span></span>
          <Show when={object()?.["governing_case"]}>{(name) => <span class="under">Case “{String(name())}” governs</span>}</Show>
        </Show>
      </div>
      <div>
        <span class="cap">By</span>
        <b>The analysis that {props.kind === "cases" ? "the file plans" : "each file plans"}</b>
        <Show when={task().result && task().texts[0] !== props.sheet.text()}><div class="under">The bridge has changed since.</div></Show>
      </div>
      <div class="notes" tabindex="0" role="region" aria-label="Warnings and assumptions">
        <span class="cap">Warnings and assumptions</span>
        <ul><For each={notes()} fallback={<li>None so far.</li>}>{(one) => <li class={one.kind}>{one.text}</li>}</For></ul>
      </div>
    </section>
  );
}

export function CasesPanel(props: { sheet: Sheet }): JSX.Element {
  const count = () => countOf(props.sheet.text(), "case");
  const names = (): string[] => props.sheet.reading[0]()?.sections?.load_names ?? [];
  const [name, setName] = createSignal("");
  const add = (): void => {
    const load = names()[0];
    if (load === undefined) return;
    const title = (name().trim() || `case ${count() + 1}`).replace(/["\\]/g, "");
    props.sheet.change(inserted(props.sheet.text(), "case", `name = "${title}"\n\n[[case.load]]\nname = ${JSON.stringify(load)}\nfactor = ${count() === 0 ? "1.0" : "1.35"}`), "case");
    setName("");
    say(`The case “${title}” stands in the text, with a factor on the load “${load}”. Change both there.`);
  };
  return (
    <div class="panel-body" tabindex="-1">
      <h2>Cases</h2>
      <p class="soft">A case names loads that act together, each with its factor. The file has {count() === 0 ? "none" : count() === 1 ? "one" : count()}.</p>
      <button type="button" class="btn main" disabled={count() === 0 || !props.sheet.reading[0]()?.usable || taskOf(props.sheet, "cases")[0]().mode === "runs"} onClick={() => void perform([[props.sheet, props.sheet.text()]], "cases", { choice: "{}" })}>Compute every case</button>
      <Stop sheet={props.sheet} kind="cases" />
      <h3 class="spaced">Add a case</h3>
      <Show when={names().length > 0} fallback={<p class="soft">The file has no load yet.</p>}>
        <div class="field wide">
          <label for="case-name">Name of the case</label>
          <div class="entry"><input id="case-name" class="text" maxlength="80" placeholder={`case ${count() + 1}`} value={name()} onInput={(event) => setName(event.currentTarget.value)} /></div>
        </div>
        <div class="row">
          <button type="button" class="btn small" onClick={add}>Write it into the file</button>
          <button type="button" class="btn small" onClick={() => { setPart("bridge"); setTab("text"); }}>To the text</button>
        </div>
      </Show>
      <Files sheet={props.sheet} kind="cases" />
    </div>
  );
}

export function ComparePanel(props: { sheet: Sheet }): JSX.Element {
  const others = () => sheets().filter((one) => one !== props.sheet);
  const [chosen, setChosen] = createSignal("");
  const other = () => others().find((one) => one.id === chosen()) ?? null;
  const usable = () => props.sheet.reading[0]()?.usable === true && props.sheet.reading[0]()?.kind === "bridge";
  const run = (): void => {
    const before = other();
    const sheets: [Sheet, string][] = [[props.sheet, props.sheet.text()], before ? [before, before.text()] : [props.sheet, props.sheet.opened]];
    void perform(sheets, "compare", { before: nameOf(sheets[1]![0], 1), choice: "{}" });
  };
  return (
    <div class="panel-body" tabindex="-1">
      <h2>Compare</h2>
      <div class="field wide">
        <label for="compare-with">{props.sheet.name()}, compared with</label>
        <select id="compare-with" onChange={(event) => setChosen(event.currentTarget.value)}>
          <option value="" selected={chosen() === ""}>itself as it was opened</option>
          <For each={others()}>{(one) => <option value={one.id} selected={chosen() === one.id}>{one.name()}, {one.path}</option>}</For>
        </select>
      </div>
      <button type="button" class="btn main" disabled={!usable() || taskOf(props.sheet, "compare")[0]().mode === "runs"} onClick={run}>Compare</button>
      <Stop sheet={props.sheet} kind="compare" />
      <p class="soft">Both by the analysis that their file plans. Open a second bridge to compare two; one that is changed here stands beside what it was.</p>
      <Files sheet={props.sheet} kind="compare" />
    </div>
  );
}

function Stop(props: { sheet: Sheet; kind: Kind }): JSX.Element {
  return <Show when={taskOf(props.sheet, props.kind)[0]().mode === "runs"}><button type="button" class="btn" onClick={() => background.stop()}>Stop</button></Show>;
}

/** What the command would write, as files. */
function Files(props: { sheet: Sheet; kind: Kind }): JSX.Element {
  const result = () => taskOf(props.sheet, props.kind)[0]().result;
  const get = async (name: string): Promise<void> => {
    try {
      const run = runOf(props.sheet, props.kind);
      if (name === "") download(await background.call<Uint8Array>("zip", { run }), `${props.kind}.zip`, "application/zip");
      else download(await background.call<Uint8Array>("file", { run, name }), name.split("/").pop()!);
    } catch (error) {
      say(`${name || "The archive"} could not be made: ${(error as Error).message}`, true);
    }
  };
  return (
    <Show when={result()}>
      {(found) => (
        <>
          <h2 class="spaced">Files</h2>
          <button type="button" class="btn small" onClick={() => void get("")}>Everything, as a zip</button>
          <ul class="files"><For each={found().files}>{(name) => <li><button type="button" class="link" onClick={() => void get(name)}>{name}</button></li>}</For></ul>
        </>
      )}
    </Show>
  );
}
