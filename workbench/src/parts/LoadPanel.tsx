/** Which load stands on the bridge, where, and what other methods say of it at this place. */
import { batch, createMemo, createSignal, For, on, createEffect, Show, type JSX } from "solid-js";
import { analyse, background } from "../model/background";
import { Lost, Refused, sentences } from "../engine/client";
import { library } from "../model/library";
import { poke } from "../model/live";
import type { Sheet } from "../model/sheet";
import { ASSUMED, loadAt, withContinuum, withPressure } from "../model/variants";
import { lineLoad, place, words } from "../units";
import { isVehicle } from "../shell/TitleBlock";
import { system } from "../shell/settings";
import { Sliders } from "./Sliders";
import { AssumeStiffness } from "./Stiffness";

export function LoadPanel(props: { sheet: Sheet }): JSX.Element {
  const about = () => props.sheet.about[0]();
  const x = () => props.sheet.x[0]();
  const loads = () => props.sheet.reading[0]()?.sections?.loads ?? 0;
  const model = createMemo(() => library()?.models.find((one) => one.vehicles.some((vehicle) => vehicle.code === props.sheet.vehicle[0]())));
  const rules = createMemo(() => (library()?.rules ?? []).filter((rule) => model()?.rules.includes(rule.code)));
  const longest = createMemo(() => Math.max(0, ...(props.sheet.picture[0]()?.dimensions ?? []).filter((one) => one.measure === "Span").map((one) => Math.abs(one.to[0] - one.from[0]))));
  const tooLong = (one: { longest_span: number | null }): boolean => one.longest_span !== null && longest() > one.longest_span + 1e-6;
  const choose = (vehicle: string): void => {
    // The file's own rule where it is made for this vehicle, else the one without factors.
    const model = library()?.models.find((one) => one.vehicles.some((each) => each.code === vehicle));
    const written = /^\s*\[sweep\][^[]*?^\s*rule\s*=\s*"([^"]*)"/ms.exec(props.sheet.text())?.[1] ?? null;
    const fits = written === null || (model?.rules.includes(written) ?? true);
    batch(() => {
      props.sheet.rule[1](fits ? "" : model!.rules.includes("characteristic") ? "characteristic" : (model!.rules[0] ?? ""));
      props.sheet.answer[1](null);
      props.sheet.zone[1](null);
      props.sheet.about[1](null);
      props.sheet.vehicle[1](vehicle);
    });
    poke();
  };
  return (
    <div class="panel-body" tabindex="-1">
      <Show when={props.sheet.reading[0]()?.kind === "blocks"}>
        <p>This is a block model: its loads stand in its text, and are not moved. “Verdict” finds the load at which its blocks collapse.</p>
      </Show>
      <div class="field wide">
        <label for="vehicle">Load</label>
        <select id="vehicle" class="plain" onChange={(event) => choose(event.currentTarget.value)}>
          <option value="" selected={props.sheet.vehicle[0]() === ""} disabled={loads() === 0}>{loads() > 0 ? "The load of the file" : "Choose a vehicle …"}</option>
          <For each={library()?.models ?? []}>
            {(model) => (
              <optgroup label={model.title ?? model.code}>
                <For each={model.vehicles}>
                  {(vehicle) => (
                    <option value={vehicle.code} selected={props.sheet.vehicle[0]() === vehicle.code} disabled={tooLong(model)}>
                      {vehicle.title ?? vehicle.code}{tooLong(model) ? ` (not for spans above ${words(place(model.longest_span!, system()))})` : ""}
                    </option>
                  )}
                </For>
              </optgroup>
            )}
          </For>
        </select>
      </div>
      <Show when={isVehicle(props.sheet)}>
        <div class="field wide">
          <label for="rule">Factors and spread by</label>
          <select id="rule" class="plain" onChange={(event) => {
            props.sheet.rule[1](event.currentTarget.value);
            poke();
          }}>
            <option value="" selected={props.sheet.rule[0]() === ""}>The rule of the file, else none</option>
            <For each={rules()}>
              {(rule) => <option value={rule.code} selected={props.sheet.rule[0]() === rule.code}>{rule.title ?? rule.code}</option>}
            </For>
          </select>
        </div>
        <Show when={model()}>
          {(one) => (
            <p class="soft">
              {one().source} ({one().confidence}).{one().longest_span !== null ? ` Not for spans above ${words(place(one().longest_span!, system()))}.` : ""}
            </p>
          )}
        </Show>
        <p>
          <label>
            <input type="checkbox" checked={props.sheet.leftward[0]()} onChange={(event) => {
              props.sheet.leftward[1](event.currentTarget.checked);
              poke();
            }} />{" "}
            Drives to the left
          </label>
        </p>
      </Show>
      <Show when={about()}>
        {(now) => (
          <>
            <div class="field">
              <label for="place">{isVehicle(props.sheet) ? "First axle at" : "Load at"}</label>
              <PlaceEntry sheet={props.sheet} />
            </div>
            <input
              type="range"
              aria-label="Place of the load along the bridge"
              min={now().from}
              max={now().to}
              step={0.01}
              value={x() ?? now().from}
              onInput={(event) => {
                props.sheet.x[1](Number(event.currentTarget.value));
                poke();
              }}
            />
            <p class="soft">
              Drag the load on the drawing, or focus it and use the arrow keys: {system() === "metric" ? "0.1 m a step, 0.5 m with Shift, 0.01 m with Alt." : "4 in a step, 20 in with Shift, ⅜ in with Alt."}
            </p>
            <Governing sheet={props.sheet} />
          </>
        )}
      </Show>
      <Methods sheet={props.sheet} />
      <Sliders sheet={props.sheet} />
    </div>
  );
}

