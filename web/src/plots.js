// Plots over time, synchronised with a scene: a line marks the instant, a click or tap goes there, a
// drag zooms, and what is under the cursor is shown as numbers.
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { palette } from "./colours.js";
import { create } from "./elements.js";
import { valueAt } from "./flight.js";
import { panelsOf, standardPanels } from "./panels.js";

const HEIGHT = 112;
/** Least distance of the numbers beside a plot [px]; the rounding doubles it at most, so there are always two. */
const SPACE = 18;
/** Least width of the numbers beside a plot [px]. */
const AXIS = 54;
/** Curves that vary by less than this share of their size are flat, and are shown with this share above and below. */
const FLAT = 1e-5;
const FLAT_ROOM = 0.1;
/** Zooms that can be undone. */
const MOST_ZOOMS = 100;
/** Shortest and longest time that a plot can show [s]. */
const RANGES = [1e-6, 1e6];
/** A drag zooms along a direction if it is this long in it [px]. */
const LEAST_DRAG = 14;

export const format = (value) => {
  const size = Math.abs(value);
  if (size < 5e-4) return "0";
  return value.toFixed(size < 1 ? 3 : size < 10 ? 2 : size < 100 ? 1 : 0);
};
/** As many decimals as tell this share of a plot's height, and no more digits than these. */
const SHARE = 5e-3;
const MOST_DIGITS = 5;
/** A number with the decimals that a plot with these limits shows. */
function fine(value, [low, high]) {
  const power = (size) => Math.floor(Math.log10(size || 1));
  const digits = Math.max(0, Math.min(Math.round(-Math.log10(SHARE * (high - low || 1))), MOST_DIGITS - 1 - power(Math.max(Math.abs(low), Math.abs(high)))));
  if (digits > 6 || Math.abs(value) >= 1e6) return value === 0 ? "0" : value.toExponential(3);
  return value.toFixed(digits).replace(/^-(0(\.0*)?)$/, "$1");
}

/**
 * Plots of flights inside an element.
 *
 * @param options.onSeek called with the time that was clicked [s]
 * @param options.onZoom called when the range has changed
 * @param options.onEdit called with the index of a plot whose signals are to be changed
 * @param options.onRemove called with the index of a plot to be removed
 */
