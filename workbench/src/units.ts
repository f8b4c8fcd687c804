/** Numbers as an engineer writes them, metric or imperial. The engine and the file stay in the units they were written in. */
export type System = "metric" | "imperial";

const THIN = "\u2009";

/** Whole digits in groups of three, a real minus sign. */
export function grouped(value: number, decimals: number): string {
  if (!Number.isFinite(value)) return "–";
  const [whole, rest] = Math.abs(value).toFixed(decimals).split(".");
  const digits = whole!.replace(/\B(?=(\d{3})+(?!\d))/g, THIN);
  const minus = value < 0 && Number(value.toFixed(decimals)) !== 0 ? "−" : "";
  return `${minus}${digits}${rest ? `.${rest}` : ""}`;
}

/** Four significant figures at most, and no more decimals than the size needs. */
export function figures(value: number, count = 4): string {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const decimals = Math.max(0, Math.min(6, count - 1 - Math.floor(Math.log10(Math.abs(value)))));
  return grouped(value, decimals);
}

export type Said = { value: string; unit: string };

/** Load per metre of width from N/m. */
export function lineLoad(newtons: number, system: System): Said {
  return system === "metric"
    ? { value: figures(newtons / 1e3), unit: "kN/m" }
    : { value: figures(newtons / 1e3 / 14.593903), unit: "kip/ft" };
}
/** Force from N. */
export function force(newtons: number, system: System): Said {
  return system === "metric"
    ? { value: figures(newtons / 1e3), unit: "kN" }
    : { value: figures(newtons / 4448.2216), unit: "kip" };
}
/** What a weight means on a weighbridge, from N. */
export function tonnes(newtons: number, system: System): Said {
  return system === "metric"
    ? { value: figures(newtons / 9806.65, 3), unit: "t" }
    : { value: figures(newtons / 9964.0164, 3), unit: "ton" };
}
/** A place along the bridge from m. */
export function place(metres: number, system: System): Said {
  return system === "metric" ? { value: grouped(metres, 2), unit: "m" } : { value: grouped(metres / 0.3048, 2), unit: "ft" };
}
/** A small movement from m. */
export function small(metres: number, system: System): Said {
  return system === "metric"
    ? { value: figures(metres * 1e3, 3), unit: "mm" }
    : { value: figures(metres / 0.0254, 3), unit: "in" };
}
/** A load on the road from Pa. */
export function pressure(pascals: number, system: System): Said {
  return system === "metric" ? { value: figures(pascals / 1e3, 3), unit: "kN/m²" } : { value: figures(pascals / 47.880259, 3), unit: "psf" };
}
export function stress(pascals: number, system: System): Said {
  return system === "metric" ? { value: figures(pascals / 1e6, 3), unit: "MPa" } : { value: figures(pascals / 6894.757, 3), unit: "psi" };
}

/** A dimension as it stands on a drawing: whole millimetres without a unit, or feet and inches. */
export function dimension(metres: number, system: System): string {
  if (system === "metric") return grouped(metres * 1e3, 0);
  const inches = metres / 0.0254;
  let feet = Math.floor(inches / 12 + 1e-9);
  let rest = Math.round((inches - 12 * feet) * 4) / 4;
  if (rest >= 12) {
    feet += 1;
    rest -= 12;
  }
  return `${feet}′${THIN}${rest}″`;
}

export function words({ value, unit }: Said): string {
  return `${value}\u00a0${unit}`;
}

