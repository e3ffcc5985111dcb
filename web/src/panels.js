// Panels of plots: the standard ones of a scene, and others of signals that the user chose.
import { palette } from "./colours.js";
import { wholeForce } from "./flight.js";

/** Curves that agree within this share of their peak are drawn and labelled as one. */
const ALIKE = 5e-3;
const DASHES = [[], [7, 3], [2, 3], [9, 3, 2, 3], [12, 4], [4, 2, 1, 2], [14, 3, 2, 3], [3, 6]];
/** Curve of each flight in place of those of all arms when there are several flights. */
const OF_ALL = {
  "Arm compression": ["largest", (values) => Math.max(...values)],
  Thrust: ["all rotors", (values) => values.reduce((a, b) => a + b, 0)],
  Velocity: ["speed", (values) => values[0]],
  Energy: ["motion", (values) => values[0]],
  "Contact force": ["sum of all contacts"],
};

/** Names of the standard panels. */
export const standardPanels = (flights) => [...new Set(flights.flatMap((f) => f.series.map((one) => one.panel)))];

/** Signals of any of the flights by name, in the order of their files. */
export const allSignals = (flights) => new Map(flights.flatMap((flight) => [...flight.signals]));

/** Plots as one text for a link: "Velocity;x,est_x;phase". */
export const textOf = (plots) => plots.map((plot) => (Array.isArray(plot) ? plot.join() : plot)).join(";");

/** Plots of such a text that the flights can show: names of standard panels, and lists of signals of one unit each. */
export function plotsOf(text, flights) {
  const standard = standardPanels(flights);
  const known = allSignals(flights);
  return text.split(";").flatMap((part) =>
    standard.includes(part) ? [part] : byUnit(part.split(",").filter((name) => known.has(name)), known));
}

/** Names of signals as lists of one unit each. */
export function byUnit(names, signals) {
  const units = new Map();
  for (const name of new Set(names)) {
    const { unit, words } = signals.get(name);
    const key = words ? name : unit; // what has words has an axis of its own
    units.set(key, [...(units.get(key) ?? []), name]);
  }
  return [...units.values()];
}

/** Panels of plots: [{key, name, unit, own, words, curves: [{name, flight, t, values, held, colour, dash}]}]. */
export function panelsOf(flights, plots) {
  return plots.map((plot) => (Array.isArray(plot) ? chosen(flights, plot) : standard(flights, plot))).filter((panel) => panel.curves.length);
}

function standard(flights, name) {
  const colours = palette();
  const mine = flights.map((flight) => flight.series.filter((one) => one.panel === name));
  const curves = flights.length > 1 ? mine.flatMap((series, k) => summed(name, series, flights[k])) : joined(mine[0]);
  curves.forEach((curve, k) => {
    curve.flight ??= flights[0];
    curve.t = curve.flight.t;
    curve.colour ??= colours.arms[k % colours.arms.length];
    curve.dash ??= DASHES[k % DASHES.length];
  });
  const word = flights.length > 1 ? OF_ALL[name]?.[0] : "";
  return { key: name, name: word ? `${name}, ${word}` : name, unit: mine.flat()[0]?.unit, own: null, curves };
}

/** A panel of signals: colours tell flights apart if there are several, else signals. */
function chosen(flights, names) {
  const colours = palette();
  const known = allSignals(flights);
  const several = flights.length > 1;
  const curves = names.flatMap((name, j) => flights.flatMap((flight) => {
    const signal = flight.signals.get(name);
    if (!signal) return [];
    const { t, shown: values, held } = signal;
    const index = several && names.length === 1 ? flight.index : j;
    return [{
      name: !several ? name : names.length === 1 ? flight.label : `${flight.label}, ${name}`,
      flight, t, values, held, dash: DASHES[index % DASHES.length],
      colour: several ? flight.colour : colours.arms[j % colours.arms.length],
    }];
  }));
  const signals = names.map((name) => known.get(name));
  const groups = new Set(signals.map((one) => one?.group));
  const name = names.length === 1 ? names[0] : groups.size === 1 ? signals[0].group : names.slice(0, 3).join(", ") + (names.length > 3 ? ", …" : "");
  return { key: names.join(), name, unit: signals[0]?.unit, own: names, words: signals[0]?.words, curves };
}

function summed(panel, series, flight) {
  if (!series.length) return [];
  const [, rule] = OF_ALL[panel] ?? ["", (values) => values[0]];
  const values = panel === "Contact force" ? wholeForce(flight) : Float32Array.from(series[0].values, (_, i) => rule(series.map((one) => one.values[i])));
  return [{ name: flight.label, values, flight, colour: flight.colour, dash: DASHES[flight.index % DASHES.length] }];
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
