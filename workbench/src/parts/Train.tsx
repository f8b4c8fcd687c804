/** Train: it crosses position by position; the bridge bends, joints open, sensors record. */
import { createMemo, createSignal, For, Show, type JSX } from "solid-js";
import type uPlot from "uplot";
import { grid, scaleBar, type Sheet as Paper } from "../drawing/elevation";
import type { Box, View } from "../drawing/view";
import { Lost, Refused, sentences } from "../engine/client";
import { analyse, background } from "../model/background";
import { examples } from "../model/library";
import { historiesOf, type Histories } from "../model/histories";
import { passageOf, sensorTable, type Mesh, type Moment } from "../model/passage";
import type { Sheet } from "../model/sheet";
import { inserted, withWord } from "../model/structure";
import { keepFiles } from "../model/storage";
import { say } from "../model/workspace";
import { Chart, type Curve } from "../shell/Chart";
import { openExample } from "../shell/OpenDialog";
import { Scene } from "../shell/Scene";
import { system } from "../shell/settings";
import { figures, grouped, place, small, words } from "../units";
import { typeset } from "../wording";
import { Svg } from "./Verdict";

const [chosen, setChosen] = createSignal(0);
const [placing, setPlacing] = createSignal(false);
const [kind, setKind] = createSignal("displacement");
const [direction, setDirection] = createSignal("vertical");

function boxOf(mesh: Mesh): Box {
  const box: Box = { left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity };
  for (const [x, y] of mesh.nodes) {
    box.left = Math.min(box.left, x);
    box.right = Math.max(box.right, x);
    box.bottom = Math.min(box.bottom, y);
    box.top = Math.max(box.top, y);
  }
  return box;
}

/** A round multiple at which the largest movement so far is a fiftieth of the bridge. */
export function exaggeration(largest: number, length: number): number {
  if (!(largest > 0)) return 1;
  const raw = length / 50 / largest;
  const power = 10 ** Math.floor(Math.log10(raw));
  return Math.max(1, [1, 2, 5].map((k) => k * power).filter((k) => k <= raw).pop() ?? power);
}

function paintMesh({ pen, view, ink }: Paper, mesh: Mesh, moment: Moment | undefined, times: number): void {
  const x = (k: number) => view.x(mesh.nodes[k]![0] + times * (moment?.displacements[2 * k] ?? 0));
  const y = (k: number) => view.y(mesh.nodes[k]![1] + times * (moment?.displacements[2 * k + 1] ?? 0));
  const tints: Record<string, string> = {
    voussoirs: ink.masonry,
    pier: ink.masonry,
    backing: ink.masonryDark,
    abutment: ink.masonryDark,
    fill: ink.soil,
    "haunch fill": ink.soilDark,
    "abutment fill": ink.soilDark,
  };
  mesh.zones.forEach((zone, z) => {
    pen.beginPath();
    mesh.quads.forEach((quad, k) => {
      if (mesh.zone_of[k] !== z) return;
      quad.forEach((node, n) => (n === 0 ? pen.moveTo(x(node), y(node)) : pen.lineTo(x(node), y(node))));
      pen.closePath();
    });
    pen.fillStyle = tints[zone.made_of] ?? ink.soil;
    pen.fill();
    const stone = zone.made_of === "voussoirs" || zone.made_of === "pier";
    pen.strokeStyle = stone ? ink.ink : ink.line;
    pen.lineWidth = stone ? 0.5 : 0.25;
    pen.stroke();
  });
}

