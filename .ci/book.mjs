// The pages of docs/ on their way into the book, and the book's check. Without an argument this is a preprocessor of mdBook: it reads context and
// book from stdin and writes the book to stdout. `node .ci/book.mjs finish FOLDER` copies what pages link to outside docs/ beside them, follows every
// link of the site, and asks its search.

import { cpSync, existsSync, readdirSync, readFileSync, statSync } from "node:fs";
import { dirname, join, relative } from "node:path/posix";
import { fileURLToPath } from "node:url";
import { runInNewContext } from "node:vm";

const ROOT = dirname(dirname(fileURLToPath(import.meta.url)));
// Pages outside docs/ that are pages of the book too: where they stand in it, and their names.
const ADDED = {
  "README.md": ["development/overview.md", "The repository"],
  "ARCHITECTURE.md": ["development/architecture.md", "Architecture"],
  "CONTRIBUTING.md": ["development/contributing.md", "Contributing"],
  "verification/README.md": ["development/verification-cases.md", "What a verification case holds"],
  "validation/README.md": ["development/field-tests.md", "What a field test holds"],
};
// Where files outside docs/ are copied to, beside the pages.
const COPIES = "files";

// ---- Equations: the LaTeX that the pages use, as MathML, which browsers set without a script or a font of ours.

