/** Collapse: the blocks, and particles where the file has some, stepped while one watches. */
import { createMemo, createSignal, For, on, onCleanup, Show, createEffect, type JSX } from "solid-js";
import { bodiesOf, type Bodies } from "../drawing/answer";
import { cover, grid, masonry, particles, road, scaleBar } from "../drawing/elevation";
import { canFilm, download, film } from "../drawing/film";
import { moved, stressScale } from "../drawing/motion";
import { boundsOf } from "../drawing/view";
import { runOf, type Frame } from "../model/run";
import { overItsWidth } from "../model/carried";
import type { Sheet } from "../model/sheet";
import { Chart } from "../shell/Chart";
import { Scene } from "../shell/Scene";
import { isSmall, system, theme } from "../shell/settings";
import { figures, grouped, lineLoad, place, small, stress, words } from "../units";
import { AssumeStiffness } from "./Stiffness";

const ENDED: Record<string, string> = {
  collapsed: "collapsed",
  stable: "every load up to the last one was carried",
  stalled: "stalled: the step neither came to rest nor collapsed",
  "step-limit": "the step used up its iterations",
  "unstable-under-self-weight": "does not stand under its own weight",
  broken: "the numbers broke down",
};

const [times, setTimes] = createSignal(1);
const [showStress, setShowStress] = createSignal(true);
const [showForces, setShowForces] = createSignal(true);
let canvas: HTMLCanvasElement | null = null;
let painter: ((k: number | null) => void) | null = null;

/** Largest load [N/m] at which the run came to rest, from rows of load, displacement x, y, iterations, at rest. */
export function lastStable(path: Float64Array): number | null {
  let last: number | null = null;
  for (let k = 0; k + 4 < path.length; k += 5) if (path[k + 4]! > 0.5) last = path[k]!;
  return last;
}

export function CollapseScene(props: { sheet: Sheet }): JSX.Element {
  const run = () => runOf(props.sheet);
  const picture = () => run().picture[0]();
  const bodies = createMemo<Bodies | null>(() => {
    const seen = picture();
    return seen ? bodiesOf(seen, run().centroids) : null;
  });
  const frame = (): Frame | undefined => run().frames[run().shown[0]()];
  const box = createMemo(() => {
    const seen = picture() ?? props.sheet.picture[0]();
    return seen ? boundsOf(seen) : null;
  });
  const [wanted, setWanted] = createSignal<number | null>(null);
  painter = (k) => setWanted(k);
  onCleanup(() => (painter = null));
  return (
    <Scene
      box={box()}
      depends={() => [run().shown[0](), run().count[0](), times(), showStress(), showForces(), picture(), wanted(), props.sheet.picture[0]()]}
      canvas={(made) => (canvas = made)}
      title={props.sheet.name()}
      note={times() === 1 ? "Displacements at true scale" : `Displacements ${times()} times as large`}
      label={`Blocks of ${props.sheet.name()} as they have moved${times() === 1 ? "" : `, displacements ${times()} times as large`}.`}
      paint={(paper) => {
        const seen = picture();
        const at = wanted();
        const now = at === null ? frame() : run().frames[at];
        paper.pen.fillStyle = paper.ink.sheet;
        paper.pen.fillRect(0, 0, paper.width, paper.height);
        grid(paper);
        const made = bodies();
        if (!seen || !now || !made) {
          const still = props.sheet.picture[0]();
          if (still) {
            cover(paper, still);
            particles(paper, still);
            masonry(paper, still);
            road(paper, still);
          }
          scaleBar(paper, 0);
          return;
        }
        paper.pen.globalAlpha = 0.5;
        road(paper, seen);
        paper.pen.globalAlpha = 1;
        const { top } = moved(paper, seen, made, run().centroids, now, { times: times(), stress: showStress(), forces: showForces(), dark: theme() === "dark" });
        if (showStress() && top > 0 && !isSmall()) stressScale(paper, words(stress(top, system())), theme() === "dark");
        scaleBar(paper, 0);
        paper.pen.font = `600 14px ${paper.ink.font}`;
        paper.pen.fillStyle = paper.ink.ink;
        paper.pen.textAlign = "left";
        paper.pen.textBaseline = "top";
        paper.pen.fillText(`${words(lineLoad(now.load, system()))}, step ${grouped(now.steps, 0)}`, 14, 34);
      }}
    >
      <Show when={run().mode[0]() === "idle" || run().mode[0]() === "setting-up" || run().mode[0]() === "failed"}>
        <div class="veil">
          <Show
            when={run().mode[0]() === "setting-up"}
            fallback={
              <div>
                <p>The load grows where it stands, step by step; the blocks move as they would, until they come to rest or fall.</p>
                <button type="button" class="btn main" onClick={() => void run().start("{}")} disabled={!props.sheet.reading[0]()?.usable}>Load until it falls</button>
                <Show when={run().trouble[0]()}>
                  <p class="complaint" role="alert">{run().trouble[0]()}</p>
                  <AssumeStiffness sheet={props.sheet} />
                </Show>
              </div>
            }
          >
            <div role="status">
              <p>{run().words[0]().stage || "Blocks are cut and fill is packed"} …</p>
              <div class="bar"><i style={{ transform: `scaleX(${Number.isFinite(run().words[0]().fraction) ? run().words[0]().fraction : 0.05})` }} /></div>
              <p><button type="button" class="btn small" onClick={() => run().stop()}>Stop</button></p>
            </div>
          </Show>
        </div>
      </Show>
    </Scene>
  );
}