function paintTrain({ pen, view, ink }: Paper, mesh: Mesh, axles: Float64Array): void {
  const top = Math.max(...mesh.surface.map((p) => p[1]));
  const y = view.y(top);
  const r = Math.max(3, Math.min(9, 0.46 * view.scale));
  pen.strokeStyle = ink.ink;
  pen.lineWidth = 1.6;
  pen.beginPath();
  pen.moveTo(view.x(mesh.surface[0]?.[0] ?? 0), y - 1);
  pen.lineTo(view.x(mesh.surface[mesh.surface.length - 1]?.[0] ?? 0), y - 1);
  pen.stroke();
  for (let k = 0; k + 1 < axles.length; k += 2) {
    const x = view.x(axles[k]!);
    pen.beginPath();
    pen.arc(x, y - 2 - r, r, 0, 2 * Math.PI);
    pen.fillStyle = ink.sheet;
    pen.fill();
    pen.stroke();
    pen.beginPath();
    pen.moveTo(x, y - 2 - 2 * r - 22);
    pen.lineTo(x, y - 6 - 2 * r);
    pen.moveTo(x - 3.5, y - 12 - 2 * r);
    pen.lineTo(x, y - 5 - 2 * r);
    pen.lineTo(x + 3.5, y - 12 - 2 * r);
    pen.stroke();
  }
}

function paintJoints({ pen, view, ink }: Paper, joints: Float32Array): number {
  let open = 0;
  for (const [state, colour] of [[1, ink.answer], [2, ink.second]] as const) {
    pen.fillStyle = colour;
    pen.beginPath();
    for (let k = 0; k + 5 < joints.length; k += 6) {
      if (Math.round(joints[k + 5]!) !== state) continue;
      if (state === 1) open += 1;
      const x = view.x(joints[k]!);
      const y = view.y(joints[k + 1]!);
      const r = state === 1 ? 2.8 : 1.3;
      pen.moveTo(x + r, y);
      pen.arc(x, y, r, 0, 2 * Math.PI);
    }
    pen.fill();
  }
  return open;
}

/** The example that has a train. */
const arch = () => (examples() ?? []).find((one) => one.command === "respond");

