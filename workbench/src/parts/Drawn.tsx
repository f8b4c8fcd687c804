/** What a drawing does not say: asked beside it, once it is drawn. */
import { createMemo, createSignal, For, Show, type JSX } from "solid-js";
import { boundsOf } from "../drawing/view";
import { isOpen, lacksOf, withLoad, withSupport, withValue } from "../model/drawn";
import { materials } from "../model/library";
import type { Sheet } from "../model/sheet";
import { setPart } from "../model/workspace";
import { entry, inSystem, meant } from "../units";
import { typeset } from "../wording";
import { system } from "../shell/settings";

export function Drawn(props: { sheet: Sheet }): JSX.Element {
  const lacks = createMemo(() => lacksOf(props.sheet.text()));
  const put = (table: string, index: number, key: string, written: string): void => props.sheet.change(withValue(props.sheet.text(), table, index, key, written), `drawn ${table} ${index} ${key}`);
  const open = () => [
    ...lacks().materials.flatMap((one) => [one.density === "" ? `density of ${one.name}` : "", one.strength === "" ? `strength of ${one.name}` : ""]),
    lacks().friction === "" ? "friction in the joints" : "",
    lacks().layers.every((one) => one.supports === 0) ? "what holds the blocks" : "",
    lacks().loads === 0 ? "a load" : "",
  ].filter((words) => words !== "");
  const masonry = () => (materials() ?? []).filter((one) => one.tables.includes("masonry"));
  const ofLibrary = (index: number, code: string): void => {
    const values = masonry().find((one) => one.code === code)?.values ?? [];
    const text = values.reduce((now, one) => (["density", "compressive_strength"].includes(one.key) ? withValue(now, "material", index, one.key, one.usual) : now), props.sheet.text());
    props.sheet.change(text, "");
  };
  const box = createMemo(() => (props.sheet.picture[0]() ? boundsOf(props.sheet.picture[0]()!) : null));
  const [at, setAt] = createSignal("");
  const [none, setNone] = createSignal(false);
  const usual = () => (box() ? (box()!.left + 0.35 * (box()!.right - box()!.left)).toFixed(2) : "");
  const addLoad = (): void => {
    const seen = props.sheet.picture[0]();
    const x = Number(at().replace(",", ".") || usual());
    const text = seen && Number.isFinite(x) ? withLoad(props.sheet.text(), seen, x) : null;
    setNone(text === null);
    if (text !== null) props.sheet.change(text, "load");
  };
  return (
    <div>
      <p class="soft">The drawing has outlines. What they are made of, what holds them and what loads them stands in no drawing, and nothing is assumed of it.</p>
      <p role="status" data-testid="lacks">
        <Show when={open().length > 0} fallback={<><b>Nothing is missing.</b> “Verdict” finds the load at which the blocks collapse.</>}>
          <b>Missing:</b> {open().join(", ")}.
        </Show>
      </p>
      <For each={lacks().materials.map((one) => one.name)}>
        {(name, k) => (
          <>
            <h2 class="spaced">{name}</h2>
            <div class="field wide">
              <label for={`d-library-${k()}`}>From the library, its usual values</label>
              <select id={`d-library-${k()}`} onChange={(event) => event.currentTarget.value !== "" && ofLibrary(k() + 1, event.currentTarget.value)}>
                <option value="">choose …</option>
                <For each={masonry()}>{(one) => <option value={one.code}>{one.title}</option>}</For>
              </select>
            </div>
            <Quantity id={`d-density-${k()}`} title={`Density of ${name}`} unit="kg/m^3" range="Usually 1500 to 3000 kg/m^3." value={lacks().materials[k()]?.density ?? ""} put={(written) => put("material", k() + 1, "density", written)} />
            <Quantity id={`d-strength-${k()}`} title={`Compressive strength of ${name}`} unit="MPa" range="Usually 0.5 to 400 MPa; “unlimited” leaves crushing out." value={lacks().materials[k()]?.strength ?? ""} put={(written) => put("material", k() + 1, "compressive_strength", written)} />
          </>
        )}
      </For>
      <h2 class="spaced">Joints</h2>
      <Quantity id="d-friction" title="Friction angle of the joints" unit="deg" range="Usually 15 to 60 deg." value={lacks().friction} put={(written) => put("joint", 1, "friction_angle", written)} />
      <h2 class="spaced">What holds them</h2>
      <For each={lacks().layers.map((one) => one.name)}>
        {(name) => {
          const layer = () => lacks().layers.find((one) => one.name === name);
          return (
            <label class="tick">
              <input type="checkbox" checked={layer()?.supports === layer()?.blocks} onChange={(event) => props.sheet.change(withSupport(props.sheet.text(), name, event.currentTarget.checked), "")} />
              <span>{name}, {layer()?.blocks === 1 ? "1 block" : `${layer()?.blocks} blocks`}: does not move</span>
            </label>
          );
        }}
      </For>
      <h2 class="spaced">Width and load</h2>
      <Quantity id="d-width" title="Width across" unit="m" range="Not given: 1 m is taken." value={lacks().width} put={(written) => put("model", 0, "width", written)} />
      <div class="field">
        <label for="d-load">A load downwards at x, m</label>
        <div class="entry"><input id="d-load" inputmode="decimal" placeholder={usual()} value={at()} onInput={(event) => setAt(event.currentTarget.value)} /></div>
        <Show when={none()}><p class="complaint" role="alert">No block that moves lies there.</p></Show>
      </div>
      <div class="row">
        <button type="button" class="btn small" onClick={addLoad}>{lacks().loads === 0 ? "Put it on the blocks" : `Put a further one, ${lacks().loads} so far`}</button>
        <Show when={!isOpen(props.sheet.text()) && open().length === 0}><button type="button" class="btn small" onClick={() => setPart("verdict")}>To the verdict</button></Show>
      </div>
    </div>
  );
}

function Quantity(props: { id: string; title: string; unit: string; range: string; value: string; put: (written: string) => void }): JSX.Element {
  let input!: HTMLInputElement;
  const shown = () => entry(props.value, props.unit, system());
  return (
    <div class="field">
      <label for={props.id}>{props.title}</label>
      <div class="entry">
        <input ref={input} id={props.id} inputmode="decimal" autocomplete="off" value={typeset(shown().text)} aria-describedby={`${props.id}-range`} onChange={(event) => event.currentTarget.value.trim() !== "" && props.put(meant(event.currentTarget.value, shown().unit))} />
        <span class="unit">{typeset(shown().unit)}</span>
      </div>
      <p class="range" id={`${props.id}-range`}>{typeset(inSystem(props.range, system()))}</p>
    </div>
  );
}
