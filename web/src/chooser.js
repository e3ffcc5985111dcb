// The dialog in which the signals of a plot are chosen.
import { create } from "./elements.js";
import { byUnit } from "./panels.js";

/**
 * @param options.signals signals by name, of signals.js
 * @param options.standard names of the standard panels
 * @param options.onChoose called with the list of all plots
 * @returns {element, open(plots, index)}: index is that of a plot to change, or none to add some
 */
export function createChooser({ signals, standard, onChoose }) {
  const search = create("input", { type: "search", placeholder: "est, N, phase, …", "aria-label": "Search signals", oninput: filter });
  const title = create("h2", { id: "chooser-title" });
  const count = create("span", { class: "count", role: "status" });
  const box = (value, name, unit) => create("label", { "data-words": `${value} ${name}`.toLowerCase() },
    create("input", { type: "checkbox", value, onchange: tell }), value, ...(unit ? [create("small", {}, unit)] : []));
  const group = (name, ...boxes) => {
    const field = create("fieldset", {}, create("legend", {}, name), ...boxes);
    if (boxes.length > 1) field.firstChild.append(create("button", { type: "button", class: "small", "aria-label": `All of ${name}, or none`, onclick: () => {
      const inputs = [...field.querySelectorAll("label:not([hidden]) input")];
      const on = !inputs.every((one) => one.checked);
      inputs.forEach((one) => (one.checked = on));
      tell();
    } }, "all"));
    return field;
  };
  const panels = group("Standard plots", ...standard.map((name) => box(name, "standard")));
  const groups = new Map();
  for (const { name, unit, group: of } of signals.values()) {
    const words = [of, unit, unit === "m/s²" ? "acceleration" : ""].join(" ");
    groups.set(of, [...(groups.get(of) ?? []), box(name, words, unit)]);
  }
  const list = create("div", { class: "signals" }, panels, ...[...groups].map(([name, boxes]) => group(name, ...boxes)));
  const none = create("p", { hidden: true }, "No signal of this flight matches.");
  const form = create("form", { method: "dialog", onsubmit: accept },
    title, create("p", { class: "hint" }, "Signals of one unit share a plot. Names are those of the columns in the files of the result."),
    search, list, none,
    create("div", { class: "actions" }, count,
      create("button", { type: "button", onclick: () => (onChoose(null), element.close()) }, "Only standard plots"),
      create("button", { type: "button", onclick: () => element.close() }, "Cancel"),
      create("button", { type: "submit", class: "main" }, "Plot")));
  const element = create("dialog", { class: "chooser", "aria-labelledby": "chooser-title" }, form);
  let plots = [];
  let edited = null;

  const checked = (within) => [...within.querySelectorAll("input[type=checkbox]:checked")].map((one) => one.value);
  const names = () => [...list.children].filter((one) => one !== panels).flatMap(checked);

  function filter() {
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const field of list.children) {
      const labels = [...field.querySelectorAll("label")];
      labels.forEach((label) => (label.hidden = !words.every((word) => label.dataset.words.includes(word))));
      field.hidden = labels.every((label) => label.hidden) || (field === panels && edited !== null);
    }
    none.hidden = [...list.children].some((field) => !field.hidden);
  }

  function tell() {
    const chosen = names();
    const many = byUnit(chosen, signals).length;
    count.textContent = chosen.length ? `${chosen.length} signal${chosen.length > 1 ? "s" : ""} in ${many} plot${many > 1 ? "s" : ""}` : "";
  }

  function accept() {
    const own = byUnit(names(), signals);
    if (edited !== null) onChoose(plots.flatMap((plot, k) => (k === edited ? own : [plot])));
    else {
      const wanted = checked(panels);
      const kept = plots.filter((plot) => Array.isArray(plot) || wanted.includes(plot));
      onChoose([...kept, ...wanted.filter((name) => !plots.includes(name)), ...own]);
    }
  }

  function open(all, index = null) {
    [plots, edited] = [all, index];
    const on = index === null ? all.filter((plot) => !Array.isArray(plot)) : all[index];
    list.querySelectorAll("input").forEach((one) => (one.checked = on.includes(one.value)));
    title.textContent = index === null ? "Add plots" : "Change a plot";
    search.value = "";
    filter();
    tell();
    element.showModal();
    search.focus();
  }

  return { element, open };
}
