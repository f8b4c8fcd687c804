/** The numbers of a survey: what the file says stands in the fields, and what is typed goes into the file. */
import { createEffect, createMemo, createSignal, For, on, onMount, Show, type JSX } from "solid-js";
import type { Question } from "../engine/types";
import { materials, questions } from "../model/library";
import { rowsOf, type Rows } from "../model/rows";
import type { Sheet } from "../model/sheet";
import { answersOf, give as giveTo, spansOf, titleOf, wrongOf, type Answers, type Wrong } from "../model/survey";
import { system } from "../shell/settings";
import { also, choices, entry, inSystem, meant, restated, rangeOf } from "../units";
import { typeset } from "../wording";
import { Judge } from "./Judge";

type Give = (key: string, typed: string, unit: string) => void;
type Asked = { answers: Answers; wrong: (key: string) => Wrong | undefined; give: Give; elsewhere: () => number; open: (key: string) => boolean };

/** The unit in which a field takes a bare number at first. */
const unitOf = (question: Question | undefined): string => choices(question?.unit ?? "", system())[0] ?? "";
const WORDS = ["name", "reference", "condition", "fill"];
/** Numbers that every span or pier may have, by the number behind their key. */
const ofMany = (key: string): boolean => /_\d+$/.test(key) || key.startsWith("pier_");
/** What was answered of further spans and piers: it is there again where these are. */
const remembered = new WeakMap<Sheet, Answers>();

