/** Ways to a bridge: ten survey numbers, an example, a file from this machine. */
import { For, onMount, type JSX } from "solid-js";
import type { Example, Question } from "../engine/types";
import { examples } from "../model/library";
import { liveEngine } from "../model/live";
import { open, say, setPart } from "../model/workspace";
import { setTab } from "../parts/BridgePanel";
import { openFiles } from "./files";

export async function openExample(example: Example): Promise<void> {
  try {
    const files: [string, Uint8Array][] = [];
    let text = "";
    for (const { name } of example.files) {
      const bytes = await liveEngine.call<Uint8Array>("exampleFile", { example: example.name, file: name });
      if (name === example.main) text = new TextDecoder().decode(bytes);
      else files.push([name, bytes]);
    }
    if (text === "") text = new TextDecoder().decode(await liveEngine.call<Uint8Array>("exampleFile", { example: example.name, file: example.main }));
    open({ path: example.main, text }, files);
  } catch (error) {
    say(`The example could not be opened: ${(error as Error).message}`, true);
  }
}

/** A bridge of the numbers that every question has as its example, with the questions beside it. */
export async function openSurvey(): Promise<void> {
  try {
    const list = await liveEngine.call<Question[]>("questions");
    const answers = Object.fromEntries(list.map((question) => [question.key, question.example]));
    const text = await liveEngine.call<string>("fromSurvey", { answers });
    const sheet = open({ path: "bridge.toml", text, survey: answers });
    sheet?.surveyed[1](text);
    setPart("bridge");
    setTab("survey");
  } catch (error) {
    say(`The survey sheet could not be opened: ${(error as Error).message}`, true);
  }
}

export function OpenDialog(props: { close: () => void; done: () => void; tour: () => void }): JSX.Element {
  let dialog!: HTMLDialogElement;
  let input!: HTMLInputElement;
  onMount(() => dialog.showModal());
  return (
    <dialog ref={dialog} aria-labelledby="open-title" onClose={props.close}>
      <div class="head">
        <h2 id="open-title">Open a bridge</h2>
        <button type="button" class="btn small" onClick={() => dialog.close()}>Close</button>
      </div>
      <div class="body">
          <div class="row">
            <button type="button" class="btn main" onClick={() => {
              void openSurvey().then(props.done);
              dialog.close();
            }}>Ten survey numbers</button>
            <button type="button" class="btn" onClick={() => input.click()}>A file from this machine</button>
            <input ref={input} type="file" multiple class="unseen" tabindex="-1" aria-label="Bridge files and their companions" accept=".toml,.dxf,.csv,.txt" onChange={(event) => {
              void openFiles([...(event.currentTarget.files ?? [])]).then(() => props.done());
              dialog.close();
            }} />
            <button type="button" class="btn" onClick={() => {
              props.tour();
              dialog.close();
            }}>Tour of two minutes</button>
            <span class="soft">A bridge file (.toml) or a drawing (.dxf); it stays on this machine.</span>
          </div>
          <h3 class="spaced">Examples</h3>
          <div class="choices">
            <For each={examples() ?? []} fallback={<p>Reading the examples …</p>}>
              {(example) => (
                <button type="button" data-example={example.name} onClick={() => {
                  void openExample(example).then(() => {
                    setPart("bridge");
                    props.done();
                  });
                  dialog.close();
                }}>
                  <b>{example.name}</b>
                  <span>{example.about}</span>
                </button>
              )}
            </For>
          </div>
      </div>
    </dialog>
  );
}

