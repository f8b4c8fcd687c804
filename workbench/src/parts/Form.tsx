/** The bridge as fields: every quantity of the file under its table, edited by its path so that the text keeps its comments. */
import { createEffect, createMemo, createSignal, For, onCleanup, Show, type JSX } from "solid-js";
import { sentences } from "../engine/client";
import type { Quantity, Refusal } from "../engine/types";
import { setQuantity } from "../model/live";
import type { Sheet } from "../model/sheet";
import { countOf, inserted, repeated, without } from "../model/structure";
import { inSystem, meant, sayKey, shown } from "../units";
import { plainly, typeset } from "../wording";
import { MaterialsOf } from "./Materials";
import { system } from "../shell/settings";

const TITLES: Record<string, string> = {
  bridge: "Bridge",
  span: "Span",
  pier: "Pier",
  abutment: "Abutments",
  masonry: "Masonry",
  joint: "Joints",
  cover: "Layer",
  backing: "Backing",
  dispersal: "Spread of loads through the cover",
  load: "Load",
  pressure: "Pressure of the fill",
  fill_pressure: "Pressure of the fill",
  continuum: "Fill as a continuum",
  ring_joint: "Joints between rings",
  mortar: "Mortar",
  fill: "Fill",
  haunch_fill: "Fill of the haunches",
  abutment_fill: "Fill behind the abutments",
  particles: "Fill as particles",
  road: "Road",
  defect: "Defect",
  sweep: "Vehicles",
  analysis: "Analysis",
  passage: "Passage of a train",
  train: "Train",
  sensor: "Sensor",
};

/** Tables that describe the bridge come before those that describe what is computed. */
const ORDER = ["bridge", "span", "pier", "cover", "backing", "masonry", "joint", "abutment", "road", "defect", "load", "dispersal", "sweep"];

/** Most that is laid out as fields; more is for the text. */
const MOST_GROUPS = 60;
const MOST_FIELDS = 60;

type Group = { id: string; base: string; index: number | null; title: string; fields: Quantity[] };

function groupsOf(quantities: Quantity[]): Group[] {
  const groups = new Map<string, Group>();
  const singles = new Set<string>();
  for (const quantity of quantities) {
    const dot = quantity.path.indexOf(".");
    const head = dot < 0 ? "" : quantity.path.slice(0, dot);
    const match = /^([\w-]+)(?:\[(\d+)\])?$/.exec(head);
    const base = match?.[1] ?? "";
    const index = match?.[2] ? Number(match[2]) : null;
    if (index === 1) singles.add(base);
    let group = groups.get(head);
    if (!group) {
      group = { id: head, base, index, title: TITLES[base] ?? sayKey(base || "file"), fields: [] };
      groups.set(head, group);
    }
    group.fields.push(quantity);
  }
  const rank = (base: string) => (ORDER.includes(base) ? ORDER.indexOf(base) : ORDER.length);
  return [...groups.values()].sort((a, b) => rank(a.base) - rank(b.base) || (a.index ?? 0) - (b.index ?? 0));
}

function FieldRow(props: { sheet: Sheet; quantity: Quantity; short: string }): JSX.Element {
  const [wrong, setWrong] = createSignal<Refusal | null>(null);
  // What is typed here and refused makes the answer one of the values before.
  createEffect(() => props.sheet.refuse(props.quantity.path, wrong() !== null));
  onCleanup(() => props.sheet.refuse(props.quantity.path, false));
  /** Words of which one stands here; yes and no of a truth. */
  const options = createMemo<{ word: string; doc: string; title?: string }[]>(() =>
    props.quantity.words.length > 0 ? props.quantity.words : /^(true|false)$/.test(props.quantity.text) ? [{ word: "true", doc: "", title: "yes" }, { word: "false", doc: "", title: "no" }] : [],
  );
  // What the file has at this place and cannot be used.
  const found = createMemo(() => {
    const { start, end } = props.quantity;
    if (start === null || end === null) return null;
    return (props.sheet.reading[0]()?.findings ?? []).find((one) => one.severity === "error" && one.start < end && one.end > start) ?? null;
  });
  const said = createMemo(() => shown(props.quantity.text, system()));
  const id = () => `f-${props.quantity.path.replace(/[^\w]/g, "-")}`;
  const send = (typed: string): void => {
    setWrong(null);
    if (typed.trim() === said().text) return;
    setQuantity(props.quantity.path, meant(typed, said().unit), `field ${props.quantity.path}`, (error) => setWrong(error));
  };
  return (
    <div class="field" classList={{ default: props.quantity.by_default, wrong: wrong() !== null || found() !== null }}>
      <label for={id()}>{props.short}</label>
      <Show
        when={options().length > 0}
        fallback={
          <div class="entry">
            <input
              id={id()}
              data-path={props.quantity.path}
              value={said().text}
              inputmode={props.quantity.number === null ? "text" : "decimal"}
              aria-describedby={`${id()}-doc`}
              aria-invalid={wrong() !== null || found() !== null}
              autocomplete="off"
              spellcheck={false}
              onInput={(event) => {
                // While typing, only what is a whole quantity already goes to the drawing.
                if (/^\s*[+-]?(\d+([.,]\d+)?)\s*([a-zA-Z].*)?$/.test(event.currentTarget.value)) send(event.currentTarget.value);
              }}
              onChange={(event) => send(event.currentTarget.value)}
              onKeyDown={(event) => {
                if (event.key !== "Escape") return;
                event.currentTarget.value = said().text;
                setWrong(null);
              }}
            />
            <Show when={said().unit}>
              <span class="unit">{typeset(said().unit)}</span>
            </Show>
          </div>
        }
      >
        <select id={id()} aria-describedby={`${id()}-doc`} onChange={(event) => setQuantity(props.quantity.path, event.currentTarget.value, "", setWrong)}>
          <For each={options()}>{(word) => <option value={word.word} title={word.doc} selected={word.word === props.quantity.text}>{word.title ?? word.word}</option>}</For>
        </select>
      </Show>
      <p class="doc" id={`${id()}-doc`}>
        {plainly(props.quantity.doc)}
        <Show when={system() === "imperial" && said().text !== props.quantity.text}> In the file: {typeset(props.quantity.text)}.</Show>
      </p>
      <Show when={wrong() === null && found()}>
        {(one) => (
          <p class="complaint" role="alert">
            {sentences({ message: inSystem(one().message, system()), help: one().help ?? one().label })}
          </p>
        )}
      </Show>
      <Show when={wrong()}>
        {(error) => (
          <p class="complaint" role="alert">
            {sentences(error())}
          </p>
        )}
      </Show>
    </div>
  );
}

