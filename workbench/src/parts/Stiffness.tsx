/** For a file that does not say how its joints give: the masonry of the library by which that is assumed, written into the file with its remark. */
import { createMemo, createSignal, For, Show, type JSX } from "solid-js";
import { materials } from "../model/library";
import type { Sheet } from "../model/sheet";
import { lacksStiffness, stoneLength, withStiffness } from "../model/stiffness";

export function AssumeStiffness(props: { sheet: Sheet }): JSX.Element {
  // The softest first: softer joints carry no more.
  const list = createMemo(() =>
    (materials() ?? []).flatMap((one) => {
      const modulus = one.tables.includes("masonry") ? one.values.find((value) => value.key === "elastic_modulus") : undefined;
      return modulus ? [{ code: one.code, title: one.title, modulus: modulus.usual }] : [];
    }).sort((a, b) => Number.parseFloat(a.modulus) - Number.parseFloat(b.modulus)),
  );
  const [code, setCode] = createSignal("");
  const filled = () => {
    const seen = props.sheet.picture[0]();
    const length = seen ? stoneLength(seen) : null;
    const one = list().find((each) => each.code === code()) ?? list()[0];
    return one && length !== null ? withStiffness(props.sheet.text(), one.modulus, length, one.code) : null;
  };
  return (
    <Show when={lacksStiffness(props.sheet.text()) && filled() !== null}>
      <div class="assume">
        <label for="assume-masonry">The file does not say how its joints give. Assume it for</label>
        <select id="assume-masonry" class="plain" onChange={(event) => setCode(event.currentTarget.value)}>
          <For each={list()}>{(one) => <option value={one.code}>{one.title}, {one.modulus}</option>}</For>
        </select>
        <button type="button" class="btn small" onClick={() => props.sheet.change(filled()!, "stiffness")}>Write it into the file</button>
      </div>
    </Show>
  );
}