export function CollapseBlock(props: { sheet: Sheet }): JSX.Element {
  const run = () => runOf(props.sheet);
  const frame = createMemo(() => {
    run().count[0]();
    return run().frames[run().shown[0]()];
  });
  const stepped = createMemo(() => {
    run().count[0]();
    const end = run().frames[run().frames.length - 1];
    return end ? lastStable(end.path) : null;
  });
  const limited = () => {
    const limit = run().limit[0]();
    return limit !== null && stepped() !== null && limit < stepped()!;
  };
  // The careful answer leads: the limit load of the same blocks where it is smaller.
  const last = () => (limited() ? run().limit[0]() : stepped());
  const ended = () => {
    run().count[0]();
    return run().frames[run().frames.length - 1]?.ended ?? "";
  };
  return (
    <section class="block" aria-label="Answer" id="answer" tabindex="-1">
      <div>
        <span class="cap">Carried so far, per metre of width</span>
        <span class="headline num" data-testid="run-headline">
          {last() === null ? "–" : lineLoad(last()!, system()).value}
          <span class="unit">{last() === null ? "" : lineLoad(last()!, system()).unit}</span>
        </span>
        <Show when={last() !== null}>
          <span class="under">{overItsWidth(props.sheet, last()!, system())}</span>
        </Show>
      </div>
      <div>
        <span class="cap">By</span>
        <b>{limited() ? "Limit analysis of the same blocks, which gives less" : "Discrete elements, last step that came to rest"}</b>
        <Show when={frame()}>
          {(now) => (
            <div class="under num" data-testid="run-state">
              Now {words(lineLoad(now().load, system()))}, step {grouped(now().steps, 0)}
              <br />
              Out of balance {figures(now().unbalanced, 2)} of the acting forces
            </div>
          )}
        </Show>
        <Show when={run().at[0]() !== null}><div class="under" data-testid="run-place">{Number.isNaN(run().at[0]()) ? "The loads stand where the file has them." : `The load at ${words(place(run().at[0]()!, system()))}, where it was put`}</div></Show>
        <div class="under" role="status">{ended() ? `Ended: ${ENDED[ended()] ?? ended()}.` : run().mode[0]() === "running" ? "Running." : run().mode[0]() === "paused" ? "Paused." : ""}</div>
      </div>
      <div class="notes" tabindex="0" role="region" aria-label="Warnings and assumptions">
        <span class="cap">Warnings and assumptions</span>
        <ul>
          <Show when={run().of !== "" && run().of !== props.sheet.text()}>
            <li class="warn">The bridge has changed since this run began.</li>
          </Show>
          <Show when={run().trouble[0]()}><li class="err">{run().trouble[0]()}</li></Show>
          <li>Rigid blocks, joints that press at points, damping that takes motion out until the blocks rest.</li>
          <Show when={limited()}><li class="warn">Discrete elements carried {words(lineLoad(stepped()!, system()))}; the smaller load leads.</li></Show>
          <Show when={run().limit[0]() !== null && !limited()}><li>Limit load of the same blocks: {words(lineLoad(run().limit[0]()!, system()))}, not smaller.</li></Show>
          <Show when={run().count[0]() > 0 && run().limit[0]() === null}><li>The limit load of the same blocks has not been compared{run().frames[0]?.particles.length ? ": particles carry with them" : ""}.</li></Show>
          <For each={(props.sheet.reading[0]()?.findings ?? []).filter((one) => one.severity === "warning")}>{(one) => <li class="warn">Line {one.line}: {one.message}</li>}</For>
        </ul>
      </div>
    </section>
  );
}

