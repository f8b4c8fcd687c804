// Compresses the files of a built page beside themselves (NAME.br), and tells what they weigh. With `--most BYTES` it only weighs, and
// fails above that.
import { existsSync, readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { join, relative } from "node:path";
import { brotliCompressSync, constants } from "node:zlib";

const [folder, flag, most] = process.argv.slice(2);

function* files(at) {
  for (const name of readdirSync(at).sort()) {
    const path = join(at, name);
    if (statSync(path).isDirectory()) yield* files(path);
    else if (!name.endsWith(".br")) yield path;
  }
}

let sum = 0;
for (const path of files(folder)) {
  const bytes = readFileSync(path);
  const compressed = `${path}.br`;
  // Fonts and pictures are compressed as they are.
  if (!flag && bytes.length > 512 && !/\.(woff2?|png|br)$/.test(path)) {
    const params = { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_LGWIN]: 24 };
    writeFileSync(compressed, brotliCompressSync(bytes, { params }));
  }
  const weighs = existsSync(compressed) ? statSync(compressed).size : bytes.length;
  sum += weighs;
  console.log(`${String(weighs).padStart(9)} of ${String(bytes.length).padStart(9)}  ${relative(folder, path)}`);
}
console.log(`${String(sum).padStart(9)} bytes in all, compressed`);
if (flag === "--most" && sum > Number(most)) {
  console.error(`more than ${most} bytes`);
  process.exit(1);
}