type Conversion = { to: string; times: number };
/** Units of fields, metric to imperial. Those that are not listed stay as they are. */
const IMPERIAL: Record<string, Conversion> = {
  m: { to: "ft", times: 1 / 0.3048 },
  mm: { to: "in", times: 1 / 25.4 },
  cm: { to: "in", times: 1 / 2.54 },
  "kg/m^3": { to: "lb/ft^3", times: 1 / 16.018463 },
  "t/m^3": { to: "lb/ft^3", times: 1000 / 16.018463 },
  MPa: { to: "psi", times: 145.03774 },
  kPa: { to: "psi", times: 0.14503774 },
  GPa: { to: "ksi", times: 145.03774 },
  "kN/m^2": { to: "psf", times: 20.885434 },
  "N/mm^2": { to: "psi", times: 145.03774 },
  kN: { to: "kip", times: 1 / 4.4482216 },
  MN: { to: "kip", times: 1000 / 4.4482216 },
  "kN/m": { to: "kip/ft", times: 1 / 14.593903 },
  "km/h": { to: "mph", times: 1 / 1.609344 },
  t: { to: "lb", times: 2204.6226 },
  kg: { to: "lb", times: 2.2046226 },
  "GPa/m": { to: "pci", times: 3683.9586 },
  "MPa/mm": { to: "pci", times: 3683.9586 },
};

const QUANTITY = /^\s*([+-]?(?:\d[\d_ \u2009]*)?(?:\.\d+)?(?:[eE][+-]?\d+)?)\s*(\D.*)?$/;

/** A quantity as written ("18.30 m") shown in the wanted system, with so many digits where it is converted; its text where it is metric anyway or no number. */
export function shown(written: string, system: System, digits = 4): { text: string; unit: string } {
  const match = QUANTITY.exec(written);
  if (!match || match[1] === "") return { text: written, unit: "" };
  const unit = (match[2] ?? "").trim();
  const number = Number(match[1]!.replace(/[_ \u2009]/g, ""));
  if (!Number.isFinite(number)) return { text: written, unit: "" };
  const conversion = system === "imperial" ? IMPERIAL[unit] : undefined;
  if (!conversion) return { text: match[1]!.trim(), unit };
  return { text: Number((number * conversion.times).toPrecision(digits)).toString(), unit: conversion.to };
}

/** Units in which engineers write what a survey asks for in a metric unit, the usual one first. The reader of files knows all of them. */
const CHOICES: Record<System, Record<string, string[]>> = {
  metric: { m: ["m", "mm"], mm: ["mm", "cm"], "kg/m^3": ["kg/m^3", "kN/m^3"], MPa: ["MPa", "N/mm^2"], kPa: ["kPa", "MPa"], kN: ["kN", "t"] },
  imperial: { m: ["ft", "in"], mm: ["in"], "kg/m^3": ["lb/ft^3", "lbf/ft^3"], MPa: ["psi", "ksi"], kPa: ["psi", "psf"], kN: ["kip", "tonf"] },
};
export function choices(unit: string, system: System): string[] {
  return CHOICES[system][unit] ?? (unit === "" ? [] : [unit]);
}

/** A unit as the reader of files suggests it: "kN/m³" and "kN/m3" are "kN/m^3". */
function plain(unit: string): string {
  return unit.replace("²", "^2").replace("³", "^3").replace(/(?<=m|ft|in)(?=[23]$)/, "^");
}

/** An answer for its field: its number where the field offers its unit, and its text with a unit of its own otherwise. */
export function entry(written: string, unit: string, system: System, digits = 4): { text: string; unit: string } {
  const offered = choices(unit, system);
  const [usual = ""] = offered;
  const match = QUANTITY.exec(written);
  const own = plain((match?.[2] ?? "").trim());
  if (match && match[1] !== "" && offered.includes(own)) return { text: match[1]!.trim(), unit: own };
  const converted = shown(written, system, digits);
  if (converted.unit !== "" && offered.includes(converted.unit)) return converted;
  return { text: written, unit: usual };
}

/** An answer as its field shows it, with its unit; as it is where the field has no unit for it. `digits` are those of a number that is converted. */
export function restated(written: string, unit: string, system: System, digits = 6): string {
  const there = entry(written, unit, system, Math.max(digits, 6));
  const same = shown(written, "metric");
  if (!choices(unit, system).includes(there.unit) || there.unit === plain(same.unit) || there.text === written || there.text === "") return written;
  return `${Number(Number(there.text).toPrecision(digits))} ${there.unit}`;
}

