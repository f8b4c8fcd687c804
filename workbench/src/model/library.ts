/** Vehicles, rules, materials, examples and survey questions of the engine, asked once; undefined while the engine is on its way, and where it never comes. */
import { createResource, createRoot } from "solid-js";
import type { Example, Library, Material, Questions } from "../engine/types";
import { liveEngine } from "./live";

async function patient<T>(call: string): Promise<T> {
  for (let attempt = 0; ; attempt += 1) {
    try {
      return await liveEngine.call<T>(call);
    } catch (error) {
      if (attempt >= 4) throw error;
      await new Promise((resolve) => setTimeout(resolve, 200));
    }
  }
}

function asked<T>(call: string): { (): T | undefined; lost: () => boolean } {
  const [value] = createRoot(() => createResource(() => patient<T>(call)));
  // A resource that failed throws where it is read.
  return Object.assign(() => (value.error === undefined ? value() : undefined), { lost: () => value.error !== undefined });
}

export const examples = asked<Example[]>("examples");
export const library = asked<Library>("library");
export const questions = asked<Questions>("questions");
export const materials = asked<Material[]>("materials");

/** The version of the engine. */
export const version = asked<string>("build");

/** What to say while the engine is on its way, or where it did not come; "" once it is there. */
export function engineOnItsWay(): string {
  if (examples.lost()) return "The engine could not be loaded. Reload the page once the network is back.";
  return examples() ? "" : "The engine is being loaded. What you choose opens as soon as it is there.";
}
