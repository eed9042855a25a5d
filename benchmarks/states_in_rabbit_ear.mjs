// Counts the folded states of one FOLD file with rabbit-ear and prints {faces, states} as JSON.
// Usage: node states_in_rabbit_ear.mjs FOLDER_WITH_NODE_MODULES FILE
// SPDX-License-Identifier: MIT
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const [folder, name] = process.argv.slice(2);
const ear = createRequire(`${folder}/`)("rabbit-ear");
const log = console.log;
console.log = () => {};  // the solver talks

const graph = ear.graph(JSON.parse(readFileSync(name, "utf8")));
graph.vertices_coords = ear.graph.makeVerticesCoordsFlatFolded(graph);
const solution = ear.layer.solver(graph);
const states = solution ? solution.count().reduce((product, n) => product * BigInt(n), 1n) : 0n;
log(JSON.stringify({ faces: graph.faces_vertices.length, states: states.toString() }));
