// The controls of the lab, built from the table that the server sends: sliders with a field and the
// paper's values as marks, and choices.  The server validates values.
import { choice, create } from "./elements.js";

const SHARES = 1000;

const rounded = (value, step) => Number((Math.round(value / step) * step).toFixed(6));

/** Position of a value on a slider, from 0 to 1. */
function shareOf(control, value) {
  const { least, most, logarithmic } = control;
  const share = logarithmic ? Math.log(value / least) / Math.log(most / least) : (value - least) / (most - least);
  return Math.min(Math.max(share, 0), 1);
}

function valueAt(control, share) {
  const { least, most, step, logarithmic } = control;
  const value = logarithmic ? least * (most / least) ** share : least + (most - least) * share;
  const digits = logarithmic ? 10 ** Math.max(Math.floor(Math.log10(value)) - 1, Math.log10(step)) : step;
  return Math.min(Math.max(rounded(value, Math.max(digits, step)), least), most);
}

function sliderControl(control, changed) {
  const id = `set-${control.name}`;
  const unit = control.unit.replace("^1.5", "¹·⁵");
  const slider = create("input", {
    type: "range", min: 0, max: SHARES, step: 1, id: `${id}-slider`, "aria-label": control.label,
    oninput: () => set(valueAt(control, Number(slider.value) / SHARES), { moving: true }),
    onchange: () => changed(control.name, field.value, { settled: true }),
    onkeydown: (event) => {
      const by = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageUp: 10, PageDown: -10 }[event.key];
      if (!by) return;
      event.preventDefault();
      const now = Number(field.value);
      if (Number.isFinite(now)) set(Math.min(Math.max(rounded(now + by * control.step, control.step), control.least), control.most), { settled: true });
    },
  });
  const field = create("input", {
    type: "text", inputmode: "decimal", id, autocomplete: "off", spellcheck: "false", maxlength: 40,
    "aria-describedby": `${id}-words`, oninput: () => changed(control.name, field.value.trim(), { typing: true }),
    onchange: () => changed(control.name, field.value.trim(), { settled: true }),
  });
  const words = create("p", { class: "words", id: `${id}-words` });
  const marks = create("div", { class: "marks" }, ...control.marks.map((mark, k) => {
    const wide = (one) => String(one.value).length * 0.013 + 0.01; // half the width of a label, as an approximate share of the rail
    const near = control.marks.some((one, i) => i < k && Math.abs(shareOf(control, one.value) - shareOf(control, mark.value)) < wide(one) + wide(mark));
    const tick = create("button", {
      type: "button", class: near ? "tight" : "", title: `${mark.value} ${unit}, ${mark.words}`, "aria-label": `${control.label} ${mark.value} ${unit}, ${mark.words}`,
      onclick: () => set(mark.value, { settled: true }),
    }, create("span", {}, String(mark.value)));
    tick.style.setProperty("--share", shareOf(control, mark.value));
    return tick;
  }));
  const element = create("div", { class: "slider-control", "data-name": control.name },
    create("label", { for: id }, control.label), create("span", { class: "field" }, field, create("span", { class: "unit" }, unit)),
    create("div", { class: "rail" }, slider, marks), words);

  function show(value) {
    const number = Number(value);
    if (field.value.trim() !== String(value)) field.value = String(value);
    if (Number.isFinite(number)) {
      slider.value = Math.round(shareOf(control, number) * SHARES);
      slider.setAttribute("aria-valuetext", `${value} ${unit}`);
    }
    tellProblem("");
  }
  /** Source of this value, else the meaning of the number. */
  function describe() {
    const mark = control.marks.find((one) => one.value === Number(field.value));
    words.className = mark ? "words printed" : "words";
    words.textContent = mark ? `= ${mark.words}` : control.explains;
  }
  function set(value, how) {
    show(value);
    changed(control.name, String(value), how);
  }
  function tellProblem(text) {
    field.setAttribute("aria-invalid", String(Boolean(text)));
    element.classList.toggle("wrong", Boolean(text));
    if (text) words.textContent = text;
    else describe();
  }
  element.title = control.explains;
  const pick = (value) => set(valueAt(control, shareOf(control, value)), { settled: true });
  return { element, show, tellProblem, pick };
}

