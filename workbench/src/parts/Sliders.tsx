/** A slider for each uncertain quantity, and how much each of them moves the answer. */
import { createMemo, createSignal, For, Show, type JSX } from "solid-js";
import { Lost, Refused, sentences } from "../engine/client";
import type { Quantity } from "../engine/types";
import { analyse, background } from "../model/background";
import { setQuantity } from "../model/live";
import type { Sheet } from "../model/sheet";
import { figures, lineLoad, shown, words } from "../units";
import { typeset } from "../wording";
import { system } from "../shell/settings";

/** What a survey leaves uncertain, and by which share [of the value] where the file states no range. */
const UNCERTAIN: [RegExp, number][] = [
  [/^joint\.friction_angle$/, 0.15],
  [/^span\[\d+\]\.(thickness|crown_thickness)$/, 0.1],
  [/^cover\[\d+\]\.(thickness|density)$/, 0.2],
  [/^masonry\.(density|compressive_strength)$/, 0.15],
  [/^backing\.(level|height|depth)/, 0.2],
  [/^cover\[\d+\]\.(friction_angle|cohesion)$/, 0.2],
];

type Uncertain = { quantity: Quantity; low: number; high: number; base: number };

function uncertain(quantities: Quantity[], bases: Map<string, number>): Uncertain[] {
  const list: Uncertain[] = [];
  for (const quantity of quantities) {
    const match = UNCERTAIN.find(([pattern]) => pattern.test(quantity.path));
    if (!match || quantity.number === null || quantity.by_default || quantity.number === 0) continue;
    const base = bases.get(quantity.path) ?? quantity.number;
    bases.set(quantity.path, base);
    const low = Math.max(base * (1 - match[1]), quantity.least ?? -Infinity);
    const high = Math.min(base * (1 + match[1]), quantity.most ?? Infinity);
    if (high > low) list.push({ quantity, low, high, base });
  }
  return list.slice(0, 12);
}

const plain = (value: number): string => Number(value.toPrecision(5)).toString();

