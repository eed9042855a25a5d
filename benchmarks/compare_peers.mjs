// Times the halving sequence in JavaScript: a bare script, and flatFold of rabbit-ear. Prints one JSON object.
// Usage: node compare_peers.mjs FOLDER_WITH_NODE_MODULES MOST_FOLDS_OF_RABBIT_EAR
// SPDX-License-Identifier: MIT
import { execFileSync } from "node:child_process";
import { createRequire } from "node:module";
import { fileURLToPath } from "node:url";
import { halve } from "./bare_script.mjs";

const folder = process.argv[2];
const most = Number(process.argv[3] ?? 9);
const ear = createRequire(`${folder}/`)("rabbit-ear");

function milliseconds(work) {
  const start = process.hrtime.bigint();
  work();
  return Number(process.hrtime.bigint() - start) / 1e6;
}

/** The smallest of several runs, after the just-in-time compiler has seen the code. */
function best(runs, work) {
  let least = Infinity;
  for (let i = 0; i < runs; i += 1) least = Math.min(least, milliseconds(work));
  return least;
}

/** Box of the folded vertices: the peer keeps one matrix a face. */
function foldedBox(graph) {
  const matrices = graph.faces_matrix2 ?? graph.faces_vertices.map(() => [1, 0, 0, 1, 0, 0]);
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
  graph.faces_vertices.forEach((vertices, f) => {
    const m = matrices[f];
    for (const v of vertices) {
      const [x, y] = graph.vertices_coords[v];
      const p = m[0] * x + m[2] * y + m[4];
      const q = m[1] * x + m[3] * y + m[5];
      x0 = Math.min(x0, p);
      x1 = Math.max(x1, p);
      y0 = Math.min(y0, q);
      y1 = Math.max(y1, q);
    }
  });
  return [x0, y0, x1, y1];
}

function peerHalves(folds) {
  const graph = ear.cp.square ? ear.cp.square() : ear.cp();
  let spent = 0;
  for (let k = 0; k < folds; k += 1) {
    const [x0, y0, x1, y1] = foldedBox(graph);
    const origin = [(x0 + x1) / 2, (y0 + y1) / 2];
    const vector = k % 2 === 0 ? [0, 1] : [1, 0];
    spent += milliseconds(() => ear.graph.flatFold(graph, vector, origin, "V"));
  }
  if (graph.faces_vertices.length !== 2 ** folds) {
    throw new Error(`rabbit-ear made ${graph.faces_vertices.length} faces in ${folds} folds`);
  }
  return spent;
}

/** A fresh process, as one meets a script: the median of five. */
function fresh(folds) {
  const script = fileURLToPath(new URL("./bare_script.mjs", import.meta.url));
  const times = [1, 2, 3, 4, 5].map(() => Number(execFileSync(process.execPath, [script, String(folds)])));
  return times.sort((a, b) => a - b)[2];
}

const result = { bare: {}, rabbit_ear: {} };
for (let folds = 1; folds <= 12; folds += 1) {
  if (halve(folds).length !== 2 ** folds) throw new Error("the bare script lost a facet");
  result.bare[folds] = { fresh: fresh(folds), warm: best(15, () => halve(folds)) };
}
for (let folds = 1; folds <= most; folds += 1) result.rabbit_ear[folds] = peerHalves(folds);
console.log(JSON.stringify(result));