export function Survey(props: { sheet: Sheet }): JSX.Element {
  const answers = createMemo(() => answersOf(props.sheet));
  const wrong = createMemo(() => wrongOf(props.sheet));
  createEffect(() => {
    const own = Object.entries(answers()).filter(([key]) => ofMany(key));
    if (own.length > 0) remembered.set(props.sheet, { ...remembered.get(props.sheet), ...Object.fromEntries(own) });
  });
  // What stood refused when the page was left still is.
  onMount(() => Object.keys(props.sheet.drafts[0]()).length > 0 && void giveTo(props.sheet, {}, "survey"));
  const known = (): Question[] => [...(questions()?.ten ?? []), ...(questions()?.pier ?? []), ...(questions()?.more ?? [])];
  const ofKey = (key: string): Question | undefined => known().find((one) => one.key === key) ?? known().find((one) => one.key === key.replace(/_\d+$/, ""));
  // In feet and pounds all answers are what their fields show, so that the file is in one system.
  const inOne = (changes: Answers): Answers => {
    if (system() === "metric") return changes;
    const others = Object.entries(answers()).map(([key, written]) => [key, WORDS.includes(key) ? written : restated(written, ofKey(key)?.unit ?? "", system())] as const);
    return { ...Object.fromEntries(others.filter(([key, written]) => written !== answers()[key])), ...changes };
  };
  const take = (changes: Answers, mark: string): void => {
    const spans = Number(changes["spans"]);
    const again = Object.entries(spans > 1 ? (remembered.get(props.sheet) ?? {}) : {}).filter(([key]) => answers()[key] === undefined && Number(/_(\d+)$/.exec(key)?.[1] ?? 1) <= spans);
    void giveTo(props.sheet, inOne({ ...Object.fromEntries(again), ...changes }), mark);
  };
  const give: Give = (key, typed, unit) => take({ [key]: WORDS.includes(key) ? typed.trim() : meant(typed, unit) }, `survey ${key}`);
  const asked: Asked = {
    give,
    get answers() {
      return answers();
    },
    wrong: (key) => wrong().find((one) => one.key === key),
    elsewhere: props.sheet.elsewhere[0],
    open: (key) => answers()[key] === undefined,
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
      take(found.answers, "survey rows");
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
  const ofSpan = (): Question[] => questions()?.ten.slice(0, 3) ?? [];
  const some = (...keys: string[]): Question[] => keys.flatMap((key) => ofKey(key) ?? []);
  const many = (): boolean => spansOf(answers()) > 1;
  const rings = (): boolean => Number(answers()["rings"] ?? 1) > 1;
  const placed = (key: string): boolean => document.getElementById(`q-${key}`) !== null;
  const laid = createMemo(() => `${system()} ${filled()}`);
  const judged = () => `${answers()["rule"] ?? ""}|${(answers()["vehicles"] ?? "").replace(/\s/g, "")}`;
  // The boxes are made anew where the file has other vehicles than were ticked here.
  let ticked = "";
  const [judge, setJudge] = createSignal("start");
  createEffect(on([judged, props.sheet.elsewhere[0]], ([now]) => now !== ticked && setJudge((ticked = now)), { defer: true }));
  const List = (list: { of: Question[] }): JSX.Element => <For each={list.of}>{(question) => <Answer question={question} asked={asked} title={titleOf(question.key)} />}</For>;
  return (
    <div onPaste={pasted}>
      <p class="soft">Measured on site or taken off an old drawing. The bridge follows while you type. What nobody has answered is marked as assumed here and in the file.</p>
      <div ref={told} tabindex="-1" role="status" class="told">
        <Show when={rows()}>{(one) => <Told rows={one()} />}</Show>
      </div>
      <Show when={laid()} keyed>
        {(_laid) => (
          <>
            <Text key="name" asked={asked} doc="It stands over the drawing, on the report and in the file." most={80} />
            <Text key="reference" asked={asked} doc={docOf("reference")} most={80} />
            <h2 class="spaced">Spans and rings</h2>
            <List of={questions() ? [questions()!.spans] : []} />
            <List of={ofSpan()} />
            <Show when={many()}>
              <List of={questions()?.pier ?? []} />
              <Others questions={ofSpan()} count={spansOf(answers())} asked={asked} title="Other spans" each="Span" heads={["Span", "Rise", "Ring"]} />
              <Show when={spansOf(answers()) > 2}>
                <Others questions={questions()?.pier ?? []} count={spansOf(answers()) - 1} asked={asked} title="Other piers" each="Pier" heads={["Width", "Height"]} />
              </Show>
            </Show>
            <List of={some("rings")} />
            <Show when={rings()}><List of={some("bond")} /></Show>
            <List of={some("skew")} />
            <h2 class="spaced">Road and fill</h2>
            <List of={some("width", "cover")} />
            <Fill asked={asked} />
            <List of={some("fill_density", "backing")} />
            <h2 class="spaced">Masonry</h2>
            <List of={some("unit", "density", "strength")} />
            <h2 class="spaced">Condition</h2>
            <List of={some("lost_mortar")} />
            <Text key="condition" asked={asked} doc={docOf("condition")} most={400} />
            <h2 class="spaced">Load</h2>
            <List of={some("axle")} />
          </>
        )}
      </Show>
      <PasteRows fill={fill} />
      <h2 class="spaced">The verdict</h2>
      <p class="soft">A bridge is adequate or not by a rule and for vehicles. Without them “Verdict” ends undetermined.</p>
      <Show when={judge()} keyed>
        {(_judge) => (
          <Judge
            id="survey-judge"
            start={{ rule: answers()["rule"] ?? "", vehicles: answers()["vehicles"] ?? "" }}
            change={(now) => {
              const { rule, vehicles } = now ?? { rule: "", vehicles: "" };
              ticked = `${rule}|${vehicles.replace(/\s/g, "")}`;
              take({ rule, vehicles }, "survey judged");
            }}
          />
        )}
      </Show>
      <For each={wrong().filter((one) => !placed(one.key))}>{(one) => <p class="complaint" role="alert">{one.text}</p>}</For>
    </div>
  );
}

const docOf = (key: string): string => questions()?.words.find(([known]) => known === key)?.[1] ?? "";

/** What an input shows follows the file: at once where something else wrote it, and otherwise where nobody types in it. */
function follow(input: () => HTMLElement, answer: () => string, asked: Asked, given: () => string | null, show: (answer: string) => void): void {
  let seen = asked.elsewhere();
  createEffect(
    on([answer, asked.elsewhere], ([now, count]) => {
      const outside = count !== seen;
      seen = count;
      if (outside || (now !== given() && document.activeElement !== input())) show(now);
    }, { defer: true }),
  );
}

/** An answer in words. */
function Text(props: { key: string; asked: Asked; doc: string; most: number }): JSX.Element {
  let input!: HTMLInputElement;
  let given: string | null = null;
  const answer = () => props.asked.answers[props.key] ?? "";
  follow(() => input, answer, props.asked, () => given, (now) => {
    given = null;
    input.value = now;
  });
  return (
    <div class="field wide">
      <label for={`q-${props.key}`}>{titleOf(props.key)}</label>
      <div class="entry">
        <input ref={input} id={`q-${props.key}`} class="text" value={answer()} maxlength={props.most} autocomplete="off" aria-describedby={`q-${props.key}-doc`} onInput={(event) => {
          given = event.currentTarget.value.trim();
          props.asked.give(props.key, event.currentTarget.value, "");
        }} />
      </div>
      <p class="doc" id={`q-${props.key}-doc`}>{props.doc}</p>
    </div>
  );
}

/** The fill as a material of the library. */
function Fill(props: { asked: Asked }): JSX.Element {
  const fills = () => (materials() ?? []).filter((one) => one.tables.includes("cover"));
  return (
    <div class="field wide">
      <div><label for="q-fill">{titleOf("fill")}</label><Show when={props.asked.open("fill")}><Assumed /></Show></div>
      <select id="q-fill" aria-describedby="q-fill-doc" onChange={(event) => props.asked.give("fill", event.currentTarget.value, "")}>
        <option value="" selected={props.asked.open("fill")}>not known</option>
        <For each={fills()}>
          {(one) => <option value={one.code} selected={props.asked.answers["fill"] === one.code}>{one.title}, {typeset(inSystem(one.values.find((value) => value.key === "density")?.usual ?? "", system()))}</option>}
        </For>
      </select>
      <p class="doc" id="q-fill-doc">{docOf("fill")}</p>
    </div>
  );
}

/** Marks a field whose value nobody gave. */
const Assumed = (): JSX.Element => <span class="assumed">assumed</span>;

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

/** What is usual of an answer, in words. */
const usualOf = (question: Question): string => (question.usual === "" ? "" : `Usually ${inSystem(question.usual, system())}.`);

/** What the materials of the library have of densities and strengths. */
function ofLibrary(question: Question): string {
  const key = question.key === "strength" ? "compressive_strength" : question.key;
  const values = (materials() ?? []).filter((one) => one.tables.includes("masonry")).flatMap((one) => one.values.filter((value) => value.key === key).map((value) => ({ title: one.title, value })));
  if (!["density", "strength"].includes(question.key) || values.length === 0) return "";
  const between = (least: string, most: string): string => {
    const [low, unit] = least.split(/ (.*)/s);
    return inSystem(most.endsWith(` ${unit}`) ? `${low} to ${most}` : `${least} to ${most}`, system());
  };
  return `Of the library: ${values.map(({ title, value }) => `${title.replace(/^[A-Z](?=[a-z])/, (c) => c.toLowerCase())} ${between(value.least, value.most)}`).join("; ")}.`;
}

function Answer(props: { question: Question; asked: Asked; title: string }): JSX.Element {
  const { question } = props;
  let input!: HTMLInputElement;
  const answer = () => props.asked.answers[question.key] ?? "";
  const start = entry(answer(), question.unit, system());
  const usual = unitOf(question);
  const [unit, setUnit] = createSignal(start.unit);
  const id = `q-${question.key}`;
  const [typed, setTyped] = createSignal(start.text);
  let given: string | null = null;
  const show = (now: string): void => {
    given = null;
    const shown = entry(now, question.unit, system());
    setUnit(shown.unit);
    setTyped(shown.text);
    input.value = typeset(shown.text);
  };
  follow(() => input, answer, props.asked, () => given, show);
  const put = (text: string): void => {
    given = text.trim() === "" ? "" : meant(text, unit());
    props.asked.give(question.key, text, unit());
  };
  const mine = () => props.asked.wrong(question.key);
  const refused = () => mine() !== undefined && !mine()!.doubtful;
  const same = () => (system() === "metric" ? also(answer()) : "");
  // Of a pier nothing is assumed, and what somebody took out of its field waits for a number.
  const stands = question.assumed || (question.key.startsWith("pier") || question.key === "skew" ? "" : question.example);
  const assumed = () => stands !== "" && props.asked.open(question.key);
  const range = () => [usualOf(question), rangeOf(question.usual, props.asked.answers["span"] ?? "", unit())].filter((words) => words !== "").join(" ");
  return (
    <div class="field" classList={{ wrong: refused(), guess: assumed() }}>
      <label for={id}>{props.title}</label>
      <div class="entry">
        <Show when={assumed()}><Assumed /></Show>
        <input ref={input} id={id} value={typeset(start.text)} placeholder={stands && unit() === usual ? entry(inSystem(stands, system()), question.unit, system()).text : ""} inputmode="decimal" autocomplete="off" aria-describedby={`${id}-range ${mine() ? `${id}-doc ${id}-wrong` : `${id}-doc`}`} aria-invalid={refused()} onInput={(event) => {
          setTyped(event.currentTarget.value);
          put(event.currentTarget.value);
        }} onBlur={() => given !== null && answer() !== given && show(answer())} />
        {/* A unit of one's own stands in the place of the usual one. */}
        <Show when={unit() && !/[a-z'′"″]/i.test(typed())}>
          <select class="unit" aria-label={`Unit: ${props.title}`} onChange={(event) => {
            setUnit(event.currentTarget.value);
            if (typed().trim() !== "") put(typed());
          }}>
            <For each={choices(question.unit, system())}>{(one) => <option value={one} selected={unit() === one}>{typeset(one)}</option>}</For>
          </select>
        </Show>
      </div>
      <Show when={range()}>{(words) => <p class="range" id={`${id}-range`}>{typeset(words())}</p>}</Show>
      <p class="doc" id={`${id}-doc`}>
        {question.doc} {typeset(ofLibrary(question))}
        {question.key === "skew" ? " Not given: the bridge is taken as square, and the verdict says so." : ""}
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
                    let input!: HTMLInputElement;
                    let given: string | null = null;
                    const answer = () => props.asked.answers[key] ?? "";
                    follow(() => input, answer, props.asked, () => given, (now) => {
                      given = null;
                      input.value = text(question, now);
                    });
                    const first = () => text(question, props.asked.answers[question.key] ?? "");
                    return (
                      <td classList={{ wrong: refused(key) }}>
                        <div class="entry">
                          <input ref={input} id={`q-${key}`} aria-label={titleOf(key)} value={text(question, answer())} placeholder={first()} inputmode="decimal" autocomplete="off" aria-invalid={refused(key)} aria-describedby={wrong().some((one) => one.key === key) ? `q-${key}-wrong` : undefined}
                            onInput={(event) => {
                              given = event.currentTarget.value.trim() === "" ? "" : meant(event.currentTarget.value, unit());
                              props.asked.give(key, event.currentTarget.value, unit());
                            }} />
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