export function CollapsePanel(props: { sheet: Sheet }): JSX.Element {
  const run = () => runOf(props.sheet);
  const [saving, setSaving] = createSignal<number | null>(null);
  const mode = () => run().mode[0]();
  const last = () => Math.max(0, run().count[0]() - 1);
  const curve = createMemo(() => {
    run().count[0]();
    const end = run().frames[run().frames.length - 1];
    const rows: [number, number][] = [];
    if (end) for (let k = 0; k + 4 < end.path.length; k += 5) rows.push([Math.hypot(end.path[k + 1]!, end.path[k + 2]!), end.path[k]!]);
    const metric = system() === "metric";
    rows.sort((a, b) => a[0] - b[0]);
    return [rows.map((row) => row[0] * (metric ? 1e3 : 1 / 0.0254)), rows.map((row) => row[1] / (metric ? 1e3 : 14593.903))] as [number[], number[]];
  });
  createEffect(
    on(
      () => props.sheet.id,
      () => onCleanup(() => runOf(props.sheet).mode[0]() === "running" && runOf(props.sheet).pause()),
    ),
  );
  const save = async (): Promise<void> => {
    if (!canvas || !painter) return;
    if (mode() === "running") run().pause();
    setSaving(0);
    try {
      const blob = await film(canvas, run().frames.length, (k) => painter?.(k), setSaving);
      download(blob, `${props.sheet.path.replace(/\.toml$/, "")}-collapse.webm`);
    } finally {
      painter?.(null);
      setSaving(null);
    }
  };
  return (
    <div class="panel-body" tabindex="-1">
      <div class="row" role="group" aria-label="Run">
        <Show when={mode() === "running"} fallback={
          <Show when={mode() === "paused"} fallback={
            <button type="button" class="btn main" disabled={mode() === "setting-up" || !props.sheet.reading[0]()?.usable} onClick={() => void run().start("{}")}>{run().count[0]() > 0 ? "Start again" : "Start"}</button>
          }>
            <button type="button" class="btn main" onClick={() => run().resume()}>Go on</button>
          </Show>
        }>
          <button type="button" class="btn main" onClick={() => run().pause()}>Pause</button>
        </Show>
        <button type="button" class="btn" disabled={mode() !== "paused"} onClick={() => void run().stepOnce()}>One picture on</button>
        <Show when={run().shown[0]() < last() && mode() !== "running"}>
          <button type="button" class="btn" onClick={() => void run().goOnFromHere()}>Go on from here</button>
        </Show>
      </div>
      <div class="slider spaced">
        <label for="scrub">Picture <span class="num soft">{run().shown[0]() + (run().count[0]() > 0 ? 1 : 0)} of {run().count[0]()}</span></label>
        <input id="scrub" type="range" min={0} max={last()} step={1} value={run().shown[0]()} disabled={run().count[0]() < 2} onInput={(event) => {
          if (mode() === "running") run().pause();
          run().shown[1](Number(event.currentTarget.value));
        }} />
      </div>
      <div class="slider">
        <label for="speed">Speed <span class="num soft">{run().speed[0]() >= 5000 ? "as fast as it goes" : `${run().speed[0]()} steps a picture`}</span></label>
        <input id="speed" type="range" min={0} max={40} step={1} value={Math.round(10 * Math.log10(run().speed[0]()))} onInput={(event) => run().speed[1](Math.round(10 ** (Number(event.currentTarget.value) / 10)))} />
      </div>
      <div class="slider">
        <label for="times">Displacements drawn <span class="num soft">{times()} times as large</span></label>
        <input id="times" type="range" min={0} max={20} step={1} value={Math.round(10 * Math.log10(times()))} onInput={(event) => setTimes(Math.round(10 ** (Number(event.currentTarget.value) / 10)))} />
      </div>
      <p>
        <label><input type="checkbox" checked={showStress()} onChange={(event) => setShowStress(event.currentTarget.checked)} /> Compression in blocks and fill</label>
        <br />
        <label><input type="checkbox" checked={showForces()} onChange={(event) => setShowForces(event.currentTarget.checked)} /> Forces in joints and between particles</label>
      </p>
      <Show when={curve()[0].length > 0}>
      <h3>Load over displacement</h3>
      <Chart
        data={curve()}
        curves={CURVES}
        x={system() === "metric" ? "displacement, mm" : "displacement, in"}
        y={system() === "metric" ? "load, kN/m" : "load, kip/ft"}
        height={210}
        label={`Load over displacement, ${curve()[0].length} steps; the last displacement is ${curve()[0].length > 0 ? words(small((curve()[0].at(-1) ?? 0) * (system() === "metric" ? 1e-3 : 0.0254), system())) : "none"}.`}
      />
      </Show>
      <div class="row spaced">
        <Show when={canFilm()}>
          <button type="button" class="btn small" disabled={run().count[0]() < 2 || saving() !== null} onClick={() => void save()}>
            {saving() === null ? "Save the film (WebM)" : `Filming, ${Math.round(100 * saving()!)} %`}
          </button>
        </Show>
        <button type="button" class="btn small" disabled={run().count[0]() === 0} onClick={() => canvas?.toBlob((blob) => blob && download(blob, `${props.sheet.path.replace(/\.toml$/, "")}-collapse.png`))}>Save this picture (PNG)</button>
      </div>
    </div>
  );
}

const CURVES = [{ label: "load", kind: "answer" as const, points: true }];
