/** The numbers of a survey: the file is written anew with every number that is typed. */
import { createSignal, For, onMount, Show, type JSX } from "solid-js";
import type { Question } from "../engine/types";
import { questions } from "../model/library";
import type { Sheet } from "../model/sheet";
import { isElsewhere, spansOf, titleOf, write, type Answers, type Wrong } from "../model/survey";
import { system } from "../shell/settings";
import { meant, shown } from "../units";
import { typeset } from "../wording";
import { Judge } from "./Judge";

type Give = (key: string, typed: string, unit: string) => void;
type Asked = { answers: Answers; wrong: (key: string) => Wrong | undefined; give: Give };

export function Survey(props: { sheet: Sheet }): JSX.Element {
  const [wrong, setWrong] = createSignal<Wrong[]>([]);
  const answers = (): Answers => props.sheet.survey[0]() ?? {};
  const put = async (now: Answers, mark: string): Promise<void> => {
    const found = await write(props.sheet, now, mark);
    if (found === undefined) return;
    setWrong(found);
    props.sheet.refuse("survey", found.some((one) => !one.doubtful));
  };
  // What stood refused when the page was left still is.
  onMount(() => !isElsewhere(props.sheet) && Object.keys(answers()).length > 0 && void put(answers(), "survey"));
  const take = (now: Answers, mark: string): void => {
    const held = isElsewhere(props.sheet);
    props.sheet.survey[1](now);
    if (!held) void put(now, mark);
  };
  const give: Give = (key, typed, unit) => {
    const now = { ...answers() };
    if (typed.trim() === "") delete now[key];
    else now[key] = meant(typed, unit);
    take(now, `survey ${key}`);
  };
  const asked: Asked = {
    give,
    get answers() {
      return answers();
    },
    wrong: (key) => wrong().find((one) => one.key === key),
  };
  // Those of a span come first, then the spans and piers beside it, then what all of them share.
  const ofSpan = (): Question[] => questions()?.ten.slice(0, 3) ?? [];
  const many = (): boolean => spansOf(answers()) > 1;
  const placed = (key: string): boolean => document.getElementById(`q-${key}`) !== null;
  return (
    <div>
      <p class="soft">Measured on site or taken off an old drawing. The bridge follows while you type; what is left empty is assumed, and the file says so.</p>
      <Show when={questions()?.spans}>{(question) => <Answer question={question()} asked={asked} title={titleOf("spans")} />}</Show>
      <For each={ofSpan()}>{(question) => <Answer question={question} asked={asked} title={titleOf(question.key)} />}</For>
      <Show when={many()}>
        <For each={questions()?.pier}>{(question) => <Answer question={question} asked={asked} title={titleOf(question.key)} />}</For>
        <Others questions={ofSpan()} count={spansOf(answers())} asked={asked} title="Other spans" each="Span" heads={["Span", "Rise", "Ring"]} />
        <Show when={spansOf(answers()) > 2}>
          <Others questions={questions()?.pier ?? []} count={spansOf(answers()) - 1} asked={asked} title="Other piers" each="Pier" heads={["Width", "Height"]} />
        </Show>
      </Show>
      <For each={questions()?.ten.slice(3)}>{(question) => <Answer question={question} asked={asked} title={titleOf(question.key)} />}</For>
      <h2 class="spaced">The verdict</h2>
      <p class="soft">A bridge is adequate or not by a rule and for vehicles. Without them “Verdict” ends undetermined.</p>
      <Judge
        id="survey-judge"
        start={{ rule: answers()["rule"] ?? "", vehicles: answers()["vehicles"] ?? "" }}
        change={(judged) => {
          const { rule: _rule, vehicles: _vehicles, ...rest } = answers();
          take({ ...rest, ...(judged ?? {}) }, "survey judged");
        }}
      />
      <For each={wrong().filter((one) => !placed(one.key))}>{(one) => <p class="complaint" role="alert">{one.text}</p>}</For>
      <Show when={isElsewhere(props.sheet)}>
        <p>
          The bridge has been changed in its form, text or drawing since. <button type="button" class="btn small" onClick={() => void put(answers(), "survey anew")}>Write it anew from these numbers</button>
        </p>
      </Show>
    </div>
  );
}

