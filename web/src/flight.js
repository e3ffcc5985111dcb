// A flight from springback.interfaces.replay.scene, unpacked for evaluation at any instant.
import { signalsOf } from "./signals.js";

const KINDS = { f4: Float32Array, f8: Float64Array, i4: Int32Array };

/** The numbers of a packed array. */
export function unpacked(packed) {
  const bytes = Uint8Array.from(atob(packed.data), (letter) => letter.charCodeAt(0));
  return new KINDS[packed.type](bytes.buffer);
}

/** A flight of a scene: arrays instead of text, and the row of the forces of each instant. */
export function flightOf(scene) {
  if (scene.ready) return scene;
  const t = unpacked(scene.t);
  const at = unpacked(scene.force.at);
  const rows = new Int32Array(t.length).fill(-1);
  at.forEach((place, row) => (rows[place] = row));
  return {
    ...scene,
    ready: true,
    t,
    n: t.length,
    begin: t[0],
    end: t[t.length - 1],
    position: unpacked(scene.position),
    attitude: unpacked(scene.attitude),
    armLength: unpacked(scene.arm_length),
    bends: unpacked(scene.bends), // empty without second joints
    thrust: unpacked(scene.thrust),
    force: unpacked(scene.force.of),
    point: unpacked(scene.point.of),
    bodies: scene.bodies.map((one) => ({ ...one, position: unpacked(one.position), attitude: unpacked(one.attitude) })),
    rows,
    series: scene.series.map((one) => ({ ...one, values: unpacked(one.values) })),
    signals: signalsOf(scene.signals),
    every: scene.signals?.telemetry?.every ?? 1, // of the ticks of the telemetry
    shift: 0,
  };
}

/** Index of the last instant at or before a time. */
export function placeOf(times, time) {
  let low = 0;
  let high = times.length - 1;
  if (!(time > times[0])) return 0;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle;
  }
  return times[high] <= time ? high : low;
}

/** State of a flight at a time, interpolated linearly between instants. */
export function poseAt(flight, time) {
  const t = Math.min(Math.max(time - flight.shift, flight.begin), flight.end);
  const i = placeOf(flight.t, t);
  const k = Math.min(i + 1, flight.n - 1);
  const u = k > i ? (t - flight.t[i]) / (flight.t[k] - flight.t[i]) : 0;
  const mixed = (values, width, part) =>
    values[i * width + part] * (1 - u) + values[k * width + part] * u;
  const many = (values, width) => Array.from({ length: width }, (_, part) => mixed(values, width, part));
  const arms = flight.arms.length;
  const turned = (attitude) => {
    const q = many(attitude, 4);
    let dot = 0;
    for (let c = 0; c < 4; c++) dot += attitude[i * 4 + c] * attitude[k * 4 + c];
    if (dot < 0) for (let c = 0; c < 4; c++) q[c] = attitude[i * 4 + c];
    const norm = Math.hypot(...q);
    return q.map((x) => x / norm);
  };

  const before = flight.rows[i];
  const after = flight.rows[k];
  const contacts = [];
  const count = flight.part.length;
  for (let slot = 0; slot < count; slot++) {
    const force = [0, 0, 0];
    let point = null;
    for (const [row, share] of [[before, 1 - u], [after, u]]) {
      if (row < 0) continue;
      const from = (row * count + slot) * 3;
      for (let c = 0; c < 3; c++) force[c] += share * flight.force[from + c];
      const there = Array.from(flight.point.subarray(from, from + 3));
      if (there.some((x) => x !== 0)) point = there;
    }
    const size = Math.hypot(...force);
    contacts.push(point && size > 1e-6 ? { part: flight.part[slot], force, size, point } : null);
  }
  return {
    t: t + flight.shift,
    own: t,
    place: i,
    position: many(flight.position, 3),
    quaternion: turned(flight.attitude),
    armLengths: many(flight.armLength, arms),
    bends: flight.bends.length ? many(flight.bends, arms) : [],
    thrust: many(flight.thrust, flight.rotors.length),
    contacts,
    bodies: flight.bodies.map((one) => ({ position: many(one.position, 3), quaternion: turned(one.attitude) })),
  };
}

/** Value at a time of a curve {flight, t, values, held}; the curves of a scene are over its instants. */
export function valueAt({ flight, t = flight.t, values, held = false }, time) {
  const own = Math.min(Math.max(time - flight.shift, t[0]), t[t.length - 1]);
  const i = placeOf(t, own);
  const k = held ? i : Math.min(i + 1, t.length - 1);
  const u = k > i ? (own - t[i]) / (t[k] - t[i]) : 0;
  return values[i] * (1 - u) + values[k] * u;
}

/** True if the pilot recorded an estimate of the pose. */
export const hasEstimate = (flight) => ["est_x", "est_qw"].every((name) => flight.signals.has(name));

/** The estimated pose at a time, as of poseAt, with arms as the Hall sensors have them. */
export function estimateAt(flight, time) {
  const value = (name, otherwise) => {
    const signal = flight.signals.get(name);
    return signal ? valueAt({ flight, ...signal, values: signal.values }, time) : otherwise;
  };
  const q = ["w", "x", "y", "z"].map((part) => value(`est_q${part}`));
  const norm = Math.hypot(...q) || 1;
  return {
    own: Math.min(Math.max(time - flight.shift, flight.begin), flight.end),
    position: ["x", "y", "z"].map((axis) => value(`est_${axis}`)),
    quaternion: q.map((x) => x / norm),
    armLengths: flight.arms.map((arm, j) => value(`hall${j + 1}`, arm.length)),
    bends: [],
    thrust: flight.rotors.map(() => 0),
    contacts: [],
  };
}

/** First touch in the world of a flight [s], or null. */
export function touchOf(flight) {
  const touch = flight.first_touch ?? flight.impacts[0]?.[0] ?? null;
  return touch === null ? null : touch + flight.shift;
}

/** Beginning of the last impact that began before a time [s], or null. */
export function impactBefore(flight, t) {
  const begun = flight.impacts.map(([begin]) => begin + flight.shift).filter((begin) => begin <= t);
  return begun.length ? begun[begun.length - 1] : null;
}

/** First touch of the first flight that touches anything [s], or null. */
export const firstTouch = (flights) => flights.map(touchOf).find((touch) => touch !== null) ?? null;

/** Largest force of one contact over a flight [N]. */
export function largestForce(flight) {
  let most = 0;
  for (let k = 0; k < flight.force.length; k += 3) {
    most = Math.max(most, Math.hypot(flight.force[k], flight.force[k + 1], flight.force[k + 2]));
  }
  return most;
}

/** Magnitude of the sum of all contact forces at the instants [N]. */
export function wholeForce(flight) {
  const count = flight.part.length;
  return Float32Array.from(flight.rows, (row) => {
    const whole = [0, 0, 0];
    for (let k = 0; row >= 0 && k < 3 * count; k++) whole[k % 3] += flight.force[row * count * 3 + k];
    return Math.hypot(...whole);
  });
}

/** Largest round number not above x: 1, 2 or 5 times a power of ten. */
export function roundBelow(x) {
  if (!(x > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(x));
  return power * ([5, 2, 1].find((digit) => digit * power <= x * 1.0000001) ?? 1);
}
