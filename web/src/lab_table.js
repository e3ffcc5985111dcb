// Measures of the robots with printed ones, and those of a pinned flight.
import { create } from "./elements.js";

const format = (value) => {
  if (value === null || value === undefined) return "–";
  if (typeof value === "string") return value;
  const size = Math.abs(value);
  if (size < 5e-4) return "0";
  return value.toFixed(size < 1 ? 3 : size < 10 ? 2 : size < 100 ? 1 : 0);
};

export function createLabTable(element) {
  /** Show the measures of an answer in the colours of its flights, and those of a pinned one. */
  function show(answer, pinned, colours) {
    const robots = answer.flights.map((one) => [one.robot, one.label]);
    const kept = (robot) => pinned?.flights.some((one) => one.robot === robot);
    const printed = answer.measures.some((row) => Object.keys(row.printed).length);
    const head = create("tr", {}, create("th", {}, ""));
    for (const [k, [robot, label]] of robots.entries()) {
      const cell = create("th", { scope: "col" }, label);
      cell.style.color = colours[k];
      head.append(cell);
      if (printed) head.append(create("th", { scope: "col", class: "printed" }, "paper"));
      if (kept(robot)) head.append(create("th", { scope: "col", class: "pinned" }, "pinned"));
    }
    const rows = answer.measures.map((row) => {
      const before = pinned?.measures.find((one) => one.name === row.name);
      const line = create("tr", { "data-measure": row.name }, create("th", { scope: "row" }, row.label, ...(row.unit ? [create("small", {}, ` ${row.unit}`)] : [])));
      for (const [robot] of robots) {
        const beside = [printed && row.printed[robot] ? `paper ${row.printed[robot]}` : "", kept(robot) ? `pinned ${format(before?.values[robot])}` : ""];
        line.append(create("td", { "data-robot": robot, "data-beside": beside.filter(Boolean).join(", ") }, create("b", {}, format(row.values[robot]))));
        if (printed) line.append(create("td", { class: "printed" }, row.printed[robot] ?? ""));
        if (kept(robot)) line.append(create("td", { class: "pinned" }, format(before?.values[robot])));
      }
      return line;
    });
    const { words, same } = answer.printed_for;
    const note = printed ? [create("p", { class: same ? "note" : "note other" }, same ? words : `${words} The settings here differ.`)] : [];
    element.replaceChildren(create("table", {}, create("thead", {}, head), create("tbody", {}, ...rows)), ...note);
    element.classList.toggle("elsewhere", !same);
  }
  return { show };
}
