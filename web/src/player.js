// The player of a replay: a scene, a time line, plots and numbers, all at one instant.
import { create, icon } from "./elements.js";
import { firstTouch, placeOf, poseAt, valueAt } from "./flight.js";
import { given } from "./joints.js";
import { timeLine } from "./pace.js";
import { format } from "./plots.js";

const PACES = [1, 2, 5, 10, 20, 50, 100, 200];
/** Start this long before the first touch [s]. */
const LEAD = 0.25;

/** Row of the compression among the numbers. */
const COMPRESSION = 2;
const isRigid = (flight) => !flight.arms.some((arm) => arm.compliant);

const paceName = (pace) => {
  if (pace > 0.995) return "real time";
  const slower = 1 / pace;
  return `1/${slower < 10 ? slower.toFixed(1).replace(/\.0$/, "") : Math.round(slower)} of real time`;
};

/**
 * Controls, time line and clock around a scene and plots.
 *
 * @param parts {scene, plots, bar, readouts}: a scene, plots or null, and elements to fill
 * @param parts.actions further keys, by name what they do
 * @param parts.onRest called when it shows another instant or pace and does not play
 * @returns {replace, seek, play, pause, setPace, time, playing, dispose}
 */
export function createPlayer({ scene, plots = null, bar, readouts = null, actions = {}, onRest = () => {} }) {
  const state = { t: 0, playing: false, pace: "auto", line: null, flights: [], last: 0 };

  // -- controls -----------------------------------------------------------------------------------
  const playButton = create("button", { class: "play", type: "button", onclick: () => (state.playing ? pause() : play()) });
  const back = create("button", { type: "button", title: "One instant back (←)", "aria-label": "One instant back", onclick: () => step(-1) }, icon("back"));
  const forth = create("button", { type: "button", title: "One instant forward (→)", "aria-label": "One instant forward", onclick: () => step(1) }, icon("forth"));
  const toTouch = create("button", { type: "button", title: "Go to the first touch (T)", "aria-label": "Go to the first touch", onclick: goToTouch }, icon("touch"));
  const pace = create("select", { "aria-label": "Speed", title: "Speed (, and .)", onchange: () => setPace(pace.value) },
    create("option", { value: "auto" }, "slow at impact"),
    ...PACES.map((p) => create("option", { value: String(p) }, p === 1 ? "real time" : `1/${p}`)));
  const clock = create("output", { class: "clock", "aria-live": "off" });
  const slider = create("input", { type: "range", min: 0, max: 1, step: "any", value: 0, "aria-label": "Time", oninput: () => {
    pause();
    seek(state.line.timeAt(Number(slider.value) * state.line.total));
  } });
  const ticks = create("div", { class: "ticks", "aria-hidden": "true" });
  const track = create("div", { class: "track" }, ticks, slider);
  const chips = create("div", { class: "events" });
  bar.classList.add("player");
  bar.replaceChildren(create("div", { class: "buttons" }, playButton, back, forth, toTouch, pace, clock), track, chips);

  // -- time ---------------------------------------------------------------------------------------
  function seek(t) {
    if (!state.line) return;
    state.t = Math.min(Math.max(t, state.line.begin), state.line.end);
    scene.show(state.t);
    plots?.show(state.t);
    const share = state.line.watchedAt(state.t) / state.line.total;
    slider.value = share;
    track.style.setProperty("--share", share);
    tell();
    if (!state.playing) onRest();
  }

  function tell() {
    const touch = firstTouch(state.flights);
    const since = touch === null ? "" : ` · ${state.t >= touch ? "+" : "−"}${Math.abs(1e3 * (state.t - touch)).toFixed(1)} ms from touch`;
    const running = state.pace === "auto" ? state.line.paceAt(state.t) : 1 / Number(state.pace);
    clock.replaceChildren(create("b", {}, `${state.t.toFixed(4)} s`), create("span", {}, since), create("span", { class: "pace" }, paceName(running)));
    slider.setAttribute("aria-valuetext", `${state.t.toFixed(3)} s${since}`);
    if (readouts) tellReadouts();
  }

  function tick(now) {
    if (!state.playing) return;
    const passed = Math.min((now - state.last) / 1000, 0.1);
    state.last = now;
    const line = state.line;
    const t = state.pace === "auto" ? line.timeAt(line.watchedAt(state.t) + passed) : state.t + passed / Number(state.pace);
    seek(t);
    if (state.t >= line.end) pause();
    else requestAnimationFrame(tick);
  }

  function play() {
    if (!state.line || state.playing) return;
    if (state.t >= state.line.end - 1e-9) seek(state.line.begin);
    state.playing = true;
    state.last = performance.now();
    tellButton();
    requestAnimationFrame(tick);
  }

  function pause() {
    if (state.playing) setTimeout(onRest);
    state.playing = false;
    tellButton();
  }

  function tellButton() {
    playButton.replaceChildren(icon(state.playing ? "pause" : "play"));
    playButton.setAttribute("aria-label", state.playing ? "Pause" : "Play");
    playButton.title = state.playing ? "Pause (space)" : "Play (space)";
  }

  function setPace(value) {
    state.pace = value === "auto" ? "auto" : String(PACES.reduce((a, b) => (Math.abs(b - value) < Math.abs(a - value) ? b : a)));
    pace.value = state.pace;
    tell();
    onRest();
  }

  function slower(by) {
    const now = state.pace === "auto" ? (by > 0 ? 0 : 1) : PACES.indexOf(Number(state.pace)) + by;
    setPace(PACES[Math.min(Math.max(now, 0), PACES.length - 1)]);
  }

  /** Go to the next or the previous computed instant. */
  function step(by) {
    pause();
    const flight = state.flights[0];
    const own = state.t - flight.shift;
    const place = placeOf(flight.t, own + 1e-9);
    const on = flight.t[place] < own - 1e-9 && by < 0 ? place : place + by;
    seek(flight.t[Math.min(Math.max(on, 0), flight.n - 1)] + flight.shift);
  }

  function goToTouch() {
    pause();
    const touch = firstTouch(state.flights);
    if (touch !== null) seek(touch);
  }

  // -- events -------------------------------------------------------------------------------------
  function drawTicks() {
    const line = state.line;
    const share = (t) => line.watchedAt(t) / line.total;
    ticks.replaceChildren(...line.stretches.map(([from, to]) => {
      const band = create("span", { class: "slow" });
      band.style.left = `${100 * share(from)}%`;
      band.style.width = `${100 * Math.max(share(to) - share(from), 0.002)}%`;
      return band;
    }));
    const events = state.flights.flatMap((flight) =>
      flight.events.map((event) => ({ ...event, t: event.t + flight.shift, flight })));
    events.sort((a, b) => a.t - b.t);
    for (const event of events) {
      const mark = create("i", { class: event.kind });
      mark.style.left = `${100 * share(event.t)}%`;
      if (state.flights.length > 1) mark.style.background = event.flight.colour;
      ticks.append(mark);
    }
    const several = state.flights.length > 1;
    chips.replaceChildren(...events.filter((event) => event.kind !== "end" || !several).slice(0, 60).map((event) => {
      const name = several ? `${event.flight.label}: ${event.label}` : event.label;
      const chip = create("button", { type: "button", class: `event ${event.kind}`, title: `${event.text}, ${event.t.toFixed(4)} s`, onclick: () => {
        pause();
        seek(event.t);
      } }, create("span", {}, name), create("small", {}, ` ${event.t.toFixed(3)} s`));
      if (several) chip.style.setProperty("--colour", event.flight.colour);
      return chip;
    }));
  }

  // -- numbers ------------------------------------------------------------------------------------
  let cells = [];

  function prepareReadouts() {
    if (!readouts) return;
    const rows = ["speed", "acceleration", "compression, largest", "contact force, sum of all contacts", "thrust, all rotors"];
    const units = ["m/s", "m/s²", "mm", "N", "N"];
    const crowded = state.flights.length > 2;
    const table = create("table", { class: crowded ? "numbers crowded" : "numbers" });
    if (state.flights.length > 1) {
      table.append(create("thead", {}, create("tr", {}, create("th", {}, ""), ...state.flights.map((f) => {
        const head = create("th", { scope: "col" }, f.label);
        head.style.color = f.colour;
        return head;
      }), ...(crowded ? [] : [create("th", {}, "")]))));
    }
    const body = create("tbody");
    cells = rows.map((name, k) => {
      const values = state.flights.map(() => create("td"));
      const unit = create("td", { class: "unit" }, k === COMPRESSION && state.flights.every(isRigid) ? "" : units[k]);
      body.append(create("tr", {}, create("th", { scope: "row" }, crowded ? `${name} [${units[k]}]` : name), ...values, ...(crowded ? [] : [unit])));
      return values;
    });
    table.append(body);
    readouts.replaceChildren(table);
  }

  function tellReadouts() {
    state.flights.forEach((flight, k) => {
      const pose = poseAt(flight, state.t);
      const find = (panel) => flight.series.find((one) => one.panel === panel);
      const value = (panel) => (find(panel) ? valueAt({ flight, values: find(panel).values }, state.t) : 0);
      const pressed = Math.max(0, ...flight.arms.map((arm, j) => (arm.compliant ? 1e3 * given(arm, pose.armLengths[j], pose.bends[j]) : 0)));
      const force = Math.hypot(...[0, 1, 2].map((c) => pose.contacts.reduce((sum, one) => sum + (one ? one.force[c] : 0), 0)));
      const numbers = [value("Velocity"), value("Acceleration"), pressed, force, pose.thrust.reduce((a, b) => a + b, 0)];
      numbers.forEach((number, row) => (cells[row][k].textContent = row === COMPRESSION && isRigid(flight) ? "rigid" : format(number)));
    });
  }

  // -- keyboard -----------------------------------------------------------------------------------
  function pressed(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest?.("dialog")) return;
    const tag = event.target.tagName;
    if (tag === "TEXTAREA" || tag === "SELECT" || (tag === "INPUT" && event.target.type !== "range")) return;
    if (event.target.type === "range" && event.target !== slider) return;
    const by = event.shiftKey ? 10 : 1;
    const all = {
      " ": () => (state.playing ? pause() : play()),
      ArrowRight: () => step(by), ArrowLeft: () => step(-by),
      Home: () => (pause(), seek(state.line.begin)), End: () => (pause(), seek(state.line.end)),
      ",": () => slower(1), ".": () => slower(-1), t: goToTouch, ...actions,
    };
    if (event.key === " " && tag === "BUTTON") return; // it presses the button
    const act = all[event.key];
    if (!act || !state.line) return;
    if (act() !== false) event.preventDefault();
  }
  document.addEventListener("keydown", pressed);

  /** Switch to the flights of the scene; the time is kept if possible. */
  function replace({ keepTime = true } = {}) {
    state.flights = scene.flights;
    state.line = timeLine(state.flights);
    prepareReadouts();
    plots?.replace(state.flights);
    drawTicks();
    const touch = firstTouch(state.flights);
    seek(keepTime ? state.t : touch === null ? state.line.begin : touch - LEAD);
  }

  tellButton();
  return {
    replace, seek, play, pause, setPace, goToTouch,
    get time() {
      return state.t;
    },
    get playing() {
      return state.playing;
    },
    get pace() {
      return state.pace;
    },
    dispose() {
      pause();
      document.removeEventListener("keydown", pressed);
      bar.replaceChildren();
    },
  };
}
