// Plots of the lab: robots overlaid, a pinned flight behind them, energy stacked.
import uPlot from "uplot";
import { palette } from "./colours.js";
import { touchOf } from "./flight.js";
import { create } from "./elements.js";

const HEIGHT = 100;
/** Least distance of the numbers beside a plot [px]; the rounding doubles it at most, so there are always two. */
const SPACE = 16;
const ENERGY = "Energy";
/** Time shown around first touch of an impact [s]. */
const WINDOW = [-0.01, 0.13];
/** Parts of the energy balance: stored ones in full colour, lost ones in a lighter one. */
const PARTS = {
  motion: ["#0072b2", 0.85], "arm springs": ["#56b4e9", 0.85], "end stops": ["#cc79a7", 0.85], contact: ["#009e73", 0.85],
  "lost in arms": ["#e69f00", 0.6], "lost in contact": ["#d55e00", 0.6], "lost in friction": ["#8c8c8c", 0.6],
  "lost in stops": ["#cc79a7", 0.4], "lost in locking": ["#444444", 0.4], "lost to air": ["#bbbbbb", 0.4],
  "moving obstacles": ["#b3a100", 0.75], "lost in obstacles": ["#b3a100", 0.35],
  "to driven obstacles": ["#6b4fa0", 0.5], "to the other robot": ["#6b4fa0", 0.5],
};
/** Lines over the stack: what was put in, to which it sums, and what of it came from outside. */
const PUT_IN = {
  "put in": { width: 1.6, dash: [6, 3] }, "by driven obstacles": { width: 1.4, dash: [2, 3] }, "by the other robot": { width: 1.4, dash: [2, 3] },
};

const faded = (colour, share) => colour + Math.round(255 * share).toString(16).padStart(2, "0");

