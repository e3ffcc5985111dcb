// Measures of the robots beside print, and beside a pinned flight.
import { palette } from "./colours.js";
import { made } from "./player.js";

const told = (value) => {
  if (value === null || value === undefined) return "–";
  if (typeof value === "string") return value;
  const size = Math.abs(value);
  if (size < 5e-4) return "0";
  return value.toFixed(size < 1 ? 3 : size < 10 ? 2 : size < 100 ? 1 : 0);
};

export function createLabTable(element) {
  /** Show measures of an answer, and those of a pinned one. */
  function show(answer, pinned) {
    const robots = answer.flights.map((one) => [one.robot, one.label]);
    const kept = (robot) => pinned?.flights.some((one) => one.robot === robot);
    const printed = answer.measures.some((row) => Object.keys(row.printed).length);
    const head = made("tr", {}, made("th", {}, ""));
    for (const [robot, label] of robots) {
      const cell = made("th", { scope: "col" }, label);
      cell.style.color = palette().robots[robot === "quad" ? 1 : 0];
      head.append(cell);
      if (printed) head.append(made("th", { scope: "col", class: "printed" }, "paper"));
      if (kept(robot)) head.append(made("th", { scope: "col", class: "pinned" }, "pinned"));
    }
    const rows = answer.measures.map((row) => {
      const before = pinned?.measures.find((one) => one.name === row.name);
      const line = made("tr", { "data-measure": row.name }, made("th", { scope: "row" }, row.label, ...(row.unit ? [made("small", {}, ` ${row.unit}`)] : [])));
      for (const [robot] of robots) {
        const beside = [printed && row.printed[robot] ? `paper ${row.printed[robot]}` : "", kept(robot) ? `pinned ${told(before?.values[robot])}` : ""];
        line.append(made("td", { "data-robot": robot, "data-beside": beside.filter(Boolean).join(", ") }, made("b", {}, told(row.values[robot]))));
        if (printed) line.append(made("td", { class: "printed" }, row.printed[robot] ?? ""));
        if (kept(robot)) line.append(made("td", { class: "pinned" }, told(before?.values[robot])));
      }
      return line;
    });
    const { words, same } = answer.printed_for;
    const note = printed ? [made("p", { class: same ? "note" : "note other" }, same ? words : `${words} Here other settings fly.`)] : [];
    element.replaceChildren(made("table", {}, made("thead", {}, head), made("tbody", {}, ...rows)), ...note);
    element.classList.toggle("elsewhere", !same);
  }
  return { show };
}
