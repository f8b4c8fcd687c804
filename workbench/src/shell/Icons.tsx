import type { JSX } from "solid-js";

const icon = (d: string) => (): JSX.Element => (
  <svg viewBox="0 0 24 24" aria-hidden="true">
    <path d={d} />
  </svg>
);
export const Undo = icon("M9 6 4 11l5 5M4 11h10a6 6 0 0 1 0 12");
export const Redo = icon("m15 6 5 5-5 5m5-5H10a6 6 0 0 0 0 12");
export const Open = icon("M3 7V5h6l2 2h10v13H3V7z");
export const Save = icon("M12 3v12m-5-5 5 5 5-5M4 17v4h16v-4");
export const Share = icon("M10 14a4 4 0 0 0 6 0l4-4a4 4 0 0 0-6-6l-1 1m1 5a4 4 0 0 0-6 0l-4 4a4 4 0 0 0 6 6l1-1");
export const Theme = icon("M12 3a9 9 0 1 0 0 18zM12 3a9 9 0 0 1 0 18");
export const Help = icon("M12 21a9 9 0 1 0 0-18 9 9 0 0 0 0 18zm-2.5-11.500a2.500 2.500 0 1 1 3.500 2.300c-.7.4-1 .9-1 1.700m0 2.800v.2");
export const Ruler = icon("M3 15 15 3l6 6L9 21zM7 11l2 2m1-5 3 3m1-6 2 2");

export function Mark(): JSX.Element {
  return (
    <svg viewBox="0 0 60 44" aria-hidden="true">
      <path d="M4 42a26 26 0 0 1 52 0h-9a17 17 0 0 0-34 0z" fill="none" stroke="currentColor" stroke-width="2.4" stroke-linejoin="round" />
      <path d="M8.500 41C13 24 20 19.500 34 20.500S49 33 51.500 41" fill="none" stroke="var(--answer)" stroke-width="3.200" stroke-linecap="round" />
      <path d="M35 2v12m-4-4 4 5 4-5" fill="none" stroke="currentColor" stroke-width="2.600" stroke-linecap="round" stroke-linejoin="round" />
    </svg>
  );
}
