import { createEffect, createSignal, For, on, onCleanup, onMount, Show, type JSX } from "solid-js";
import { forgetEnvelope, wantEnvelope } from "../model/background";
import { engineOnItsWay } from "../model/library";
import { lookAt } from "../model/live";
import { active, activeId, close, keep, notice, open, part, restore, say, setActiveId, setNotice, setPart, sheets, type Part } from "../model/workspace";
import { fromFragment, toFragment } from "../model/address";
import type { Sheet } from "../model/sheet";
import { isSurvey } from "../model/survey";
import { BesideBlock, BesideScene, CasesPanel, ComparePanel } from "../parts/Beside";
import { BridgePanel, setTab } from "../parts/BridgePanel";
import { CollapseBlock, CollapsePanel, CollapseScene } from "../parts/Collapse";
import { saveBridge, VerdictBlock, VerdictPanel, VerdictScene } from "../parts/Verdict";
import { TrainBlock, TrainPanel, TrainScene } from "../parts/Train";
import { LoadPanel } from "../parts/LoadPanel";
import { Board } from "./Board";
import { filesOf, openFiles } from "./files";
import * as icons from "./Icons";
import { OpenDialog } from "./OpenDialog";
import { applySettings, system, theme, toggleSystem, toggleTheme } from "./settings";
import { Tour } from "./Tour";
import { sayFactor, TitleBlock } from "./TitleBlock";

const PARTS: { id: Part; title: string }[] = [
  { id: "bridge", title: "Bridge" },
  { id: "load", title: "Load" },
  { id: "collapse", title: "Collapse" },
  { id: "train", title: "Train" },
  { id: "verdict", title: "Verdict" },
  { id: "cases", title: "Cases" },
  { id: "compare", title: "Compare" },
];

