// Writing crease patterns as FOLD 1.2 (docs/formats/fold.md).
// SPDX-License-Identifier: MIT
#include "io/patterns/fold_pattern_writer.h"

#include <algorithm>
#include <array>
#include <utility>

#include "io/fold_json.h"
#include "io/patterns/fold_faces.h"
#include "io/patterns/fold_units.h"
#include "io/patterns/losses.h"

namespace kiri {

namespace {

const char* letterOfAssignment(Assignment assignment) {
  constexpr std::array<const char*, 7> kLetters = {"B", "M", "V", "F", "U", "C", "J"};
  return kLetters[static_cast<std::size_t>(assignment)];
}

/// The angle that the line has, or means; null where nobody knows.
JsonValue angleOfLine(const DrawnCrease& line) {
  if (line.angle) return JsonValue::ofNumber(*line.angle);
  constexpr double kFull = 180;
  switch (line.assignment) {
    case Assignment::Valley:
      return JsonValue::ofNumber(kFull);
    case Assignment::Mountain:
      return JsonValue::ofNumber(-kFull);
    case Assignment::Unassigned:
      return {};
    default:
      return JsonValue::ofNumber(0);
  }
}

bool hasAssignment(const CreaseDrawing& drawing, Assignment assignment) {
  return std::any_of(drawing.lines.begin(), drawing.lines.end(),
                     [&](const DrawnCrease& line) { return line.assignment == assignment; });
}

bool isConvexRun(const VertexList& vertices, const std::vector<std::uint32_t>& face) {
  const std::size_t n = face.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = vertices.places[face[i]];
    const Vec2 b = vertices.places[face[(i + 1) % n]];
    const Vec2 c = vertices.places[face[(i + 2) % n]];
    if (cross(b - a, c - b) < 0) return false;
  }
  return true;
}

void addHead(JsonValue& out, const PatternFile& file) {
  out.add("file_spec", JsonValue::ofNumber(1.2));
  out.add("file_creator", JsonValue::ofText("KiriSim"));
  addJsonText(out, "file_title", file.title);
  addJsonText(out, "file_author", file.author);
  addJsonText(out, "file_description", file.description);
  out.add("file_classes", jsonTexts({"singleModel"}));
  out.add("frame_classes", jsonTexts({"creasePattern"}));
}

void addUnit(JsonValue& out, const PatternFile& file) {
  if (!file.mmPerUnit) return;
  const std::string unit = foldUnitOf(*file.mmPerUnit);
  out.add("frame_unit", JsonValue::ofText(unit.empty() ? "unit" : unit));
  if (unit.empty()) out.add(kMmPerUnitKey, JsonValue::ofNumber(*file.mmPerUnit));
}

void addLinesAsEdges(JsonValue& out, const CreaseDrawing& drawing, const VertexList& vertices) {
  JsonValue places = JsonValue::array();
  for (const Vec2 p : vertices.places) {
    places.items.push_back(jsonPair(JsonValue::ofNumber(p.x), JsonValue::ofNumber(p.y)));
  }
  JsonValue ends = JsonValue::array();
  JsonValue letters = JsonValue::array();
  JsonValue angles = JsonValue::array();
  for (std::size_t i = 0; i < drawing.lines.size(); ++i) {
    const auto [from, to] = vertices.edges[i];
    ends.items.push_back(jsonPair(JsonValue::ofNumber(from), JsonValue::ofNumber(to)));
    letters.items.push_back(JsonValue::ofText(letterOfAssignment(drawing.lines[i].assignment)));
    angles.items.push_back(angleOfLine(drawing.lines[i]));
  }
  out.add("vertices_coords", std::move(places));
  out.add("edges_vertices", std::move(ends));
  out.add("edges_assignment", std::move(letters));
  out.add("edges_foldAngle", std::move(angles));
}

void addFacesAndOrders(JsonValue& out, const FaceList& faces,
                       const std::vector<FoldOrder>& orders) {
  if (faces.faces.empty()) return;
  JsonValue runs = JsonValue::array();
  for (const std::vector<std::uint32_t>& face : faces.faces) {
    JsonValue& run = runs.items.emplace_back(JsonValue::array());
    for (const std::uint32_t v : face) run.items.push_back(JsonValue::ofNumber(v));
  }
  out.add("faces_vertices", std::move(runs));
  if (orders.empty()) return;
  JsonValue triples = JsonValue::array();
  for (const FoldOrder& order : orders) {
    JsonValue& triple = triples.items.emplace_back(
        jsonPair(JsonValue::ofNumber(order.f), JsonValue::ofNumber(order.g)));
    triple.items.push_back(JsonValue::ofNumber(order.side));
  }
  out.add("faceOrders", std::move(triples));
}

void addUnknownKeys(JsonValue& out, const PatternFile& file) {
  if (file.unknown.empty()) return;
  const Result<JsonValue> kept = parseJson(file.unknown, "keys of others");
  if (!kept) return;
  for (const JsonMember& member : kept->members) {
    if (out.find(member.name) == nullptr) out.add(member.name, member.value);
  }
}

}  // namespace

WrittenPattern writeFoldPattern(const PatternFile& file) {
  const VertexList vertices = verticesOf(file.drawing);
  const FaceList faces = facesOf(file.drawing, vertices);
  std::size_t lost = 0;
  const std::vector<FoldOrder> orders = ordersOf(file.drawing, vertices, faces, lost);
  JsonValue out = JsonValue::object();
  addHead(out, file);
  const bool isConvex = std::all_of(faces.faces.begin(), faces.faces.end(),
                                    [&](const auto& face) { return isConvexRun(vertices, face); });
  out.add("frame_attributes",
          foldAttributes("2D", isConvex, hasAssignment(file.drawing, Assignment::Cut),
                         hasAssignment(file.drawing, Assignment::Join)));
  addUnit(out, file);
  addLinesAsEdges(out, file.drawing, vertices);
  addFacesAndOrders(out, faces, orders);
  addUnknownKeys(out, file);
  WrittenPattern written;
  if (!faces.complaint.empty()) written.losses.push_back(faces.complaint);
  if (lost > 0) {
    written.losses.push_back(std::to_string(lost) +
                             " layer orders were left out: they name no two faces");
  }
  constexpr std::size_t kDocumentOnly = 1;
  written.text = layOut(out, kDocumentOnly);
  return written;
}

}  // namespace kiri
