// Reads FOLD files with the `fold` package and prints what it makes of each frame as one JSON object.
// SPDX-License-Identifier: MIT
// Usage: node read_fold.mjs FOLDER_WITH_NODE_MODULES FILE...
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";

const [folder, ...files] = process.argv.slice(2);
const FOLD = createRequire(join(folder, "package.json"))("fold");

/** The frame with what it inherits: the package leaves that to its users. */
function frameOf(file, index) {
  if (index === 0) return file;
  const frame = file.file_frames[index - 1];
  if (!frame.frame_inherit) return frame;
  return { ...frameOf(file, frame.frame_parent), ...frame };
}

/** A face as one text whatever vertex it starts with. */
function loop(face) {
  const least = face.indexOf(Math.min(...face));
  return face.slice(least).concat(face.slice(0, least)).join(" ");
}

const sorted = (list) => list.map(loop).sort();
const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
// The deepCopy of the package makes {} of null.
const copy = (fold) => JSON.parse(JSON.stringify(fold));

/** Faces, edges beside them and edges of faces, rebuilt by the package from less. */
function rebuilt(frame) {
  const { vertices_coords, edges_vertices, faces_vertices } = frame;
  const faces = FOLD.convert.edges_vertices_to_faces_vertices(copy({ vertices_coords, edges_vertices }));
  const edges = FOLD.convert.edges_vertices_to_edges_faces_edges(
    copy({ vertices_coords, edges_vertices, faces_vertices, faces_edges: [] }));
  const bare = FOLD.convert.faces_vertices_to_edges(copy({ vertices_coords, faces_vertices }));
  return {
    faces: same(sorted(faces.faces_vertices), sorted(faces_vertices)),
    edges_faces: same(edges.edges_faces, frame.edges_faces),
    faces_edges: same(edges.faces_edges, frame.faces_edges),
    edges: bare.edges_vertices.length,
  };
}

/** How many vertices, edges and faces are left when the package has cleaned the pattern up. */
function cleaned(frame, epsilon) {
  const { vertices_coords, edges_vertices, edges_assignment } = frame;
  const fold = copy({ vertices_coords, edges_vertices, edges_assignment });
  FOLD.filter.collapseNearbyVertices(fold, epsilon);
  FOLD.filter.removeLoopEdges(fold);
  FOLD.filter.removeDuplicateEdges_vertices(fold);
  FOLD.filter.subdivideCrossingEdges_vertices(fold, epsilon);
  return { vertices: FOLD.filter.numVertices(fold), edges: FOLD.filter.numEdges(fold) };
}

/** The largest distance between a folded form and the same folded by the package from its own root. */
function foldedApart(pattern, folded) {
  const areas = pattern.faces_vertices.map((face) =>
    FOLD.geom.twiceSignedArea(face.map((v) => pattern.vertices_coords[v])));
  const own = copy(pattern);
  const error = FOLD.convert.flatFoldedGeometry(own, areas.indexOf(Math.max(...areas)));
  const distances = own.vertices_flatFoldCoords.map((p, v) => FOLD.geom.dist(p, folded.vertices_coords[v]));
  return { error, apart: Math.max(...distances), orientation: own.faces_flatFoldOrientation };
}

const counts = (frame) => ({
  vertices: FOLD.filter.numVertices(frame),
  edges: FOLD.filter.numEdges(frame),
  faces: FOLD.filter.numFaces(frame),
  mountains: FOLD.filter.mountainEdges(frame).length,
  valleys: FOLD.filter.valleyEdges(frame).length,
  unassigned: FOLD.filter.unassignedEdges(frame).length,
  border: FOLD.filter.boundaryEdges(frame).length,
  cuts: FOLD.filter.cutEdges(frame).length,
});

const reports = {};
for (const name of files) {
  const file = JSON.parse(readFileSync(name, "utf8"));
  const size = Math.max(...file.vertices_coords.flat()) - Math.min(...file.vertices_coords.flat());
  const report = { ...counts(file), rebuilt: rebuilt(file), cleaned: cleaned(file, size * 1e-9), size, frames: [] };
  for (let i = 1; i <= (file.file_frames ?? []).length; i += 1) {
    const frame = frameOf(file, i);
    const own = { ...counts(frame), classes: frame.frame_classes, orders: frame.faceOrders };
    own.assignments = frame.edges_assignment;
    own.edges_faces = frame.edges_faces;
    if (file.file_frames[i - 1].frame_inherit) own.folding = foldedApart(file, frame);
    report.frames.push(own);
  }
  // The package writes what it has read: nothing is lost on the way.
  report.text = same(JSON.parse(FOLD.convert.toJSON(file)), file);
  reports[name] = report;
}
console.log(JSON.stringify(reports));
