// Plots over time, synchronised with a scene: a line marks the instant, a click or tap goes there.
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { palette } from "./colours.js";
import { valueAt, wholeForce } from "./flight.js";

const HEIGHT = 112;
/** Curves that agree within this share of their peak are drawn and labelled as one. */
const ALIKE = 5e-3;
const DASHES = [[], [7, 3], [2, 3], [9, 3, 2, 3], [12, 4], [4, 2, 1, 2]];
/** Curve that replaces those of all arms when there are two flights. */
const OF_ALL = {
  "Arm compression": ["largest", (values) => Math.max(...values)],
  Thrust: ["all rotors", (values) => values.reduce((a, b) => a + b, 0)],
  Velocity: ["speed", (values) => values[0]],
  Energy: ["motion", (values) => values[0]],
};

/** Panels of curves: [{name, unit, curves: [{name, flight, values, colour, dash}]}]. */
export function panelsOf(flights) {
  const colours = palette();
  const names = [...new Set(flights.flatMap((f) => f.series.map((one) => one.panel)))];
  return names.map((name) => {
    const mine = flights.map((flight) => flight.series.filter((one) => one.panel === name));
    const unit = mine.flat()[0].unit;
    const curves = flights.length > 1 ? mine.flatMap((series, k) => summed(name, series, flights[k], k)) : joined(mine[0]);
    curves.forEach((curve, k) => {
      curve.flight ??= flights[0];
      curve.colour ??= colours.arms[k % colours.arms.length];
      curve.dash ??= DASHES[k % DASHES.length];
    });
    return { name, unit, curves };
  });
}

function summed(panel, series, flight, k) {
  if (!series.length) return [];
  if (panel === "Contact force") {
    return [{ name: `${flight.label}, sum of all contacts`, values: wholeForce(flight), flight, colour: flight.colour, dash: k ? [7, 3] : [] }];
  }
  const [word, rule] = OF_ALL[panel] ?? ["", (values) => values[0]];
  const values = Float32Array.from(series[0].values, (_, i) => rule(series.map((one) => one.values[i])));
  const name = word ? `${flight.label}, ${word}` : flight.label;
  return [{ name, values, flight, colour: flight.colour, dash: k ? [7, 3] : [] }];
}

/** Equal curves of arms merged. */
function joined(series) {
  const found = [];
  for (const one of series) {
    const peak = one.values.reduce((most, x) => Math.max(most, Math.abs(x)), 0);
    const twin = found.find((other) => {
      const limit = ALIKE * Math.max(peak, other.peak);
      return other.values.every((x, i) => Math.abs(x - one.values[i]) <= limit);
    });
    if (twin) twin.names.push(one.name);
    else found.push({ names: [one.name], values: one.values, peak });
  }
  return found.map(({ names, values }) => ({ name: shortened(names), values }));
}

/** "arm 1", "arm 2" as "arm 1, 2". */
function shortened(names) {
  const stems = names.map((name) => name.match(/^(.*?)\s*(\d+)$/));
  if (names.length < 2 || stems.some((m) => !m || m[1] !== stems[0][1])) return names.join(", ");
  return `${stems[0][1]} ${stems.map((m) => m[2]).join(", ")}`;
}

export const format = (value) => {
  const size = Math.abs(value);
  if (size < 5e-4) return "0";
  return value.toFixed(size < 1 ? 3 : size < 10 ? 2 : size < 100 ? 1 : 0);
};

/**
 * Plots of flights inside an element.
 *
 * @param options.onSeek called with the time that was clicked [s]
 * @param options.onZoom called when the user has changed the range: true for a part, false for all
 */
