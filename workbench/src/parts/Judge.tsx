/** What a bridge is judged by, in the words of engineers: what runs over it, by which code, and with which vehicles. Neither traffic nor rule is chosen for the engineer; a rule brings its vehicles. */
import { createEffect, createMemo, createSignal, For, Show, type JSX } from "solid-js";
import type { LibraryModel } from "../engine/types";
import { allOf, codesOf, judgedBy, modelsOf, pickedBy, withJudged, type Judged } from "../model/judged";
import { library } from "../model/library";
import type { Sheet } from "../model/sheet";
import { say } from "../model/workspace";
import { system } from "../shell/settings";
import { inSystem } from "../units";

type Traffic = "" | "road" | "rail";

export function Judge(props: { id: string; start: Judged; change: (judged: Judged | null) => void }): JSX.Element {
  const ruleOf = (code: string) => library()?.rules.find((one) => one.code === code);
  const modelOf = (code: string) => library()?.models.find((one) => one.code === code || one.vehicles.some((vehicle) => vehicle.code === code));
  const [chosen, setChosen] = createSignal<Traffic | null>(null);
  const [rule, setRule] = createSignal(props.start.rule);
  const traffic = (): Traffic => {
    const own = modelOf(props.start.vehicles.split(",")[0]!.trim())?.ways ?? (ruleOf(rule())?.ways.length === 1 ? ruleOf(rule())!.ways[0] : undefined);
    return chosen() ?? (own === "road" || own === "rail" ? own : "");
  };
  const rules = createMemo(() => (library()?.rules ?? []).filter((one) => one.ways.includes(traffic())));
  const models = createMemo<LibraryModel[]>(() => (library() ? modelsOf(library()!, traffic(), rule()) : []));
  const all = createMemo(() => allOf(models()));
  const [ticked, setTicked] = createSignal<Set<string> | null>(null);
  const picked = (): Set<string> => ticked() ?? (rule() === "" ? new Set<string>() : pickedBy(models(), props.start.vehicles));
  const give = (): void => {
    const known = library();
    props.change(known && rule() !== "" && picked().size > 0 ? { rule: rule(), vehicles: codesOf(known, traffic(), rule(), picked()) } : null);
  };
  const pickTraffic = (value: string): void => {
    setChosen(value as Traffic);
    pickRule(rules().some((one) => one.code === rule()) ? rule() : "");
  };
  // A rule brings its vehicles; what must be carried besides, or alone, is ticked.
  const pickRule = (value: string): void => {
    // A rule for road and rail does not say which of both runs here.
    setChosen(traffic());
    setRule(value);
    setTicked(new Set(all()));
    give();
  };
  const tick = (codes: string[], is: boolean): void => {
    const next = new Set(picked());
    for (const code of codes) is ? next.add(code) : next.delete(code);
    setTicked(next);
    give();
  };
  const codes = (one: LibraryModel): string[] => one.vehicles.map((vehicle) => vehicle.code);
  const isAll = (): boolean => picked().size === all().size && [...all()].every((code) => picked().has(code));
  const taken = createMemo(() => models().filter((one) => codes(one).some((code) => picked().has(code))));
  const about = (one: LibraryModel): string =>
    [one.only_by_name ? "not among “all”" : "", one.longest_span === null ? "" : `for spans up to ${inSystem(`${one.longest_span} m`, system())}`].filter((words) => words !== "").join(", ");
  return (
    <div class="judge">
      <div class="field wide">
        <label for={`${props.id}-traffic`}>Traffic over the bridge</label>
        <select id={`${props.id}-traffic`} onChange={(event) => pickTraffic(event.currentTarget.value)}>
          <For each={[["", "choose …"], ["road", "Road"], ["rail", "Railway"]]}>{([code, words]) => <option value={code} selected={traffic() === code}>{words}</option>}</For>
        </select>
      </div>
      <Show when={traffic() !== ""}>
        <div class="field wide">
          <label for={`${props.id}-rule`}>Judged by</label>
          <select id={`${props.id}-rule`} onChange={(event) => pickRule(event.currentTarget.value)}>
            <option value="" selected={rule() === ""}>choose …</option>
            <For each={rules()}>
              {(one) => (
                <option value={one.code} selected={rule() === one.code} disabled={!one.judges}>
                  {one.title}{one.judges ? "" : " (no factor on loads: it shows what falls short, and no bridge as adequate)"}
                </option>
              )}
            </For>
          </select>
        </div>
      </Show>
      <Show when={rule() !== ""}>
        <fieldset class="vehicles">
          <legend>Vehicles that must be carried</legend>
          <Tick is={isAll()} part={false} change={(is) => { setTicked(is ? new Set(all()) : new Set<string>()); give(); }}>
            <b>All that go with the rule</b>
          </Tick>
          <For each={models()}>
            {(one) => (
              <div class="model">
                <Tick is={codes(one).every((code) => picked().has(code))} part={codes(one).some((code) => picked().has(code))} change={(is) => tick(codes(one), is)}>
                  {one.vehicles.length > 1 ? `${one.title}, all ${one.vehicles.length}` : one.title}
                  <Show when={about(one)}>{(words) => <span class="soft"> ({words()})</span>}</Show>
                </Tick>
                <Show when={one.vehicles.length > 1}>
                  <details open={codes(one).some((code) => picked().has(code)) && !codes(one).every((code) => picked().has(code))}>
                    <summary>Some of {one.title}</summary>
                    <For each={one.vehicles}>
                      {(vehicle) => <Tick is={picked().has(vehicle.code)} part={false} change={(is) => tick([vehicle.code], is)}>{vehicle.title}</Tick>}
                    </For>
                  </details>
                </Show>
              </div>
            )}
          </For>
          <Show when={picked().size === 0}>
            <p class="complaint" role="status">Nothing is ticked: without a vehicle there is no verdict.</p>
          </Show>
        </fieldset>
      </Show>
      <For each={taken()}>{(one) => <p class="soft">{one.title}: {one.source} ({one.confidence}).</p>}</For>
      <Show when={taken().length > 0}><p class="soft">Factors, impact and spread by the rule, each with its source in the report.</p></Show>
    </div>
  );
}

/** A box that is ticked, or ticked in part. */
function Tick(props: { is: boolean; part: boolean; change: (is: boolean) => void; children: JSX.Element }): JSX.Element {
  return (
    <label class="tick">
      <input type="checkbox" checked={props.is} ref={(box) => createEffect(() => (box.indeterminate = props.part && !props.is))} onChange={(event) => props.change(event.currentTarget.checked)} />
      <span>{props.children}</span>
    </label>
  );
}

/** For a file that names no rule: the same questions, whose answers are written into it. */
export function JudgeFile(props: { sheet: Sheet }): JSX.Element {
  const [judged, setJudged] = createSignal<Judged | null>(null);
  const open = () => {
    const known = library();
    return known && props.sheet.reading[0]()?.kind === "bridge" && judgedBy(props.sheet.text(), known) === "";
  };
  const put = (answer: Judged): void => {
    props.sheet.change(withJudged(props.sheet.text(), answer), "judged");
    say("The rule and the vehicles are in the file. “Assessment with report” judges by them.");
  };
  return (
    <Show when={open()}>
      <section class="assume" aria-label="What it is judged by">
        <p>The file names no rule that judges the bridge: an assessment ends undetermined, or finds only what fails without safety.</p>
        <Judge id="judge" start={{ rule: "", vehicles: "" }} change={setJudged} />
        <button type="button" class="btn small" disabled={judged() === null} onClick={() => put(judged()!)}>Write it into the file</button>
      </section>
    </Show>
  );
}