export function Form(props: { sheet: Sheet }): JSX.Element {
  const groups = createMemo(() => groupsOf(props.sheet.quantities[0]()));
  const ids = createMemo(() => groups().slice(0, MOST_GROUPS).map((group) => group.id), [], { equals: (a, b) => a.length === b.length && a.every((id, k) => id === b[k]) });
  const [all, setAll] = createSignal(false);
  const change = (text: string | null, what: string): void => {
    if (text !== null) props.sheet.change(text, what);
  };
  const addSpan = (): void => {
    let text = repeated(props.sheet.text(), "span");
    if (text === null) return;
    const spans = countOf(text, "span");
    text = countOf(text, "pier") > 0 ? (repeated(text, "pier") ?? text) : inserted(text, "pier", 'width = "1.5 m"  # assumed\nheight = "3 m"  # assumed\ncourses = 10');
    change(text, `add span ${spans}`);
  };
  const addLayer = (): void => change(inserted(props.sheet.text(), "cover", 'layer = "fill"\nthickness = "0.2 m"\ndensity = "1800 kg/m^3"'), "add layer");
  const lists = ["span", "pier", "cover", "load", "defect"];
  return (
    <div>
      <div class="row">
        <button type="button" class="btn small" onClick={addSpan}>Add a span and its pier</button>
        <button type="button" class="btn small" onClick={addLayer}>Add a layer</button>
      </div>
      <p class="soft spaced">
        <label>
          <input type="checkbox" checked={all()} onChange={(event) => setAll(event.currentTarget.checked)} /> Show values that the file leaves to their defaults
        </label>
      </p>
      <Show when={props.sheet.reading[0]()?.kind === "blocks"}>
        <p>This is a block model, with blocks from a drawing. What is not listed here is in its text.</p>
      </Show>
      <Show when={groups().length > MOST_GROUPS}>
        <p class="soft">The first {MOST_GROUPS} of {groups().length} tables; the others are in the text.</p>
      </Show>
      <For each={ids()}>
        {(id) => {
          const group = () => groups().find((one) => one.id === id) ?? { id, base: "", index: null, title: "", fields: [] };
          const fields = createMemo(
            () => group().fields.filter((one) => all() || !one.by_default).slice(0, MOST_FIELDS).map((one) => one.path),
            [],
            { equals: (a, b) => a.length === b.length && a.every((path, k) => path === b[k]) },
          );
          const many = () => groups().filter((one) => one.base === group().base).length > 1;
          const note = () => {
            const layer = group().base === "cover" ? /layer\s*=\s*"([^"]*)"/.exec(layerText(props.sheet.text(), group().index ?? 1)) : null;
            return layer ? ` ${layer[1]}` : "";
          };
          return (
            <Show when={fields().length > 0}>
              <details class="group" open={!["analysis", "abutment"].includes(group().base)}>
                <summary>
                  {group().title}
                  {group().index !== null && many() ? ` ${group().index}` : ""}
                  <span class="soft">{note()}</span>
                </summary>
                <For each={fields()}>
                  {(path) => {
                    const quantity = () => group().fields.find((one) => one.path === path);
                    return <Show when={quantity()}>{(one) => <FieldRow sheet={props.sheet} quantity={one()} short={sayKey(path.slice(id.length + 1).replace(/\[(\d+)\]/g, " $1").replace(/\./g, ", "))} />}</Show>;
                  }}
                </For>
                <MaterialsOf sheet={props.sheet} at={id} table={group().base} there={group().fields.filter((one) => !one.by_default).map((one) => one.path.slice(id.length + 1))} />
                <Show when={group().index !== null && many() && lists.includes(group().base)}>
                  <button type="button" class="btn small" onClick={() => change(without(props.sheet.text(), group().base, group().index!), `remove ${id}`)}>
                    Remove {group().title.toLowerCase()} {group().index}
                  </button>
                </Show>
              </details>
            </Show>
          );
        }}
      </For>
    </div>
  );
}

function layerText(text: string, index: number): string {
  const parts = text.split(/^\s*\[\[cover\]\]/m);
  return parts[index]?.split(/^\s*\[/m)[0] ?? "";
}