const LETTERS = {
  alpha: "α", beta: "β", gamma: "γ", delta: "δ", Delta: "Δ", varepsilon: "ε", eta: "η", theta: "θ", lambda: "λ", mu: "μ", xi: "ξ", pi: "π",
  rho: "ρ", sigma: "σ", tau: "τ", phi: "φ", varphi: "φ",
};
const SIGNS = {
  partial: "∂", nabla: "∇", le: "≤", ge: "≥", cdot: "·", times: "×", dots: "…", lVert: "‖", rVert: "‖", sum: "∑", int: "∫",
};
const SPACES = { ",": 0.17, ";": 0.28, quad: 1, qquad: 2 };
const FUNCTIONS = ["tan", "sin", "cos", "max"];
// What Markdown would read as its own.
const safe = (text) => text.replace(/[&<>*_`\\[\]|$]/g, (sign) => `&#${sign.codePointAt(0)};`);
const tag = (name, inside, more = "") => `<${name}${more}>${inside}</${name}>`;

export function mathml(source, display) {
  const tokens = source.match(/\\[a-zA-Z]+|\\.|\d+(?:\.\d+)?|\s+|./gsu).filter((token) => token.trim() !== "" || token === "\\ ");
  let at = 0;
  const fail = (why) => {
    throw new Error(`${why} in the equation ${source}`);
  };
  const argument = () => {
    if (tokens[at] !== "{") return one();
    at += 1;
    const inside = row("}");
    at += 1;
    return inside;
  };
  const plain = () => {
    if (tokens[at] !== "{") return tokens[at++];
    const end = tokens.indexOf("}", at);
    const text = tokens.slice(at + 1, end).join("");
    at = end + 1;
    return text;
  };
  const letter = (token, more = "") => {
    const name = token.replace(/^\\/, "");
    return tag(/^\d/.test(name) ? "mn" : "mi", safe(LETTERS[name] ?? name), more);
  };
  const one = () => {
    const token = tokens[at++];
    if (token === undefined) fail("something is missing at the end");
    if (token === "{") {
      at -= 1;
      return argument();
    }
    if (!token.startsWith("\\")) {
      if (/\p{L}/u.test(token)) return tag("mi", token);
      if (/\d/.test(token)) return tag("mn", token);
      const fixed = "|()[]".includes(token) ? ' stretchy="false"' : "";
      return tag("mo", token === "-" ? "−" : safe(token), fixed);
    }
    const name = token.slice(1);
    if (name in LETTERS) return letter(token);
    if (name in SIGNS) return tag("mo", SIGNS[name]);
    if (name in SPACES) return `<mspace width="${SPACES[name]}em"/>`;
    if (FUNCTIONS.includes(name)) return tag("mi", name);
    if (name === "operatorname") return tag("mi", plain(), ' mathvariant="normal"');
    if (name === "text") return tag("mtext", plain());
    if (name === "mathbf") return tag("mrow", [...plain()].map((sign) => letter(sign, ' class="bold" mathvariant="normal"')).join(""));
    if (name === "boldsymbol") return letter(plain(), ' class="bold"');
    if (name === "frac" || name === "tfrac") return tag("mfrac", argument() + argument());
    if (name === "sqrt") return tag("msqrt", argument());
    if (name === "hat") return tag("mover", argument() + '<mo stretchy="false">ˆ</mo>', ' accent="true"');
    if (name === "Big") return tag("mo", safe(tokens[at++]), ' minsize="2em"');
    if (name === "left") {
      const open = tag("mo", safe(tokens[at++]), ' stretchy="true"');
      const inside = row("\\right");
      at += 1;
      return tag("mrow", open + inside + tag("mo", safe(tokens[at++]), ' stretchy="true"'));
    }
    return fail(`${token} is not known`);
  };
  const scripted = () => {
    const large = ["\\sum", "\\int", "\\max"].includes(tokens[at]) ? tokens[at] : "";
    let [base, below, above, primes] = [one(), "", "", ""];
    for (;;) {
      if (tokens[at] === "_") {
        at += 1;
        below = argument();
      } else if (tokens[at] === "^") {
        at += 1;
        above = argument();
      } else if (tokens[at] === "'") {
        at += 1;
        primes += tag("mo", "′");
      } else break;
    }
    above = primes + above && tag("mrow", primes + above);
    const under = display && large !== "" && large !== "\\int";
    const [sub, sup, both] = under ? ["munder", "mover", "munderover"] : ["msub", "msup", "msubsup"];
    if (below && above) return tag(both, base + below + above);
    if (below) return tag(sub, base + below);
    return above ? tag(sup, base + above) : base;
  };
  const row = (end) => {
    let inside = "";
    while (at < tokens.length && tokens[at] !== end) inside += scripted();
    if (end !== undefined && at >= tokens.length) fail(`${end} is missing`);
    return tag("mrow", inside);
  };
  return tag("math", row(undefined), display ? ' display="block"' : "");
}

const equations = (text) =>
  text
    .replace(/^\$\$([\s\S]+?)\$\$$/gm, (_, inside) => tag("div", mathml(inside, true), ' class="equation"'))
    .replace(/\$([^$\s](?:[^$]*[^$\s])?)\$/g, (_, inside) => mathml(inside, false));

// ---- Links out of docs/.

const FENCE = /^ {0,3}```[\s\S]*?^ {0,3}```[^\n]*$/gm;
const LINK = /(\]\()([^)\s]+)(\))/g;
const DATA = /(^|[^[`])`((?:examples|validation|verification)\/[\w./-]+\.(?:toml|csv|dxf))`/g;

// Changes a page outside the parts of it that match.
function outside(parts, page, change) {
  let [changed, at] = ["", 0];
  for (const part of page.matchAll(parts)) {
    changed += change(page.slice(at, part.index)) + part[0];
    at = part.index + part[0].length;
  }
  return changed + change(page.slice(at));
}

// A link of a page within the book. `from` and its target count from the root of the repository, pages of the book from docs/.
function inBook(target, from, page) {
  if (/^[a-z]+:|^#/.test(target)) return target;
  const [path, anchor] = target.split("#");
  const place = join(dirname(from), path);
  if (place === "docs/SUMMARY.md") return relative(dirname(page), "toc.html");
  const inside = place.startsWith("docs/") ? place.slice("docs/".length) : ADDED[place]?.[0];
  if (inside === undefined && place.endsWith(".md")) throw new Error(`${from} leads to ${place}, which is no page of the book: add it to ADDED`);
  // mdBook names the page of a folder `index`.
  return relative(dirname(page), inside?.replace(/README\.md$/, "index.md") ?? `${COPIES}/${place}`) + (anchor ? `#${anchor}` : "");
}

function made(content, from, page) {
  const files = (text) =>
    text.replace(DATA, (all, before, file, at) => {
      // Words under a picture hold no link.
      const picture = text.slice(text.lastIndexOf("\n", at + before.length) + 1).startsWith("![");
      const there = !picture && existsSync(join(ROOT, file));
      return there ? `${before}[\`${file}\`](${relative(dirname(page), `${COPIES}/${file}`)})` : all;
    });
  const links = (text) => text.replace(LINK, (_, open, target, close) => open + inBook(target, from, page) + close);
  const code = /`[^`\n]+(?:\n[^`\n]+)?`/g;
  return outside(FENCE, content, (text) => outside(code, files(links(text)), equations));
}

// Each word of the glossary as a heading of its own: so the search finds it by its title.
const words = (page) =>
  page
    .replace(/^\| Word .*\n\|[-|]+\n/m, "")
    .replace(/^\| (.+?) \| (.+?) \| (.*?) ?\|$/gm, (_, word, meaning, more) => `## ${word}\n\n${meaning}${more && `\n\n${more}`}\n`);

function preprocess([, book]) {
  const items = book.items ?? book.sections;
  const walk = (chapters) => {
    for (const chapter of chapters.map((item) => item.Chapter).filter((one) => one?.path)) {
      if (chapter.path === "glossary.md") chapter.content = words(chapter.content);
      chapter.content = made(chapter.content, `docs/${chapter.source_path ?? chapter.path}`, chapter.path);
      walk(chapter.sub_items);
    }
  };
  walk(items);
  for (const [place, [path, name]] of Object.entries(ADDED)) {
    const content = made(readFileSync(join(ROOT, place), "utf8"), place, path);
    items.push({ Chapter: { name, content, number: null, sub_items: [], path, source_path: null, parent_names: [] } });
  }
  return book;
}

// ---- The site as it was built.

function pagesBelow(folder, under = "") {
  return readdirSync(join(folder, under)).flatMap((name) => {
    const place = join(under, name);
    if (place === COPIES) return [];
    return statSync(join(folder, place)).isDirectory() ? pagesBelow(folder, place) : place.endsWith(".html") ? [place] : [];
  });
}

// Follows every link of every page; those to copies make the copy.
function follow(folder) {
  const pages = new Map();
  for (const page of pagesBelow(folder)) {
    const html = readFileSync(join(folder, page), "utf8").replace(/<script[\s\S]*?<\/script>/g, "");
    const links = [...html.matchAll(/\s(?:href|src)="([^"]*)"/g)].map((link) => link[1].replaceAll("&amp;", "&"));
    pages.set(page, { links, ids: new Set([...html.matchAll(/\sid="([^"]*)"/g)].map((id) => id[1])) });
  }
  const [wrong, copied] = [[], new Set()];
  let [links, anchors, foreign] = [0, 0, 0];
  for (const [page, { links: all }] of pages) {
    for (const link of all) {
      if (/^(https?|mailto|data):/.test(link)) {
        // What is followed by a reader may lead anywhere; what a page loads may not.
        foreign += 1;
        continue;
      }
      const [path, anchor] = decodeURI(link).split("#");
      const there = path === "" ? page : join(dirname(page), path);
      const copy = there.startsWith(`${COPIES}/`) ? there.slice(COPIES.length + 1) : undefined;
      if (copy !== undefined && existsSync(join(ROOT, copy))) {
        cpSync(join(ROOT, copy), join(folder, there), { recursive: true });
        copied.add(copy);
      }
      links += 1;
      if (!existsSync(join(folder, there))) wrong.push(`${page}: ${link} leads nowhere`);
      else if (anchor && pages.has(there)) {
        anchors += 1;
        if (!pages.get(there).ids.has(anchor)) wrong.push(`${page}: ${link} leads to no heading`);
      }
    }
  }
  const loaded = [...pages.keys()].flatMap((page) => {
    const html = readFileSync(join(folder, page), "utf8");
    return [...html.matchAll(/<(?:script|img|link|iframe)[^>]*\s(?:src|href)="(https?:[^"]*)"/g)].map((one) => `${page} loads ${one[1]}`);
  });
  console.log(`${pages.size} pages, ${links} links, ${anchors} of them to headings, ${foreign} to other sites; ${copied.size} files copied beside the pages`);
  return [...wrong, ...loaded];
}

// Terms of the trade, each with pages that are about it. The search must put one of these first or
// second: that is what a reader sees without scrolling.
const TERMS = {
  "arch ring": ["glossary#arch-ring", "theory/limit-analysis"],
  voussoir: ["glossary#voussoir", "theory/limit-analysis"],
  "spandrel wall": ["theory/spandrel-walls", "glossary#spandrel-wall"],
  backing: ["glossary#backing", "theory/spandrels"],
  haunching: ["glossary#haunching", "theory/spandrels"],
  skew: ["theory/load-rules#skew", "glossary#skew"],
  "ring separation": ["verification/ring-separation", "glossary#ring-separation"],
  hinge: ["glossary#hinge", "tutorials/first-bridge"],
  mechanism: ["glossary#mechanism", "theory/limit-analysis"],
  "thrust line": ["glossary#thrust-line-thrust-zone", "verification/three-engines"],
  axle: ["glossary#axle", "theory/load-rules"],
  restriction: ["glossary#restriction", "theory/next-steps"],
  "condition factor": ["glossary#condition-factor", "theory/checks"],
  "adequacy factor": ["glossary#adequacy-factor", "theory/checks"],
  fill: ["glossary#fill", "theory/fill-pressure", "theory/continuum"],
  springing: ["theory/supports", "glossary#springing"],
  abutment: ["theory/supports", "glossary#abutment"],
  "load test": ["glossary#load-test", "verification/validation"],
  dispersal: ["theory/dispersal", "glossary#dispersal"],
  DXF: ["input/drawings", "glossary#dxf"],
  pier: ["theory/supports", "glossary#pier"],
  MEXE: ["glossary#mexe", "theory/checks"],
  "Route Availability": ["theory/load-rules#route-availability-number-of-a-vehicle", "glossary#route-availability"],
  "effective width": ["glossary#effective-width", "theory/load-rules"],
};

function ask(folder) {
  const [index, engine] = [/^searchindex-?\w*\.js$/, /^elasticlunr-?\w*\.min\.js$/].map((name) =>
    readFileSync(join(folder, readdirSync(folder).find((file) => name.test(file))), "utf8"),
  );
  const browser = { console, search: {} };
  browser.window = browser.self = browser;
  runInNewContext(`${engine};this.elasticlunr ??= elasticlunr;${index}`, browser);
  const { search, elasticlunr } = browser;
  const loaded = elasticlunr.Index.load(search.index);
  const wrong = [];
  for (const [term, about] of Object.entries(TERMS)) {
    const found = loaded.search(term, search.search_options).slice(0, search.results_options.limit_results);
    // Several headings of one page count once, but for the words of the glossary.
    const name = (one) => search.doc_urls[one.ref].replace(".html", "").replace(/^(?!glossary#)(.*?)#.*$/, "$1");
    const first = [...new Set(found.map(name))];
    const place = (page) => first.indexOf(page.startsWith("glossary#") ? page : page.split("#")[0]) + 1;
    const places = about.map((page) => [page, place(page)]).sort(([, a], [, b]) => (a || Infinity) - (b || Infinity));
    const rank = places[0][1];
    const others = process.env.EXTRADOS_TELL ? ` (${first.slice(0, 6).join(", ")})` : "";
    console.log(`  ${term}: ${places.map(([page, at]) => `${page} ${at || "not"}`).join(", ")} of ${first.length}${others}`);
    if (rank === 0 || rank > 2) wrong.push(`the search for "${term}" finds ${first.slice(0, 5).join(", ") || "nothing"} first`);
  }
  console.log(`${Object.keys(TERMS).length - wrong.length} of ${Object.keys(TERMS).length} terms lead to a page that is about them`);
  return wrong;
}

const [what, folder] = process.argv.slice(2);
if (what === "supports") {
  process.exit(folder === "html" ? 0 : 1);
} else if (what === "finish") {
  const wrong = [...follow(folder), ...ask(folder)];
  wrong.forEach((line) => console.error(line));
  process.exit(wrong.length === 0 ? 0 : 1);
} else {
  process.stdout.write(JSON.stringify(preprocess(JSON.parse(readFileSync(0, "utf8")))));
}