function Answer(props: { question: Question; asked: Asked; title: string }): JSX.Element {
  const { question } = props;
  const start = shown(props.asked.answers[question.key] ?? "", system());
  const unit = shown(question.example, system()).unit;
  const id = `q-${question.key}`;
  const [typed, setTyped] = createSignal(start.text);
  const mine = () => props.asked.wrong(question.key);
  const refused = () => mine() !== undefined && !mine()!.doubtful;
  return (
    <div class="field" classList={{ wrong: refused() }}>
      <label for={id}>{props.title}</label>
      <div class="entry">
        <input id={id} value={start.text} placeholder={question.assumed ? shown(question.assumed, system()).text : ""} inputmode="decimal" autocomplete="off" aria-describedby={mine() ? `${id}-doc ${id}-wrong` : `${id}-doc`} aria-invalid={refused()} onInput={(event) => {
          setTyped(event.currentTarget.value);
          props.asked.give(question.key, event.currentTarget.value, unit);
        }} />
        {/* A unit of one's own stands in the place of the usual one. */}
        <Show when={unit && !/[a-z]/i.test(typed())}>
          <span class="unit">{typeset(unit)}</span>
        </Show>
      </div>
      <p class="doc" id={`${id}-doc`}>
        {question.doc}
        {question.assumed && unit ? ` If unknown: ${typeset(question.assumed)} is assumed.` : ""}
      </p>
      <Show when={mine()}>{(one) => <Complaint id={`${id}-wrong`} wrong={one()} />}</Show>
    </div>
  );
}

/** What is wrong with an answer, or doubtful. */
function Complaint(props: { id: string; wrong: Wrong }): JSX.Element {
  return (
    <p class="complaint" classList={{ doubt: props.wrong.doubtful === true }} id={props.id} role={props.wrong.doubtful ? "status" : "alert"}>
      {props.wrong.text}
    </p>
  );
}

/** The spans or piers after the first: what is left empty is taken from the first, and assumed. */
function Others(props: { questions: Question[]; count: number; asked: Asked; title: string; each: string; heads: string[] }): JSX.Element {
  const rows = () => Array.from({ length: props.count - 1 }, (_, k) => k + 2);
  const unit = () => shown(props.questions[0]?.example ?? "", system()).unit;
  const keys = () => rows().flatMap((k) => props.questions.map((question) => `${question.key}_${k}`));
  const wrong = () => keys().flatMap((key) => props.asked.wrong(key) ?? []);
  const refused = (key: string) => wrong().some((one) => one.key === key && !one.doubtful);
  return (
    <div class="others">
      <table class="plain">
        <caption>{props.title}, {unit()}. Left empty: assumed as the first.</caption>
        <thead>
          <tr>
            <th scope="col"><span class="unseen">{props.each}</span></th>
            <For each={props.heads}>{(head) => <th scope="col" class="right">{head}</th>}</For>
          </tr>
        </thead>
        <tbody>
          <For each={rows()}>
            {(k) => (
              <tr>
                <th scope="row">{props.each} {k}</th>
                <For each={props.questions}>
                  {(question) => {
                    const key = `${question.key}_${k}`;
                    const first = () => shown(props.asked.answers[question.key] ?? "", system()).text;
                    return (
                      <td classList={{ wrong: refused(key) }}>
                        <div class="entry">
                          <input id={`q-${key}`} aria-label={titleOf(key)} value={shown(props.asked.answers[key] ?? "", system()).text} placeholder={first()} inputmode="decimal" autocomplete="off" aria-invalid={refused(key)} aria-describedby={wrong().some((one) => one.key === key) ? `q-${key}-wrong` : undefined}
                            onInput={(event) => props.asked.give(key, event.currentTarget.value, unit())} />
                        </div>
                      </td>
                    );
                  }}
                </For>
              </tr>
            )}
          </For>
        </tbody>
      </table>
      <For each={wrong()}>{(one) => <Complaint id={`q-${one.key}-wrong`} wrong={{ ...one, text: `${titleOf(one.key)}: ${one.text}` }} />}</For>
    </div>
  );
}
