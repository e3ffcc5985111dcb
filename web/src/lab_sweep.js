// A sweep: a measure over the range of one control, with the present point marked; the curve comes
// from springback.interfaces.lab.sweeps.
import uPlot from "uplot";
import { steady } from "./lab_plots.js";
import { create } from "./elements.js";
import { palette } from "./colours.js";

const HEIGHT = 150;
const AGAIN = 700;
/** Most curves kept, so that a way back needs no flight. */
const MOST_KEPT = 40;

/**
 * @param element element to fill
 * @param options.choices {controls, measures} that can be swept and drawn
 * @param options.table the table of controls, for ranges and units
 * @param options.page identifier of this page's requests for the server
 * @param options.isShown whether a control has an effect at present
 * @param options.onPick called with a control's name and its value at a click on the curve
 * @param options.onChoice called when another sweep was chosen
 */
export function createLabSweep(element, { choices, table, page, isShown, onPick, onChoice }) {
  const kept = new Map();
  let answer = null;
  let shown = null;
  let plot = null;
  let bounds = null;
  let timer = 0;
  let asked = "";

  const controls = create("select", { id: "sweep-of", "aria-label": "Control to sweep", onchange: chosen });
  const measures = create("select", { id: "sweep-measure", "aria-label": "Measure of the sweep", onchange: chosen },
    ...choices.measures.map((one) => create("option", { value: one.name }, one.label)));
  measures.value = "impact_peak_acceleration";
  const canvas = create("div", { class: "plot-canvas" });
  const title = create("h3");
  const note = create("p", { class: "words", role: "status" });
  element.classList.add("sweep");
  element.replaceChildren(create("div", { class: "sweep-head" }, create("h2", {}, "Sweep"), controls, measures), title, canvas, note);
  offer();

  const controlOf = (name) => table.find((one) => one.name === name);
  const measureOf = () => choices.measures.find((one) => one.name === measures.value);

  /** Offer the controls that have an effect. */
  function offer() {
    const now = controls.value;
    const names = choices.controls.filter((one) => isShown(one.name) || one.name === now);
    const wanted = ["", ...names.map((one) => one.name)].join();
    if (controls.dataset.names === wanted) return;
    controls.dataset.names = wanted;
    controls.replaceChildren(create("option", { value: "" }, "off"), ...names.map((one) => create("option", { value: one.name }, one.label)));
    controls.value = now;
  }

  function chosen() {
    bounds = null;
    show(answer, {});
    onChoice();
  }

  /** Settings other than the one that is swept: the curve depends on these alone. */
  function restOf(query) {
    return query.split("&").filter((part) => part && part.split("=")[0] !== controls.value).join("&");
  }

  /** Show the curve for an answer, or request it once a control has come to rest. */
  function show(found, { moving = false }) {
    answer = found;
    offer();
    clearTimeout(timer);
    if (!answer || !controls.value) return clear("");
    if (answer.is_piloted) return clear("Flights with a pilot are not swept here; a campaign can: springback campaign.");
    if (!isShown(controls.value)) return clear("This control has no effect here.");
    const key = `${controls.value}?${restOf(answer.query)}`;
    if (kept.has(key)) {
      shown = kept.get(key);
      tell();
    } else if (!moving) {
      request(key);
    }
    draw(!kept.has(key));
  }

  async function request(key) {
    asked = key;
    const [of, rest] = key.split(/\?(.*)/s);
    note.textContent = "Flying the sweep …";
    try {
      const response = await fetch(`sweep?${[rest, `of=${of}`].filter(Boolean).join("&")}`, { headers: { "x-lab-page": page } });
      const found = await response.json();
      if (asked !== key) return;
      if (response.ok) {
        if (kept.size >= MOST_KEPT) kept.delete(kept.keys().next().value);
        kept.set(key, found);
        show(answer, {});
      } else if (response.status === 503) {
        const kind = found.preparing;
        note.textContent = kind ? `Compiling for ${kind.what}, about ${kind.about} s, once on this machine: ${Math.round(kind.waited)} s so far.` : "Too many requests are waiting.";
        timer = setTimeout(() => request(key), AGAIN);
      } else if (!found.overtaken) {
        clear(found.errors.join(" "));
      }
    } catch {
      note.textContent = "The lab does not respond.";
    }
  }

  function tell() {
    const refused = shown.refusals.reduce((sum, one) => sum + one.count, 0);
    const labels = Object.keys(shown.labels).length > 1 ? shown.labels : {};
    const round = (x) => Number(x.toPrecision(3));
    const reasons = shown.refusals.map(({ robot, from, to, why }) =>
      ` ${labels[robot] ? `${labels[robot]}, ` : ""}${from === to ? "" : `${round(from)} to `}${round(to)} ${controlOf(shown.of).unit}: ${why}.`);
    note.textContent = refused ? `${refused} of ${shown.at.length * Object.keys(shown.labels).length} points cannot be flown.${reasons.join("")}` : `${shown.at.length} flights for each robot in ${shown.took.toFixed(0)} ms. A click sets the value.`;
  }

  function clear(words) {
    asked = "";
    shown = null;
    title.textContent = "";
    plot?.destroy();
    plot = null;
    note.textContent = words;
    element.classList.toggle("off", !controls.value);
  }

  /** Values of the present measure at the present settings, by robot. */
  function present() {
    const row = answer.measures.find((one) => one.name === measures.value);
    return answer.flights.map((one, k) => ({
      robot: one.robot, label: one.label, colour: palette().robots[colourAt(k)], dash: k ? [8, 3] : [],
      x: answer.settings[controls.value], y: row?.values[one.robot] ?? null,
    }));
  }
  const colourAt = (k) => (answer.flights.length === 1 && answer.flights[0].robot === "quad" ? 1 : k % 2);

  function draw(old) {
    element.classList.remove("off");
    if (!shown || shown.of !== controls.value) return plot && (plot.destroy(), (plot = null));
    const points = present();
    const control = controlOf(controls.value);
    const curves = points.map((one) => shown.measures[measures.value][one.robot] ?? shown.at.map(() => null));
    const all = [...curves.flat(), ...points.map((one) => one.y)].filter((y) => y !== null);
    bounds = steady(bounds, Math.min(0, ...all), Math.max(0, ...all));
    const measure = measureOf();
    title.textContent = measure.unit ? `${measure.label} [${measure.unit}]` : measure.label;
    const look = JSON.stringify([control.name, measures.value, points.map((one) => [one.label, one.colour])]);
    if (plot?.look !== look) build(control, points, look);
    plot.batch(() => {
      plot.setData([shown.at, ...curves], false);
      plot.setScale("x", { min: control.least, max: control.most });
      plot.setScale("y", { min: bounds[0], max: bounds[1] });
    });
    plot.points = points;
    canvas.classList.toggle("old", old);
    mark();
  }

  function build(control, points, look) {
    plot?.destroy();
    const colours = palette();
    const axis = { stroke: colours.faint, grid: { stroke: colours.line, width: 0.6 }, ticks: { show: false }, font: "11px system-ui, sans-serif" };
    const unit = control.unit ? ` [${control.unit.replace("^1.5", "¹·⁵")}]` : "";
    const x = { ...axis, size: 24, gap: 6, label: `${control.label}${unit}`, labelSize: 15, labelFont: axis.font, labelGap: 0 };
    if (control.logarithmic) Object.assign(x, { splits: (_, i, from, to) => decades(from, to), values: (_, splits) => splits.map(String), filter: (_, splits) => splits });
    plot = new uPlot({
      width: Math.max(canvas.clientWidth, 200), height: HEIGHT, padding: [8, 12, 0, 0], legend: { show: false },
      scales: { x: { time: false, auto: false, distr: control.logarithmic ? 3 : 1, range: [control.least, control.most] }, y: { auto: false } },
      cursor: { x: false, y: false, points: { show: false }, drag: { x: false, y: false } },
      axes: [x, { ...axis, size: 46, gap: 4, space: 26 }],
      series: [{}, ...points.map((one) => ({ stroke: one.colour, width: 1.8, dash: one.dash, points: { show: false } }))],
      hooks: { draw: [mark] },
    }, [[control.least, control.most], ...points.map(() => [null, null])], canvas);
    plot.look = look;
    plot.line = create("div", { class: "plot-now" });
    plot.dots = points.map((one) => {
      const dot = create("div", { class: "sweep-point", title: one.label });
      dot.style.background = one.colour;
      return dot;
    });
    plot.over.append(plot.line, ...plot.dots);
    plot.over.addEventListener("click", (event) => onPick(control.name, plot.posToVal(event.offsetX, "x")));
  }

  /** Put the marks of the present point where it is. */
  function mark() {
    if (!plot?.points) return;
    const measure = measureOf();
    plot.line.style.transform = `translateX(${plot.valToPos(plot.points[0].x, "x")}px)`;
    plot.points.forEach(({ x, y, label }, k) => {
      const dot = plot.dots[k];
      dot.hidden = y === null;
      if (y === null) return;
      dot.title = `${label}: ${Number(y.toPrecision(4))} ${measure.unit}`;
      dot.style.transform = `translate(${plot.valToPos(x, "x")}px, ${plot.valToPos(y, "y")}px)`;
    });
  }

  new ResizeObserver(() => {
    const width = canvas.clientWidth;
    if (plot && width && Math.abs(width - plot.width) > 1) plot.setSize({ width, height: HEIGHT });
  }).observe(element);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => answer && show(answer, {}));

  return {
    show,
    /** The choice as part of a link, and back. */
    hash: () => (controls.value ? `#sweep=${controls.value},${measures.value}` : ""),
    restore(hash) {
      const [of, measure] = (hash.match(/^#sweep=([a-z_]+),([a-z_]+)$/) ?? []).slice(1);
      const known = (list, name) => list.some((one) => one.name === name);
      controls.dataset.names = "";
      controls.replaceChildren(create("option", { value: "" }, "off"), ...choices.controls.map((one) => create("option", { value: one.name }, one.label)));
      controls.value = known(choices.controls, of) ? of : "";
      if (known(choices.measures, measure)) measures.value = measure;
      bounds = null;
      if (answer) show(answer, {});
    },
    /** What is drawn, for tests. */
    state: () => ({ of: controls.value, measure: measures.value, curve: shown, points: plot?.points ?? [], bounds, words: note.textContent }),
  };
}

/** 1, 2 and 5 times powers of ten. */
function decades(from, to) {
  const found = [];
  for (let power = Math.floor(Math.log10(from)); power <= Math.log10(to); power++) {
    for (const digit of [1, 2, 5]) {
      const value = Number((digit * 10 ** power).toPrecision(3));
      if (value >= from && value <= to) found.push(value);
    }
  }
  return found;
}