function PlaceEntry(props: { sheet: Sheet }): JSX.Element {
  const unit = () => (system() === "metric" ? "m" : "ft");
  const per = () => (system() === "metric" ? 1 : 0.3048);
  return (
    <div class="entry">
      <input
        id="place"
        inputmode="decimal"
        value={((props.sheet.x[0]() ?? 0) / per()).toFixed(2)}
        onChange={(event) => {
          const typed = Number(event.currentTarget.value.replace(",", "."));
          const about = props.sheet.about[0]();
          if (!about || !Number.isFinite(typed)) return;
          props.sheet.x[1](Math.min(about.to, Math.max(about.from, typed * per())));
          poke();
        }}
      />
      <span class="unit">{unit()}</span>
    </div>
  );
}

function Governing(props: { sheet: Sheet }): JSX.Element {
  const least = createMemo(() => {
    const curve = props.sheet.envelope[0]();
    if (!curve) return null;
    let at = -1;
    for (let k = 0; k < curve.xs.length; k += 1) {
      if (curve.known[k] && Number.isFinite(curve.factors[k]!) && (at < 0 || curve.factors[k]! < curve.factors[at]!)) at = k;
    }
    return at < 0 ? null : curve.xs[at]!;
  });
  return (
    <Show when={least() !== null}>
      <p>
        <button type="button" class="btn small" onClick={() => {
          props.sheet.x[1](least()!);
          poke();
        }}>
          Go to the governing place, {words(place(least()!, system()))}
        </button>
      </p>
    </Show>
  );
}

type Row = {
  key: string;
  title: string;
  about: string;
  choice: string;
  /** The file that is analysed, from the sheet's; null where it cannot be made. */
  text: (own: string) => string | null;
  state: "idle" | "runs" | "done" | "failed";
  fraction: number;
  load: number | null;
  words: string;
  at: number | null;
};

const own = (text: string): string => text;
const METHODS: Omit<Row, "state" | "fraction" | "load" | "words" | "at">[] = [
  { key: "limit", title: "Rigid blocks", about: "Limit analysis: bounds of the load, joints do not give", choice: '{"method":"limit","analysis":"load"}', text: own },
  { key: "path", title: "Deformable joints", about: "Equilibrium path: the load at which balance ends", choice: '{"method":"path","analysis":"load"}', text: own },
  { key: "dem", title: "Discrete elements", about: "Blocks in motion, loaded step by step", choice: '{"method":"dem","analysis":"load"}', text: own },
  { key: "pressure", title: "Fill that presses sideways", about: `Limit analysis; assumed for this answer alone: ${ASSUMED}`, choice: '{"method":"limit","analysis":"load"}', text: withPressure },
  { key: "continuum", title: "Fill as a continuum", about: `Both bounds; assumed for this answer alone: ${ASSUMED}`, choice: '{"method":"limit","analysis":"load"}', text: withContinuum },
];

