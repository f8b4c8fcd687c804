import { createHash } from "node:crypto";
import { readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { join, relative } from "node:path";
import { defineConfig, type Plugin } from "vite";
import solid from "vite-plugin-solid";

/** What the page may do: nothing from elsewhere, no inline script, no inline style. The server says the same in its headers. */
const POLICY = [
  "default-src 'none'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "style-src 'self'",
  "img-src 'self' blob: data:",
  "font-src 'self'",
  "connect-src 'self' blob:",
  "worker-src 'self'",
  "manifest-src 'self'",
  "media-src blob:",
  "frame-src 'self' blob:",
  "base-uri 'none'",
  "form-action 'none'",
].join("; ");

function policy(): Plugin {
  return {
    name: "policy",
    apply: "build",
    transformIndexHtml: () => [
      { tag: "meta", attrs: { "http-equiv": "Content-Security-Policy", content: POLICY }, injectTo: "head-prepend" },
    ],
  };
}

/** Licences of everything that is in the built page, as they ask for. */
function licences(): Plugin {
  return {
    name: "licences",
    apply: "build",
    generateBundle() {
      const lock = JSON.parse(readFileSync(join(import.meta.dirname, "package-lock.json"), "utf8")) as {
        packages: Record<string, { version?: string; license?: string; dev?: boolean }>;
      };
      const parts: string[] = [];
      for (const [path, one] of Object.entries(lock.packages)) {
        if (path === "" || one.dev) continue;
        const folder = join(import.meta.dirname, path);
        const name = readdirSync(folder).find((file) => /^licen[cs]e/i.test(file));
        const text = name ? readFileSync(join(folder, name), "utf8").trim() : `Licence: ${one.license ?? "see its package"}`;
        parts.push(`${path.replace(/^.*node_modules\//, "")} ${one.version ?? ""}\n\n${text}`);
      }
      this.emitFile({ type: "asset", fileName: "licences.txt", source: `${parts.join(`\n\n${"-".repeat(80)}\n\n`)}\n` });
    },
  };
}

/** Lists every file that was built in the service worker, so that the page opens without a network after the first visit. */
function offline(): Plugin {
  return {
    name: "offline",
    apply: "build",
    closeBundle() {
      const folder = join(import.meta.dirname, "dist");
      const files: string[] = [];
      const walk = (at: string): void => {
        for (const name of readdirSync(at)) {
          const path = join(at, name);
          if (statSync(path).isDirectory()) walk(path);
          else files.push(relative(folder, path));
        }
      };
      walk(folder);
      const kept = files.filter((name) => name !== "sw.js").sort();
      const hash = createHash("sha256");
      for (const name of kept) hash.update(name).update(readFileSync(join(folder, name)));
      const worker = join(folder, "sw.js");
      const text = readFileSync(worker, "utf8")
        .replace("__VERSION__", hash.digest("hex").slice(0, 16))
        .replace('"__FILES__"', kept.map((name) => JSON.stringify(name)).join(", "));
      writeFileSync(worker, text);
    },
  };
}

export default defineConfig({
  base: "./",
  plugins: [solid(), policy(), licences(), offline()],
  build: {
    target: "es2022",
    outDir: "dist",
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    cssCodeSplit: false,
    chunkSizeWarningLimit: 900,
  },
  worker: { format: "es" },
});
