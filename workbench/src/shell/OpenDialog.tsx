/** Ways to a bridge: ten survey numbers, an example, a file from this machine. */
import { For, onMount, Show, type JSX } from "solid-js";
import type { Example } from "../engine/types";
import { engineOnItsWay, examples } from "../model/library";
import { liveEngine } from "../model/live";
import { open, say, setPart } from "../model/workspace";
import { setTab } from "../parts/BridgePanel";
import { openFiles } from "./files";

export async function openExample(example: Example, main = example.main): Promise<void> {
  try {
    const files: [string, Uint8Array][] = [];
    let text = "";
    for (const { name } of example.files) {
      const bytes = await liveEngine.call<Uint8Array>("exampleFile", { example: example.name, file: name });
      if (name === main) text = new TextDecoder().decode(bytes);
      else files.push([name, bytes]);
    }
    const toml = files.filter(([name]) => !/\.toml$/.test(name));
    // Other bridge files of an example are not beside it, but the one that a file of it is made from may be.
    open({ path: main, text }, text.includes(".toml") ? files : toml);
  } catch (error) {
    say(`The example could not be opened: ${(error as Error).message}`, true);
  }
}

const sayName = (name: string): string => name.replace(/-/g, " ").replace(/^./, (c) => c.toUpperCase());

/** A bridge in which every number is assumed, and the questions beside it. */
export async function openSurvey(): Promise<void> {
  try {
    open({ path: "bridge.toml", text: await liveEngine.call<string>("surveyStart") });
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
  const take = (example: Example, main: string): void => {
    void openExample(example, main).then(() => {
      setPart("bridge");
      props.done();
    });
    dialog.close();
  };
  return (
    <dialog ref={dialog} aria-labelledby="open-title" onClose={props.close}>
      <div class="head">
        <h2 id="open-title">Open a bridge</h2>
        <button type="button" class="btn small" onClick={() => dialog.close()}>Close</button>
      </div>
      <div class="body">
          <div class="row">
            <button type="button" class="btn main" autofocus onClick={() => {
              void openSurvey().then(props.done);
              dialog.close();
            }}>Ten survey numbers</button>
            <button type="button" class="btn" onClick={() => input.click()}>A file from this machine</button>
            <input ref={input} type="file" multiple class="unseen" tabindex="-1" aria-label="Bridge files and their companions" accept=".toml,.dxf,.csv,.txt,.zip" onChange={(event) => {
              void openFiles([...(event.currentTarget.files ?? [])]).then(() => props.done());
              dialog.close();
            }} />
            <button type="button" class="btn" onClick={() => {
              props.tour();
              dialog.close();
            }}>Tour of two minutes</button>
            <span class="soft">A bridge file (.toml), a drawing (.dxf), results (.zip, or the folder dropped here); it stays on this machine.</span>
          </div>
          <h3 class="spaced">Examples</h3>
          <Show when={engineOnItsWay()}>{(words) => <p role="status">{words()}</p>}</Show>
          <div class="choices">
            <For each={examples() ?? []}>
              {(example) => (
                <div class="choice">
                  <button type="button" data-example={example.name} onClick={() => take(example, example.main)}>
                    <b>{sayName(example.name)}</b>
                    <span>{example.about}</span>
                  </button>
                  <Show when={example.files.filter((file) => /\.toml$/.test(file.name)).length > 1}>
                    <details>
                      <summary>Other files</summary>
                      <For each={example.files.filter((file) => /\.toml$/.test(file.name) && file.name !== example.main)}>
                        {(file) => <button type="button" class="link" title={file.about} onClick={() => take(example, file.name)}>{file.name}</button>}
                      </For>
                    </details>
                  </Show>
                </div>
              )}
            </For>
          </div>
      </div>
    </dialog>
  );
}

