/** Vehicles, rules, materials, examples and survey questions of the engine, asked once. */
import { createResource } from "solid-js";
import type { Example, Library, Material, Question } from "../engine/types";
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

export const [examples] = createResource(() => patient<Example[]>("examples"));
export const [library] = createResource(() => patient<Library>("library"));
export const [questions] = createResource(() => patient<Question[]>("questions"));
export const [materials] = createResource(() => patient<Material[]>("materials"));
