// The impact lab: settings on one side, the resulting flight on the other; its page and its data
// come from springback.interfaces.lab.app.
import "./lab.css";
import { touchOf } from "./flight.js";
import { createControls } from "./lab_controls.js";
import { createQueue } from "./lab_queue.js";
import { createLabPlots } from "./lab_plots.js";
import { createLabSweep } from "./lab_sweep.js";
import { createFullScreen } from "./full_screen.js";
import { createLabTable } from "./lab_table.js";
import { choice, create, markCompare } from "./elements.js";
import { createPlayer } from "./player.js";
import { CAMERAS, createScene, together } from "./scene.js";
import { palette } from "./colours.js";

const VIEWS = { impact: "Impact", follow: "Follow", side: "Side", top: "Top", free: "All" };
/** Initial instant of an impact after the touch, about at the largest compression [s]. */
const PRESSED = 0.012;
/** Time after the last key at which typed input is sent [ms]. */
const PAUSE = 350;

/** @param data {controls, sweeps, file}: the table of settings, what can be swept, the user's file */
export function startLab(element, data) {
  const page = Math.random().toString(36).slice(2);
  let answer = null;
  let pinned = null;
  let whole = false;
  const latency = [];

  // -- elements of the page -----------------------------------------------------------------------
  const controls = createControls(data.controls, changed);
  const outcomes = create("div", { class: "outcomes", "aria-live": "polite" });
  const alert = create("p", { class: "alert", role: "alert", hidden: true });
  const link = create("input", { class: "link", readonly: true, "aria-label": "Link to these settings", id: "link", onfocus: () => link.select() });
  const copy = create("button", { type: "button", id: "copy", onclick: copyLink }, "Copy link");
  const pin = create("button", { type: "button", id: "pin", "aria-pressed": "false", title: "Keep this flight behind the next ones for comparison", onclick: togglePin }, "Pin");
  const reset = create("button", { type: "button", id: "reset", title: data.file ? `Return to ${data.file}` : "Return to the paper's slider test", onclick: () => go("", { push: true }) }, "Reset");
  const files = create("span", { class: "files" });
  const stage = create("div", { class: "stage" });
  const preparing = create("div", { class: "preparing", role: "status", hidden: true });
  const bar = create("div");
  const plotBox = create("div");
  const tableBox = create("div", { class: "measures" });
  const sweepBox = create("div");
  const lock = create("button", { type: "button", id: "lock", "aria-pressed": "false", title: "Keep the vertical scales of all plots as they are", onclick: toggleLock }, "Lock y");
  const took = create("p", { class: "took" });
  const drawer = create("button", { type: "button", class: "drawer", id: "drawer", "aria-expanded": "false", onclick: () => open(!element.classList.contains("open")) }, "Settings");
  const cameras = choice("Camera", CAMERAS.filter((mode) => VIEWS[mode]).map((mode) => [mode, VIEWS[mode]]), "impact", (mode) => scene.setCamera(mode));
  const compare = choice("Two robots", [["side", "side by side"], ["ghost", "overlaid"]], "side", (mode) => (scene.setCompare(mode), markCompare(compare, scene)));
  const timeHead = create("h2");
  const spans = choice("Plots show", [["impact", "impact"], ["all", "all"]], "impact", (which) => {
    whole = which === "all";
    if (answer) drawPlots();
  });

  const fullScreen = createFullScreen(() => middle, () => say(["This browser refuses full screen."]));
  const middle = create("div", { class: "middle" },
    create("div", { class: "frame" }, stage, create("div", { class: "views" }, cameras, compare, fullScreen.button), preparing), bar, tableBox);

  element.classList.add("lab");
  element.replaceChildren(
    create("header", { class: "top" },
      create("div", { class: "said" }, create("h1", {}, "Impact lab", ...(data.file ? [create("small", {}, data.file)] : [])), outcomes, alert),
      create("div", { class: "actions" }, pin, reset, files, create("span", { class: "linking" }, link, copy))),
    create("main", {},
      create("aside", { class: "settings", id: "settings" }, controls.element, took),
      middle,
      create("aside", { class: "curves" }, sweepBox, create("div", { class: "plot-head" }, timeHead, lock, spans), plotBox)),
    drawer,
  );

  const scene = createScene(stage, { onCamera: (mode) => cameras.mark(mode) });
  const plots = createLabPlots(plotBox, { onSeek: (t) => (player.pause(), player.seek(t)) });
  const player = createPlayer({ scene, plots: { show: plots.show, replace: () => drawPlots() }, bar, actions: { f: fullScreen.toggle } });
  const table = createLabTable(tableBox);
  const sweep = createLabSweep(sweepBox, {
    choices: data.sweeps, table: data.controls, page, isShown: controls.isShown, onPick: controls.pick,
    onChoice: () => answer && remember(answer.query, { settled: true }),
  });
  const queue = createQueue(page, { answered, refused, waits, gone });

  // -- settings and answers -----------------------------------------------------------------------
  let typed = 0;
  let moving = false;
  function changed(name, value, how) {
    clearTimeout(typed);
    const ask = () => queue.ask(controls.query(), { ...how, since: performance.now() });
    if (how.typing) typed = setTimeout(ask, PAUSE);
    else ask();
  }

  function answered(found, how) {
    const before = answer;
    answer = found;
    element.classList.add("ready");
    if (!how.aside) say([]);
    preparing.hidden = true;
    if (!how.typing && !how.older) controls.show(found.settings); // an older answer does not undo a choice
    else controls.tellProblems([]);
    const first = !before || before.settings.mode !== found.settings.mode;
    const many = found.flights.length !== before?.flights.length;
    const seconds = found.flights.flatMap((one) => (one.second ? [one.second] : [])); // after the others, whose order counts
    scene.replace([...found.flights.map((one) => one.scene), ...seconds], { keepCamera: !first && !many });
    compare.hidden = found.flights.length < 2;
    markCompare(compare, scene);
    if (first) spans.mark((whole = found.is_piloted) ? "all" : "impact");
    moving = Boolean(how.moving);
    player.replace({ keepTime: !first });
    if (first) begin();
    drawOutcomes();
    showTable();
    sweep.show(found, how);
    files.replaceChildren(...found.flights.map((one) => create("a", {
      class: "button", href: `scenario.toml?${[found.query, `of=${one.robot}`].filter(Boolean).join("&")}`, download: one.file, title: `Scenario for springback fly, ${one.label}`,
    }, `${one.label}.toml`)));
    remember(found.query, how);
    requestAnimationFrame(() => {
      const time = performance.now() - how.since;
      latency.push(time);
      took.textContent = `Flown in ${found.took.flying.toFixed(0)} ms, answered in ${found.took.all.toFixed(0)} ms, drawn after ${time.toFixed(0)} ms.`;
    });
  }

  /** Initial camera and instant of a new kind of flight. */
  function begin() {
    const touch = touchOf(scene.flights[0]);
    const impact = !answer.is_piloted;
    const view = impact ? "impact" : "follow";
    cameras.mark(view);
    scene.setCamera(view);
    player.seek(touch === null ? scene.flights[0].begin : impact ? touch + PRESSED : touch);
  }

  function drawPlots() {
    if (!answer) return;
    timeHead.textContent = whole ? "Time [s]" : "Time from touch [ms]";
    plots.replace(scene.flights, { whole, moving });
  }

  function drawOutcomes() {
    outcomes.replaceChildren(...answer.flights.map((one, k) => {
      const line = create("p", { class: `outcome ${one.well ? "well" : "badly"}` }, create("b", {}, one.label), one.sentence.slice(one.label.length));
      line.style.setProperty("--colour", scene.flights[k].colour);
      return line;
    }));
  }

  const showTable = () => table.show(answer, pinned, scene.flights.map((one) => one.colour));

  function toggleLock() {
    const on = lock.getAttribute("aria-pressed") !== "true";
    lock.setAttribute("aria-pressed", String(on));
    plots.lock(on);
    drawPlots();
  }

  function say(lines) {
    alert.hidden = !lines.length;
    alert.textContent = lines.join(" ");
  }

  /** The settings cannot be flown: show the problems beside them, and keep the last flight. */
  function refused(lines, how) {
    preparing.hidden = true;
    controls.tellProblems(lines);
    say([...lines.map((line) => `${line}.`), answer ? "The previous flight is shown." : "The default flight is shown instead."]);
    if (!answer) queue.ask("", { since: performance.now(), aside: true });
  }

  /** Kernels are being compiled: the request is repeated soon. */
  function waits(kind) {
    preparing.hidden = false;
    preparing.replaceChildren(create("progress", {}), create("p", {}, `Compiling for ${kind.what}, about ${kind.about} s: ${Math.round(kind.waited)} s so far.`),
      create("p", { class: "words" }, `Once on this machine; ${answer ? "the previous flight stays, and " : ""}other settings can be flown meanwhile if they are ready.`));
  }

  function gone() {
    say(["The lab does not respond; it may have been stopped in its terminal. Any change tries again."]);
  }

  // -- link, history, pin -------------------------------------------------------------------------
  let gesture = false;
  /** Put settings into the address; one drag or one typed word is one step of the history. */
  function remember(query, { settled = false, aside = false, restored = false }) {
    const address = `${location.pathname}${query ? `?${query}` : ""}${sweep.hash()}`;
    link.value = location.origin + address;
    if (aside || restored) return;
    if (`${location.pathname}${location.search}${location.hash}` !== address) {
      if (gesture) history.replaceState(null, "", address);
      else history.pushState(null, "", address);
    }
    gesture = !settled;
  }

  function go(query, { push = false } = {}) {
    controls.showQuery(query);
    queue.ask(query, { since: performance.now(), settled: push, restored: !push });
  }
  addEventListener("popstate", () => (sweep.restore(location.hash), go(location.search.slice(1))));

  async function copyLink() {
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
    plots.pin(behind);
    drawPlots();
    showTable();
  }

  function open(opened) {
    element.classList.toggle("open", opened);
    drawer.setAttribute("aria-expanded", String(opened));
    drawer.textContent = opened ? "Done" : "Settings";
    if (opened) stage.scrollIntoView({ block: "start" });
  }

  sweep.restore(location.hash);
  go(location.search.slice(1));
  window.springback = {
    scene, player, plots, controls, sweep, latency,
    pose: () => ({ ...scene.pose(), playing: player.playing, pace: player.pace }),
    get answer() {
      return answer;
    },
  };
  return window.springback;
}