export function createPlots(element, { onSeek = () => {}, onZoom = () => {}, onEdit = () => {}, onRemove = () => {} } = {}) {
  let plots = [];
  let flights = [];
  let wanted = null; // all standard panels
  let zoomed = { range: null, heights: {} }; // times [s]; limits of the values by key of the panel
  let history = [];
  let now = 0;
  let under = null; // time under the cursor
  element.classList.add("plots");

  /** Show these plots: names of standard panels, and lists of signals. */
  function choose(list) {
    wanted = list && [...new Map(list.map((plot) => [String(plot), plot])).values()];
    build(flights);
  }

  function build(those) {
    flights = those;
    plots.forEach(({ plot }) => plot.destroy());
    element.replaceChildren();
    const colours = palette();
    const list = wanted ?? standardPanels(flights);
    plots = panelsOf(flights, list).map((panel) => {
      const keys = create("div", { class: "plot-keys" });
      const values = panel.curves.map((curve) => {
        const swatch = document.createElementNS("http://www.w3.org/2000/svg", "svg");
        swatch.setAttribute("viewBox", "0 0 22 6");
        swatch.setAttribute("aria-hidden", "true");
        const line = document.createElementNS("http://www.w3.org/2000/svg", "line");
        Object.entries({ x1: 0, x2: 22, y1: 3, y2: 3, stroke: curve.colour, "stroke-width": 2.4, "stroke-dasharray": curve.dash.join(" ") })
          .forEach(([k, v]) => line.setAttribute(k, v));
        swatch.append(line);
        const value = create("b");
        value.style.setProperty("--colour", curve.colour);
        keys.append(create("span", { class: "plot-key" }, swatch, create("span", {}, curve.name), value));
        return value;
      });
      const title = panel.unit ? `${panel.name} [${panel.unit}]` : panel.name;
      const index = list.findIndex((one) => panel.key === (Array.isArray(one) ? one.join() : one));
      const small = (text, label, act) => create("button", { type: "button", class: "small", title: label, "aria-label": `${label}: ${title}`, onclick: act }, text);
      const tools = create("span", { class: "plot-tools" },
        ...(panel.own ? [small("edit", "Change the signals", () => onEdit(index))] : []), small("×", "Remove this plot", () => onRemove(index)));
      const canvas = create("div", { class: "plot-canvas" });
      element.append(create("section", { class: "plot" }, create("header", {}, create("h3", {}, title), tools, keys), canvas));
      const one = { panel, values, canvas, marker: create("div", { class: "plot-now" }), cross: create("div", { class: "plot-under", hidden: true }), flag: create("div", { class: "plot-flag", hidden: true }) };
      one.plot = drawnIn(one, colours);
      one.plot.over.append(one.marker, one.cross, one.flag);
      return one;
    });
    apply();
  }

  function drawnIn({ panel, canvas }, colours) {
    const clocks = new Map();
    for (const curve of panel.curves) {
      const key = clocks.get(curve.t) ?? { times: Array.from(curve.t, (t) => t + curve.flight.shift), curves: [] };
      clocks.set(curve.t, { ...key, curves: [...key.curves, curve] });
    }
    const groups = [...clocks.values()];
    const tables = groups.map(({ times, curves }) => [times, ...curves.map((curve) => Array.from(curve.values))]);
    const data = tables.length === 1 ? tables[0] : uPlot.join(tables);
    const ordered = groups.flatMap(({ curves }) => curves); // as the columns of the data
    const axis = { stroke: colours.faint, grid: { stroke: colours.line, width: 0.6 }, ticks: { show: false }, font: "11px system-ui, sans-serif" };
    const stretches = merged(flights.flatMap((f) => f.impacts.map(([a, b]) => [a + f.shift, b + f.shift])));
    const stepped = uPlot.paths.stepped({ align: 1 });
    const words = panel.words && ((_, ticks) => ticks.map((x) => panel.words[x] ?? ""));
    const options = {
      width: Math.max(canvas.clientWidth, 200),
      height: HEIGHT,
      padding: [6, 20, 0, 0],
      legend: { show: false },
      scales: { x: { time: false }, y: { range: (_, low, high) => zoomed.heights[panel.key] ?? roomy(low, high) } },
      cursor: { x: false, y: false, points: { show: false }, drag: { x: true, y: true, uni: LEAST_DRAG, setScale: false }, bind: { dblclick: () => () => zoom() } },
      axes: [
        { ...axis, size: 22, gap: 2, space: 56, values: (_, ticks) => ticks.map((t) => seconds(t, ticks)) },
        { ...axis, size: (_, ticks) => Math.max(AXIS, 7 * Math.max(0, ...(ticks ?? []).map((text) => text.length)) + 8), gap: 4, space: words ? 13 : SPACE, values: words || ((_, ticks) => decimals(ticks)) },
      ],
      series: [{}, ...ordered.map((curve) => ({ stroke: curve.colour, width: 1.7, dash: curve.dash, spanGaps: true, points: { show: false }, ...(curve.held ? { paths: stepped } : {}) }))],
      hooks: {
        drawClear: [
          (u) => {
            u.ctx.fillStyle = colours.force + "2e";
            for (const [from, to] of stretches) {
              const a = u.valToPos(Math.max(from, u.scales.x.min), "x", true);
              const b = u.valToPos(Math.min(to, u.scales.x.max), "x", true);
              if (b > a) u.ctx.fillRect(a, u.bbox.top, Math.max(b - a, 1), u.bbox.height);
            }
          },
        ],
        setSelect: [(u) => select(u, panel.key)],
        // A new range or size applies from the next drawing on, so the mark moves then.
        draw: [(u) => plots.filter((one) => one.plot === u).forEach(tellOne)],
      },
    };
    const plot = new uPlot(options, data, canvas);
    let pressed = null;
    plot.over.addEventListener("pointerdown", (event) => (pressed = [event.clientX, event.clientY]));
    plot.over.addEventListener("pointerup", (event) => {
      if (pressed && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) < 5) onSeek(timeAt(event));
      pressed = null;
    });
    plot.over.addEventListener("pointercancel", () => (pressed = null));
    plot.over.addEventListener("pointermove", (event) => event.pointerType !== "touch" && point(timeAt(event), plot));
    plot.over.addEventListener("pointerleave", () => point(null));
    const timeAt = (event) => plot.posToVal(event.clientX - plot.over.getBoundingClientRect().left, "x");
    return plot;
  }

  // -- zoom ---------------------------------------------------------------------------------------

  /** The rectangle that was dragged: times for all plots, values for this one. */
  function select(u, key) {
    const { left, top, width, height } = u.select;
    const across = width >= LEAST_DRAG && width < u.over.clientWidth - 1;
    const up = height >= LEAST_DRAG && height < u.over.clientHeight - 1;
    if (width + height <= 0 || !(across || up)) return;
    const range = across ? [u.posToVal(left, "x"), u.posToVal(left + width, "x")] : zoomed.range;
    const limits = up ? { [key]: [u.posToVal(top + height, "y"), u.posToVal(top, "y")] } : {};
    u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    go({ range, heights: { ...zoomed.heights, ...limits } });
  }

  /** Change the range, so that it can be undone. */
  function go(next) {
    if (JSON.stringify(next) === JSON.stringify(zoomed) || !isPossible(next.range)) return;
    history = [...history, zoomed].slice(-MOST_ZOOMS);
    zoomed = next;
    apply();
    onZoom();
  }

  /** Show the times from begin to end [s] and all values; everything without arguments. */
  function zoom(from, to) {
    go({ range: from === undefined ? null : [from, to], heights: {} });
  }

  /** Return to the range before the last zoom; false if there was none. */
  function back() {
    if (!history.length) return false;
    zoomed = history.pop();
    apply();
    onZoom();
    return true;
  }

  function apply() {
    const ends = flights.length ? [Math.min(...flights.map((f) => f.begin + f.shift)), Math.max(...flights.map((f) => f.end + f.shift))] : [0, 1];
    const [min, max] = zoomed.range ?? ends;
    plots.forEach(({ plot }) => plot.setScale("x", { min, max }));
    show(now);
  }

  // -- instants -----------------------------------------------------------------------------------

  /** Move the lines of a plot to the time and to the cursor, or hide them if that is not in view. */
  function mark({ plot, marker, cross }) {
    const { min, max } = plot.scales.x;
    for (const [line, t] of [[marker, now], [cross, under]]) {
      line.hidden = t === null || !(t >= min && t <= max);
      if (!line.hidden) line.style.transform = `translateX(${plot.valToPos(t, "x")}px)`;
    }
  }

  /** Show the values at a time in place of those at the instant; null ends that. */
  function point(t, plot) {
    under = t;
    for (const one of plots) {
      one.flag.hidden = t === null || one.plot !== plot;
      if (one.flag.hidden) continue;
      one.flag.textContent = `${t.toFixed(4)} s`;
      const at = plot.valToPos(t, "x");
      one.flag.classList.toggle("left", at > 0.7 * plot.over.clientWidth);
      one.flag.style.transform = `translateX(${at}px)`;
    }
    element.classList.toggle("pointing", t !== null);
    tell();
  }

  /** Mark a time [s] and show all values there. */
  function show(t) {
    now = t;
    tell();
  }

  const tell = () => plots.forEach(tellOne);

  function tellOne(one) {
    const { panel, plot, values } = one;
    const limits = [plot.scales.y.min ?? 0, plot.scales.y.max ?? 1];
    mark(one);
    panel.curves.forEach((curve, k) => {
      const value = valueAt(curve, under ?? now);
      values[k].textContent = panel.words?.[Math.round(value)] ?? fine(value, limits);
    });
  }

  function resize() {
    plots.forEach(({ plot, canvas }) => {
      const width = canvas.clientWidth;
      if (width && Math.abs(width - plot.width) > 1) plot.setSize({ width, height: HEIGHT });
    });
    show(now);
  }

  const watching = new ResizeObserver(resize);
  watching.observe(element);
  return {
    replace: build,
    choose,
    show,
    zoom,
    back,
    resize,
    /** Show a range without a step to undo: as of a link. */
    restore(next) {
      if (!isPossible(next.range)) return;
      zoomed = next;
      apply();
      onZoom();
    },
    get wanted() {
      return wanted ?? standardPanels(flights);
    },
    get range() {
      return zoomed.range;
    },
    get zoomed() {
      return zoomed;
    },
    get canGoBack() {
      return history.length > 0;
    },
    /** What is shown: [{name, unit, limits, ticks, values: {curve: text}}]. */
    shown: () => plots.map(({ panel, plot, values }) => ({ name: panel.name, unit: panel.unit, limits: [plot.scales.y.min, plot.scales.y.max],
      ticks: [...(plot.axes[1]._values ?? [])], values: Object.fromEntries(panel.curves.map((curve, k) => [curve.name, values[k].textContent])) })),
    dispose() {
      watching.disconnect();
      plots.forEach(({ plot }) => plot.destroy());
      element.replaceChildren();
    },
  };
}

