// Signals of a flight: all columns of its trajectory and telemetry, as springback.interfaces.replay.signals packs them.
import { unzlibSync } from "fflate";

const bytesOf = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));

/** All columns of a table, each a Float64Array over n instants. */
function columnsOf(table, n) {
  const bytes = unzlibSync(bytesOf(table.data));
  return table.columns.map(({ low, step }, k) => {
    const from = 2 * n * k;
    const values = new Float64Array(n);
    for (let i = 0, level = 0; i < n; i++) {
      level = (level + bytes[from + i] + 256 * bytes[from + n + i]) & 0xffff;
      values[i] = low + step * level;
    }
    return values;
  });
}

/**
 * Signals by name: {name, unit, group, held, words, t, values, shown}; a table is unpacked at its first use.
 *
 * values are in SI; shown are those in the unit in which they are shown.
 *
 * Telemetry is held from tick to tick; words are those of the values 0, 1, ….
 */
export function signalsOf(tables) {
  const found = new Map();
  if (!tables) return found;
  for (const clock of ["trajectory", "telemetry"].filter((one) => tables[one])) {
    const table = tables[clock];
    const t = new Float64Array(bytesOf(table.t.data).buffer);
    let columns = null;
    const scaled = [];
    table.columns.forEach(({ name, unit, factor, group }, k) => found.set(name, {
      name, unit, group, t, held: clock === "telemetry", words: tables.words[name],
      get values() {
        columns ??= columnsOf(table, t.length);
        return columns[k];
      },
      get shown() {
        scaled[k] ??= factor === 1 ? this.values : this.values.map((value) => factor * value);
        return scaled[k];
      },
    }));
  }
  return found;
}