export function App(): JSX.Element {
  applySettings();
  const [dialog, setDialog] = createSignal<"" | "open">("");
  const [tour, setTour] = createSignal(false);
  const [over, setOver] = createSignal(false);

  onMount(() => {
    void (async () => {
      await restore();
      // Who left the page at a survey comes back to it.
      if (isSurvey(active()?.text() ?? "")) setTab("survey");
      await fromAddress();
      if (sheets().length === 0 && !tour()) setDialog("open");
    })();
    const key = (event: KeyboardEvent): void => {
      if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
      const letter = event.key.toLowerCase();
      const inField = (event.target as Element | null)?.matches?.("input, select, textarea, [contenteditable]");
      if (letter === "z" && !inField) {
        event.preventDefault();
        if (event.shiftKey) active()?.redo();
        else active()?.undo();
      } else if (letter === "y" && !inField) {
        event.preventDefault();
        active()?.redo();
      } else if (letter === "o") {
        event.preventDefault();
        setDialog("open");
      }
    };
    addEventListener("keydown", key);
    addEventListener("hashchange", () => void fromAddress());
    addEventListener("pagehide", keep);
    document.addEventListener("visibilitychange", () => document.visibilityState === "hidden" && keep());
    onCleanup(() => removeEventListener("keydown", key));
  });

  async function fromAddress(): Promise<void> {
    const fragment = location.hash;
    if (!fragment.startsWith("#b=")) return;
    history.replaceState(null, "", location.pathname + location.search);
    try {
      const shared = await fromFragment(fragment);
      if (shared) open({ ...shared, x: shared.x ?? null });
      setDialog("");
    } catch (error) {
      say((error as Error).message, true);
    }
  }

  // The live worker follows whatever changes; what is kept on this machine follows a little later.
  createEffect(() => {
    const sheet = active();
    if (!sheet) {
      document.title = "Extrados workbench";
      return;
    }
    document.title = `${sheet.name()} – Extrados`;
    sheet.text();
    sheet.filesVersion();
    lookAt(sheet);
  });
  let keeping: ReturnType<typeof setTimeout> | undefined;
  createEffect(() => {
    for (const sheet of sheets()) {
      sheet.text();
      sheet.x[0]();
      sheet.vehicle[0]();
    }
    activeId();
    part();
    clearTimeout(keeping);
    keeping = setTimeout(keep, 400);
  });

  // The envelope fills itself once the bridge and its load have been left alone for a moment.
  let waiting: ReturnType<typeof setTimeout> | undefined;
  createEffect(
    on(
      () => {
        const sheet = active();
        return sheet && part() === "load" && sheet.about[0]() ? ([sheet, sheet.text(), sheet.vehicle[0](), sheet.rule[0](), sheet.leftward[0]()] as const) : null;
      },
      (now) => {
        clearTimeout(waiting);
        if (!now) {
          forgetEnvelope();
          return;
        }
        const [sheet, ...rest] = now;
        const key = rest.join("\u0000");
        if (sheet.envelopeKey === key && sheet.envelope[0]()) return;
        sheet.envelope[1](null);
        waiting = setTimeout(() => {
          sheet.envelopeKey = key;
          wantEnvelope(sheet, key);
        }, 350);
      },
    ),
  );

  async function share(): Promise<void> {
    const sheet = active();
    if (!sheet) return;
    const x = sheet.x[0]();
    const fragment = await toFragment({
      path: sheet.path,
      text: sheet.text(),
      ...(sheet.vehicle[0]() ? { vehicle: sheet.vehicle[0]() } : {}),
      ...(sheet.rule[0]() ? { rule: sheet.rule[0]() } : {}),
      ...(x !== null ? { x } : {}),
    });
    const link = location.origin + location.pathname + fragment;
    const without = sheet.files.size > 0 ? " Files beside it (records, drawings) are not in the link." : "";
    try {
      await navigator.clipboard.writeText(link);
      say(`The link is copied; the bridge is in it, ${(link.length / 1024).toFixed(1)} kB.${without}`);
    } catch {
      history.replaceState(null, "", fragment);
      say(`The link now stands in the address bar; the bridge is in it.${without}`);
    }
  }

  const dropped = (event: DragEvent): void => {
    event.preventDefault();
    setOver(false);
    setDialog("");
    void filesOf(event.dataTransfer).then(openFiles);
  };

  return (
    <div
      class="desk"
      onDragOver={(event) => {
        event.preventDefault();
        setOver(true);
      }}
      onDragLeave={(event) => event.relatedTarget === null && setOver(false)}
      onDrop={dropped}
    >
      <div class="skips">
        <a class="skip" href="#scene" onClick={(event) => jump(event, "#scene .grip, #scene button")}>To the drawing</a>
        <a class="skip" href="#answer" onClick={(event) => jump(event, "#answer")}>To the answer</a>
        <a class="skip" href="#panel" onClick={(event) => jump(event, "#panel .panel-tabs [aria-selected=true], #panel .panel-body")}>To the form</a>
      </div>
      <header class="head">
        <div class="brand">
          <icons.Mark />
          <span>Extrados</span>
        </div>
        <div class="tabs">
          <For each={sheets()}>
            {(sheet) => (
              <div class="tab" data-on={activeId() === sheet.id ? "" : undefined}>
                <button type="button" aria-current={activeId() === sheet.id ? "true" : undefined} onClick={() => setActiveId(sheet.id)}>
                  {sheet.name()}
                </button>
                <button type="button" class="close" aria-label={`Close ${sheet.name()}`} onClick={() => closeSheet(sheet)}>×</button>
              </div>
            )}
          </For>
        </div>
        <div class="tools" role="toolbar" aria-label="Tools">
          <button type="button" class="tool" onClick={() => setDialog("open")} aria-label="Open a bridge">
            <icons.Open />
            <span class="words">Open</span>
          </button>
          <button type="button" class="tool" disabled={(active()?.steps().back ?? 0) === 0} onClick={() => active()?.undo()} aria-label="Undo" title="Undo (Ctrl Z)">
            <icons.Undo />
          </button>
          <button type="button" class="tool" disabled={(active()?.steps().forth ?? 0) === 0} onClick={() => active()?.redo()} aria-label="Redo" title="Redo (Ctrl Shift Z)">
            <icons.Redo />
          </button>
          <button type="button" class="tool" disabled={!active()} onClick={() => saveBridge(active()!)} aria-label="Save the bridge file" title="Save the bridge file">
            <icons.Save />
            <span class="words">Save</span>
          </button>
          <button type="button" class="tool" disabled={!active()} onClick={() => void share()} aria-label="Copy a link to this bridge" title="Copy a link: the bridge is in the address, nothing is stored elsewhere">
            <icons.Share />
            <span class="words">Link</span>
          </button>
          <button type="button" class="tool" onClick={toggleSystem} aria-label={`Units: ${system()}. Change`}>
            <icons.Ruler />
            <span class="words">{system() === "metric" ? "Metric" : "Imperial"}</span>
          </button>
          <button type="button" class="tool" onClick={() => setTour(true)} aria-label="Tour of two minutes" title="Tour of two minutes">
            <icons.Help />
          </button>
          <button type="button" class="tool" onClick={toggleTheme} aria-label={theme() === "dark" ? "Light sheet" : "Dark sheet"}>
            <icons.Theme />
          </button>
        </div>
      </header>
      <div class="board">
        <nav class="index" aria-label="Parts">
          <For each={PARTS}>
            {(one, k) => (
              <button type="button" aria-current={part() === one.id ? "page" : undefined} onClick={() => setPart(one.id)}>
                <span class="no">{k() + 1}</span>
                <span>{one.title}</span>
              </button>
            )}
          </For>
          <div class="foot">Computed on this machine. Nothing is sent. <a href="./licences.txt" target="_blank" rel="noreferrer">Licences</a></div>
        </nav>
        <Show when={active()} keyed fallback={<Empty open={() => setDialog("open")} />}>
          {(sheet) => (
            <>
              <main class="middle" id="scene" aria-label="Drawing">
                <Show when={part() === "bridge" || part() === "load"}>
                  <Board sheet={sheet} handles={part() === "bridge"} load={part() === "load"} reach={26} sayLoad={(factor) => sayFactor(sheet, factor, system())} />
                  <TitleBlock sheet={sheet} />
                </Show>
                <Show when={part() === "collapse"}>
                  <CollapseScene sheet={sheet} />
                  <CollapseBlock sheet={sheet} />
                </Show>
                <Show when={part() === "train"}>
                  <TrainScene sheet={sheet} />
                  <TrainBlock sheet={sheet} />
                </Show>
                <Show when={part() === "verdict"}>
                  <VerdictScene sheet={sheet} />
                  <VerdictBlock sheet={sheet} />
                </Show>
                <Show when={part() === "cases" || part() === "compare" ? (part() as "cases" | "compare") : null} keyed>
                  {(kind) => (
                    <>
                      <BesideScene sheet={sheet} kind={kind} />
                      <BesideBlock sheet={sheet} kind={kind} />
                    </>
                  )}
                </Show>
              </main>
              <aside class="panel" id="panel" aria-label="Form">
                <Show when={part() === "bridge"}>
                  <BridgePanel sheet={sheet} />
                </Show>
                <Show when={part() === "load"}>
                  <LoadPanel sheet={sheet} />
                </Show>
                <Show when={part() === "collapse"}>
                  <CollapsePanel sheet={sheet} />
                </Show>
                <Show when={part() === "train"}>
                  <TrainPanel sheet={sheet} />
                </Show>
                <Show when={part() === "verdict"}>
                  <VerdictPanel sheet={sheet} />
                </Show>
                <Show when={part() === "cases"}>
                  <CasesPanel sheet={sheet} />
                </Show>
                <Show when={part() === "compare"}>
                  <ComparePanel sheet={sheet} />
                </Show>
              </aside>
            </>
          )}
        </Show>
      </div>
      <Show when={dialog() === "open"}>
        <OpenDialog close={() => setDialog("")} done={() => undefined} tour={() => setTour(true)} />
      </Show>
      <Show when={tour()}>
        <Tour close={() => setTour(false)} />
      </Show>
      <Show when={notice()}>
        {(one) => (
          <div class="notice" role={one().bad ? "alert" : "status"}>
            <span>{one().text}</span>
            <button type="button" onClick={() => setNotice(null)}>Close</button>
          </div>
        )}
      </Show>
      <Show when={over()}>
        <div class="drop">Drop a bridge file, a drawing, records or results</div>
      </Show>
    </div>
  );

  function closeSheet(sheet: Sheet): void {
    close(sheet.id);
    say(`${sheet.name()} is closed.`);
  }
}

function jump(event: MouseEvent, selector: string): void {
  event.preventDefault();
  (document.querySelector(selector) as HTMLElement | null)?.focus();
}

function Empty(props: { open: () => void }): JSX.Element {
  return (
    <main class="middle empty" id="scene">
      <div>
        <h1>No bridge is open</h1>
        <p class="soft" role="status">{engineOnItsWay() || "Type ten numbers of a survey, take an example, or drop a bridge file or a drawing here."}</p>
        <button type="button" class="btn main" onClick={props.open}>Open a bridge</button>
      </div>
    </main>
  );
}

