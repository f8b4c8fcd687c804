/** The title block: what is carried and by which load, how it was found, and what was assumed, side by side. */
import { createEffect, createMemo, createSignal, For, on, onCleanup, Show, type JSX } from "solid-js";
import { sentences } from "../engine/client";
import type { Finding } from "../engine/types";
import { assumedIn } from "../model/assumed";
import { overItsWidth } from "../model/carried";
import type { Sheet } from "../model/sheet";
import { sought } from "../model/structure";
import { titleOf } from "../model/survey";
import { part, setPart } from "../model/workspace";
import { goToText } from "../parts/BridgePanel";
import { figures, inSystem, lineLoad, place, words, type System } from "../units";
import { plainly, typeset } from "../wording";
import { system } from "./settings";

/** Whether the load is the file's own, whose size is sought, or a vehicle with a size of its own. */
export function isVehicle(sheet: Sheet): boolean {
  return sheet.vehicle[0]() !== "";
}

/** Load per metre [N/m] for a factor: the answer's own load over its own factor. */
export function perFactor(sheet: Sheet): number | null {
  const found = sheet.answer[0]()?.words;
  return found && found.load !== null && found.factor ? found.load / found.factor : null;
}

export function sayFactor(sheet: Sheet, factor: number, units: System): string {
  const per = perFactor(sheet);
  if (!isVehicle(sheet) && per !== null) return words(lineLoad(factor * per, units));
  return `factor ${figures(factor, 3)}`;
}

/** Findings that stand in the title block; more are told by their number. */
const MOST_NOTES = 20;

type Note = { kind: "err" | "warn" | ""; text: string; finding?: Finding };

const STATUS: Record<string, string> = {
  collapsed: "mechanism found",
  locks: "no load at this place makes a mechanism",
  "not-converged": "no reliable answer at this place",
  "unstable-under-self-weight": "does not stand under its own weight",
};

