// FOLD 1.2 files (docs/formats/fold.md).
// SPDX-License-Identifier: MIT
#include "io/fold_writer.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "io/face_orders.h"
#include "io/facet_mesh.h"
#include "io/fold_json.h"
#include "io/folded_form.h"
#include "io/json_tree.h"

namespace kiri {

namespace {

JsonValue integer(std::uint32_t value) { return JsonValue::ofNumber(value); }

JsonValue indexOrNull(std::uint32_t value) {
  return value == MeshEdge::kNoFace ? JsonValue{} : integer(value);
}

/// Coordinates with as many digits as are wanted.
class Coordinates {
 public:
  explicit Coordinates(int decimals) {
    constexpr double kTen = 10;
    if (decimals > 0) steps_ = std::pow(kTen, decimals);
  }

  JsonValue of(Vec2 v) const { return jsonPair(number(v.x), number(v.y)); }

  JsonValue of(Vec3 v) const {
    JsonValue triple = jsonPair(number(v.x), number(v.y));
    triple.items.push_back(number(v.z));
    return triple;
  }

 private:
  /// Never -0.
  JsonValue number(double value) const {
    return JsonValue::ofNumber(steps_ > 0 ? std::round(value * steps_) / steps_ + 0.0 : value);
  }

  double steps_ = 0;
};

struct EdgeMeaning {
  const char* letter = "B";
  double angle = 0;
};

EdgeMeaning assignmentOf(const FoldedState& state, const MeshEdge& edge) {
  switch (edge.kind) {
    case MeshEdgeKind::Border:
      return {"B", 0};
    case MeshEdgeKind::Cut:
      return {"C", 0};
    case MeshEdgeKind::Join:
      return {"J", 0};
    case MeshEdgeKind::Hinge:
      break;
  }
  const double angle = state.pattern[edge.source].angle;
  return {angle > 0 ? "V" : angle < 0 ? "M" : "F", angle};
}

/// The name of the fold line that an edge belongs to; null when it belongs to none.
JsonValue foldNameOf(const FoldedState& state, const MeshEdge& edge) {
  if (edge.kind != MeshEdgeKind::Hinge) return {};
  const FoldLineId line = state.pattern[edge.source].line;
  return line.isValid() ? JsonValue::ofText(state.lines[line.index].name) : JsonValue{};
}

void addEdges(JsonValue& frame, const FoldedState& state, const std::vector<MeshEdge>& edges) {
  JsonValue vertices = JsonValue::array();
  JsonValue assignments = JsonValue::array();
  JsonValue angles = JsonValue::array();
  JsonValue faces = JsonValue::array();
  JsonValue names = JsonValue::array();
  for (const MeshEdge& edge : edges) {
    const EdgeMeaning assignment = assignmentOf(state, edge);
    vertices.items.push_back(jsonPair(integer(edge.from), integer(edge.to)));
    assignments.items.push_back(JsonValue::ofText(assignment.letter));
    angles.items.push_back(JsonValue::ofNumber(assignment.angle));
    faces.items.push_back(jsonPair(indexOrNull(edge.left), indexOrNull(edge.right)));
    names.items.push_back(foldNameOf(state, edge));
  }
  frame.add("edges_vertices", std::move(vertices));
  frame.add("edges_assignment", std::move(assignments));
  frame.add("edges_foldAngle", std::move(angles));
  frame.add("edges_faces", std::move(faces));
  frame.add("edges_kiri:fold", std::move(names));
}

void addFaces(JsonValue& frame, const std::vector<MeshFace>& faces) {
  JsonValue vertices = JsonValue::array();
  JsonValue facets = JsonValue::array();
  for (const MeshFace& face : faces) {
    JsonValue& loop = vertices.items.emplace_back(JsonValue::array());
    for (const std::uint32_t v : face.vertices) loop.items.push_back(integer(v));
    facets.items.push_back(integer(face.facet.index));
  }
  frame.add("faces_vertices", std::move(vertices));
  frame.add("faces_kiri:facet", std::move(facets));
}

void addOrders(JsonValue& frame, const FaceOrders& orders) {
  JsonValue list = JsonValue::array();
  for (const FaceOrder& order : orders.list) {
    JsonValue& triple = list.items.emplace_back(jsonPair(integer(order.f), integer(order.g)));
    triple.items.push_back(JsonValue::ofNumber(order.side));
  }
  frame.add("faceOrders", std::move(list));
  if (orders.isReduced)
    frame.add("kiri:faceOrders", JsonValue::ofText("pairs that follow from others are left out"));
}

bool hasKind(const std::vector<MeshEdge>& edges, MeshEdgeKind kind) {
  return std::any_of(edges.begin(), edges.end(),
                     [&](const MeshEdge& edge) { return edge.kind == kind; });
}

JsonValue attributesOf(const char* dimension, const std::vector<MeshEdge>& edges) {
  return foldAttributes(dimension, true, hasKind(edges, MeshEdgeKind::Cut),
                        hasKind(edges, MeshEdgeKind::Join));
}

void addPattern(JsonValue& out, const FoldedState& state, const FacetMesh& mesh,
                const Coordinates& coordinates) {
  out.add("frame_classes", jsonTexts({"creasePattern"}));
  out.add("frame_attributes", attributesOf("2D", mesh.edges));
  out.add("frame_unit", JsonValue::ofText("mm"));
  JsonValue places = JsonValue::array();
  for (const Vec2 v : mesh.vertices) places.items.push_back(coordinates.of(v));
  out.add("vertices_coords", std::move(places));
  addEdges(out, state, mesh.edges);
  addFaces(out, mesh.faces);
  addOrders(out, faceOrdersOf(state, mesh));
}

JsonValue foldedFrame(const FoldFrame& entry, const FacetMesh& mesh,
                      const Coordinates& coordinates) {
  const FoldedState& state = *entry.state;
  const FoldedForm form = foldedFormOf(state, mesh);
  JsonValue out = JsonValue::object();
  addJsonText(out, "frame_title", entry.title);
  addJsonText(out, "frame_description", entry.description);
  out.add("frame_classes", jsonTexts({"foldedForm"}));
  out.add("frame_attributes", attributesOf("3D", form.edges));
  out.add("frame_unit", JsonValue::ofText("mm"));
  out.add("frame_inherit", JsonValue::ofBool(false));
  JsonValue places = JsonValue::array();
  JsonValue rest = JsonValue::array();
  for (const Vec3 v : form.vertices) places.items.push_back(coordinates.of(v));
  for (const Vec2 v : form.paper) rest.items.push_back(coordinates.of(v));
  out.add("vertices_coords", std::move(places));
  out.add("vertices_kiri:paper", std::move(rest));
  addEdges(out, state, form.edges);
  addFaces(out, form.faces);
  addOrders(out, faceOrdersOf(state, mesh));
  return out;
}

/// What got lost in any of the meshes, each sentence once.
class Losses {
 public:
  void note(const FacetMesh& mesh) {
    hasCurves_ = hasCurves_ || mesh.hasCurves;
    hasJoins_ = hasJoins_ || mesh.hasJoins;
  }