export function TrainScene(props: { sheet: Sheet }): JSX.Element {
  const passage = () => passageOf(props.sheet);
  const set = () => passage().set[0]();
  const box = createMemo(() => {
    const now = set();
    return now ? boxOf(now.mesh) : null;
  });
  const largest = createMemo(() => {
    passage().done[0]();
    let most = 0;
    for (const moment of passage().moments.values()) {
      for (let k = 0; k + 1 < moment.displacements.length; k += 2) {
        const size = Math.abs(moment.displacements[k]!) + Math.abs(moment.displacements[k + 1]!);
        if (size > most) most = size;
      }
      break;
    }
    const now = passage().momentAt(passage().shown[0]());
    if (now) for (let k = 0; k + 1 < now.displacements.length; k += 2) most = Math.max(most, Math.hypot(now.displacements[k]!, now.displacements[k + 1]!));
    return most;
  });
  let kept = 0;
  const times = createMemo(() => {
    const area = box();
    if (!area) return 1;
    // Held at what the largest moment so far asks for, so that the scale does not breathe.
    if (passage().done[0]() <= 1) kept = 0;
    kept = Math.max(kept, largest());
    return exaggeration(kept, area.right - area.left);
  });
  /** How many sensors at the same place come before this one, so that none hides another. */
  const before = (k: number): number => {
    const all = set()?.sensors ?? [];
    const here = all[k]?.at;
    return here ? all.slice(0, k).filter((one) => one.at && Math.hypot(one.at[0] - here[0], one.at[1] - here[1]) < 0.3).length : 0;
  };
  const click = (x: number, y: number): void => {
    if (!placing()) return;
    const count = (props.sheet.text().match(/^\s*\[\[sensor\]\]/gm) ?? []).length + 1;
    const name = `${kind() === "displacement" ? `${direction()} displacement` : kind().replace("-", " ")} ${count}`;
    props.sheet.change(inserted(props.sheet.text(), "sensor", sensorTable(name, kind(), direction(), "intrados", x, y)), "place sensor");
    setPlacing(false);
    say(`${name} is placed at ${words(place(x, system()))}, ${words(place(y, system()))} above the springing. Run the train again to record it.`);
  };
  return (
    <Scene
      box={box()}
      depends={() => [passage().shown[0](), passage().done[0](), set(), chosen(), times()]}
      title={props.sheet.name()}
      note={set() ? (times() > 1 ? `Displacements ${grouped(times(), 0)} times as large` : "Displacements at true scale") : ""}
      label={set() ? `Mesh of ${props.sheet.name()} with the train; displacements ${times()} times as large.` : `${props.sheet.name()}: no passage yet.`}
      click={click}
      paint={(paper) => {
        const now = set();
        grid(paper);
        if (!now) return;
        const moment = passage().momentAt(passage().shown[0]());
        paintMesh(paper, now.mesh, moment, times());
        if (moment) {
          paintJoints(paper, moment.joints);
          paintTrain(paper, now.mesh, moment.axles);
        }
        scaleBar(paper, 0);
      }}
      over={(view: View) => (
        <For each={set()?.sensors ?? []}>
          {(sensor, k) => (
            <Show when={sensor.at}>
              {(at) => (
                <button
                  type="button"
                  class="sensor"
                  aria-pressed={chosen() === k()}
                  aria-label={`Sensor ${k() + 1}: ${sensor.name}`}
                  title={sensor.about}
                  style={{ transform: `translate(${view.x(at()[0]) + 20 * before(k())}px, ${view.y(at()[1]) + 20}px)` }}
                  onClick={() => setChosen(k())}
                >
                  {k() + 1}
                </button>
              )}
            </Show>
          )}
        </For>
      )}
    >
      <Show when={!set()}>
        <div class="veil">
          <Show
            when={passage().mode[0]() === "setting-up"}
            fallback={
              <div>
                <p>{props.sheet.reading[0]()?.sections?.passage ? "The train of the file crosses the bridge; finite elements with joints that open." : "This file has no train and no passage. The example “Railway arch” has both."}</p>
                <Show
                  when={props.sheet.reading[0]()?.sections?.passage}
                  fallback={<button type="button" class="btn main" disabled={!arch()} onClick={() => void openExample(arch()!)}>Open the railway arch</button>}
                >
                  <button type="button" class="btn main" onClick={() => void passage().start()} disabled={!props.sheet.reading[0]()?.usable}>Let the train cross</button>
                </Show>
                <Show when={passage().trouble[0]()}><p class="complaint" role="alert">{passage().trouble[0]()}</p></Show>
              </div>
            }
          >
            <div role="status">
              <p>{passage().words[0]().stage || "The mesh is made and stands under its own weight"} …</p>
              <div class="bar"><i style={{ transform: `scaleX(${Number.isFinite(passage().words[0]().fraction) ? passage().words[0]().fraction : 0.05})` }} /></div>
              <p><button type="button" class="btn small" onClick={() => passage().stop()}>Stop</button></p>
            </div>
          </Show>
        </div>
      </Show>
    </Scene>
  );
}

/** Peak of a sensor so far, in its unit. */
function peakOf(values: Float64Array[], sensor: number, scale: number): { value: number; at: number } | null {
  let best: { value: number; at: number } | null = null;
  values.forEach((row, at) => {
    const value = (row[sensor] ?? 0) * scale;
    if (!best || Math.abs(value) > Math.abs(best.value)) best = { value, at };
  });
  return best;
}

