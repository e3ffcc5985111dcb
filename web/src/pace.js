// Pace of a replay: slowed down around impacts, so that they can be followed.

/** Chosen: viewing time of an impact [s], and the slowest pace. */
const WATCHED = 3.0;
const SLOWEST = 1 / 200;
/** Slow time before and after the touch [s]; of a long contact only the beginning is slow. */
const BEFORE = 0.008;
const AFTER = 0.02;
const LONGEST = 0.12;
/** The pace changes over this time on either side [s]. */
const RAMP = 0.12;
/** Largest number of slow intervals: a robot leaning on a wall touches it again and again. */
const MOST = 12;

/** Slow intervals: [begin, end, pace]. */
export function slowStretches(flights) {
  const found = [];
  for (const flight of flights) {
    for (const [begin, end] of flight.impacts.slice(0, MOST)) {
      const from = begin + flight.shift - BEFORE;
      found.push([from, Math.min(end, begin + LONGEST) + flight.shift + AFTER]);
    }
  }
  found.sort((a, b) => a[0] - b[0]);
  const joined = [];
  for (const one of found) {
    const last = joined[joined.length - 1];
    if (last && one[0] < last[1] + 2 * RAMP) last[1] = Math.max(last[1], one[1]);
    else joined.push([...one]);
  }
  return joined.map(([begin, end]) => [begin, end, Math.min(1, Math.max(SLOWEST, (end - begin) / WATCHED))]);
}

/** Pace at a time: 1 far from all slow intervals, theirs within, geometric between. */
function paceAt(stretches, time) {
  let pace = 1;
  for (const [begin, end, slow] of stretches) {
    const away = Math.max(begin - time, time - end, 0);
    if (away < RAMP) pace = Math.min(pace, slow ** ((1 + Math.cos((Math.PI * away) / RAMP)) / 2));
  }
  return pace;
}

/** The time line: conversion between flight time and viewing time at automatic pace. */
export function timeLine(flights) {
  const begin = Math.min(...flights.map((f) => f.begin + f.shift));
  const end = Math.max(...flights.map((f) => f.end + f.shift));
  const stretches = slowStretches(flights);
  const knots = new Set([begin, end]);
  for (let k = 1; k < 200; k++) knots.add(begin + ((end - begin) * k) / 200);
  for (const [from, to] of stretches) {
    for (let k = 0; k <= 60; k++) {
      knots.add(from - RAMP + ((to - from + 2 * RAMP) * k) / 60);
      knots.add(from + ((to - from) * k) / 60);
      knots.add(from - (RAMP * k) / 60);
      knots.add(to + (RAMP * k) / 60);
    }
  }
  const times = [...knots].filter((t) => t >= begin && t <= end).sort((a, b) => a - b);
  const watched = [0];
  for (let k = 1; k < times.length; k++) {
    const pace = Math.sqrt(paceAt(stretches, times[k - 1]) * paceAt(stretches, times[k]));
    watched.push(watched[k - 1] + (times[k] - times[k - 1]) / pace);
  }
  const total = watched[watched.length - 1] || 1;
  return {
    begin,
    end,
    stretches,
    total,
    paceAt: (time) => paceAt(stretches, time),
    watchedAt: (time) => interpolated(times, watched, time),
    timeAt: (seconds) => interpolated(watched, times, seconds),
  };
}

function interpolated(from, to, x) {
  let low = 0;
  let high = from.length - 1;
  if (!(x > from[0])) return to[0];
  if (x >= from[high]) return to[high];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (from[middle] <= x) low = middle;
    else high = middle;
  }
  return to[low] + ((to[high] - to[low]) * (x - from[low])) / (from[high] - from[low]);
}
