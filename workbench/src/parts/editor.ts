/** CodeMirror as a view of the sheet's text: it owns neither text nor history. It lives in a shadow root, where its styles are
 * constructed sheets, so that the page needs no inline style. */
import { acceptCompletion, autocompletion, completionKeymap, type Completion, type CompletionContext, type CompletionResult } from "@codemirror/autocomplete";
import { defaultKeymap, indentWithTab } from "@codemirror/commands";
import { bracketMatching, HighlightStyle, StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import { toml } from "@codemirror/legacy-modes/mode/toml";
import { lintGutter, setDiagnostics, type Diagnostic } from "@codemirror/lint";
import { highlightSelectionMatches, search, searchKeymap } from "@codemirror/search";
import { Annotation, EditorState } from "@codemirror/state";
import { drawSelection, EditorView, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";
import { tags } from "@lezer/highlight";
import type { Finding, Section } from "../engine/types";
import { typeset } from "../wording";

const fromSheet = Annotation.define<boolean>();

const look = EditorView.theme({
  "&": { height: "100%", fontSize: "13.5px", color: "var(--ink)", backgroundColor: "var(--field)" },
  ".cm-content": { fontFamily: "var(--mono)", caretColor: "var(--ink)", padding: "8px 0" },
  ".cm-gutters": { backgroundColor: "var(--panel)", color: "var(--ink-soft)", border: "0", borderRight: "1px solid var(--hair)" },
  ".cm-activeLine": { backgroundColor: "color-mix(in srgb, var(--second) 8%, transparent)" },
  ".cm-cursor": { borderLeftColor: "var(--ink)" },
  "&.cm-focused": { outline: "2px solid var(--focus)", outlineOffset: "-2px" },
  ".cm-selectionBackground, &.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground": {
    background: "color-mix(in srgb, var(--second) 26%, transparent)",
  },
  ".cm-tooltip": { backgroundColor: "var(--panel)", color: "var(--ink)", border: "1px solid var(--ink)", fontFamily: "var(--font)", fontSize: "14px" },
  ".cm-tooltip-autocomplete > ul > li[aria-selected]": { backgroundColor: "var(--ink)", color: "var(--sheet)" },
  ".cm-completionInfo": { maxWidth: "280px", padding: "6px 8px" },
  ".cm-diagnostic": { padding: "6px 10px", maxWidth: "360px" },
  ".cm-diagnostic-error": { borderLeft: "4px solid var(--answer)" },
  ".cm-diagnostic-warning": { borderLeft: "4px solid var(--line)" },
  ".cm-lintRange-error": { backgroundImage: "none", textDecoration: "underline wavy var(--answer) 1.5px" },
  ".cm-lintRange-warning": { backgroundImage: "none", textDecoration: "underline dotted var(--ink) 2px" },
  ".cm-panels": { backgroundColor: "var(--panel)", color: "var(--ink)" },
});

const colours = HighlightStyle.define([
  { tag: tags.comment, color: "var(--ink-soft)", fontStyle: "italic" },
  { tag: [tags.propertyName, tags.definition(tags.propertyName)], color: "var(--ink)" },
  { tag: [tags.string, tags.number, tags.bool, tags.atom], color: "var(--second)" },
  { tag: [tags.heading, tags.bracket, tags.keyword], fontWeight: "600" },
]);

/** The table that a line of the text stands in: "span", "span.ring", "" before the first. */
export function tableAt(text: string, position: number): string {
  let table = "";
  for (const line of text.slice(0, position).split("\n")) {
    const match = /^\s*\[\[?\s*([\w.\-]+)\s*\]\]?/.exec(line);
    if (match) table = match[1]!;
  }
  return table;
}

function complete(sections: () => Section[]): (context: CompletionContext) => CompletionResult | null {
  return (context) => {
    const line = context.state.doc.lineAt(context.pos);
    const before = line.text.slice(0, context.pos - line.from);
    if (/^\s*#/.test(before)) return null;
    const header = /^\s*\[\[?([\w.\-]*)$/.exec(before);
    if (header) {
      const options: Completion[] = sections()
        .filter((section) => section.path !== "")
        .map((section) => ({
          label: section.path,
          apply: (view, _completion, from, to) => {
            const double = before.includes("[[");
            const rest = view.state.doc.sliceString(to, Math.min(to + 2, view.state.doc.length));
            const closing = (double ? "]]" : "]").slice(rest.match(/^\]*/)![0].length);
            view.dispatch({ changes: { from, to, insert: section.path + closing }, selection: { anchor: from + section.path.length + closing.length } });
          },
          detail: section.list ? "list" : "",
          type: "class",
        }));
      return { from: context.pos - header[1]!.length, options, validFor: /^[\w.\-]*$/ };
    }
    const table = tableAt(context.state.doc.toString(), line.from);
    const section = sections().find((one) => one.path === table);
    if (!section) return null;
    const value = /^\s*([\w-]+)\s*=\s*("?)([^"]*)$/.exec(before);
    if (value) {
      const field = section.fields.find((one) => one.key === value[1]);
      if (!field) return null;
      const options: Completion[] = field.words.map(({ word, doc }) => ({ label: word, info: typeset(doc), type: "enum", apply: value[2] ? word : `"${word}"` }));
      if (options.length === 0 && field.example && value[3] === "" && value[2] === "") options.push({ label: field.example, info: typeset(field.doc), type: "text" });
      return options.length > 0 ? { from: context.pos - value[3]!.length, options } : null;
    }
    const key = /^\s*([\w-]*)$/.exec(before);
    if (!key || (key[1] === "" && !context.explicit)) return null;
    const options: Completion[] = section.fields
      .filter((field) => field.kind !== "table" && field.kind !== "tables")
      .map((field) => ({
        label: field.key,
        detail: field.need === "required" ? "needed" : field.default ?? "",
        info: `${typeset(field.doc)}${field.example ? ` For example ${field.example}` : ""}`,
        apply: `${field.key} = `,
        type: "property",
        boost: field.need === "required" ? 1 : 0,
      }));
    return { from: context.pos - key[1]!.length, options, validFor: /^[\w-]*$/ };
  };
}

export class TomlEditor {
  readonly view: EditorView;

  constructor(
    host: HTMLElement,
    text: string,
    sections: () => Section[],
    changed: (text: string) => void,
    undo: () => void,
    redo: () => void,
  ) {
    const root = host.shadowRoot ?? host.attachShadow({ mode: "open" });
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(":host { display: block; height: 100%; } .cm-editor { height: 100%; }");
    root.adoptedStyleSheets = [sheet];
    this.view = new EditorView({
      root,
      parent: root,
      state: EditorState.create({
        doc: text,
        extensions: [
          lineNumbers(),
          EditorView.lineWrapping,
          highlightActiveLine(),
          drawSelection(),
          bracketMatching(),
          highlightSelectionMatches(),
          search({ top: true }),
          lintGutter(),
          StreamLanguage.define(toml),
          syntaxHighlighting(colours),
          autocompletion({ override: [complete(sections)], activateOnTyping: true }),
          keymap.of([
            { key: "Mod-z", run: () => (undo(), true), preventDefault: true },
            { key: "Mod-y", run: () => (redo(), true), preventDefault: true },
            { key: "Mod-Shift-z", run: () => (redo(), true), preventDefault: true },
            { key: "Tab", run: acceptCompletion },
            ...completionKeymap,
            ...searchKeymap,
            ...defaultKeymap,
          ]),
          // Tab leaves the editor, as everywhere else on the page; Ctrl-M and the like are CodeMirror's own.
          keymap.of([{ key: "Ctrl-Alt-Tab", run: indentWithTab.run! }]),
          EditorView.contentAttributes.of({ "aria-label": "Bridge file as text", tabindex: "0" }),
          EditorState.tabSize.of(4),
          look,
          EditorView.updateListener.of((update) => {
            if (update.docChanged && !update.transactions.some((one) => one.annotation(fromSheet))) changed(update.state.doc.toString());
          }),
        ],
      }),
    });
  }

  /** Takes the sheet's text where it differs, by the smallest change, so that cursor and scroll stay. */
  take(text: string): void {
    const old = this.view.state.doc.toString();
    if (old === text) return;
    let from = 0;
    const shorter = Math.min(old.length, text.length);
    while (from < shorter && old[from] === text[from]) from += 1;
    let endOld = old.length;
    let endNew = text.length;
    while (endOld > from && endNew > from && old[endOld - 1] === text[endNew - 1]) {
      endOld -= 1;
      endNew -= 1;
    }
    this.view.dispatch({ changes: { from, to: endOld, insert: text.slice(from, endNew) }, annotations: fromSheet.of(true) });
  }

  /** Findings at their places; those of a text that has moved on are cut to what is there. */
  mark(findings: Finding[]): void {
    const length = this.view.state.doc.length;
    const diagnostics: Diagnostic[] = findings.map((one) => ({
      from: Math.min(one.start, length),
      to: Math.min(Math.max(one.end, one.start), length),
      severity: one.severity === "note" ? "info" : one.severity,
      message: [one.message, one.label, one.note, one.help].filter(Boolean).join("\n"),
      source: one.code,
    }));
    this.view.dispatch(setDiagnostics(this.view.state, diagnostics));
  }

  goTo(start: number, end: number): void {
    const length = this.view.state.doc.length;
    const selection = { anchor: Math.min(start, length), head: Math.min(end, length) };
    this.view.dispatch({ selection, effects: EditorView.scrollIntoView(selection.anchor, { y: "center" }) });
    this.view.focus();
  }

  destroy(): void {
    this.view.destroy();
  }
}