  std::vector<std::string> sentences() const {
    std::vector<std::string> out;
    if (hasCurves_) out.push_back("FOLD has no curves: curved edges became polylines");
    if (hasJoins_) {
      out.push_back(
          "facets that are not convex were divided into convex faces with join edges (J)");
    }
    return out;
  }

 private:
  bool hasCurves_ = false;
  bool hasJoins_ = false;
};

}  // namespace

Exported writeFold(const FoldedState& state, const std::vector<FoldFrame>& history,
                   const FoldOptions& options) {
  Losses losses;
  JsonValue out = JsonValue::object();
  out.add("file_spec", JsonValue::ofNumber(1.2));
  out.add("file_creator", JsonValue::ofText(options.creator));
  addJsonText(out, "file_title", options.title);
  addJsonText(out, "file_description", options.description);
  out.add("file_classes",
          history.empty() ? jsonTexts({"singleModel"}) : jsonTexts({"singleModel", "diagrams"}));
  const Coordinates coordinates(options.decimals);
  const FacetMesh mesh = meshOf(state.pattern, options.chordError);
  losses.note(mesh);
  addPattern(out, state, mesh, coordinates);
  if (!history.empty()) {
    JsonValue frames = JsonValue::array();
    for (const FoldFrame& entry : history) {
      const FacetMesh own = meshOf(entry.state->pattern, options.chordError);
      losses.note(own);
      frames.items.push_back(foldedFrame(entry, own, coordinates));
    }
    out.add("file_frames", std::move(frames));
  }
  const std::vector<std::string> sentences = losses.sentences();
  if (!sentences.empty()) out.add("kiri:losses", jsonTexts(sentences));
  constexpr std::size_t kDocument = 1;
  return {layOut(out, kDocument), sentences};
}

}  // namespace kiri
