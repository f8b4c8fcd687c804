/** Films and pictures of a canvas, made in the browser. */

export function canFilm(): boolean {
  return typeof MediaRecorder !== "undefined" && MediaRecorder.isTypeSupported("video/webm");
}

/** Plays pictures one after the other onto a canvas and records them as WebM. */
export async function film(canvas: HTMLCanvasElement, count: number, paint: (k: number) => void, told: (fraction: number) => void): Promise<Blob> {
  const stream = canvas.captureStream(30);
  const recorder = new MediaRecorder(stream, { mimeType: "video/webm", videoBitsPerSecond: 4_000_000 });
  const parts: Blob[] = [];
  recorder.ondataavailable = (event) => event.data.size > 0 && parts.push(event.data);
  const ended = new Promise<void>((resolve) => (recorder.onstop = () => resolve()));
  recorder.start(500);
  const stride = Math.max(1, Math.ceil(count / 600));
  for (let k = 0; k < count; k += stride) {
    paint(k);
    told(k / count);
    await new Promise((resolve) => setTimeout(resolve, 33));
  }
  paint(count - 1);
  await new Promise((resolve) => setTimeout(resolve, 500));
  recorder.stop();
  await ended;
  stream.getTracks().forEach((track) => track.stop());
  return new Blob(parts, { type: "video/webm" });
}

export function download(data: Blob | Uint8Array, name: string, type = "application/octet-stream"): void {
  const blob = data instanceof Blob ? data : new Blob([data as BlobPart], { type });
  const url = URL.createObjectURL(blob);
  const link = document.createElement("a");
  link.href = url;
  link.download = name.replace(/[^\w.\- ()]/g, "_");
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 20_000);
}
