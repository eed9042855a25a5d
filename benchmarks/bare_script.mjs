// The halving sequence as a bare list of polygons from bottom to top: what folding costs without hinges, without the
// sheet, without relations between layers. Run by compare_peers.sh; run by itself it prints the milliseconds that
// FOLDS folds take in a fresh process: node bare_script.mjs FOLDS
// SPDX-License-Identifier: MIT
import { pathToFileURL } from "node:url";

const kThin = 1e-12;

/** The part of a convex polygon where side * (normal . p - distance) >= 0. */
function clipped(polygon, normal, distance, side) {
  const height = ([x, y]) => side * (normal[0] * x + normal[1] * y - distance);
  const kept = [];
  polygon.forEach((p, i) => {
    const q = polygon[(i + 1) % polygon.length];
    const [hp, hq] = [height(p), height(q)];
    if (hp >= -kThin) kept.push(p);
    if ((hp > kThin && hq < -kThin) || (hp < -kThin && hq > kThin)) {
      const t = hp / (hp - hq);
      kept.push([p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]);
    }
  });
  return kept;
}

function area(polygon) {
  let sum = 0;
  for (let i = 0; i < polygon.length; i += 1) {
    const [a, b] = [polygon[i], polygon[(i + 1) % polygon.length]];
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return Math.abs(sum) / 2;
}

function reflected([x, y], normal, distance) {
  const twice = 2 * (normal[0] * x + normal[1] * y - distance);
  return [x - twice * normal[0], y - twice * normal[1]];
}

/** Folds what lies beyond the line over it, on top. */
function folded(stack, normal, distance) {
  const resting = stack.map((p) => clipped(p, normal, distance, -1)).filter((p) => area(p) > kThin);
  const turned = stack.map((p) => clipped(p, normal, distance, 1)).filter((p) => area(p) > kThin);
  return resting.concat(turned.reverse().map((polygon) => polygon.map((p) => reflected(p, normal, distance))));
}

/** Halves a unit square `folds` times, left onto right and upper onto lower in turn. */
export function halve(folds) {
  let stack = [[[0, 0], [1, 0], [1, 1], [0, 1]]];
  for (let k = 0; k < folds; k += 1) {
    const axis = k % 2;
    let [low, high] = [Infinity, -Infinity];
    for (const polygon of stack) {
      for (const p of polygon) {
        low = Math.min(low, p[axis]);
        high = Math.max(high, p[axis]);
      }
    }
    const middle = (low + high) / 2;
    stack = axis === 0 ? folded(stack, [-1, 0], -middle) : folded(stack, [0, 1], middle);
  }
  return stack;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const before = process.cpuUsage();
  halve(Number(process.argv[2]));
  const { user, system } = process.cpuUsage(before);
  console.log((user + system) / 1000);
}