export function TrainBlock(props: { sheet: Sheet }): JSX.Element {
  const passage = () => passageOf(props.sheet);
  const sensor = () => passage().set[0]()?.sensors[chosen()];
  const peak = createMemo(() => {
    passage().done[0]();
    const now = sensor();
    return now ? peakOf(passage().values, chosen(), now.scale) : null;
  });
  const state = createMemo(() => {
    const moment = passage().momentAt(passage().shown[0]());
    passage().done[0]();
    if (!moment) return null;
    let open = 0;
    let sliding = 0;
    let widest = 0;
    for (let k = 0; k + 5 < moment.joints.length; k += 6) {
      const word = Math.round(moment.joints[k + 5]!);
      if (word === 1) {
        open += 1;
        widest = Math.max(widest, moment.joints[k + 2]!);
      } else if (word === 2) sliding += 1;
    }
    return { open, sliding, widest };
  });
  return (
    <section class="block" aria-label="Answer" id="answer" tabindex="-1">
      <div>
        <span class="cap">Peak so far, {sensor()?.name ?? "no sensor"}</span>
        <span class="headline num" data-testid="peak">
          {peak() ? figures(peak()!.value, 3) : "–"}
          <span class="unit">{peak() ? typeset(sensor()?.unit ?? "") : ""}</span>
        </span>
        <span class="under">{sensor()?.about ?? ""}</span>
      </div>
      <div>
        <span class="cap">Now</span>
        <Show when={passage().set[0]()} fallback={<span>no passage yet</span>}>
          {(set) => (
            <>
              <b class="num" data-testid="passage-state">Position {Math.min(passage().shown[0]() + 1, set().count)} of {set().count}</b>
              <div class="under num">
                {figures(set().places[2 * passage().shown[0]()] ?? 0, 3)} s, first axle at {words(place(set().places[2 * passage().shown[0]() + 1] ?? 0, system()))}
              </div>
              <Show when={state()}>
                {(now) => (
                  <div class="under num">
                    {now().open} points of joints open{now().open > 0 ? `, by ${words(small(now().widest, system()))} at most` : ""}; {now().sliding} slide
                  </div>
                )}
              </Show>
              <div class="under" role="status">{passage().ended[0]() ? `Ended: ${passage().ended[0]()}.` : passage().mode[0]() === "running" ? "Running." : ""}</div>
            </>
          )}
        </Show>
      </div>
      <div class="notes" tabindex="0" role="region" aria-label="Warnings and assumptions">
        <span class="cap">Warnings and assumptions</span>
        <ul>
          <Show when={passage().text !== "" && passage().text !== props.sheet.text()}><li class="warn">The bridge has changed since this passage began.</li></Show>
          <Show when={passage().trouble[0]()}><li class="err">{passage().trouble[0]()}</li></Show>
          <li>Displacements, strains and stresses are those of the train; self-weight is taken off.</li>
          <Show when={passage().set[0]()?.mesh.remark}><li>{passage().set[0]()!.mesh.remark}</li></Show>
          <For each={(props.sheet.reading[0]()?.findings ?? []).filter((one) => one.severity === "warning")}>{(one) => <li class="warn">Line {one.line}: {one.message}</li>}</For>
        </ul>
      </div>
    </section>
  );
}

const MODEL: Curve[] = [{ label: "model", kind: "answer" }];
const BOTH: Curve[] = [
  { label: "model", kind: "answer" },
  { label: "measured", kind: "ink", dash: [4, 3] },
];

