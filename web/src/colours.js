// Colours of Okabe and Ito, as in springback.interfaces.output.robots; lighter ones of the same hues if
// the page is dark.
export const isDark = () => matchMedia("(prefers-color-scheme: dark)").matches;

const LIGHT = {
  background: "#f3f5f8", ink: "#222222", faint: "#8c8c8c", line: "#c3cad4",
  wall: "#7d8794", shapes: ["#7d8794", "#94806a", "#6f8f7c", "#8b7a99", "#6b8fa3", "#a3827f"], mat: "#009e73", ground: "#a8aeb7", metal: "#5b6470", dark: "#30363d",
  arms: ["#0072b2", "#d98a00", "#009e73", "#cc79a7", "#3a9bd9", "#8c8c8c"],
  robots: ["#0072b2", "#d55e00", "#007a5a", "#a8488a", "#8a6d00", "#1b2a6b", "#6b6b6b", "#7a1f1f"], force: "#e69f00", thrust: "#56b4e9", before: "#8c8c8c",
};
const DARK = {
  background: "#14181d", ink: "#e6e9ed", faint: "#9aa3ad", line: "#3a434e",
  wall: "#98a3b1", shapes: ["#98a3b1", "#b5a089", "#8db39b", "#ac9abd", "#88b0c6", "#c4a19d"], mat: "#2cc79a", ground: "#59626d", metal: "#aab4c0", dark: "#cdd4dc",
  arms: ["#4ea8e0", "#f0b429", "#35c79b", "#e29cc4", "#8fd0f5", "#a7b0ba"],
  robots: ["#4ea8e0", "#ff8a3d", "#35c79b", "#e29cc4", "#e3cf57", "#a9b4ff", "#c9d1d9", "#ff8f8f"], force: "#ffc13d", thrust: "#7cc8f2", before: "#a7b0ba",
};

/** The present colours of the page. */
export const palette = () => (isDark() ? DARK : LIGHT);
