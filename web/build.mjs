// Bundles src/ into one script and one style sheet inside the Python package, with the licences of
// what is bundled.  The banner holds a digest of the sources: a test compares it.
import { build } from "esbuild";
import { createHash } from "node:crypto";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const out = join(here, "../src/springback/interfaces/web");
const sources = [
  "build.mjs",
  "package-lock.json",
  ...readdirSync(join(here, "src")).map((name) => `src/${name}`),
].sort();

const digest = createHash("sha256");
for (const name of sources) digest.update(name + "\n").update(readFileSync(join(here, name)));
const hash = digest.digest("hex");

const bundled = ["fflate", "three", "uplot"];
const licences = bundled
  .map((name) => {
    const about = JSON.parse(readFileSync(join(here, "node_modules", name, "package.json")));
    const text = readFileSync(join(here, "node_modules", name, "LICENSE"), "utf8").trim();
    return `${name} ${about.version}\n\n${text}\n`;
  })
  .join("\n----\n\n");

await build({
  entryPoints: { springback: join(here, "src/main.js") },
  outdir: out,
  bundle: true,
  minify: true,
  format: "iife",
  target: ["es2020"],
  charset: "utf8",
  legalComments: "none",
  banner: {
    js: `/*! springback, MIT licence; sources ${hash}\n\nIt holds:\n\n${licences}*/`,
    css: `/*! springback, MIT licence; sources ${hash}; with the style sheet of uPlot, MIT licence, (c) Leon Sorokin */`,
  },
});
writeFileSync(join(out, "LICENSES.txt"), licences);