export function Sliders(props: { sheet: Sheet }): JSX.Element {
  const bases = new Map<string, number>();
  const list = createMemo(() => uncertain(props.sheet.quantities[0](), bases));
  const paths = createMemo(() => list().map((one) => one.quantity.path), [], { equals: (a, b) => a.join() === b.join() });
  const [bars, setBars] = createSignal<{ path: string; low: number; high: number; base: number }[] | null>(null);
  const [state, setState] = createSignal<{ words: string; fraction: number } | null>(null);
  const [trouble, setTrouble] = createSignal("");
  const [stale, setStale] = createSignal("");

  const run = async (): Promise<void> => {
    setTrouble("");
    setState({ words: "", fraction: 0 });
    const text = props.sheet.text();
    const settings = list().map(({ quantity, low, high }) => `${quantity.path}=${plain(low)}${space(quantity.unit)}..${plain(high)}${space(quantity.unit)}:3`);
    try {
      const out = await analyse(props.sheet, "vary", { run: "tornado", settings, choice: '{"method":"limit","analysis":"load"}' }, (stage, fraction) => setState({ words: stage, fraction }));
      setBars(barsOf(JSON.parse(out.json)));
      setStale(text);
    } catch (error) {
      setTrouble(error instanceof Refused ? sentences(error) : error instanceof Lost && error.why === "stopped" ? "Stopped." : String((error as Error).message));
    }
    setState(null);
  };
  const scale = createMemo(() => {
    const all = bars() ?? [];
    const low = Math.min(...all.map((bar) => bar.low), ...all.map((bar) => bar.base));
    const high = Math.max(...all.map((bar) => bar.high), ...all.map((bar) => bar.base));
    return { low, high: high > low ? high : low + 1 };
  });
  return (
    <Show when={list().length > 0}>
      <details class="group" open>
        <summary>What is uncertain</summary>
        <For each={paths()}>
          {(path) => {
            const one = () => list().find((entry) => entry.quantity.path === path);
            return (
              <Show when={one()}>
                {(entry) => {
                  const id = `s-${path.replace(/[^\w]/g, "-")}`;
                  const said = () => shown(entry().quantity.text, system());
                  return (
                    <div class="slider">
                      <label for={id}>
                        {sayPath(path)} <span class="num soft">{said().text} {typeset(said().unit)}</span>
                      </label>
                      <input
                        id={id}
                        type="range"
                        min={entry().low}
                        max={entry().high}
                        step={(entry().high - entry().low) / 100}
                        value={entry().quantity.number ?? 0}
                        aria-valuetext={`${said().text} ${typeset(said().unit)}`}
                        onInput={(event) => setQuantity(path, `${plain(Number(event.currentTarget.value))}${space(entry().quantity.unit)}`, `slide ${path}`)}
                      />
                    </div>
                  );
                }}
              </Show>
            );
          }}
        </For>
        <Show when={props.sheet.about[0]()}><div class="row">
          <Show when={state()} fallback={<button type="button" class="btn small" onClick={() => void run()}>How much each one matters</button>}>
            {(now) => (
              <>
                <button type="button" class="btn small" onClick={() => background.stop()}>Stop</button>
                <span class="soft" role="status">{Number.isFinite(now().fraction) ? `${Math.round(100 * now().fraction)} %` : ""} {now().words}</span>
              </>
            )}
          </Show>
        </div></Show>
        <Show when={trouble()}>
          <p class="complaint" role="alert">{trouble()}</p>
        </Show>
        <Show when={bars()}>
          {(all) => (
            <figure class="tornado" aria-label="Load carried over the range of each quantity, the widest first">
              <p class="soft">
                Load of the file where it places it, each quantity by itself over its slider{stale() === props.sheet.text() ? "" : "; the bridge has changed since"}.
              </p>
              <For each={all()}>
                {(bar) => (
                  <div class="tornado-row">
                    <span>{sayPath(bar.path)}</span>
                    <span class="num">{figures(bar.low / 1e3)} to {words(lineLoad(bar.high, system()))}</span>
                    <span class="tornado-bar" aria-hidden="true">
                      <i style={{ left: `${(100 * (bar.low - scale().low)) / (scale().high - scale().low)}%`, width: `${Math.max(0.6, (100 * (bar.high - bar.low)) / (scale().high - scale().low))}%` }} />
                      <b style={{ left: `${(100 * (bar.base - scale().low)) / (scale().high - scale().low)}%` }} />
                    </span>
                  </div>
                )}
              </For>
            </figure>
          )}
        </Show>
      </details>
    </Show>
  );
}

function space(unit: string): string {
  return unit === "" ? "" : ` ${unit}`;
}

function sayPath(path: string): string {
  return path
    .replace(/^joint\./, "joint ")
    .replace(/^masonry\./, "masonry ")
    .replace(/^cover\[(\d+)\]\./, "layer $1 ")
    .replace(/^span\[(\d+)\]\./, "span $1 ")
    .replace(/[._]/g, " ")
    .replace(/^./, (c) => c.toUpperCase());
}


type Bar = { path: string; low: number; high: number; base: number };

/** Bars [N/m] from the object of `vary`, the widest first; ends without an answer are left out. */
export function barsOf(result: Record<string, unknown>): Bar[] {
  const outcome = String(result["outcome"] ?? "");
  const baseline = (result["baseline"] as { outcomes?: Record<string, number> } | null)?.outcomes?.[outcome];
  const list = (result["sensitivity"] ?? []) as { quantity: string; low: { outcome: number } | null; high: { outcome: number } | null }[];
  const bars: Bar[] = [];
  for (const { quantity, low, high } of list) {
    const ends = [low?.outcome, high?.outcome, baseline].filter((value): value is number => typeof value === "number" && Number.isFinite(value));
    if (ends.length < 2) continue;
    bars.push({ path: quantity, low: Math.min(...ends) * 1e3, high: Math.max(...ends) * 1e3, base: (baseline ?? ends[0]!) * 1e3 });
  }
  return bars.sort((a, b) => b.high - b.low - (a.high - a.low));
}
