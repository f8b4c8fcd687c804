/** Ways to a bridge: ten survey numbers, an example, a file from this machine. */
import { createSignal, For, onMount, Show, type JSX } from "solid-js";
import { Refused } from "../engine/client";
import type { Example, Question } from "../engine/types";
import { examples, questions } from "../model/library";
import { liveEngine } from "../model/live";
import { open, say, setPart } from "../model/workspace";
import { meant, shown } from "../units";
import { openFiles } from "./files";
import { system } from "./settings";

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

export function OpenDialog(props: { close: () => void; done: () => void }): JSX.Element {
  let dialog!: HTMLDialogElement;
  let input!: HTMLInputElement;
  const [survey, setSurvey] = createSignal(false);
  onMount(() => dialog.showModal());
  return (
    <dialog ref={dialog} aria-labelledby="open-title" onClose={props.close}>
      <div class="head">
        <h2 id="open-title">{survey() ? "A bridge from ten survey numbers" : "Open a bridge"}</h2>
        <button type="button" class="btn small" onClick={() => dialog.close()}>Close</button>
      </div>
      <div class="body">
        <Show
          when={!survey()}
          fallback={<Survey back={() => setSurvey(false)} done={() => {
            props.done();
            dialog.close();
          }} />}
        >
          <div class="row">
            <button type="button" class="btn main" onClick={() => setSurvey(true)}>Ten survey numbers</button>
            <button type="button" class="btn" onClick={() => input.click()}>A file from this machine</button>
            <input ref={input} type="file" multiple class="unseen" tabindex="-1" aria-label="Bridge files and their companions" accept=".toml,.dxf,.csv,.txt" onChange={(event) => {
              void openFiles([...(event.currentTarget.files ?? [])]).then(() => props.done());
              dialog.close();
            }} />
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
        </Show>
      </div>
    </dialog>
  );
}

function Survey(props: { back: () => void; done: () => void }): JSX.Element {
  const answers: Record<string, string> = {};
  const [wrong, setWrong] = createSignal("");
  const make = async (): Promise<void> => {
    setWrong("");
    const filled = Object.fromEntries(
      (questions() ?? []).map((question) => {
        const typed = answers[question.key] ?? "";
        const unit = shown(question.example, system()).unit;
        return [question.key, typed.trim() === "" ? question.example : meant(typed, unit)];
      }),
    );
    try {
      const text = await liveEngine.call<string>("fromSurvey", { answers: filled });
      open({ path: "bridge.toml", text });
      setPart("bridge");
      props.done();
    } catch (error) {
      setWrong(error instanceof Refused ? `${error.message} ${error.help}` : String((error as Error).message));
    }
  };
  return (
    <form onSubmit={(event) => {
      event.preventDefault();
      void make();
    }}>
      <p class="soft">Measured on site, or off an old drawing. What you leave empty takes the value shown in grey, and can be changed on the drawing.</p>
      <For each={questions() ?? []}>{(question) => <Ask question={question} take={(text) => (answers[question.key] = text)} />}</For>
      <Show when={wrong()}>
        <p class="complaint" role="alert">{wrong()}</p>
      </Show>
      <div class="row spaced">
        <button type="submit" class="btn main">Draw the bridge</button>
        <button type="button" class="btn" onClick={props.back}>Back</button>
      </div>
    </form>
  );
}

function Ask(props: { question: Question; take: (text: string) => void }): JSX.Element {
  const example = () => shown(String(props.question.example), system());
  const id = () => `q-${props.question.key}`;
  return (
    <div class="field">
      <label for={id()}>{props.question.title ?? props.question.key}</label>
      <Show
        when={(props.question.words ?? []).length > 0}
        fallback={
          <div class="entry">
            <input id={id()} placeholder={example().text} inputmode="decimal" autocomplete="off" aria-describedby={`${id()}-doc`} onInput={(event) => props.take(event.currentTarget.value)} />
            <Show when={example().unit}>
              <span class="unit">{example().unit}</span>
            </Show>
          </div>
        }
      >
        <select id={id()} onChange={(event) => props.take(event.currentTarget.value)} aria-describedby={`${id()}-doc`}>
          <For each={props.question.words}>{(word) => <option value={word.word} selected={word.word === props.question.example}>{word.word}</option>}</For>
        </select>
      </Show>
      <p class="doc" id={`${id()}-doc`}>{props.question.doc}</p>
    </div>
  );
}
