/** The ten numbers of a survey: the file is written anew with every number that is typed. */
import { createSignal, For, Show, type JSX } from "solid-js";
import { Refused } from "../engine/client";
import { questions } from "../model/library";
import { liveEngine } from "../model/live";
import type { Sheet } from "../model/sheet";
import { system } from "../shell/settings";
import { meant, sayKey, shown } from "../units";

const TITLES: Record<string, string> = {
  span: "Span",
  rise: "Rise",
  thickness: "Thickness of the ring",
  width: "Width of the barrel",
  cover: "Cover over the crown",
  unit: "Length of a stone along the ring",
  backing: "Height of backing",
  density: "Density of the masonry",
  strength: "Strength of the masonry",
  axle: "Axle",
};

export function Survey(props: { sheet: Sheet }): JSX.Element {
  const [wrong, setWrong] = createSignal("");
  const elsewhere = () => props.sheet.surveyed[0]() !== "" && props.sheet.surveyed[0]() !== props.sheet.text();
  let newest = 0;
  const write = async (answers: Record<string, string>, mark: string): Promise<void> => {
    const mine = ++newest;
    try {
      const text = await liveEngine.call<string>("fromSurvey", { answers }, { patience: 5000 });
      if (mine !== newest) return;
      setWrong("");
      props.sheet.surveyed[1](text);
      props.sheet.change(text, mark);
    } catch (error) {
      if (mine === newest) setWrong(error instanceof Refused ? `${error.message}. ${error.help}.` : String((error as Error).message));
    }
  };
  const answer = (key: string, typed: string, unit: string): void => {
    const answers = { ...(props.sheet.survey[0]() ?? {}) };
    if (typed.trim() === "") delete answers[key];
    else answers[key] = meant(typed, unit);
    props.sheet.survey[1](answers);
    if (!elsewhere()) void write(answers, `survey ${key}`);
  };
  return (
    <div>
      <p class="soft">Measured on site or taken off an old drawing. The bridge follows while you type; what is left empty is assumed, and the file says so.</p>
      <For each={questions() ?? []}>
        {(question) => {
          const start = shown(props.sheet.survey[0]()?.[question.key] ?? "", system());
          const unit = shown(question.example, system()).unit;
          const id = `q-${question.key}`;
          return (
            <div class="field">
              <label for={id}>{TITLES[question.key] ?? sayKey(question.key)}</label>
              <div class="entry">
                <input id={id} value={start.text} placeholder={question.assumed ? "assumed" : ""} inputmode="decimal" autocomplete="off" aria-describedby={`${id}-doc`} onInput={(event) => answer(question.key, event.currentTarget.value, unit)} />
                <Show when={unit}>
                  <span class="unit">{unit}</span>
                </Show>
              </div>
              <p class="doc" id={`${id}-doc`}>
                {question.doc}
                {question.assumed ? ` If unknown: ${question.assumed} is assumed.` : ""}
              </p>
            </div>
          );
        }}
      </For>
      <Show when={wrong()}>
        <p class="complaint" role="alert">{wrong()}</p>
      </Show>
      <Show when={elsewhere()}>
        <p>
          The bridge has been changed in its form, text or drawing since. <button type="button" class="btn small" onClick={() => void write(props.sheet.survey[0]() ?? {}, "survey anew")}>Write it anew from these numbers</button>
        </p>
      </Show>
    </div>
  );
}