/** Other methods for the load of the file, at the place where it stands. */
function Methods(props: { sheet: Sheet }): JSX.Element {
  const [rows, setRows] = createSignal<Row[]>([]);
  const [busy, setBusy] = createSignal("");
  const single = () => loadAt(props.sheet.text(), 0) !== null;
  const update = (key: string, change: Partial<Row>) => setRows((list) => list.map((row) => (row.key === key ? { ...row, ...change } : row)));
  /** Why a method cannot be asked for the bridge of the file. */
  const refused = (row: Row): string | null => {
    const method = (JSON.parse(row.choice) as { method: string }).method;
    return row.text === own ? (props.sheet.reading[0]()?.sections?.not_known?.[method] ?? null) : null;
  };
  const fresh = () => METHODS.filter((one) => one.text(props.sheet.text()) !== null).map((one): Row => ({ ...one, state: "idle", fraction: NaN, load: null, words: "", at: null }));
  createEffect(
    on([() => props.sheet.id, () => props.sheet.text()], () => {
      setRows(fresh());
    }),
  );
  const run = async (row: Row): Promise<void> => {
    setBusy(row.key);
    update(row.key, { state: "runs", words: "", fraction: NaN });
    const x = props.sheet.x[0]();
    const file = row.text(props.sheet.text()) ?? props.sheet.text();
    const moved = x === null ? null : loadAt(file, x);
    try {
      const out = await analyse(props.sheet, "collapse", { run: `method-${row.key}`, choice: row.choice, instead: moved ?? file }, (stage, fraction) =>
        update(row.key, { fraction, words: stage }),
      );
      const result = JSON.parse(out.json) as { headline_kn_per_m?: number | null; headline_from?: string; status: string };
      update(row.key, { state: "done", load: result.headline_kn_per_m ?? null, words: [result.status, result.headline_from].filter(Boolean).join("; "), at: moved === null ? null : x });
    } catch (error) {
      const said = error instanceof Refused ? sentences(error) : error instanceof Lost && error.why === "stopped" ? "Stopped." : String((error as Error).message);
      update(row.key, { state: "failed", words: said });
    }
    setBusy("");
  };
  return (
    <Show when={!isVehicle(props.sheet) && (props.sheet.reading[0]()?.sections?.loads ?? 0) > 0}>
      <details class="group" open>
        <summary>The same load by other methods</summary>
        <p class="soft">{single() ? "For the load of the file where it stands now." : "For the loads of the file where the file places them."} The smaller answer is the one to use; the headline stays that of rigid blocks, which follow the load.</p>
        <table class="plain">
          <thead>
            <tr>
              <th scope="col">Method</th>
              <th scope="col" class="right">Carried</th>
              <th scope="col"><span class="unseen">Run</span></th>
            </tr>
          </thead>
          <tbody>
            <For each={rows()}>
              {(row) => (
                <tr>
                  <td>
                    {row.title}
                    <Show when={row.at !== null}><span class="soft"> at {words(place(row.at!, system()))}</span></Show>
                    <div class="soft">{row.state === "done" ? `${row.words}${row.text === own ? "" : `; ${ASSUMED}`}` : row.state === "failed" ? row.words : row.state === "runs" ? `${row.words} ${Number.isFinite(row.fraction) ? `${Math.round(100 * row.fraction)} %` : ""}` : (refused(row) ?? row.about)}</div>
                  </td>
                  <td class="right num">{row.load === null ? "" : words(lineLoad(row.load * 1e3, system()))}</td>
                  <td class="right">
                    <Show
                      when={busy() === row.key}
                      fallback={
                        <button type="button" class="btn small" disabled={busy() !== "" || refused(row) !== null} onClick={() => void run(row)} aria-label={`Run ${row.title}`}>
                          Run
                        </button>
                      }
                    >
                      <button type="button" class="btn small" onClick={() => background.stop()}>Stop</button>
                    </Show>
                  </td>
                </tr>
              )}
            </For>
          </tbody>
        </table>
        <Show when={rows().some((row) => row.state === "failed")}>
          <AssumeStiffness sheet={props.sheet} />
        </Show>
      </details>
    </Show>
  );
}

