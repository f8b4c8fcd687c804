/** The bridge as form, as text, and what the reader of the file found: views of one document. */
import { createEffect, createSignal, For, on, onCleanup, onMount, Show, type JSX } from "solid-js";
import { sentences } from "../engine/client";
import type { Card, Finding, Section } from "../engine/types";
import { liveEngine } from "../model/live";
import type { Sheet } from "../model/sheet";
import { isSurvey } from "../model/survey";
import { setPart } from "../model/workspace";
import { plainly } from "../wording";
import { TomlEditor } from "./editor";
import { Drawn } from "./Drawn";
import { Form } from "./Form";
import { Survey } from "./Survey";

let sections: Section[] = [];

type Tab = "survey" | "drawn" | "form" | "text" | "findings";
export const [tab, setTab] = createSignal<Tab>("form");
const [goal, setGoal] = createSignal<{ start: number; end: number } | null>(null);
const MOST_FINDINGS = 200;

/** Opens the text at a place of it. */
export function goToText(place: { start: number; end: number }): void {
  setPart("bridge");
  setTab("text");
  setTimeout(() => setGoal(place), 60);
}

function TextView(props: { sheet: Sheet }): JSX.Element {
  let host!: HTMLDivElement;
  let editor: TomlEditor | null = null;
  onMount(() => {
    editor = new TomlEditor(
      host,
      props.sheet.text(),
      () => sections,
      (text) => props.sheet.change(text, "typing"),
      () => props.sheet.undo(),
      () => props.sheet.redo(),
    );
    if (sections.length === 0) void liveEngine.call<Section[]>("keys").then((found) => (sections = found)).catch(() => undefined);
    createEffect(() => editor?.take(props.sheet.text()));
    createEffect(() => editor?.mark((props.sheet.reading[0]()?.findings ?? []).slice(0, MOST_FINDINGS)));
    createEffect(
      on(goal, (finding) => {
        if (!finding) return;
        editor?.goTo(finding.start, finding.end);
        setGoal(null);
      }),
    );
  });
  onCleanup(() => editor?.destroy());
  return (
    <div class="editor">
      <div ref={host} data-testid="editor" />
    </div>
  );
}

const MARKS = { error: "✕ Error", warning: "▲ Warning", note: "Note" };

function FindingView(props: { finding: Finding }): JSX.Element {
  const [card, setCard] = createSignal<Card | null>(null);
  return (
    <div class="finding">
      <div>
        <span class="mark">{MARKS[props.finding.severity]}</span>{" "}
        <button
          type="button"
          onClick={() => goToText(props.finding)}
        >
          Line {props.finding.line}: {plainly(props.finding.message)}
        </button>
      </div>
      <Show when={props.finding.label}>
        <p>{plainly(props.finding.label)}</p>
      </Show>
      <Show when={props.finding.note}>
        <p class="soft">{plainly(props.finding.note!)}</p>
      </Show>
      <Show when={props.finding.help}>
        <p>{plainly(props.finding.help!)}</p>
      </Show>
      <details onToggle={(event) => {
        if (event.currentTarget.open && !card()) void liveEngine.call<Card | null>("explain", { code: props.finding.code }).then(setCard).catch(() => undefined);
      }}>
        <summary class="soft">What {props.finding.code} means</summary>
        <Show when={card()}>{(one) => <p>{plainly(one().text)}</p>}</Show>
      </details>
    </div>
  );
}

export function BridgePanel(props: { sheet: Sheet }): JSX.Element {
  const findings = () => props.sheet.reading[0]()?.findings ?? [];
  const serious = () => findings().filter((one) => one.severity !== "note").length;
  const tabs = (): [Tab, () => string][] => [
    ...(isSurvey(props.sheet.text()) ? [["survey", () => "Survey"] as [Tab, () => string]] : []),
    ...(props.sheet.reading[0]()?.kind === "blocks" ? [["drawn", () => "Drawing"] as [Tab, () => string]] : []),
    ["form", () => "Form"],
    ["text", () => "Text"],
    ["findings", () => `Findings${serious() > 0 ? ` (${serious()})` : ""}`],
  ];
  const keys = (event: KeyboardEvent): void => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    const list = tabs();
    const at = list.findIndex(([name]) => name === tab());
    const next = list[(at + step + list.length) % list.length]![0];
    setTab(next);
    document.getElementById(`tab-${next}`)?.focus();
  };
  createEffect(() => {
    if (tab() === "survey" && !isSurvey(props.sheet.text())) setTab("form");
    if (tab() === "drawn" && props.sheet.reading[0]() && props.sheet.reading[0]()!.kind !== "blocks") setTab("form");
  });
  return (
    <>
      <div class="panel-tabs" role="tablist" aria-label="Views of the bridge" onKeyDown={keys}>
        <For each={tabs()}>
          {([name, words]) => (
            <button type="button" role="tab" id={`tab-${name}`} aria-selected={tab() === name} aria-controls="panel-view" tabindex={tab() === name ? 0 : -1} onClick={() => setTab(name)}>
              {words()}
            </button>
          )}
        </For>
      </div>
      <div class="panel-body" classList={{ flush: tab() === "text" }} role="tabpanel" id="panel-view" aria-labelledby={`tab-${tab()}`} tabindex="-1">
        <Show when={props.sheet.trouble[0]()}>
          {(trouble) => (
            <p class="complaint" role="alert">
              {sentences(trouble())}
            </p>
          )}
        </Show>
        <Show when={tab() === "survey" && isSurvey(props.sheet.text()) ? props.sheet : null} keyed>
          {(sheet) => <Survey sheet={sheet} />}
        </Show>
        <Show when={tab() === "drawn"}>
          <Drawn sheet={props.sheet} />
        </Show>
        <Show when={tab() === "form"}>
          <Form sheet={props.sheet} />
        </Show>
        <Show when={tab() === "text" ? props.sheet.id : null} keyed>
          {(_id) => <TextView sheet={props.sheet} />}
        </Show>
        <Show when={tab() === "findings"}>
          <Show when={findings().length > MOST_FINDINGS}><p>The first {MOST_FINDINGS} of {findings().length}.</p></Show>
          <For each={findings().slice(0, MOST_FINDINGS)} fallback={<p>The reader of the file found nothing to remark.</p>}>
            {(finding) => <FindingView finding={finding} />}
          </For>
        </Show>
      </div>
    </>
  );
}