/** False for a range that is empty, too short or too long, or no numbers. */
function isPossible(range) {
  if (range === null) return true;
  const [from, to] = range;
  return to - from >= RANGES[0] && to - from <= RANGES[1] && Math.abs(from) <= RANGES[1];
}

/** Stretches of time without overlaps. */
function merged(stretches) {
  const found = [];
  for (const [from, to] of stretches.sort((a, b) => a[0] - b[0])) {
    const last = found[found.length - 1];
    if (last && from <= last[1]) last[1] = Math.max(last[1], to);
    else found.push([from, to]);
  }
  return found;
}

function roomy(low, high) {
  if (low == null || high == null) return [0, 1];
  const size = Math.max(Math.abs(low), Math.abs(high));
  if (size === 0) return [-0.1, 1];
  if (high - low < FLAT * size) [low, high] = [low - FLAT_ROOM * size, high + FLAT_ROOM * size];
  const span = Math.max(high - low, 1e-3 * Math.max(Math.abs(low), Math.abs(high)), 1e-6);
  return [low - 0.06 * span, high + 0.08 * span];
}

/** Ticks of values, with as many decimals as tell each from the next. */
function decimals(ticks) {
  const step = ticks.length > 1 ? Math.abs(ticks[1] - ticks[0]) : Math.abs(ticks[0]);
  const power = Math.floor(Math.log10(step || 1) + 1e-9);
  const most = Math.max(...ticks.map(Math.abs));
  if (power < -6 || most >= 1e6) return ticks.map((x) => (x === 0 ? "0" : x.toExponential(2)));
  let digits = Math.max(0, -power);
  if (Math.abs(step * 10 ** digits - Math.round(step * 10 ** digits)) > 1e-6) digits++;
  return ticks.map((x) => x.toFixed(digits).replace(/^-(0(\.0*)?)$/, "$1"));
}

/** Ticks of time, with as many digits as they need. */
function seconds(t, ticks) {
  let digits = 0;
  const least = 1e-3 * (ticks.length > 1 ? ticks[1] - ticks[0] : 1);
  while (digits < 6 && ticks.some((x) => Math.abs(x - Number(x.toFixed(digits))) > least)) digits++;
  return `${t.toFixed(digits)} s`;
}