export function TrainPanel(props: { sheet: Sheet }): JSX.Element {
  const passage = () => passageOf(props.sheet);
  const set = () => passage().set[0]();
  const mode = () => passage().mode[0]();
  let input!: HTMLInputElement;
  const tables = () => {
    props.sheet.filesVersion();
    return [...props.sheet.files.keys()].filter((name) => /\.(csv|txt|tsv)$/i.test(name));
  };
  const measuredOf = (name: string): { times: number[]; values: number[] } | null => {
    const found = passage().measured[0]();
    if (!found) return null;
    const at = found.channels.findIndex((one) => one.name.toLowerCase() === name.toLowerCase());
    return at < 0 ? null : { times: found.times, values: found.values[at]! };
  };
  const data = createMemo<uPlot.AlignedData>(() => {
    passage().done[0]();
    const now = set();
    if (!now) return [[], []];
    const sensor = now.sensors[chosen()];
    if (!sensor) return [[], []];
    const times = passage().values.map((_, k) => now.places[2 * k] ?? 0);
    const model = passage().values.map((row) => (row[chosen()] ?? 0) * sensor.scale);
    const measured = measuredOf(sensor.name);
    if (!measured) return [times, model];
    // Both on one axis of time: the values of the one are missing where only the other has one.
    const rows = new Map<number, [number | null, number | null]>();
    times.forEach((time, k) => rows.set(time, [model[k]!, null]));
    const found = passage().measured[0]()!.channels.find((one) => one.name.toLowerCase() === sensor.name.toLowerCase());
    const scale = found && found.unit === sensor.unit ? 1 : (found?.scale ?? 1) * sensor.scale;
    measured.times.forEach((time, k) => {
      const row = rows.get(time);
      if (row) row[1] = measured.values[k]! * scale;
      else rows.set(time, [null, measured.values[k]! * scale]);
    });
    const sorted = [...rows].sort((a, b) => a[0] - b[0]);
    return [sorted.map(([time]) => time), sorted.map(([, row]) => row[0]), sorted.map(([, row]) => row[1])];
  });
  const curves = () => (data().length > 2 ? BOTH : MODEL);
  return (
    <div class="panel-body" tabindex="-1">
      <div class="row" role="group" aria-label="Passage">
        <Show when={mode() === "running"} fallback={
          <Show when={mode() === "paused"} fallback={
            <button type="button" class="btn main" disabled={mode() === "setting-up" || !props.sheet.reading[0]()?.sections?.passage} onClick={() => void passage().start()}>{set() ? "Let it cross again" : "Let the train cross"}</button>
          }>
            <button type="button" class="btn main" onClick={() => passage().resume()}>Go on</button>
          </Show>
        }>
          <button type="button" class="btn main" onClick={() => passage().pause()}>Pause</button>
        </Show>
      </div>
      <div class="slider spaced">
        <label for="time">Time <span class="num soft">{set() ? `${figures(set()!.places[2 * passage().shown[0]()] ?? 0, 3)} s` : ""}</span></label>
        <input id="time" type="range" min={0} max={Math.max(0, passage().done[0]() - 1)} step={1} value={passage().shown[0]()} disabled={passage().done[0]() < 2} onInput={(event) => passage().shown[1](Number(event.currentTarget.value))} />
      </div>
      <Show when={set()}>
        {(now) => (
          <>
            <div class="field">
              <label for="sensor">Record of</label>
              <select id="sensor" onChange={(event) => setChosen(Number(event.currentTarget.value))}>
                <For each={now().sensors}>{(sensor, k) => <option value={k()} selected={chosen() === k()}>{k() + 1} {sensor.name}</option>}</For>
              </select>
            </div>
            <Chart
              data={data()}
              curves={curves()}
              x="time, s"
              y={typeset(now().sensors[chosen()]?.unit ?? "")}
              height={200}
              time={now().places[2 * passage().shown[0]()] ?? 0}
              label={`Record of ${now().sensors[chosen()]?.name ?? ""} over time.`}
            />
            <Show when={data().length > 2}><p class="soft">Unbroken: computed. Dashed: measured, {passage().measured[0]()?.name}.</p></Show>
          </>
        )}
      </Show>
      <details class="group" open>
        <summary>Sensors</summary>
        <div class="field">
          <label for="kind">A new one measures</label>
          <select id="kind" value={kind()} onChange={(event) => setKind(event.currentTarget.value)}>
            <option value="displacement">displacement</option>
            <option value="strain">strain of a stone</option>
            <option value="joint-opening">opening of a joint</option>
            <option value="joint-sliding">sliding of a joint</option>
            <option value="stress">stress along the ring</option>
          </select>
        </div>
        <Show when={kind() === "displacement"}>
          <div class="field">
            <label for="direction">Direction</label>
            <select id="direction" value={direction()} onChange={(event) => setDirection(event.currentTarget.value)}>
              <option value="vertical">vertical, up positive</option>
              <option value="horizontal">horizontal, right positive</option>
              <option value="lateral">away from mid-span positive</option>
            </select>
          </div>
        </Show>
        <button type="button" class="btn small" aria-pressed={placing()} disabled={!set()} onClick={() => setPlacing(!placing())}>
          {placing() ? "Click a stone on the drawing, or press again to leave" : "Place a sensor on the drawing"}
        </button>
      </details>
      <details class="group" open>
        <summary>Measured records</summary>
        <div class="row">
          <button type="button" class="btn small" onClick={() => input.click()}>Lay a table (CSV) over them</button>
          <input ref={input} type="file" class="unseen" tabindex="-1" aria-label="Measured table" accept=".csv,.txt,.tsv" onChange={async (event) => {
            const file = event.currentTarget.files?.[0];
            if (!file) return;
            const bytes = new Uint8Array(await file.arrayBuffer());
            const name = file.name.replace(/[^\w.\- ()]/g, "_");
            props.sheet.put(name, bytes);
            void keepFiles(props.sheet.id, [...props.sheet.files]);
            void passage().measure(name, bytes);
          }} />
          <For each={tables()}>{(name) => <button type="button" class="btn small" onClick={() => void passage().measure(name, props.sheet.files.get(name)!)}>{name}</button>}</For>
        </div>
        <For each={tables().filter((name) => withWord(props.sheet.text(), "records", "place", name) !== props.sheet.text())}>
          {(name) => (
            <p>
              <button type="button" class="link" onClick={() => props.sheet.change(withWord(props.sheet.text(), "records", "place", name), "records of the update")}>Let the update read {name}</button>
            </p>
          )}
        </For>
        <Show when={passage().measured[0]()}>
          {(found) => (
            <>
              <p class="soft">{found().channels.length} channels: {found().channels.map((one) => one.name).join(", ")}</p>
              <For each={found().findings.slice(0, 8)}>{(one) => <p class="soft">{one.message}</p>}</For>
            </>
          )}
        </Show>
      </details>
      <Show when={props.sheet.reading[0]()?.sections?.update}>
        <Update sheet={props.sheet} />
      </Show>
    </div>
  );
}