/** The smallest of 1, 1.5, 2, 3, 5, 7 times a power of ten that is not below x. */
function roundAbove(x, digits = [1, 1.5, 2, 3, 5, 7, 10]) {
  if (!(x > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(x));
  return power * digits.find((digit) => digit * power >= x * 0.999999);
}

/**
 * Bounds that stay constant while curves still fit and fill them; while a control moves they only
 * grow, and locked ones never change.
 */
export function steady(bounds, low, high, { moving = false, locked = false } = {}) {
  if (bounds && locked) return bounds;
  const wanted = [low < -1e-9 ? -roundAbove(-low) : 0, high > 1e-9 ? roundAbove(high) : low < -1e-9 ? 0 : 1];
  const [least, most] = bounds ?? wanted;
  const fits = low >= least && high <= most && (moving || high - low > 0.3 * (most - least));
  if (bounds && fits) return bounds;
  return moving ? [Math.min(least, wanted[0]), Math.max(most, wanted[1])] : wanted;
}

function span(curves, from, to) {
  let low = 0;
  let high = 0;
  for (const { t, values } of curves) {
    for (let i = 0; i < values.length; i++) {
      if (t[i] < from || t[i] > to) continue;
      if (values[i] < low) low = values[i];
      if (values[i] > high) high = values[i];
    }
  }
  return [low, high];
}

/** Curves of some flights by panel. */
function curvesOf(flights, pinned) {
  const panels = new Map();
  const add = (name, unit, curve) => {
    if (!panels.has(name)) panels.set(name, { name, unit, curves: [], stacked: name.startsWith(ENERGY) });
    panels.get(name).curves.push(curve);
  };
  const of = (flight, behind) => {
    const t = Array.from(flight.t, (one) => one + flight.shift);
    let sum = null;
    for (const one of flight.series) {
      if (one.panel === ENERGY) {
        if (behind) continue;
        if (PUT_IN[one.name]) {
          add(`${ENERGY}, ${flight.label}`, one.unit, { name: one.name, t, values: Array.from(one.values), colour: palette().ink, flight, over: true, ...PUT_IN[one.name] });
          continue;
        }
        sum = Array.from(one.values, (x, i) => x + (sum ? sum[i] : 0));
        const [colour, share] = PARTS[one.name] ?? ["#8c8c8c", 0.5];
        add(`${ENERGY}, ${flight.label}`, one.unit, { name: one.name, t, values: sum, colour, fill: faded(colour, share), flight });
      } else {
        add(one.panel, one.unit, {
          name: behind ? `${flight.label}, pinned` : flight.label, t, values: Array.from(one.values), flight,
          colour: behind ? faded(flight.colour, 0.75) : flight.colour, dash: behind ? [3, 3] : flight.dash, behind,
        });
      }
    }
  };
  flights.forEach((flight, k) => {
    flight.dash = k ? [8, 3] : [];
    of(flight, false);
  });
  pinned.forEach((flight) => of(flight, true));
  const balances = flights.map((flight) => `${ENERGY}, ${flight.label}`);
  const order = (panel) => ["Acceleration", "Arm compression", ...balances, "Velocity", "Contact force"].indexOf(panel.name);
  return [...panels.values()].sort((a, b) => order(a) - order(b));
}

/**
 * @param element element to fill with plots
 * @param onSeek called with the time that was clicked [s]
 */
export function createLabPlots(element, { onSeek }) {
  const plots = new Map();
  let pinned = [];
  let shown = [];
  let now = 0;
  let window_ = null;
  let locked = false;
  element.classList.add("plots");

  function replace(flights, { whole = false, moving = false } = {}) {
    shown = flights;
    const touch = touchOf(flights[0]);
    const [begin, end] = [flights[0].begin, flights[0].end];
    window_ = whole || touch === null ? [begin, end] : [touch + WINDOW[0], Math.min(touch + WINDOW[1], end)];
    const zero = touch ?? 0;
    const panels = curvesOf(flights, pinned);
    for (const [name, one] of plots) {
      if (panels.some((panel) => panel.name === name && signature(panel, whole) === one.signature)) continue;
      one.plot.destroy();
      one.box.remove();
      plots.delete(name);
    }
    for (const panel of panels) {
      const one = plots.get(panel.name) ?? build(panel, whole);
      one.panel = panel;
      one.zero = zero;
      one.bounds = steady(one.bounds, ...span(panel.curves, ...window_), { moving, locked });
      one.plot.batch(() => {
        one.plot.setData(dataOf(panel), false);
        one.plot.setScale("x", { min: window_[0], max: window_[1] });
        one.plot.setScale("y", { min: one.bounds[0], max: one.bounds[1] });
      });
      element.append(one.box);
    }
    show(now);
  }

  const signature = (panel, whole) => `${whole} ${panel.curves.map((curve) => `${curve.name} ${curve.colour}`).join()}`;

  /** One table of all curves; those of one flight share their instants. */
  function dataOf(panel) {
    const shared = panel.curves.every((curve) => curve.flight === panel.curves[0].flight);
    const table = shared
      ? [panel.curves[0].t, ...panel.curves.map((curve) => curve.values)]
      : uPlot.join(panel.curves.map((curve) => [curve.t, curve.values]));
    return [table[0], ...drawnOrder(panel, table.slice(1))];
  }

  /** Of a stack the highest first, so that those below are drawn on it, and lines over it last. */
  function drawnOrder(panel, all) {
    if (!panel.stacked) return all;
    const over = panel.curves.map((curve) => Boolean(curve.over));
    return [...all.filter((_, k) => !over[k]).reverse(), ...all.filter((_, k) => over[k])];
  }

  function build(panel, whole) {
    const colours = palette();
    const hasKeys = !panel.stacked || panel.curves[0].flight === shown[0]; // the second balance has the colours of the first
    const keys = panel.curves.filter(() => hasKeys).map((curve) => {
      const swatch = document.createElementNS("http://www.w3.org/2000/svg", "svg");
      swatch.setAttribute("viewBox", "0 0 22 8");
      swatch.setAttribute("aria-hidden", "true");
      const line = document.createElementNS("http://www.w3.org/2000/svg", "line");
      const look = { x1: 0, x2: 22, y1: 4, y2: 4, stroke: curve.fill ?? curve.colour, "stroke-width": curve.fill ? 8 : 2.4, "stroke-dasharray": (curve.dash ?? []).join(" ") };
      Object.entries(look).forEach(([name, value]) => line.setAttribute(name, value));
      swatch.append(line);
      return create("span", { class: "plot-key" }, swatch, create("span", {}, curve.name));
    });
    const canvas = create("div", { class: "plot-canvas" });
    const box = create("section", { class: "plot", "data-panel": panel.name }, create("header", {}, create("h3", {}, `${panel.name} [${panel.unit}]`), create("div", { class: "plot-keys" }, ...keys)), canvas);
    element.append(box);
    const one = { box, canvas, panel, signature: signature(panel, whole), bounds: null, zero: 0 };
    const axis = { stroke: colours.faint, grid: { stroke: colours.line, width: 0.6 }, ticks: { show: false }, font: "11px system-ui, sans-serif" };
    const curves = drawnOrder(panel, panel.curves);
    const parts = curves.filter((curve) => !curve.over);
    const labels = (_, ticks) => ticks.map((t) => (whole ? String(+t.toFixed(3)) : String(Math.round(1e3 * (t - one.zero)))));
    const splits = (u, _, from, to) => ticksOf(from, to, one.zero, whole);
    one.plot = new uPlot({
      width: Math.max(canvas.clientWidth, 200), height: HEIGHT, padding: [6, 10, 0, 0], legend: { show: false },
      scales: { x: { time: false, auto: false }, y: { auto: false } },
      cursor: { x: false, y: false, points: { show: false }, drag: { x: false, y: false } },
      axes: [{ ...axis, size: 22, gap: 2, values: labels, splits }, { ...axis, size: 46, gap: 4, space: SPACE }],
      series: [{}, ...curves.map((curve) => ({
        stroke: curve.colour, width: curve.width ?? (curve.fill ? 1 : curve.behind ? 1.4 : 1.8), dash: curve.dash ?? [], fill: curve.fill, spanGaps: true, points: { show: false },
      }))],
      // A new range or size applies from the next drawing on, so the mark moves then.
      hooks: { draw: [() => mark(one)] },
      bands: panel.stacked ? parts.slice(1).map((_, k) => ({ series: [k + 1, k + 2], fill: parts[k].fill })) : [],
    }, dataOf(panel), canvas);
    one.marker = create("div", { class: "plot-now" });
    one.plot.over.append(one.marker);
    one.plot.over.addEventListener("click", (event) => onSeek(one.plot.posToVal(event.offsetX, "x")));
    plots.set(panel.name, one);
    return one;
  }

  /** Move the line of a plot to the time, or hide it if that is not in view. */
  function mark({ plot, marker }) {
    if (!marker) return;
    const { min, max } = plot.scales.x;
    marker.hidden = !(now >= min && now <= max);
    marker.style.transform = `translateX(${plot.valToPos(now, "x")}px)`;
  }

  /** Mark a time [s]. */
  function show(t) {
    now = t;
    plots.forEach(mark);
  }

  function resize() {
    for (const { plot, canvas } of plots.values()) {
      const width = canvas.clientWidth;
      if (width && Math.abs(width - plot.width) > 1) plot.setSize({ width, height: HEIGHT });
    }
    show(now);
  }
  new ResizeObserver(resize).observe(element);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    plots.forEach(({ plot, box }) => (plot.destroy(), box.remove()));
    plots.clear();
  });

  return {
    replace,
    show,
    /** Flights to show behind the others. */
    pin(flights) {
      pinned = flights;
    },
    /** Keep all vertical scales as they are, whatever is drawn. */
    lock(on) {
      locked = on;
    },
    /** Vertical scale of a panel, for tests. */
    bounds: (name) => plots.get(name)?.bounds,
    /** Numbers of a panel's curves, for tests. */
    curve: (name) => plots.get(name)?.panel.curves.map((curve) => ({ name: curve.name, peak: curve.values.reduce((a, b) => Math.max(a, b), 0), points: curve.values.length })),
    get flights() {
      return shown;
    },
  };
}

function ticksOf(from, to, zero, whole) {
  const step = whole ? roundAbove((to - from) / 8, [1, 2, 5, 10]) : 0.02;
  const found = [];
  for (let k = Math.ceil((from - zero * !whole) / step); ; k++) {
    const t = k * step + (whole ? 0 : zero);
    if (t > to) return found;
    found.push(t);
  }
}
