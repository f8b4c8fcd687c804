import { createEffect, createSignal } from "solid-js";
import type { System } from "../units";

function kept(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}
function keep(key: string, value: string): void {
  try {
    localStorage.setItem(key, value);
  } catch {
    // Only a preference.
  }
}

const dark = matchMedia("(prefers-color-scheme: dark)");
const theme0 = kept("extrados.theme");
export const [theme, setTheme] = createSignal<"light" | "dark">(theme0 === "dark" || theme0 === "light" ? theme0 : dark.matches ? "dark" : "light");
export const [system, setSystem] = createSignal<System>(kept("extrados.units") === "imperial" ? "imperial" : "metric");

const small = matchMedia("(max-width: 800px)");
export const [isSmall, setSmall] = createSignal(small.matches);
small.addEventListener("change", () => setSmall(small.matches));

export const calm = matchMedia("(prefers-reduced-motion: reduce)");

export function applySettings(): void {
  createEffect(() => {
    document.documentElement.dataset["theme"] = theme();
    document.querySelector('meta[name="color-scheme"]')?.setAttribute("content", theme());
  });
}
export function toggleTheme(): void {
  setTheme(theme() === "dark" ? "light" : "dark");
  keep("extrados.theme", theme());
}
export function toggleSystem(): void {
  setSystem(system() === "metric" ? "imperial" : "metric");
  keep("extrados.units", system());
}