type Parameter = { name: string; value: number; unit?: string; lower: number; upper: number; interval_95?: [number, number] | null; identifiable?: boolean; at_bound?: boolean };
type Updated = { parameters: Parameter[]; histories: Histories | null; figures: { name: string; svg: string }[]; status: string; norms: [number | null, number | null]; warnings: string[] };

/** What was measured lies on top, as a dashed line that lets the others be seen. */
const THREE: Curve[] = [
  { label: "before", kind: "second" },
  { label: "found", kind: "answer" },
  { label: "measured", kind: "ink", dash: [4, 3] },
];

/** Where a value and its interval lie between the bounds of the search. */
function Interval(props: { of: Parameter }): JSX.Element {
  const at = (value: number): number => (200 * (value - props.of.lower)) / (props.of.upper - props.of.lower || 1);
  return (
    <svg class="interval" viewBox="-4 0 208 16" role="img" aria-label={`Between ${figures(props.of.lower)} and ${figures(props.of.upper)}`}>
      <line x1="0" x2="200" y1="8" y2="8" />
      <Show when={props.of.interval_95}>{(ends) => <rect x={at(ends()[0])} width={Math.max(1, at(ends()[1]) - at(ends()[0]))} y="4" height="8" />}</Show>
      <circle cx={at(props.of.value)} cy="8" r="4" />
    </svg>
  );
}