export function createPlots(element, { onSeek = () => {}, onZoom = () => {} } = {}) {
  let plots = [];
  let range = null;
  let now = 0;
  element.classList.add("plots");

  function build(flights) {
    plots.forEach(({ plot }) => plot.destroy());
    element.replaceChildren();
    const colours = palette();
    plots = panelsOf(flights).filter((panel) => panel.curves.length).map((panel) => {
      const box = document.createElement("section");
      box.className = "plot";
      const head = document.createElement("header");
      const title = document.createElement("h3");
      title.textContent = panel.unit ? `${panel.name} [${panel.unit}]` : panel.name;
      const keys = document.createElement("div");
      keys.className = "plot-keys";
      const values = panel.curves.map((curve) => {
        const key = document.createElement("span");
        key.className = "plot-key";
        const swatch = document.createElementNS("http://www.w3.org/2000/svg", "svg");
        swatch.setAttribute("viewBox", "0 0 22 6");
        swatch.setAttribute("aria-hidden", "true");
        const line = document.createElementNS("http://www.w3.org/2000/svg", "line");
        Object.entries({ x1: 0, x2: 22, y1: 3, y2: 3, stroke: curve.colour, "stroke-width": 2.4, "stroke-dasharray": curve.dash.join(" ") })
          .forEach(([k, v]) => line.setAttribute(k, v));
        swatch.append(line);
        const name = document.createElement("span");
        name.textContent = curve.name;
        const value = document.createElement("b");
        key.append(swatch, name, value);
        keys.append(key);
        return value;
      });
      head.append(title, keys);
      const canvas = document.createElement("div");
      canvas.className = "plot-canvas";
      box.append(head, canvas);
      element.append(box);
      return { panel, values, canvas, plot: drawnIn(canvas, panel, flights, colours), marker: null };
    });
    plots.forEach((one) => {
      one.marker = document.createElement("div");
      one.marker.className = "plot-now";
      one.plot.over.append(one.marker);
      mark(one);
    });
    if (range) zoom(...range);
    show(now);
  }

  function drawnIn(canvas, panel, flights, colours) {
    const tables = panel.curves.map((curve) => [Array.from(curve.flight.t, (t) => t + curve.flight.shift), Array.from(curve.values)]);
    const shared = panel.curves.every((curve) => curve.flight === panel.curves[0].flight);
    const data = shared ? [tables[0][0], ...tables.map((table) => table[1])] : uPlot.join(tables);
    const axis = { stroke: colours.faint, grid: { stroke: colours.line, width: 0.6 }, ticks: { show: false }, font: "11px system-ui, sans-serif" };
    const stretches = flights.flatMap((f) => f.impacts.map(([a, b]) => [a + f.shift, b + f.shift]));
    const options = {
      width: Math.max(canvas.clientWidth, 200),
      height: HEIGHT,
      padding: [6, 20, 0, 0],
      legend: { show: false },
      scales: { x: { time: false }, y: { range: (_, low, high) => roomy(low, high) } },
      cursor: { x: false, y: false, points: { show: false }, drag: { x: true, y: false, setScale: false }, bind: { dblclick: () => () => (zoom(), onZoom(false)) } },
      axes: [
        { ...axis, size: 22, gap: 2, space: 56, values: (_, ticks) => ticks.map((t) => seconds(t, ticks)) },
        { ...axis, size: 46, gap: 4, space: 22 },
      ],
      series: [{}, ...panel.curves.map((curve) => ({ stroke: curve.colour, width: 1.7, dash: curve.dash, spanGaps: true, points: { show: false } }))],
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
        setSelect: [
          (u) => {
            if (u.select.width < 6) return;
            zoom(u.posToVal(u.select.left, "x"), u.posToVal(u.select.left + u.select.width, "x"));
            u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
            onZoom(true);
          },
        ],
        // A new range or size applies from the next drawing on, so the mark moves then.
        draw: [(u) => plots.filter((one) => one.plot === u).forEach(mark)],
      },
    };
    const plot = new uPlot(options, data, canvas);
    let pressed = null;
    plot.over.addEventListener("pointerdown", (event) => (pressed = event.clientX));
    plot.over.addEventListener("pointerup", (event) => {
      const left = plot.over.getBoundingClientRect().left;
      if (pressed !== null && Math.abs(event.clientX - pressed) < 5) onSeek(plot.posToVal(event.clientX - left, "x"));
      pressed = null;
    });
    plot.over.addEventListener("pointercancel", () => (pressed = null));
    return plot;
  }

  /** Show the times from begin to end [s]; all without arguments. */
  function zoom(from, to) {
    range = from === undefined ? null : [from, to];
    plots.forEach(({ plot }) => {
      const t = plot.data[0];
      plot.setScale("x", range ? { min: from, max: to } : { min: t[0], max: t[t.length - 1] });
    });
    show(now);
  }

  /** Move the line of a plot to the time, or hide it if that is not in view. */
  function mark({ plot, marker }) {
    if (!marker) return;
    const { min, max } = plot.scales.x;
    marker.hidden = !(now >= min && now <= max);
    marker.style.transform = `translateX(${plot.valToPos(now, "x")}px)`;
  }

  /** Mark a time [s] and show all values there. */
  function show(t) {
    now = t;
    for (const one of plots) {
      const { panel, values } = one;
      mark(one);
      panel.curves.forEach((curve, k) => (values[k].textContent = format(valueAt(curve.flight, curve.values, t))));
    }
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
    show,
    zoom,
    resize,
    get range() {
      return range;
    },
    dispose() {
      watching.disconnect();
      plots.forEach(({ plot }) => plot.destroy());
      element.replaceChildren();
    },
  };
}

function roomy(low, high) {
  if (low == null || high == null) return [0, 1];
  const span = Math.max(high - low, 1e-3 * Math.max(Math.abs(low), Math.abs(high)), 1e-6);
  return [low - 0.06 * span, high + 0.08 * span];
}

/** Ticks of time, with as many digits as they need. */
function seconds(t, ticks) {
  let digits = 0;
  const least = 1e-3 * (ticks.length > 1 ? ticks[1] - ticks[0] : 1);
  while (digits < 6 && ticks.some((x) => Math.abs(x - Number(x.toFixed(digits))) > least)) digits++;
  return `${t.toFixed(digits)} s`;
}
