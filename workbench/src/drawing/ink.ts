/** Colours of the sheet, read once a theme from the style sheet, so that paper, ink and answer have one place. */
export type Ink = {
  sheet: string;
  ink: string;
  soft: string;
  line: string;
  grid: string;
  masonry: string;
  masonryDark: string;
  soil: string;
  soilDark: string;
  road: string;
  answer: string;
  answerSoft: string;
  second: string;
  font: string;
};

const NAMES: Record<Exclude<keyof Ink, "font">, string> = {
  sheet: "--sheet",
  ink: "--ink",
  soft: "--ink-soft",
  line: "--line",
  grid: "--grid",
  masonry: "--masonry",
  masonryDark: "--masonry-dark",
  soil: "--soil",
  soilDark: "--soil-dark",
  road: "--road",
  answer: "--answer",
  answerSoft: "--answer-soft",
  second: "--second",
};

export function inkOf(element: Element): Ink {
  const style = getComputedStyle(element);
  const ink = { font: style.fontFamily } as Ink;
  for (const [key, name] of Object.entries(NAMES)) ink[key as keyof Ink] = style.getPropertyValue(name).trim();
  return ink;
}

/** The map "cividis" (Nuñez, Anderton and Renslow 2018, PLoS ONE 13(7): e0199239): even steps for the eye, colour-blind or not. */
const CIVIDIS: [number, number, number][] = [
  [0, 34, 78], [0, 46, 106], [26, 56, 111], [50, 67, 109], [67, 78, 108], [83, 90, 109], [97, 101, 111], [111, 112, 115], [125, 124, 120],
  [140, 136, 120], [155, 148, 118], [171, 160, 114], [188, 174, 108], [205, 187, 99], [222, 201, 88], [240, 216, 70], [254, 232, 56],
];

const steps: string[] = Array.from({ length: 64 }, (_, k) => {
  const at = (k / 63) * (CIVIDIS.length - 1);
  const low = Math.min(CIVIDIS.length - 2, Math.floor(at));
  const t = at - low;
  const mix = (c: 0 | 1 | 2) => Math.round(CIVIDIS[low]![c] + t * (CIVIDIS[low + 1]![c] - CIVIDIS[low]![c]));
  return `rgb(${mix(0)} ${mix(1)} ${mix(2)})`;
});

/** Colour of a share from 0 to 1; `dark` says whether the sheet is dark, where much is light instead of dark. */
export function scaleColour(share: number, dark: boolean): string {
  const k = Math.round(Math.min(1, Math.max(0, share)) * 63);
  return steps[dark ? k : 63 - k]!;
}
