// The page of springback view: flights, their plots and their numbers.
import { createCapture } from "./capture.js";
import { createChooser } from "./chooser.js";
import { choice, create, icon, markCompare, toggle } from "./elements.js";
import { hasEstimate } from "./flight.js";
import { createFullScreen } from "./full_screen.js";
import { createLink } from "./link.js";
import { allSignals, plotsOf, standardPanels, textOf } from "./panels.js";
import { createPlayer } from "./player.js";
import { createPlots } from "./plots.js";
import { CAMERAS, createScene } from "./scene.js";

const NAMES = { follow: "Follow", free: "Whole flight", front: "Front", side: "Side", top: "Top", impact: "Impact" };
const CAMERA_KEYS = { 1: "front", 2: "side", 3: "top", 4: "follow", 5: "free", 6: "impact", 0: "follow" };
const KEYS = [
  ["space", "play, pause"], ["← →", "one instant back, forth; with shift ten"], [", .", "slower, faster"],
  ["t", "to the first touch"], ["Home End", "to the start, to the end"],
  ["1 2 3", "view from the front, from the side, from above"], ["4 5 6", "follow, whole flight, impact"], ["0", "the view as it was at first"],
  ["e", "estimated pose, on and off"], ["f", "full screen"], ["p", "save a picture"], ["l", "copy a link to this instant and view"],
  ["a click in a plot", "goes to that instant"], ["a drag in a plot", "zooms: along the time, the values, or both"],
  ["a double click in a plot", "shows everything"], ["Escape", "undoes the last zoom"], ["?", "these keys"],
];
/** Where the user's choice of plots is stored. */
const STORED = "springback.plots";
/** Time for which a remark is shown [ms]. */
const REMARK = 8000;