/** Gravity by which the reader of files takes a weight per volume for a density, and a mass for its weight [m/s²]. */
const GRAVITY = 9.81;
/** [unit, per, the other unit, how it is said]. */
const SAME: [string, number, string, string][] = [
  ["kN/m^3", 1000 / GRAVITY, "kg/m^3", "is"],
  ["kg/m^3", GRAVITY / 1000, "kN/m^3", "weighs"],
  ["t/m^3", GRAVITY, "kN/m^3", "weighs"],
  ["t", GRAVITY, "kN", "weighs"],
  ["kN", 1 / GRAVITY, "t", "is the weight of"],
];

/** What a weight per volume is as a density, a mass as a weight, and the other way: "22 kN/m^3 is 2243 kg/m^3 at g = 9.81 m/s^2". "" for all else. */
export function also(written: string): string {
  const match = QUANTITY.exec(written);
  const number = Number((match?.[1] ?? "").replace(/[_ \u2009]/g, ""));
  const same = SAME.find(([unit]) => unit === plain((match?.[2] ?? "").trim()));
  if (!same || !match?.[1] || !Number.isFinite(number)) return "";
  const [unit, per, other, says] = same;
  return `${match[1].trim()} ${unit} ${says} ${Number((number * per).toPrecision(4))} ${other} at g = ${GRAVITY} m/s^2`;
}

/** Metric quantities within words, "1500 to 3000 kg/m^3", in the wanted system; what stands in quotation marks stays. */
export function inSystem(words: string, system: System): string {
  if (system === "metric") return words;
  return words.replace(/"[^"]*"|(\d[\d.]*)(?: to (\d[\d.]*))? (kg\/m\^3|kN\/m\^3|kN\/m\^2|kN\/m|GPa|MPa|kPa|kN|mm|m)(?![\w^/])/g, (all, low: string | undefined, high: string | undefined, unit: string) => {
    const conversion = low === undefined ? undefined : IMPERIAL[unit];
    if (!conversion) return all;
    const said = (number: string): string => Number((Number(number) * conversion.times).toPrecision(3)).toString();
    return `${said(low!)}${high === undefined ? "" : ` to ${said(high)}`} ${conversion.to}`;
  });
}

/** What "1/40 to 1/10 of the span" is of a span as written, in a unit of lengths; "" where it is no share of the span. */
export function rangeOf(usual: string, span: string, unit: string): string {
  const share = /^1\/(\d+) to 1\/(\d+) of the span$/.exec(usual);
  const match = QUANTITY.exec(span);
  const METRES: Record<string, number> = { m: 1, mm: 1e-3, cm: 1e-2, ft: 0.3048, in: 0.0254, yd: 0.9144 };
  const [from, to] = [METRES[(match?.[2] ?? "").trim()], METRES[unit]];
  if (!share || !match?.[1] || from === undefined || to === undefined) return "";
  const of = (parts: string): string => Number(((Number(match[1]!.replace(/[_ \u2009]/g, "")) * from) / to / Number(parts)).toPrecision(3)).toString();
  return `Here ${of(share[1]!)} to ${of(share[2]!)} ${unit}.`;
}

/** What a person typed, as a quantity of the file: a bare number takes the unit that was shown. */
export function meant(typed: string, unit: string): string {
  // A comma before three digits may part thousands: the engine says what to write in its place.
  const trimmed = /\d,\d{3}(?!\d)/.test(typed) ? typed.trim() : typed.trim().replace(/,/g, ".");
  return /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/.test(trimmed) && unit !== "" ? `${trimmed} ${unit}` : trimmed;
}

/** A key of the file in words: "compressive_strength" is "Compressive strength". */
export function sayKey(key: string): string {
  const words = key.replace(/_/g, " ");
  return words.charAt(0).toUpperCase() + words.slice(1);
}
