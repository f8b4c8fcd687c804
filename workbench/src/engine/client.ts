/** Workers as the page sees them: calls that are answered, refused, or lost with a worker that is then replaced. */
import engine from "./pkg/extrados_workbench_bg.wasm?url";
import { plainly } from "../wording";
import type { Refusal } from "./types";

let module: Promise<WebAssembly.Module> | null = null;
/** The engine, fetched and compiled once for all workers; after a failure the next worker tries again. */
function compiled(): Promise<WebAssembly.Module> {
  module ??= WebAssembly.compileStreaming(fetch(engine)).catch((error: unknown) => {
    module = null;
    throw error;
  });
  return module;
}

/** The engine understood the call and says no, in the engineer's words. */
export class Refused extends Error {
  readonly code: string;
  readonly help: string;
  constructor(refusal: Refusal) {
    super(refusal.message);
    this.name = "Refused";
    this.code = refusal.code;
    this.help = refusal.help;
  }
}

/** A refusal in sentences, for people: what is wrong, and what to do in the page; a line of the command is not for them. */
export function sentences({ message, help }: { message: string; help: string }): string {
  return [message, help]
    .filter((words) => words !== "" && !/^extrados /.test(words))
    .map((words) => words.charAt(0).toUpperCase() + words.slice(1) + (/[.!?]$/.test(words) ? "" : "."))
    .map(plainly)
    .join(" ");
}

/** The worker died, was stopped, or did not answer in time. Another one has taken its place and holds nothing yet. */
export class Lost extends Error {
  constructor(
    message: string,
    readonly why: "broken" | "slow" | "stopped",
  ) {
    super(message);
    this.name = "Lost";
  }
}

type Waiting = {
  resolve: (value: unknown) => void;
  reject: (error: Error) => void;
  tell: ((stage: string, fraction: number) => void) | undefined;
  timer: ReturnType<typeof setTimeout> | undefined;
};

export type Options = {
  /** Longest wait [ms]; the worker is replaced after it. Without it a call may take as long as it needs. */
  patience?: number;
  tell?: (stage: string, fraction: number) => void;
  move?: Transferable[];
};

export class Engine {
  #worker: Worker | null = null;
  #next = 1;
  #waiting = new Map<number, Waiting>();
  #panic = "";
  /** The lock that the worker holds while it lives. */
  #life = "";
  #ready: Promise<void> = Promise.resolve();
  /** Counts workers: what was opened in an earlier one must be opened again. */
  generation = 0;
  /** How many workers died by themselves. */
  deaths = 0;
  onLost: ((error: Lost) => void) | undefined;

  constructor(readonly name: string) {}

  #start(): Worker {
    const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module", name: this.name });
    this.generation += 1;
    this.#panic = "";
    worker.onmessage = (event: MessageEvent) => this.#hear(event.data);
    worker.onerror = (event) => {
      event.preventDefault();
      this.#lose(new Lost(event.message || "The worker could not be started.", "broken"));
    };
    this.#worker = worker;
    this.#life = `extrados ${this.name} ${crypto.randomUUID()}`;
    this.#ready = compiled().then(
      (made) => worker.postMessage({ module: made, life: this.#life }),
      (error: unknown) => {
        if (this.#worker === worker) this.#lose(new Lost(`The engine could not be loaded: ${String((error as Error).message ?? error)}`, "broken"));
      },
    );
    return worker;
  }

  #hear(data: {
    id?: number;
    ok?: boolean;
    value?: unknown;
    refusal?: Refusal;
    broken?: string;
    tell?: { id: number; stage: string; fraction: number };
    panic?: string;
    lives?: boolean;
  }): void {
    if (data.lives) {
      this.#outlive();
      return;
    }
    if (data.panic !== undefined) {
      this.#panic = data.panic;
      return;
    }
    if (data.tell) {
      this.#waiting.get(data.tell.id)?.tell?.(data.tell.stage, data.tell.fraction);
      return;
    }
    const waiting = this.#waiting.get(data.id ?? -1);
    if (!waiting) return;
    if (data.broken !== undefined) {
      this.#lose(new Lost(this.#panic || data.broken, "broken"));
      return;
    }
    clearTimeout(waiting.timer);
    this.#waiting.delete(data.id!);
    if (data.ok) waiting.resolve(data.value);
    else waiting.reject(new Refused(data.refusal ?? { message: "Refused.", code: "", help: "" }));
  }

  /** Waits for the end of the worker, however it ends: by itself, by the system, for want of memory. */
  #outlive(): void {
    const worker = this.#worker;
    void navigator.locks?.request(this.#life, () => {
      if (worker && this.#worker === worker) this.#lose(new Lost(this.#panic || "The worker ended.", "broken"));
    });
  }

  #lose(error: Lost): void {
    this.#worker?.terminate();
    this.#worker = null;
    // What was open is gone, before the next worker starts.
    this.generation += 1;
    if (error.why !== "stopped") this.deaths += 1;
    const waiting = [...this.#waiting.values()];
    this.#waiting.clear();
    for (const one of waiting) {
      clearTimeout(one.timer);
      one.reject(error);
    }
    this.onLost?.(error);
  }

  /** Ends whatever runs; a worker that holds nothing starts with the next call. */
  stop(): void {
    if (this.#worker) this.#lose(new Lost("Stopped.", "stopped"));
  }

  /** For tests: the worker goes as if the system had ended it. */
  kill(): void {
    if (this.#worker) this.#lose(new Lost("The worker was ended.", "broken"));
  }

  get busy(): boolean {
    return this.#waiting.size > 0;
  }

  call<T>(call: string, args: Record<string, unknown> = {}, options: Options = {}): Promise<T> {
    const worker = this.#worker ?? this.#start();
    const id = this.#next++;
    return new Promise<T>((resolve, reject) => {
      const waiting: Waiting = { resolve: resolve as (value: unknown) => void, reject, tell: options.tell, timer: undefined };
      this.#waiting.set(id, waiting);
      // Patience begins once the engine stands ready.
      void this.#ready.then(() => {
        if (this.#waiting.get(id) !== waiting) return;
        if (options.patience !== undefined) {
          waiting.timer = setTimeout(() => this.#lose(new Lost("This takes too long and was stopped.", "slow")), options.patience);
        }
        worker.postMessage({ id, call, args }, options.move ?? []);
      });
    });
  }
}