/** @param data {flights: […]} */
export function startReplay(element, data) {
  const stage = create("div", { class: "stage" });
  const bar = create("div");
  const readouts = create("div", { class: "readouts" });
  const plotBox = create("div");
  const remark = create("p", { class: "remark", role: "status", hidden: true });
  let ready = false;
  let cameras = null;
  let capture = null;

  const scene = createScene(stage, { flights: data.flights, onCamera: (mode) => (cameras?.mark(mode), changed()), onDrawn: () => capture?.drawn() });
  const flights = scene.all;
  const many = flights.length > 1;
  const worlds = new Set(flights.map((flight) => flight.world)).size;
  const names = [...new Set(flights.map((flight) => flight.scenario))];
  const title = names.length > 2 ? `${flights.length} flights` : names.join(" and ");

  function say(text) {
    remark.textContent = text;
    remark.hidden = false;
    clearTimeout(say.ends);
    say.ends = setTimeout(() => (remark.hidden = true), REMARK);
  }

  // -- flights and views --------------------------------------------------------------------------
  const legend = flights.map((flight, k) => legendEntry(flight, many && ((on) => setShown(k, on))));
  cameras = choice("Camera", CAMERAS.map((mode) => [mode, NAMES[mode]]), "follow", (mode) => scene.setCamera(mode));
  const compare = choice("Flights", [["side", "side by side"], ["ghost", "overlaid"]], "side", (mode) => (scene.setCompare(mode), markCompare(compare, scene), changed()));
  const bends = flights.some((flight) => flight.arms.some((arm) => arm.compliant));
  const arms = choice("Arm travel", [["1", "arms to scale"], ["10", "arm travel × 10"]], "1", (times) => (scene.setMagnified(Number(times)), changed()));
  const layers = { forces: ["Forces", true], path: ["Path", true], ...(flights.some(hasEstimate) ? { estimate: ["Estimate", false] } : {}) };
  const switches = Object.fromEntries(Object.entries(layers).map(([name, [label, on]]) =>
    [name, toggle(label, on, (now) => (scene.setShown(name, now), changed()), name === "estimate" ? "The pose that the pilot estimates, as a grey ghost (E)" : "")]));
  const layered = create("div", { class: "choice", role: "group", "aria-label": "Show" }, ...Object.values(switches));

  const hidden = () => flights.flatMap((_, k) => (legend[k].shown ? [] : [k + 1]));
  function setShown(k, on) {
    if (!on && hidden().length === flights.length - 1) return say("One flight is always shown.");
    legend[k].mark(on);
    scene.setShown(k, on);
    markCompare(compare, scene);
    player.replace();
    changed();
  }

  // -- plots --------------------------------------------------------------------------------------
  const plots = createPlots(plotBox, {
    onSeek: (t) => (player.pause(), player.seek(t)),
    onZoom: () => (markZoom(), changed()),
    onEdit: (index) => chooser.open(plots.wanted, index),
    onRemove: (index) => choosePlots(plots.wanted.filter((_, k) => k !== index)),
  });
  const chooser = createChooser({ signals: allSignals(flights), standard: standardPanels(flights), onChoose: choosePlots });
  const touched = flights.find((flight) => flight.impacts.length);
  const impact = () => {
    const [begin, end] = touched.impacts[0].map((t) => t + touched.shift);
    const room = 0.35 * Math.min(end - begin, 0.2) + 0.004;
    return [begin - room, Math.min(end, begin + 0.3) + 2 * room];
  };
  const isImpact = (range) => Boolean(touched && range) && range.every((t, k) => Math.abs(t - impact()[k]) < 1e-9);
  const zooms = choice("Plots show", [["all", "whole flight"], ...(touched ? [["impact", "first impact"]] : [])], "all", (which) =>
    which === "all" ? plots.zoom() : plots.zoom(...impact()));
  const undo = create("button", { type: "button", class: "undo", title: "Undo the last zoom (Escape)", disabled: true, "aria-label": "Undo the last zoom", onclick: () => plots.back() }, icon("undo"));
  const adding = create("button", { type: "button", class: "adding", title: "Choose plots and signals", onclick: () => chooser.open(plots.wanted) }, "Plots …");

  function markZoom() {
    const { range, heights } = plots.zoomed;
    const whole = !Object.keys(heights).length;
    zooms.mark(whole && !range ? "all" : whole && isImpact(range) ? "impact" : "");
    undo.disabled = !plots.canGoBack;
  }

  /** Show these plots and remember them; null shows the standard ones. */
  function choosePlots(list) {
    plots.choose(list);
    try {
      if (list) localStorage.setItem(STORED, textOf(list));
      else localStorage.removeItem(STORED);
    } catch {
      // without storage the link alone has the choice
    }
    changed();
  }

  // -- pictures, link, keys -----------------------------------------------------------------------
  const keysBox = create("dialog", { class: "keys", "aria-label": "Keys and mouse" }, create("h2", {}, "Keys and mouse"),
    create("table", {}, ...KEYS.map(([key, what]) => create("tr", {}, create("th", { scope: "row" }, key), create("td", {}, what)))),
    create("form", { method: "dialog" }, create("button", { class: "main" }, "Close")));
  const tool = (name, label, act, key) => create("button", { type: "button", class: `tool tool-${name}`, title: `${label}${key ? ` (${key})` : ""}`, "aria-label": label, onclick: act }, icon(name));
  const filmButton = tool("film", "Record a film from here", () => capture.film());
  const left = create("div", { class: "left" }, stage, bar);
  const fullScreen = createFullScreen(() => left, () => say("This browser refuses full screen."));
  const tools = create("div", { class: "tools" },
    tool("link", "Copy a link to this instant and view", copyLink, "L"), tool("picture", "Save a picture", () => capture.picture(), "P"), filmButton,
    fullScreen.button, tool("help", "Keys and mouse", () => keysBox.showModal(), "?"));

  async function copyLink() {
    const address = link.address();
    try {
      await navigator.clipboard.writeText(address);
      say("The link is copied.");
    } catch {
      say("The address of this page is now a link to this instant and view.");
    }
  }

  const views = Object.fromEntries(Object.entries(CAMERA_KEYS).map(([key, mode]) => [key, () => scene.setCamera(mode)]));
  const actions = {
    ...views, f: fullScreen.toggle, p: () => capture.picture(), l: copyLink, "?": () => keysBox.showModal(),
    e: () => switches.estimate?.click(), Escape: () => plots.back(),
  };

  // -- the page -----------------------------------------------------------------------------------
  element.replaceChildren(
    create("header", { class: "top" }, create("div", { class: many ? "flights several" : "flights" }, create("h1", {}, title), ...legend.map((one) => one.element)),
      create("div", { class: "views" }, cameras, ...(worlds > 1 ? [compare] : []), ...(bends ? [arms] : []), layered)),
    create("main", {}, left, create("aside", {}, ...warnedOf(flights), readouts,
      create("div", { class: "plot-head" }, create("h2", {}, "Over time"), zooms, undo, adding), plotBox, ...touchedBy(flights), aboutOf(flights))),
    chooser.element, keysBox,
  );
  stage.append(remark);
  element.classList.add("replay");
  const player = createPlayer({ scene, plots, bar, readouts, actions, onRest: () => (capture?.rested(), changed()) });
  capture = createCapture({ scene, stage, player, say, name: title.replace(/[^\p{L}\p{N}]+/gu, "-").slice(0, 60), onRecording: (on) => {
    filmButton.classList.toggle("recording", on);
    filmButton.setAttribute("aria-label", on ? "End the film" : "Record a film from here");
  } });
  bar.querySelector(".buttons").append(tools);
  player.replace({ keepTime: false });
  markCompare(compare, scene);
  if (touched) plots.restore({ range: impact(), heights: {} });
  markZoom();
  scene.setCamera("follow");

  // -- the link -----------------------------------------------------------------------------------
  const link = createLink({ read, apply });

  function changed() {
    if (ready && !player.playing) link.renew();
  }

  function read() {
    const { range } = plots.zoomed;
    return {
      t: player.time.toFixed(6).replace(/0+$/, "").replace(/\.$/, ""),
      camera: scene.camera === "follow" ? "" : scene.camera,
      speed: player.pace === "auto" ? "" : player.pace,
      arms: arms.chosen === "10" ? "10" : "",
      compare: scene.wantedCompare === "ghost" ? "ghost" : "",
      hide: hidden().join(),
      layers: Object.keys(layers).filter((name) => switches[name].on !== layers[name][1]).join(),
      zoom: isImpact(range) || (!range && !touched) ? "" : range ? range.map((t) => t.toFixed(6)).join() : "all",
      plots: textOf(plots.wanted) === textOf(standardPanels(flights)) ? "" : textOf(plots.wanted),
    };
  }

  /** Show what a link asks for; words that mean nothing here are passed over. */
  function apply(asked) {
    const numbers = (text) => text.split(",").map(Number);
    if (asked.hide) {
      const away = numbers(asked.hide);
      if (!flights.every((_, k) => away.includes(k + 1))) flights.forEach((_, k) => legend[k].shown === away.includes(k + 1) && setShown(k, !away.includes(k + 1)));
    }
    if (asked.compare === "ghost" && worlds > 1) compare.press("ghost");
    if (asked.arms === "10" && bends) arms.press("10");
    const others = (asked.layers ?? "").split(",");
    for (const name of Object.keys(layers)) if (others.includes(name) && switches[name].on === layers[name][1]) switches[name].click();
    if (CAMERAS.includes(asked.camera)) scene.setCamera(asked.camera);
    const wanted = asked.plots ? plotsOf(asked.plots, flights) : [];
    if (wanted.length) plots.choose(wanted);
    if (asked.zoom === "all") plots.restore({ range: null, heights: {} });
    else if (asked.zoom) plots.restore({ range: numbers(asked.zoom), heights: {} });
    if (asked.speed === "auto" || Number(asked.speed) > 0) player.setPace(asked.speed);
    if (asked.t && Number.isFinite(Number(asked.t))) player.seek(Number(asked.t));
  }

  const stored = storedPlots(flights);
  if (stored.length) plots.choose(stored);
  link.follow();
  ready = true;

  window.springback = { scene, player, plots, link, pose: () => ({ ...scene.pose(), playing: player.playing, pace: player.pace }) };
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    flights.forEach((flight, k) => legend[k].element.style.setProperty("--colour", flight.colour));
    player.replace();
  });
  return window.springback;
}