export function TitleBlock(props: { sheet: Sheet; extra?: JSX.Element }): JSX.Element {
  const answer = () => props.sheet.answer[0]();
  const about = () => props.sheet.about[0]();
  const reading = () => props.sheet.reading[0]();
  /** Whether the answer is of values before those that were typed last, which are refused. */
  const old = () => answer() !== null && props.sheet.isOld();

  /** What the file's plan seeks in place of a load, where it has none. */
  const elsewhere = createMemo(() => {
    const seeks = sought(props.sheet.text());
    return (reading()?.sections?.loads ?? 0) > 0 || isVehicle(props.sheet) ? "" : seeks === "thickness" ? "the least thickness of its rings" : seeks === "support-movement" ? "the movement of a support" : "";
  });
  /** Which field holds what is refused. */
  const refusedIn = (): string => {
    const answers = (props.sheet.refusedAnswers[0]() ?? []).filter((one) => !one.doubtful).map((one) => titleOf(one.key));
    return answers.length > 0 ? `what was typed as ${[...new Set(answers)].join(", ")} is refused` : "what was typed last is refused";
  };
  const headline = createMemo(() => {
    if (about()?.stands === false) return { value: "Does not stand", unit: "", whole: "under its own weight" };
    const found = answer()?.words;
    if (!found) return null;
    if (found.factor === null) return { value: "–", unit: "", whole: "" };
    if (!isVehicle(props.sheet) && found.load !== null) {
      const said = lineLoad(found.load, system());
      return { ...said, whole: overItsWidth(props.sheet, found.load, system()) };
    }
    return { value: figures(found.factor, 3), unit: "× the vehicle", whole: "adequacy factor" };
  });
  const how = createMemo(() => {
    const found = answer()?.words;
    if (!found) return "";
    const parts = [STATUS[found.status] ?? found.status];
    if (found.hinges.length > 0) parts.push(`${found.hinges.length} hinges`);
    if (found.sliding.length > 0) parts.push(`${found.sliding.length} joints slide`);
    return parts.join(", ");
  });
  const least = createMemo(() => {
    const curve = props.sheet.envelope[0]();
    if (!curve) return null;
    let at = -1;
    let done = 0;
    for (let k = 0; k < curve.xs.length; k += 1) {
      if (!curve.known[k]) continue;
      done += 1;
      if (Number.isFinite(curve.factors[k]!) && (at < 0 || curve.factors[k]! < curve.factors[at]!)) at = k;
    }
    return at < 0 ? null : { x: curve.xs[at]!, factor: curve.factors[at]!, done, of: curve.xs.length };
  });
  const findings = () => (reading()?.findings ?? []).filter((one) => one.severity !== "note");
  const warnings = createMemo<Note[]>(() => {
    const list: Note[] = [];
    const trouble = props.sheet.trouble[0]() ?? reading()?.refusal ?? (elsewhere() ? null : props.sheet.placeTrouble[0]());
    if (trouble) list.push({ kind: "err", text: sentences(trouble) });
    for (const one of findings().slice(0, MOST_NOTES)) list.push({ kind: one.severity === "error" ? "err" : "warn", text: `Line ${one.line}: ${plainly(inSystem(one.message, system()))}`, finding: one });
    if (findings().length > MOST_NOTES) list.push({ kind: "warn", text: `and ${findings().length - MOST_NOTES} more: see the findings of the bridge.` });
    if (about()?.stands === false) list.push({ kind: "err", text: "The bridge does not stand under its own weight." });
    const found = answer()?.words;
    if (found?.slides && found.dilatant_factor !== null && found.factor !== null && found.dilatant_factor > found.factor * 1.0005) {
      list.push({
        kind: "warn",
        text: `Joints slide: the smaller load without dilation leads; with dilation it would be ${sayFactor(props.sheet, found.dilatant_factor, system())}.`,
      });
    }
    if (found?.open) {
      const less = found.slides ? "Joints slide here: less may be carried without dilation." : "Other axles may carry less here.";
      list.push({ kind: "warn", text: `${less} The answer settles when the load rests.` });
    }
    if (about()?.fast === false && about()?.stands !== false) list.push({ kind: "", text: "This model takes longer than a picture at each place; the answer follows when it is ready." });
    for (const text of about()?.assumptions ?? []) list.push({ kind: "", text: plainly(inSystem(text, system())) });
    const assumed = assumedIn(props.sheet.text());
    if (assumed.length > 0) list.push({ kind: "", text: typeset(inSystem(`Assumed by the file: ${assumed.join("; ")}.`, system())) });
    return list;
  }, [], {
    // A new answer with the same notes leaves them where they are.
    equals: (a, b) => a.length === b.length && a.every((one, k) => one.text === b[k]!.text && one.kind === b[k]!.kind && one.finding?.start === b[k]!.finding?.start),
  });

  // Said once the load has come to rest, so that a screen reader is not flooded.
  const [spoken, setSpoken] = createSignal("");
  let timer: ReturnType<typeof setTimeout> | undefined;
  createEffect(
    on(answer, (found) => {
      clearTimeout(timer);
      if (!found) return;
      timer = setTimeout(() => {
        const head = headline();
        if (head) setSpoken(`Load at ${words(place(found.x, system()))}: ${head.value} ${head.unit} carried, ${how()}.`);
      }, 700);
    }),
  );
  onCleanup(() => clearTimeout(timer));

  return (
    <section class="block" classList={{ old: old() }} aria-label={old() ? "Answer of the values before: what was typed last is refused" : "Answer"} data-old={old() ? "" : undefined} id="answer" tabindex="-1">
      <div>
        <Show when={old()}>
          <span class="cap was" role="status" data-testid="old">Of the values before: {refusedIn()}</span>
        </Show>
        <span class="cap">{answer()?.words.open ? "Carried at this place, at most" : "Carried at this place"}{isVehicle(props.sheet) ? "" : system() === "metric" ? ", per metre of width" : ", per foot of width"}</span>
        <Show when={headline()} fallback={<span class="headline" data-none>–</span>}>
          {(head) => (
            <>
              <span class="headline num" classList={{ words: /^[A-Z]/.test(head().value) }} data-testid="headline">
                {head().value}
                <span class="unit">{head().unit}</span>
              </span>
              <span class="under">{head().whole}</span>
              {/* The curve belongs to the text that stood when the load was last looked at. */}
              <Show when={part() === "bridge"}>
                <div class="under"><button type="button" class="link" onClick={() => setPart("load")}>Where is it least?</button></div>
              </Show>
              <Show when={part() === "load" && least()}>
                {(found) => (
                  <div class="under least" data-testid="least">
                    {found().done < found().of ? "Least so far" : "Least along the road"} {sayFactor(props.sheet, found().factor, system())} at {words(place(found().x, system()))}
                    {found().done < found().of ? ` (${found().done} of ${found().of} places)` : ""}
                  </div>
                )}
              </Show>
            </>
          )}
        </Show>
      </div>
      <div>
        <span class="cap">By</span>
        <Show when={about()} fallback={<Show when={elsewhere()} fallback={<span>no load</span>}>{(what) => <button type="button" class="link" onClick={() => setPart("verdict")}>The file asks for {what()}: find it under Verdict</button>}</Show>}>
          <b>{about()!.name.replace(/^./, (c) => c.toUpperCase())}</b>
          <div class="under">
            at <span class="num" data-testid="place">{words(place(props.sheet.x[0]() ?? 0, system()))}</span>, {how()}
          </div>
          <Show when={about()!.rule}><div class="under">{about()!.rule}</div></Show>
          <div class="under" data-testid="factors">{typeset(about()!.factors)}</div>
          <div class="under soft">
            Rigid blocks, limit analysis, {answer()?.words.friction === "non-associated" ? "friction without dilation" : "lower bound"}
          </div>
        </Show>
      </div>
      <div class="notes" tabindex="0" role="region" aria-label="Warnings and assumptions">
        <span class="cap">
          Warnings and assumptions
        </span>
        <ul>
          <For each={warnings()} fallback={<li>None so far.</li>}>
            {(one) => (
              <li class={one.kind}>
                <Show when={one.finding} fallback={one.text}>
                  {(finding) => <button type="button" class="link" onClick={() => goToText(finding())}>{one.text}</button>}
                </Show>
              </li>
            )}
          </For>
        </ul>
      </div>
      <p class="unseen" aria-live="polite" data-testid="spoken">
        {spoken()}
      </p>
    </section>
  );
}