/** Parameters of the model from the records that the file names. */
function Update(props: { sheet: Sheet }): JSX.Element {
  const [state, setState] = createSignal<{ words: string; fraction: number } | null>(null);
  const [trouble, setTrouble] = createSignal("");
  const [found, setFound] = createSignal<Updated | null>(null);
  const [channel, setChannel] = createSignal(0);
  const run = async (): Promise<void> => {
    setTrouble("");
    setFound(null);
    setState({ words: "", fraction: NaN });
    try {
      const name = `update-${props.sheet.id}`;
      const out = await analyse(props.sheet, "update", { run: name }, (stage, fraction) => setState({ words: stage, fraction }));
      const object = JSON.parse(out.json) as { parameters?: Parameter[]; error_norm?: number; initial_error_norm?: number; warnings?: { message?: string }[] };
      const table = out.files.includes("histories.csv") ? new TextDecoder().decode(await background.call<Uint8Array>("file", { run: name, name: "histories.csv" })) : "";
      setChannel(0);
      setFound({
        parameters: object.parameters ?? [],
        histories: table ? historiesOf(table) : null,
        figures: out.figures,
        status: out.status,
        norms: [object.initial_error_norm ?? null, object.error_norm ?? null],
        warnings: (object.warnings ?? []).map((one) => one.message ?? ""),
      });
    } catch (error) {
      setTrouble(error instanceof Refused ? sentences(error) : error instanceof Lost && error.why === "stopped" ? "Stopped." : String((error as Error).message));
    }
    setState(null);
  };
  const shown = () => found()?.histories?.channels[channel()];
  const curves = createMemo<uPlot.AlignedData>(() => {
    const one = shown();
    return one ? [found()!.histories!.times, one.start, one.updated, one.measured] : [[], [], [], []];
  });
  const percent = (norm: number | null): string => (norm === null ? "–" : `${figures(100 * norm, 3)} %`);
  return (
    <details class="group" open>
      <summary>Update from records</summary>
      <p class="soft">Searches the parameters with which the computed records fit the measured ones. A minute or more.</p>
      <div class="row">
        <Show when={state()} fallback={<button type="button" class="btn small" disabled={!props.sheet.reading[0]()?.usable} onClick={() => void run()}>Update</button>}>
          {(now) => (
            <>
              <button type="button" class="btn small" onClick={() => background.stop()}>Stop</button>
              <span class="soft" role="status">{Number.isFinite(now().fraction) ? `${Math.round(100 * now().fraction)} %` : ""} {now().words}</span>
            </>
          )}
        </Show>
      </div>
      <Show when={trouble()}><p class="complaint" role="alert">{trouble()}</p></Show>
      <Show when={found()}>
        {(now) => (
          <>
            <p role="status" data-testid="update-status">Misfit of the peaks {percent(now().norms[0])} before, {percent(now().norms[1])} after. Ended: {now().status}.</p>
            <table class="plain" data-testid="parameters">
              <thead><tr><th scope="col">Parameter</th><th scope="col" class="right">Found</th><th scope="col" class="right">95 %</th></tr></thead>
              <tbody>
                <For each={now().parameters}>
                  {(one) => (
                    <tr>
                      <td>{one.name}<Interval of={one} />{one.identifiable === false ? <div class="soft">the records do not tell</div> : null}{one.at_bound ? <div class="soft">at its bound</div> : null}</td>
                      <td class="right num">{figures(one.value)} {typeset(one.unit ?? "")}</td>
                      <td class="right num">{one.interval_95 ? `${figures(one.interval_95[0], 3)} to ${figures(one.interval_95[1], 3)}` : "–"}</td>
                    </tr>
                  )}
                </For>
              </tbody>
            </table>
            <p class="soft">Line: between the bounds of the search. Bar: the 95 % interval. Point: what was found.</p>
            <Show when={now().histories}>
              {(histories) => (
                <>
                  <div class="field">
                    <label for="history">Records of</label>
                    <select id="history" value={channel()} onChange={(event) => setChannel(Number(event.currentTarget.value))}>
                      <For each={histories().channels}>{(one, k) => <option value={k()}>{one.name}</option>}</For>
                    </select>
                  </div>
                  <Chart data={curves()} curves={THREE} x="time, s" y={typeset(shown()?.unit ?? "")} height={200} label={`${shown()?.name ?? ""}: measured, before the update and after it.`} />
                  <p class="soft">Dashed: measured. Blue: before. Red: with what was found.</p>
                </>
              )}
            </Show>
            <For each={now().warnings}>{(words) => <p class="soft">{words}</p>}</For>
            <div class="figures inline">
              <For each={now().figures.slice(0, 6)}>{(figure) => <figure><Svg svg={figure.svg} name={figure.name} /><figcaption>{figure.name.replace(/-/g, " ")}</figcaption></figure>}</For>
            </div>
          </>
        )}
      </Show>
    </details>
  );
}