function storedPlots(flights) {
  try {
    return plotsOf(localStorage.getItem(STORED) ?? "", flights);
  } catch {
    return [];
  }
}

/** A flight's name and outcome; a button that hides and shows it if onToggle is given. */
function legendEntry(flight, onToggle) {
  const entry = { shown: true };
  const name = onToggle
    ? create("button", { type: "button", class: "flight", "aria-pressed": "true", title: "Hide or show this flight", onclick: () => onToggle(!entry.shown) }, flight.label)
    : create("b", {}, flight.label);
  entry.element = create("p", { class: `outcome ${flight.success ? "well" : "badly"}` }, name, create("span", {}, ` ${flight.sentence}`));
  entry.element.style.setProperty("--colour", flight.colour);
  entry.mark = (on) => {
    entry.shown = on;
    name.setAttribute("aria-pressed", String(on));
    entry.element.classList.toggle("away", !on);
  };
  return entry;
}

/** What each flight touched, if anything. */
function touchedBy(flights) {
  const lines = flights.flatMap((flight) => flight.touched.map((text) => create("p", {}, flights.length > 1 ? `${flight.label}: ${text}` : text)));
  return lines.length ? [create("details", { class: "about touched", open: flights.length === 1 }, create("summary", {}, "Touched obstacles"), ...lines)] : [];
}

/** Warnings of each flight, if there are any: at the top, as what they tell of may not be in the view. */
function warnedOf(flights) {
  const lines = flights.flatMap((flight) => flight.warnings.map((text) => create("p", {}, flights.length > 1 ? `${flight.label}: ${text}` : text)));
  return lines.length ? [create("details", { class: "about warned", open: true }, create("summary", {}, lines.length > 1 ? "Warnings" : "Warning"), ...lines)] : [];
}

function aboutOf(flights) {
  const notes = flights.flatMap((flight) => [
    ...flight.notes.map((note) => `${flight.label}: ${note}.`),
    flight.shift ? `${flight.label} is shown ${Math.abs(flight.shift).toFixed(3)} s ${flight.shift < 0 ? "earlier" : "later"} than it flew, so that all touch at the same time.` : "",
  ]);
  const error = Math.max(...flights.map((flight) => flight.departure.position)) * 1000;
  notes.push(`Motion between the drawn instants is interpolated linearly: positions are within ${error < 0.01 ? "0.01" : error.toFixed(2)} mm of the flight.`);
  const every = Math.max(...flights.map((flight) => flight.every));
  notes.push("Signals that you choose are rounded to 1/65534 of their range.");
  if (every > 1) notes.push(`Telemetry is shown at every tick near impacts and changes of phase, elsewhere at one tick in ${every}.`);
  return create("details", { class: "about" }, create("summary", {}, "About this view"),
    ...[...new Set(notes)].filter(Boolean).map((note) => create("p", {}, note)),
    create("p", {}, "World axes: x north, y west, z up. Yellow arrows are the contact forces on cages and main body, including friction; the numbers show their vector sum, in which friction on two cages may cancel. Blue bars are the thrust of the rotors; dark discs are vertical shadows."));
}
