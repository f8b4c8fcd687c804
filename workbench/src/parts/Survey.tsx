/** The numbers of a survey: the file is written anew with every number that is typed. */
import { createMemo, createSignal, For, onMount, Show, type JSX } from "solid-js";
import type { Question } from "../engine/types";
import { materials, questions } from "../model/library";
import { rowsOf, type Rows } from "../model/rows";
import type { Sheet } from "../model/sheet";
import { isElsewhere, spansOf, titleOf, write, type Answers, type Wrong } from "../model/survey";
import { system } from "../shell/settings";
import { also, choices, entry, inSystem, meant, restated } from "../units";
import { typeset } from "../wording";
import { Judge } from "./Judge";

type Give = (key: string, typed: string, unit: string) => void;
type Asked = { answers: Answers; wrong: (key: string) => Wrong | undefined; give: Give };

/** The unit in which a field takes a bare number at first. */
const unitOf = (question: Question | undefined): string => choices(question?.unit ?? "", system())[0] ?? "";

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
  const known = (): Question[] => [...(questions()?.ten ?? []), ...(questions()?.pier ?? [])];
  const ofKey = (key: string): Question | undefined => known().find((one) => one.key === key.replace(/_\d+$/, ""));
  // In feet and pounds all answers are what their fields show, so that the file is in one system.
  const inOne = (all: Answers): Answers =>
    system() === "metric" ? { ...all } : Object.fromEntries(Object.entries(all).map(([key, written]) => [key, restated(written, ofKey(key)?.unit ?? "", system())]));
  const give: Give = (key, typed, unit) => {
    const now = inOne(answers());
    if (typed.trim() === "") delete now[key];
    else now[key] = key === "name" ? typed.trim() : meant(typed, unit);
    take(now, `survey ${key}`);
  };
  const asked: Asked = {
    give,
    get answers() {
      return answers();
    },
    wrong: (key) => wrong().find((one) => one.key === key),
  };
  // Rows of a table fill fields; these are made anew then, and where the units change.
  const [filled, setFilled] = createSignal(0);
  const [rows, setRows] = createSignal<(Rows & { units: string }) | null>(null);
  let told!: HTMLDivElement;
  const fill = (text: string): boolean => {
    const found = rowsOf(text, (key) => unitOf(ofKey(key)));
    if (Object.keys(found.answers).length === 0 && found.left.length === 0) return false;
    setRows({ ...found, units: system() });
    if (Object.keys(found.answers).length > 0) {
      take(inOne({ ...answers(), ...found.answers }), "survey rows");
      setFilled((count) => count + 1);
    }
    queueMicrotask(() => told.focus());
    return true;
  };
  const pasted = (event: ClipboardEvent): void => {
    const text = (event.clipboardData?.getData("text/plain") ?? "").trim();
    // One value goes into its field as ever.
    if (/[\t\n\r]/.test(text) && fill(text)) event.preventDefault();
  };
  // Those of a span come first, then the spans and piers beside it, then what all of them share.
  const ofSpan = (): Question[] => questions()?.ten.slice(0, 3) ?? [];
  const many = (): boolean => spansOf(answers()) > 1;
  const placed = (key: string): boolean => document.getElementById(`q-${key}`) !== null;
  const laid = createMemo(() => `${system()} ${filled()}`);
  return (
    <div onPaste={pasted}>
      <p class="soft">Measured on site or taken off an old drawing. The bridge follows while you type; what is left empty is assumed, and the file says so.</p>
      <div ref={told} tabindex="-1" role="status" class="told">
        <Show when={rows()}>{(one) => <Told rows={one()} />}</Show>
      </div>
      <Show when={laid()} keyed>
        {(_laid) => (
          <>
            <div class="field wide">
              <label for="q-name">{titleOf("name")}</label>
              <div class="entry">
                <input id="q-name" class="text" value={answers()["name"] ?? ""} maxlength="80" autocomplete="off" aria-describedby="q-name-doc" onInput={(event) => give("name", event.currentTarget.value, "")} />
              </div>
              <p class="doc" id="q-name-doc">It stands over the drawing, on the report and in the file.</p>
            </div>
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
          </>
        )}
      </Show>
      <PasteRows fill={fill} />
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

/** What became of the rows of a table. */
function Told(props: { rows: Rows & { units: string } }): JSX.Element {
  const keys = () => Object.keys(props.rows.answers);
  const count = (n: number): string => (n === 1 ? "1 row" : `${n} rows`);
  return (
    <>
      <Show when={keys().length > 0} fallback={<p>No row was understood: nothing is changed.</p>}>
        <p>{count(keys().length)} taken: {keys().map((key) => `${titleOf(key)} ${typeset(props.rows.answers[key]!)}`).join("; ")}.</p>
      </Show>
      <Show when={props.rows.left.length > 0}>
        <p>Not understood:</p>
        <ul>
          <For each={props.rows.left}>{(one) => <li>row {one.row}, “{one.text}”: {one.why}</li>}</For>
        </ul>
      </Show>
    </>
  );
}

/** A place for rows where a field is no place, and for who does not know that they may be pasted anywhere here. */
function PasteRows(props: { fill: (text: string) => boolean }): JSX.Element {
  const [text, setText] = createSignal("");
  return (
    <details class="library">
      <summary>Paste rows from a spreadsheet</summary>
      <p class="soft">Two columns, name and value, such as “Clear span” and “6.00 m”; a third may hold the unit. Without a unit a number has that of its field.</p>
      <textarea class="rows" aria-label="Rows of a spreadsheet" rows="4" spellcheck={false} value={text()} onInput={(event) => setText(event.currentTarget.value)} />
      <button type="button" class="btn small" disabled={text().trim() === ""} onClick={() => props.fill(text()) && setText("")}>Fill in the fields</button>
    </details>
  );
}

/** What is usual of an answer, in words; of densities and strengths the materials of the library as well. */
function usualOf(question: Question): string {
  const usual = question.usual === "" ? "" : `Usually ${inSystem(question.usual, system())}.`;
  const key = question.key === "strength" ? "compressive_strength" : question.key;
  const values = (materials() ?? []).filter((one) => one.tables.includes("masonry")).flatMap((one) => one.values.filter((value) => value.key === key).map((value) => ({ title: one.title, value })));
  if (!["density", "strength"].includes(question.key) || values.length === 0) return usual;
  const between = (least: string, most: string): string => {
    const [low, unit] = least.split(/ (.*)/s);
    return inSystem(most.endsWith(` ${unit}`) ? `${low} to ${most}` : `${least} to ${most}`, system());
  };
  return `${usual} Of the library: ${values.map(({ title, value }) => `${title.replace(/^[A-Z](?=[a-z])/, (c) => c.toLowerCase())} ${between(value.least, value.most)}`).join("; ")}.`;
}

function Answer(props: { question: Question; asked: Asked; title: string }): JSX.Element {
  const { question } = props;
  const start = entry(props.asked.answers[question.key] ?? "", question.unit, system());
  const usual = unitOf(question);
  const [unit, setUnit] = createSignal(start.unit);
  const id = `q-${question.key}`;
  const [typed, setTyped] = createSignal(start.text);
  const mine = () => props.asked.wrong(question.key);
  const refused = () => mine() !== undefined && !mine()!.doubtful;
  const same = () => (system() === "metric" ? also(props.asked.answers[question.key] ?? "") : "");
  return (
    <div class="field" classList={{ wrong: refused() }}>
      <label for={id}>{props.title}</label>
      <div class="entry">
        <input id={id} value={typeset(start.text)} placeholder={question.assumed && unit() === usual ? entry(inSystem(question.assumed, system()), question.unit, system()).text : ""} inputmode="decimal" autocomplete="off" aria-describedby={mine() ? `${id}-doc ${id}-wrong` : `${id}-doc`} aria-invalid={refused()} onInput={(event) => {
          setTyped(event.currentTarget.value);
          props.asked.give(question.key, event.currentTarget.value, unit());
        }} />
        {/* A unit of one's own stands in the place of the usual one. */}
        <Show when={unit() && !/[a-z'′"″]/i.test(typed())}>
          <select class="unit" aria-label={`Unit: ${props.title}`} onChange={(event) => {
            setUnit(event.currentTarget.value);
            if (typed().trim() !== "") props.asked.give(question.key, typed(), unit());
          }}>
            <For each={choices(question.unit, system())}>{(one) => <option value={one} selected={unit() === one}>{typeset(one)}</option>}</For>
          </select>
        </Show>
      </div>
      <p class="doc" id={`${id}-doc`}>
        {question.doc} {typeset(usualOf(question))}
        {question.assumed && usual ? ` If unknown: ${typeset(inSystem(question.assumed, system()))} is assumed.` : ""}
      </p>
      <Show when={same()}>{(words) => <p class="doc">{typeset(words())}.</p>}</Show>
      <Show when={mine()}>{(one) => <Complaint id={`${id}-wrong`} wrong={one()} />}</Show>
    </div>
  );
}

/** What is wrong with an answer, or doubtful. */
function Complaint(props: { id: string; wrong: Wrong }): JSX.Element {
  return (
    <p class="complaint" classList={{ doubt: props.wrong.doubtful === true }} id={props.id} role={props.wrong.doubtful ? "status" : "alert"}>
      {typeset(inSystem(props.wrong.text, system()))}
    </p>
  );
}

/** The spans or piers after the first: what is left empty is taken from the first, and assumed. */
function Others(props: { questions: Question[]; count: number; asked: Asked; title: string; each: string; heads: string[] }): JSX.Element {
  const rows = () => Array.from({ length: props.count - 1 }, (_, k) => k + 2);
  const unit = () => unitOf(props.questions[0]);
  const text = (question: Question, answer: string): string => {
    const found = entry(answer, question.unit, system());
    return found.unit === unit() || /[a-z'"]/i.test(found.text) ? found.text : `${found.text}${found.text === "" ? "" : ` ${found.unit}`}`;
  };
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
                    const first = () => text(question, props.asked.answers[question.key] ?? "");
                    return (
                      <td classList={{ wrong: refused(key) }}>
                        <div class="entry">
                          <input id={`q-${key}`} aria-label={titleOf(key)} value={text(question, props.asked.answers[key] ?? "")} placeholder={first()} inputmode="decimal" autocomplete="off" aria-invalid={refused(key)} aria-describedby={wrong().some((one) => one.key === key) ? `q-${key}-wrong` : undefined}
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
