/** A bridge in the part of the address after "#", which no server ever sees: deflated, then base64 for addresses. */

export type Shared = { path: string; text: string; vehicle?: string; rule?: string; leftward?: boolean; x?: number };

/** Longest address that is read, and most that it may unfold to: a few hundred times what a bridge needs. */
export const MOST_ADDRESS = 200_000;
export const MOST_UNFOLDED = 1_000_000;
const PREFIX = "#b=";

async function through(bytes: Uint8Array, stream: TransformStream<BufferSource, Uint8Array>, most: number): Promise<Uint8Array> {
  const writer = stream.writable.getWriter();
  const written = writer.write(bytes as BufferSource).then(() => writer.close());
  written.catch(() => undefined);
  const reader = stream.readable.getReader();
  const parts: Uint8Array[] = [];
  let size = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    size += value.length;
    if (size > most) {
      await reader.cancel().catch(() => undefined);
      throw new Error("The bridge in this address unfolds to more than a bridge needs.");
    }
    parts.push(value);
  }
  await written;
  const whole = new Uint8Array(size);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

export async function toFragment(shared: Shared): Promise<string> {
  const bytes = new TextEncoder().encode(JSON.stringify(shared));
  const folded = await through(bytes, new CompressionStream("deflate-raw") as TransformStream<BufferSource, Uint8Array>, Infinity);
  let binary = "";
  for (const byte of folded) binary += String.fromCharCode(byte);
  return PREFIX + btoa(binary).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");
}

/** The bridge of an address; null where there is none; an error in words where it cannot be one. */
export async function fromFragment(fragment: string): Promise<Shared | null> {
  if (!fragment.startsWith(PREFIX)) return null;
  if (fragment.length > MOST_ADDRESS) throw new Error("This address is longer than any bridge needs. It was not opened.");
  let bytes: Uint8Array;
  try {
    const binary = atob(fragment.slice(PREFIX.length).replace(/-/g, "+").replace(/_/g, "/"));
    bytes = Uint8Array.from(binary, (character) => character.charCodeAt(0));
  } catch {
    throw new Error("The bridge in this address is not whole: a part of the link is missing. Copy the whole link.");
  }
  let found: unknown;
  try {
    const text = await through(bytes, new DecompressionStream("deflate-raw") as TransformStream<BufferSource, Uint8Array>, MOST_UNFOLDED);
    found = JSON.parse(new TextDecoder().decode(text));
  } catch (error) {
    if (error instanceof Error && error.message.includes("unfolds")) throw error;
    throw new Error("The bridge in this address is not whole: a part of the link is missing. Copy the whole link.");
  }
  const shared = found as Partial<Shared> | null;
  if (typeof shared !== "object" || shared === null || typeof shared.text !== "string" || typeof shared.path !== "string") {
    throw new Error("This address holds no bridge.");
  }
  const path = shared.path.replace(/[^\w.\- ]/g, "").slice(0, 80) || "bridge.toml";
  return {
    path,
    text: shared.text,
    ...(typeof shared.vehicle === "string" ? { vehicle: shared.vehicle.slice(0, 100) } : {}),
    ...(typeof shared.rule === "string" ? { rule: shared.rule.slice(0, 100) } : {}),
    ...(shared.leftward === true ? { leftward: true } : {}),
    ...(typeof shared.x === "number" && Number.isFinite(shared.x) ? { x: shared.x } : {}),
  };
}
