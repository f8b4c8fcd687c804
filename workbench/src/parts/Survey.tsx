/** The ten numbers of a survey: the file is written anew with every number that is typed. */
import { createSignal, For, Show, type JSX } from "solid-js";
import { Refused, sentences } from "../engine/client";
import { questions } from "../model/library";
import { liveEngine } from "../model/live";
import type { Sheet } from "../model/sheet";
import { system } from "../shell/settings";
import { figures, meant, sayKey, shown } from "../units";

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
  const [wrong, setWrong] = createSignal<{ key: string; text: string } | null>(null);
  const elsewhere = () => props.sheet.surveyed[0]() !== "" && props.sheet.surveyed[0]() !== props.sheet.text();
  let newest = 0;
  const write = async (answers: Record<string, string>, mark: string): Promise<void> => {
    const mine = ++newest;
    try {
      const text = await liveEngine.call<string>("fromSurvey", { answers }, { patience: 5000 });
      if (mine !== newest) return;
      setWrong(null);
      props.sheet.surveyed[1](text);
      props.sheet.change(text, mark);
    } catch (error) {
      if (mine === newest) setWrong(told(error, answers));
    }
  };
  const answer = (key: string, typed: string, unit: string): void => {
    const answers = { ...(props.sheet.survey[0]() ?? {}) };
    if (typed.trim() === "") delete answers[key];
    else answers[key] = meant(typed, unit);
    props.sheet.survey[1](answers);
    if (!elsewhere()) void write(answers, `survey ${key}`);
  };
  // Only what the engine names; a refusal of several numbers belongs to the first of them.
  const told = (error: unknown, answers: Record<string, string>): { key: string; text: string } => {
    if (!(error instanceof Refused)) return { key: "", text: String((error as Error).message) };
    const key = /^(\w+)(?::| is missing)/.exec(error.message)?.[1] ?? "";
    const mass = key === "axle" ? /^([\d.]+)\s*(t|tonnes?)$/.exec(answers[key] ?? "") : null;
    if (mass) return { key, text: `This is a mass. An axle of ${mass[1]} t weighs ${figures(Number(mass[1]) * 9.80665)} kN: write that.` };
    return { key, text: sentences(error) };
  };
  return (
    <div>
      <p class="soft">Measured on site or taken off an old drawing. The bridge follows while you type; what is left empty is assumed, and the file says so. These numbers make one span: “Form” adds others with their piers.</p>
      <For each={questions() ?? []}>
        {(question) => {
          const start = shown(props.sheet.survey[0]()?.[question.key] ?? "", system());
          const unit = shown(question.example, system()).unit;
          const id = `q-${question.key}`;
          const [typed, setTyped] = createSignal(start.text);
          const mine = () => (wrong()?.key === question.key ? wrong()!.text : "");
          return (
            <div class="field" classList={{ wrong: mine() !== "" }}>
              <label for={id}>{TITLES[question.key] ?? sayKey(question.key)}</label>
              <div class="entry">
                <input id={id} value={start.text} placeholder={question.assumed ? shown(question.assumed, system()).text : ""} inputmode="decimal" autocomplete="off" aria-describedby={`${id}-doc`} aria-invalid={mine() !== ""} onInput={(event) => {
                  setTyped(event.currentTarget.value);
                  answer(question.key, event.currentTarget.value, unit);
                }} />
                {/* A unit of one's own stands in the place of the usual one. */}
                <Show when={unit && !/[a-z]/i.test(typed())}>
                  <span class="unit">{unit}</span>
                </Show>
              </div>
              <p class="doc" id={`${id}-doc`}>
                {question.doc}
                {question.assumed ? ` If unknown: ${question.assumed} is assumed.` : ""}
              </p>
              <Show when={mine()}>
                <p class="complaint" role="alert">{mine()}</p>
              </Show>
            </div>
          );
        }}
      </For>
      <Show when={wrong() && !questions()?.some((one) => one.key === wrong()!.key)}>
        <p class="complaint" role="alert">{wrong()!.text}</p>
      </Show>
      <Show when={elsewhere()}>
        <p>
          The bridge has been changed in its form, text or drawing since. <button type="button" class="btn small" onClick={() => void write(props.sheet.survey[0]() ?? {}, "survey anew")}>Write it anew from these numbers</button>
        </p>
      </Show>
    </div>
  );
}
