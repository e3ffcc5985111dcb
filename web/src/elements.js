// Elements of pages.

/** An element with attributes and children. */
export function create(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false && value != null) element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
}

const ICONS = {
  play: "M7 4.5v15l12.5-7.5z",
  pause: "M6.5 4.5h4v15h-4zM13.5 4.5h4v15h-4z",
  back: "M18 5v14l-9.5-7zM5.5 5h2.4v14H5.5z",
  forth: "M6 5v14l9.5-7zM16.1 5h2.4v14h-2.4z",
  touch: "M4 4h3v16H4zM20 12l-9 6V6z",
  link: "M10.6 13.4a4 4 0 0 0 5.7 0l3-3a4 4 0 1 0-5.7-5.7l-1.6 1.6 1.4 1.4 1.6-1.6a2 2 0 1 1 2.9 2.9l-3 3a2 2 0 0 1-2.9 0zm2.8-2.8a4 4 0 0 0-5.7 0l-3 3a4 4 0 1 0 5.7 5.7l1.6-1.6-1.4-1.4-1.6 1.6a2 2 0 1 1-2.9-2.9l3-3a2 2 0 0 1 2.9 0z",
  picture: "M4 7h4l1.5-2.5h5L16 7h4v12H4zm8 2.5a3.5 3.5 0 1 0 0 7 3.5 3.5 0 0 0 0-7zm0 1.8a1.7 1.7 0 1 1 0 3.4 1.7 1.7 0 0 1 0-3.4z",
  undo: "M9 4 3.5 9.5 9 15v-4h5a3.5 3.5 0 0 1 0 7h-4v2.2h4a5.7 5.7 0 0 0 0-11.4H9z",
  film: "M3 6h12v12H3zM16.5 10.5 21 7.5v9l-4.5-3z",
  full: "M4 4h6v2H6v4H4zM14 4h6v6h-2V6h-4zM4 14h2v4h4v2H4zM18 14h2v6h-6v-2h4z",
  help: "M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zm-1 12.5h2v2h-2zm1-9c-2 0-3.5 1.3-3.5 3.2h2c0-.8.6-1.4 1.5-1.4s1.5.5 1.5 1.3c0 1.4-2.5 1.6-2.5 4.1v.3h2v-.2c0-1.4 2.5-1.8 2.5-4.3 0-1.8-1.5-3-3.5-3z",
};

/** A small picture of a button. */
export function icon(name) {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", "0 0 24 24");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
  path.setAttribute("d", ICONS[name]);
  path.setAttribute("fill-rule", "evenodd");
  svg.append(path);
  return svg;
}

/** Buttons that choose one of several. */
export function choice(label, options, chosen, onchoose) {
  const group = create("div", { class: "choice", role: "group", "aria-label": label });
  for (const [value, name] of options) {
    group.append(create("button", { type: "button", "data-value": value, "aria-pressed": String(value === chosen), onclick: () => {
      mark(value);
      onchoose(value);
    } }, name));
  }
  function mark(value) {
    for (const button of group.children) button.setAttribute("aria-pressed", String(button.dataset.value === value));
  }
  const press = (value) => (mark(value), onchoose(value));
  Object.defineProperty(group, "chosen", { get: () => group.querySelector("[aria-pressed=true]")?.dataset.value });
  return Object.assign(group, { mark, press });
}

/** Mark in a choice of "side" and "ghost" how flights are compared: overlaid where they cannot stand side by side. */
export function markCompare(group, scene) {
  const [side] = group.children;
  side.disabled = scene.tooWide;
  side.title = side.disabled ? "The obstacles are too wide to be put side by side." : "";
  group.mark(scene.compared);
}

/** A button that switches something on and off. */
export function toggle(name, on, onchange, title = "") {
  const button = create("button", { type: "button", title, "aria-pressed": String(on), onclick: () => {
    button.setAttribute("aria-pressed", String(!button.on));
    onchange(button.on);
  } }, name);
  Object.defineProperty(button, "on", { get: () => button.getAttribute("aria-pressed") === "true" });
  return button;
}
