/** What a bridge is judged by, in the engineer's words: what runs over it, by which code, and with which vehicles. Nothing is chosen for the engineer. */
import { createMemo, createSignal, For, Show, type JSX } from "solid-js";
import type { LibraryModel } from "../engine/types";
import { judgedBy, withJudged, type Judged } from "../model/judged";
import { library } from "../model/library";
import type { Sheet } from "../model/sheet";
import { isElsewhere, write } from "../model/survey";
import { say } from "../model/workspace";

type Traffic = "" | "road" | "rail";

export function Judge(props: { id: string; start: Judged; change: (judged: Judged | null) => void }): JSX.Element {
  const ruleOf = (code: string) => library()?.rules.find((one) => one.code === code);
  const modelOf = (code: string) => library()?.models.find((one) => one.code === code || one.vehicles.some((vehicle) => vehicle.code === code));
  const [chosen, setChosen] = createSignal<Traffic | null>(null);
  const [rule, setRule] = createSignal(props.start.rule);
  const [vehicles, setVehicles] = createSignal(props.start.vehicles);
  const traffic = (): Traffic => {
    const own = modelOf(vehicles())?.ways ?? (ruleOf(rule())?.ways.length === 1 ? ruleOf(rule())!.ways[0] : undefined);
    return chosen() ?? (own === "road" || own === "rail" ? own : "");
  };
  const rules = createMemo(() => (library()?.rules ?? []).filter((one) => one.ways.includes(traffic())));
  const models = createMemo<LibraryModel[]>(() => (library()?.models ?? []).filter((one) => one.ways === traffic() && one.rules.includes(rule())));
  const give = (): void => props.change(rule() !== "" && vehicles() !== "" ? { rule: rule(), vehicles: vehicles() } : null);
  const pickTraffic = (value: string): void => {
    setChosen(value as Traffic);
    if (!rules().some((one) => one.code === rule())) setRule("");
    pickRule(rule());
  };
  const pickRule = (value: string): void => {
    setRule(value);
    if (!models().some((model) => model.code === vehicles() || model.vehicles.some((one) => one.code === vehicles()))) setVehicles("");
    give();
  };
  const model = createMemo(() => modelOf(vehicles()));
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
                  {one.title}{one.judges ? "" : " (no factor on loads, no verdict)"}
                </option>
              )}
            </For>
          </select>
        </div>
      </Show>
      <Show when={rule() !== ""}>
        <div class="field wide">
          <label for={`${props.id}-vehicles`}>Vehicles that must be carried</label>
          <select id={`${props.id}-vehicles`} onChange={(event) => {
            setVehicles(event.currentTarget.value);
            give();
          }}>
            <option value="" selected={vehicles() === ""}>choose …</option>
            <For each={models()}>
              {(one) => (
                <optgroup label={one.title}>
                  <Show when={one.vehicles.length > 1}>
                    <option value={one.code} selected={vehicles() === one.code}>All {one.vehicles.length} of {one.title}</option>
                  </Show>
                  <For each={one.vehicles}>{(vehicle) => <option value={vehicle.code} selected={vehicles() === vehicle.code && (one.vehicles.length === 1 || vehicle.code !== one.code)}>{vehicle.title}</option>}</For>
                </optgroup>
              )}
            </For>
          </select>
        </div>
      </Show>
      <Show when={vehicles() !== "" && model()}>
        {(one) => <p class="soft">Loads: {one().source} ({one().confidence}). Factors, impact and spread by the rule, each with its source in the report.</p>}
      </Show>
    </div>
  );
}

/** For a file that names no rule: the same questions, whose answers are written into it. */
export function JudgeFile(props: { sheet: Sheet }): JSX.Element {
  const [judged, setJudged] = createSignal<Judged | null>(null);
  const open = () => {
    const known = library();
    return known && props.sheet.reading[0]()?.kind === "bridge" && judgedBy(props.sheet.text(), known) === "";
  };
  const put = async (answer: Judged): Promise<void> => {
    const answers = props.sheet.survey[0]();
    if (answers && !isElsewhere(props.sheet)) {
      // The survey stays what the file is made from.
      props.sheet.survey[1]({ ...answers, ...answer });
      const found = await write(props.sheet, { ...answers, ...answer }, "survey judged");
      const wrong = found?.find((one) => !one.doubtful);
      if (wrong) return say(wrong.text, true);
    } else {
      props.sheet.change(withJudged(props.sheet.text(), answer), "judged");
    }
    say("The rule and the vehicles are in the file. “Assessment with report” judges by them.");
  };
  return (
    <Show when={open()}>
      <section class="assume" aria-label="What it is judged by">
        <p>The file names no rule that judges the bridge: an assessment ends undetermined, or finds only what fails without safety.</p>
        <Judge id="judge" start={{ rule: "", vehicles: "" }} change={setJudged} />
        <button type="button" class="btn small" disabled={judged() === null} onClick={() => void put(judged()!)}>Write it into the file</button>
      </section>
    </Show>
  );
}
