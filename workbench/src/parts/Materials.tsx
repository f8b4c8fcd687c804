/** Materials of the library for a table of the file: what is usual, between which ends, from where; written as values with remarks. */
import { createMemo, createSignal, For, Show, type JSX } from "solid-js";
import { Refused, sentences } from "../engine/client";
import type { Material, MaterialValue } from "../engine/types";
import { materials } from "../model/library";
import { liveEngine } from "../model/live";
import type { Sheet } from "../model/sheet";
import { say } from "../model/workspace";
import { sayKey } from "../units";
import { typeset } from "../wording";

/** "2100 to 2400 kg/m^3": the unit once where both have it. */
function between(value: MaterialValue): string {
  const [low, unit] = value.least.split(/ (.*)/s);
  return value.most.endsWith(` ${unit}`) ? `${low} to ${value.most}` : `${value.least} to ${value.most}`;
}

export function offered(table: string): Material[] {
  return (materials() ?? []).filter((one) => one.tables.includes(table));
}

/** `at` is the table, as "masonry" or "cover[2]"; `there` the keys that the file writes in it. */
export function MaterialsOf(props: { sheet: Sheet; at: string; table: string; there: string[] }): JSX.Element {
  const [code, setCode] = createSignal("");
  const [left, setLeft] = createSignal<Set<string>>(new Set());
  const list = () => offered(props.table);
  const chosen = createMemo(() => list().find((one) => one.code === code()));
  const keys = () => (chosen()?.values ?? []).map((one) => one.key).filter((key) => !left().has(key));
  const choose = (name: string): void => {
    setCode(name);
    // What the file does not write yet may mean nothing to its methods: it is taken only where somebody asks for it.
    const values = list().find((one) => one.code === name)?.values ?? [];
    setLeft(new Set(values.map((one) => one.key).filter((key) => !props.there.includes(key))));
  };
  const toggle = (key: string): void => {
    const next = new Set(left());
    if (!next.delete(key)) next.add(key);
    setLeft(next);
  };
  const write = async (): Promise<void> => {
    const text = props.sheet.text();
    try {
      const filled = await liveEngine.call<string>("withMaterial", { text, table: props.at, material: code(), keys: keys() });
      if (props.sheet.text() !== text) return say("The file changed meanwhile; nothing was written. Press the button again.", true);
      props.sheet.change(filled, `material ${props.at}`);
      say(`${chosen()!.title}: ${keys().length} ${keys().length === 1 ? "value is" : "values are"} in the file with the source beside each. None is measured on this bridge.`);
      setCode("");
    } catch (error) {
      say(error instanceof Refused ? sentences(error) : String((error as Error).message), true);
    }
  };
  const id = (): string => `material-${props.at.replace(/\W/g, "-")}`;
  return (
    <Show when={list().length > 0}>
      <details class="library">
        <summary>From the library of materials</summary>
        <div class="field wide">
          <label for={id()}>Material</label>
          <select id={id()} value={code()} onChange={(event) => choose(event.currentTarget.value)}>
            <option value="">choose …</option>
            <For each={list()}>{(one) => <option value={one.code}>{one.title}</option>}</For>
          </select>
        </div>
        <Show when={chosen()}>
          {(material) => (
            <>
              <ul class="values">
                <For each={material().values}>
                  {(value) => (
                    <li>
                      <label>
                        <input type="checkbox" checked={!left().has(value.key)} onChange={() => toggle(value.key)} />{" "}
                        <b>{sayKey(value.key)} <span class="num">{typeset(value.usual)}</span></b>
                      </label>
                      <span class="num soft">usually {typeset(between(value))}</span>
                      <span class="soft">{typeset(`${value.source.confidence}: ${value.source.text}, ${value.source.date}${value.source.note ? `; ${value.source.note}` : ""}`)}</span>
                    </li>
                  )}
                </For>
              </ul>
              <button type="button" class="btn small" disabled={keys().length === 0} onClick={() => void write()}>Write into the file</button>
            </>
          )}
        </Show>
      </details>
    </Show>
  );
}