/** A number that cannot be set here, with the reason. */
function fixedControl(control) {
  const words = create("p", { class: "words" }, control.explains);
  const element = create("div", { class: "fixed-control", "data-name": control.name }, create("span", { class: "label" }, control.label), words);
  const tellProblem = (text) => (words.textContent = text || control.explains);
  return { element, show: () => {}, tellProblem };
}

function choiceControl(control, changed) {
  const many = Object.keys(control.words).length > 3;
  const words = create("p", { class: "words" }, control.explains);
  const set = (value) => changed(control.name, value, { settled: true });
  if (!many) {
    const group = choice(control.label, Object.entries(control.words), control.default, set);
    const element = create("div", { class: "picked", "data-name": control.name, title: control.explains }, create("span", { class: "label" }, control.label), group);
    return { element, show: group.mark, tellProblem: () => {} };
  }
  const select = create("select", { id: `set-${control.name}`, onchange: () => set(select.value) },
    ...Object.entries(control.words).map(([value, name]) => create("option", { value }, name)));
  const element = create("div", { class: "picked", "data-name": control.name, title: control.explains }, create("label", { for: `set-${control.name}` }, control.label), select, words);
  return { element, show: (value) => (select.value = value), tellProblem: (text) => (words.textContent = text || control.explains) };
}

const KINDS = { slider: sliderControl, fixed: fixedControl, choice: choiceControl };

/**
 * A form with all controls.
 *
 * @param controls the table, from springback.interfaces.lab.settings.controls
 * @param changed called with name, text and {moving, typing, settled}
 * @returns {element, values, query, show, showQuery, tellProblems, isShown, pick}: values are texts as typed
 */
export function createControls(controls, changed) {
  const values = {};
  const parts = {};
  const groups = new Map();
  const onChange = (name, value, how) => {
    values[name] = value;
    hide();
    changed(name, value, how);
  };
  for (const control of controls) {
    values[control.name] = String(control.default);
    parts[control.name] = KINDS[control.kind](control, onChange);
    if (!groups.has(control.group)) groups.set(control.group, []);
    groups.get(control.group).push(parts[control.name].element);
  }
  const sections = [...groups].map(([name, elements]) =>
    create("section", {}, ...(name ? [create("h2", {}, name)] : []), ...elements));
  const element = create("form", { class: "controls", onsubmit: (event) => event.preventDefault() }, ...sections);

  /** Hide settings without effect. */
  function hide() {
    for (const control of controls) {
      const acts = Object.entries(control.when).every(([other, words]) => words.includes(values[other]));
      parts[control.name].element.hidden = !acts;
    }
    sections.forEach((section) => (section.hidden = ![...section.querySelectorAll("[data-name]")].some((one) => !one.hidden)));
  }

  /** Show the settings that the server returns. */
  function show(settings) {
    for (const [name, value] of Object.entries(settings)) {
      values[name] = String(value);
      parts[name]?.show(value);
    }
    hide();
  }

  /** Show the settings of a query, at once: the flight may be long in coming. */
  function showQuery(query) {
    const asked = new URLSearchParams(query);
    show(Object.fromEntries(controls.map(({ name, words, default: own }) => {
      const value = asked.get(name);
      return [name, value === null || (words && !(value in words)) ? own : value];
    })));
  }

  /** Show problems beside their settings. */
  function tellProblems(lines) {
    for (const part of Object.values(parts)) part.tellProblem("");
    for (const line of lines) {
      const field = line.split(":")[0];
      const name = field in parts ? field : controls.find((one) => one.path === field)?.name;
      parts[name]?.tellProblem(line.slice(field.length + 1).trim());
    }
  }

  const query = () => controls.filter((one) => values[one.name] !== String(one.default))
    .map((one) => `${one.name}=${encodeURIComponent(values[one.name])}`).join("&");
  hide();
  const isShown = (name) => !parts[name].element.hidden;
  const pick = (name, value) => parts[name].pick(value);
  return { element, values, query, show, showQuery, tellProblems, isShown, pick };
}
