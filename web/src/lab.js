// The impact lab: settings on one side, the flight they make on the other; its page and its data
// are springback.interfaces.lab.app.
import "./lab.css";
import { touchOf } from "./flight.js";
import { createControls } from "./lab_controls.js";
import { createDesk } from "./lab_desk.js";
import { createLabPlots } from "./lab_plots.js";
import { createLabTable } from "./lab_table.js";
import { choice, createPlayer, made } from "./player.js";
import { CAMERAS, createScene, together } from "./scene.js";
import { palette } from "./colours.js";

const VIEWS = { impact: "Impact", follow: "Follow", side: "Side", top: "Top", free: "All" };
/** An impact is first shown where springs are most pressed, so long after the touch [s]. */
const PRESSED = 0.012;
/** So long after the last key what is typed counts as said [ms]. */
const PAUSE = 350;
const colourOf = (flight) => palette().robots[flight.label === "Quad" ? 1 : 0];

/** @param data {controls}: the table of settings */
export function startLab(element, data) {
  const page = Math.random().toString(36).slice(2);
  let answer = null;
  let pinned = null;
  let whole = false;
  const latency = [];

  // -- what the page is made of -------------------------------------------------------------------
  const controls = createControls(data.controls, changed);
  const outcomes = made("div", { class: "outcomes", "aria-live": "polite" });
  const alert = made("p", { class: "alert", role: "alert", hidden: true });
  const link = made("input", { class: "link", readonly: true, "aria-label": "Link to these settings", id: "link", onfocus: () => link.select() });
  const copy = made("button", { type: "button", id: "copy", onclick: copied }, "Copy link");
  const pin = made("button", { type: "button", id: "pin", "aria-pressed": "false", title: "Keep this flight behind the next ones, to compare", onclick: togglePin }, "Pin");
  const reset = made("button", { type: "button", id: "reset", title: "Back to the paper's slider test", onclick: () => go("", { push: true }) }, "Reset");
  const files = made("span", { class: "files" });
  const stage = made("div", { class: "stage" });
  const preparing = made("div", { class: "preparing", role: "status", hidden: true });
  const bar = made("div");
  const plotBox = made("div");
  const tableBox = made("div", { class: "measures" });
  const took = made("p", { class: "took" });
  const drawer = made("button", { type: "button", class: "drawer", id: "drawer", "aria-expanded": "false", onclick: () => open(!element.classList.contains("open")) }, "Settings");
  const cameras = choice("Camera", CAMERAS.map((mode) => [mode, VIEWS[mode] ?? mode]), "impact", (mode) => scene.setCamera(mode));
  const compare = choice("Two robots", [["side", "side by side"], ["ghost", "one in the other"]], "side", (mode) => scene.setCompare(mode));
  const timeHead = made("h2");
  const spans = choice("Plots show", [["impact", "impact"], ["all", "all"]], "impact", (which) => {
    whole = which === "all";
    if (answer) drawPlots();
  });

  element.classList.add("lab");
  element.replaceChildren(
    made("header", { class: "top" },
      made("div", { class: "said" }, made("h1", {}, "Impact lab"), outcomes, alert),
      made("div", { class: "actions" }, pin, reset, files, made("span", { class: "linking" }, link, copy))),
    made("main", {},
      made("aside", { class: "settings", id: "settings" }, controls.element, took),
      made("div", { class: "middle" },
        made("div", { class: "frame" }, stage, made("div", { class: "views" }, cameras, compare), preparing), bar, tableBox),
      made("aside", { class: "curves" }, made("div", { class: "plot-head" }, timeHead, spans), plotBox)),
    drawer,
  );

  const scene = createScene(stage, { onCamera: (mode) => cameras.mark(mode) });
  const plots = createLabPlots(plotBox, { onSeek: (t) => (player.pause(), player.seek(t)) });
  const player = createPlayer({ scene, plots: { show: plots.show, replace: () => drawPlots() }, bar });
  const table = createLabTable(tableBox);
  const desk = createDesk(page, { answered, refused, waits, gone });

  // -- settings and answers -----------------------------------------------------------------------
  let typed = 0;
  function changed(name, value, how) {
    clearTimeout(typed);
    const ask = () => desk.ask(controls.query(), { ...how, since: performance.now() });
    if (how.typing) typed = setTimeout(ask, PAUSE);
    else ask();
  }

  function answered(found, asked) {
    const before = answer;
    answer = found;
    element.classList.add("ready");
    if (!asked.aside) say([]);
    preparing.hidden = true;
    if (!asked.typing) controls.show(found.settings);
    else controls.tellProblems([]);
    const first = !before || before.settings.mode !== found.settings.mode;
    const many = found.flights.length !== before?.flights.length;
    scene.replace(found.flights.map((one) => one.scene), { keepCamera: !first && !many });
    for (const flight of scene.flights) flight.colour = colourOf(flight);
    compare.hidden = found.flights.length < 2;
    if (first) spans.mark((whole = found.settings.mode === "flight") ? "all" : "impact");
    player.replace({ keepTime: !first });
    if (first) begin();
    drawOutcomes();
    table.show(found, pinned);
    files.replaceChildren(...found.flights.map((one) => made("a", {
      class: "button", href: `scenario.toml?${[found.query, `of=${one.robot}`].filter(Boolean).join("&")}`, download: one.file, title: `What springback fly takes, of ${one.label}`,
    }, `${one.label}.toml`)));
    remember(found.query, asked);
    requestAnimationFrame(() => {
      const time = performance.now() - asked.since;
      latency.push(time);
      took.textContent = `Flown in ${found.took.flying.toFixed(0)} ms, answered in ${found.took.all.toFixed(0)} ms, drawn after ${time.toFixed(0)} ms.`;
    });
  }

  /** Where a new kind of flight begins to be shown. */
  function begin() {
    const touch = touchOf(scene.flights[0]);
    const impact = answer.settings.mode === "impact";
    const view = impact ? "impact" : "follow";
    cameras.mark(view);
    scene.setCamera(view);
    player.seek(touch === null ? scene.flights[0].begin : impact ? touch + PRESSED : touch);
  }

  function drawPlots() {
    if (!answer) return;
    timeHead.textContent = whole ? "Time [s]" : "Time from touch [ms]";
    plots.replace(scene.flights, { whole });
  }

  function drawOutcomes() {
    outcomes.replaceChildren(...answer.flights.map((one, k) => {
      const line = made("p", { class: `outcome ${one.well ? "well" : "badly"}` }, made("b", {}, one.label), one.sentence.slice(one.label.length));
      line.style.setProperty("--colour", scene.flights[k].colour);
      return line;
    }));
  }

  function say(lines) {
    alert.hidden = !lines.length;
    alert.textContent = lines.join(" ");
  }

  /** The settings are not to be flown: told where they stand, the last flight stays. */
  function refused(lines, asked) {
    preparing.hidden = true;
    controls.tellProblems(lines);
    say([...lines.map((line) => `${line}.`), answer ? "Shown is the flight before." : "The lab is shown as it opens instead."]);
    if (!answer) desk.ask("", { since: performance.now(), aside: true });
  }

  /** Kernels are being compiled: the same is asked again soon. */
  function waits(told) {
    preparing.hidden = false;
    preparing.replaceChildren(made("progress", {}), made("p", {}, `Compiling for ${told.what}: ${Math.round(told.waited)} s so far.`),
      made("p", { class: "words" }, "Once on this machine, 10 s to a minute or two; other settings can be flown meanwhile where they are ready."));
  }

  function gone() {
    say(["The lab does not answer; it may have been ended in its terminal. Any change asks again."]);
  }

  // -- link, history, pin -------------------------------------------------------------------------
  let gesture = false;
  /** Put settings into the address: what one drag or one word goes through is one step of history. */
  function remember(query, { settled = false, aside = false, restored = false }) {
    const address = `${location.pathname}${query ? `?${query}` : ""}`;
    link.value = location.origin + address;
    if (aside || restored) return;
    if (`${location.pathname}${location.search}` !== address) {
      if (gesture) history.replaceState(null, "", address);
      else history.pushState(null, "", address);
    }
    gesture = !settled;
  }

  function go(query, { push = false } = {}) {
    desk.ask(query, { since: performance.now(), settled: push, restored: !push });
  }
  addEventListener("popstate", () => go(location.search.slice(1)));

  async function copied() {
    try {
      await navigator.clipboard.writeText(link.value);
    } catch {
      link.select();
      document.execCommand("copy");
    }
    copy.textContent = "Copied";
    setTimeout(() => (copy.textContent = "Copy link"), 1500);
  }

  function togglePin() {
    pinned = pinned ? null : answer;
    pin.setAttribute("aria-pressed", String(Boolean(pinned)));
    pin.textContent = pinned ? "Unpin" : "Pin";
    const behind = pinned ? together(pinned.flights.map((one) => ({ ...one.scene })), palette()) : [];
    for (const flight of behind) flight.colour = colourOf(flight);
    plots.pin(behind);
    drawPlots();
    table.show(answer, pinned);
  }

  function open(opened) {
    element.classList.toggle("open", opened);
    drawer.setAttribute("aria-expanded", String(opened));
    drawer.textContent = opened ? "Done" : "Settings";
    if (opened) stage.scrollIntoView({ block: "start" });
  }

  controls.show(Object.fromEntries(data.controls.map((one) => [one.name, one.default])));
  go(location.search.slice(1));
  window.springback = {
    scene, player, plots, controls, latency,
    pose: () => ({ ...scene.pose(), playing: player.playing, pace: player.pace }),
    get answer() {
      return answer;
    },
  };
  return window.springback;
}
