// Vertices, edges and faces of one frame of a FOLD file, checked.
// SPDX-License-Identifier: MIT
#include "io/patterns/fold_graph.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/geometry/tolerance.h"
#include "io/patterns/plain_number.h"
#include "io/patterns/tally.h"

namespace kiri {

namespace {

using Kind = JsonValue::Kind;

Error graphError(std::string sentence) { return {ErrorCode::BadFile, std::move(sentence)}; }

/// The array of that name; none, and a note, when it is something else.
const JsonValue* arrayOf(const FoldFrameView& frame, const char* key,
                         std::vector<std::string>& notes) {
  const JsonValue* value = frame.find(key);
  if (value == nullptr || value->is(Kind::Array)) return value;
  notes.push_back(std::string(key) + " of " + frame.name() + " is no array and was left out");
  return nullptr;
}

/// An index below `count`; none for anything else.
std::optional<std::uint32_t> indexOf(const JsonValue& value, std::size_t count) {
  if (!value.is(Kind::Number) || std::floor(value.number) != value.number) return std::nullopt;
  if (value.number < 0 || value.number >= static_cast<double>(count)) return std::nullopt;
  return static_cast<std::uint32_t>(value.number);
}

std::optional<Vec3> placeOf(const JsonValue& value) {
  if (!value.is(Kind::Array) || value.items.empty()) return std::nullopt;
  Vec3 out;
  const std::size_t count = std::min<std::size_t>(value.items.size(), 3);
  for (std::size_t i = 0; i < count; ++i) {
    const JsonValue& item = value.items[i];
    if (!item.is(Kind::Number) || !isDrawable(item.number)) return std::nullopt;
    (i == 0 ? out.x : i == 1 ? out.y : out.z) = item.number;
  }
  return out;
}

/// Reads one frame, array by array.
class GraphReader {
 public:
  GraphReader(const FoldFrameView& frame, std::vector<std::string>& notes)
      : frame_(frame), notes_(notes) {}

  Result<FoldGraph> read() {
    const JsonValue* coordinates = arrayOf(frame_, "vertices_coords", notes_);
    if (coordinates == nullptr || coordinates->items.empty()) {
      return graphError(frame_.name() +
                        " has no vertices_coords: the places of the vertices are not known, so it "
                        "cannot be drawn; export it again with coordinates");
    }
    readVertices(*coordinates);
    readFaces();
    if (const JsonValue* edges = arrayOf(frame_, "edges_vertices", notes_)) {
      readEdges(*edges);
    } else if (!graph_.faces.empty()) {
      edgesFromFaces();
    } else {
      return graphError(frame_.name() +
                        " has neither edges_vertices nor faces_vertices: there are no lines to "
                        "read; export it again with edges");
    }
    if (graph_.edges.empty()) {
      return graphError(frame_.name() + " has no edge that can be used; see edges_vertices");
    }
    measure();
    return std::move(graph_);
  }

 private:
  void readVertices(const JsonValue& coordinates) {
    Tally bad;
    graph_.vertices.reserve(coordinates.items.size());
    for (const JsonValue& item : coordinates.items) {
      const std::optional<Vec3> place = placeOf(item);
      if (!place) bad.add(graph_.vertices.size());
      isPlaced_.push_back(place.has_value());
      graph_.vertices.push_back(place.value_or(Vec3{}));
    }
    bad.tell(notes_, "vertex", "vertices",
             "without coordinates that can be drawn; edges at such vertices were left out");
  }

  std::optional<std::uint32_t> vertexOf(const JsonValue& value) const {
    const std::optional<std::uint32_t> index = indexOf(value, graph_.vertices.size());
    return index && isPlaced_[*index] ? index : std::nullopt;
  }

  void readFaces() {
    const JsonValue* faces = arrayOf(frame_, "faces_vertices", notes_);
    if (faces == nullptr) return;
    Tally bad;
    graph_.faces.reserve(faces->items.size());
    for (const JsonValue& item : faces->items) {
      std::vector<std::uint32_t>& face = graph_.faces.emplace_back();
      for (const JsonValue& corner : item.items) {
        const std::optional<std::uint32_t> vertex = vertexOf(corner);
        if (vertex) face.push_back(*vertex);
      }
      if (face.size() < 3 || face.size() != item.items.size()) bad.add(graph_.faces.size() - 1);
    }
    bad.tell(notes_, "face", "faces",
             "of vertices that do not exist, or of less than three; the faces of the file were "
             "left out and are found from its edges");
    if (bad.count() > 0) graph_.faces.clear();
  }

  void readEdges(const JsonValue& edges) {
    const JsonValue* letters = arrayOf(frame_, "edges_assignment", notes_);
    const JsonValue* angles = arrayOf(frame_, "edges_foldAngle", notes_);
    if (angles == nullptr) angles = arrayOf(frame_, "edges_foldAngles", notes_);
    const JsonValue* beside = arrayOf(frame_, "edges_faces", notes_);
    graph_.isAssigned = letters != nullptr || angles != nullptr;
    tellLength(letters, edges, "edges_assignment");
    tellLength(angles, edges, "edges_foldAngle");
    if (angles != nullptr && isAllZeroWhereFolded(letters, *angles)) {
      notes_.push_back(
          "every mountain and valley has fold angle 0: the angles say how the paper lies now, not "
          "how it folds, and were left out");
      angles = nullptr;
    }
    if (letters == nullptr) countFaces(edges, beside);
    for (std::size_t i = 0; i < edges.items.size(); ++i) {
      const JsonValue& ends = edges.items[i];
      FoldGraphEdge edge;
      if (!ends.is(Kind::Array) || ends.items.size() != 2) {
        badEdges_.add(i);
        continue;
      }
      const std::optional<std::uint32_t> from = vertexOf(ends.items[0]);
      const std::optional<std::uint32_t> to = vertexOf(ends.items[1]);
      if (!from || !to) {
        badEdges_.add(i);
        continue;
      }
      edge.from = *from;
      edge.to = *to;
      readMeaning(letters, angles, i, edge);
      graph_.edges.push_back(edge);
    }
    tellEdges();
  }

  void tellLength(const JsonValue* array, const JsonValue& edges, const char* key) {
    if (array == nullptr || array->items.size() == edges.items.size()) return;
    notes_.push_back(std::string(key) + " has " + std::to_string(array->items.size()) +
                     " entries for " + std::to_string(edges.items.size()) +
                     " edges; what is missing is unassigned");
  }

  static char letterOf(const JsonValue* letters, std::size_t i) {
    if (letters == nullptr || i >= letters->items.size()) return 0;
    const JsonValue& item = letters->items[i];
    if (!item.is(Kind::String) || item.text.size() != 1) return item.is(Kind::Null) ? '\0' : '?';
    const char c = item.text[0];
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }

  static bool isAllZeroWhereFolded(const JsonValue* letters, const JsonValue& angles) {
    bool isFolded = false;
    for (std::size_t i = 0; i < angles.items.size(); ++i) {
      const char letter = letterOf(letters, i);
      if (letter != 'M' && letter != 'V') continue;
      isFolded = true;
      if (angles.items[i].is(Kind::Null) || angles.items[i].number != 0) return false;
    }
    return isFolded;
  }

  std::optional<double> angleOf(const JsonValue* angles, std::size_t i) {
    if (angles == nullptr || i >= angles->items.size()) return std::nullopt;
    const JsonValue& item = angles->items[i];
    if (item.is(Kind::Null)) return std::nullopt;
    constexpr double kFull = 180;
    if (!item.is(Kind::Number) || item.number < -kFull || item.number > kFull) {
      badAngles_.add(i);
      return std::nullopt;
    }
    return item.number;
  }

  void readMeaning(const JsonValue* letters, const JsonValue* angles, std::size_t i,
                   FoldGraphEdge& edge) {
    std::optional<double> angle = angleOf(angles, i);
    const char letter = letterOf(letters, i);
    switch (letter) {
      case 'B':
        edge.assignment = Assignment::Border;
        return;
      case 'C':
        edge.assignment = Assignment::Cut;
        return;
      case 'J':
        edge.assignment = Assignment::Join;
        return;
      case 'F':
        edge.assignment = Assignment::Flat;
        if (angle.value_or(0) != 0) disagreeing_.add(i);
        return;
      case 'M':
      case 'V':
        edge.assignment = letter == 'M' ? Assignment::Mountain : Assignment::Valley;
        if (angle && (letter == 'M' ? *angle > 0 : *angle < 0)) {
          disagreeing_.add(i);
          angle = -*angle;
        }
        edge.angle = angle;
        return;
      case 'U':
        edge.angle = angle;
        return;
      case 0:
        assignWithoutLetter(angle, i, edge);
        return;
      default:
        unknownLetters_.add(i);
        edge.angle = angle;
        return;
    }
  }

  void assignWithoutLetter(std::optional<double> angle, std::size_t i, FoldGraphEdge& edge) {
    edge.angle = angle;
    if (i < faceCounts_.size() && faceCounts_[i] == 1) {
      edge.assignment = Assignment::Border;
      edge.angle.reset();
    } else if (angle) {
      edge.assignment = *angle > 0   ? Assignment::Valley
                        : *angle < 0 ? Assignment::Mountain
                                     : Assignment::Flat;
    }
  }

  using Side = std::pair<std::uint32_t, std::uint32_t>;

  std::map<Side, std::uint32_t> sidesOfFaces() const {
    std::map<Side, std::uint32_t> out;
    for (const std::vector<std::uint32_t>& face : graph_.faces) {
      for (std::size_t i = 0; i < face.size(); ++i) {
        ++out[std::minmax(face[i], face[(i + 1) % face.size()])];
      }
    }
    return out;
  }

  /// How many faces lie beside each edge, where nobody said what is border.
  void countFaces(const JsonValue& edges, const JsonValue* beside) {
    if (!graph_.faces.empty()) {
      const std::map<Side, std::uint32_t> sides = sidesOfFaces();
      for (const JsonValue& ends : edges.items) {
        std::uint32_t count = 0;
        if (ends.items.size() == 2) {
          const std::optional<std::uint32_t> from = vertexOf(ends.items[0]);
          const std::optional<std::uint32_t> to = vertexOf(ends.items[1]);
          const auto at = from && to ? sides.find(std::minmax(*from, *to)) : sides.end();
          if (at != sides.end()) count = at->second;
        }
        faceCounts_.push_back(count);
      }
    } else if (beside != nullptr) {
      for (const JsonValue& faces : beside->items) {
        faceCounts_.push_back(static_cast<std::uint32_t>(
            std::count_if(faces.items.begin(), faces.items.end(),
                          [](const JsonValue& face) { return face.is(Kind::Number); })));
      }
    }
  }

  void edgesFromFaces() {
    graph_.isAssigned = false;
    for (const auto& [side, count] : sidesOfFaces()) {
      const Assignment assignment = count == 1 ? Assignment::Border : Assignment::Unassigned;
      graph_.edges.push_back({side.first, side.second, assignment, std::nullopt});
    }
    notes_.push_back(
        "edges_vertices is missing: the sides of the faces were taken, without assignments");
  }

  void tellEdges() {
    badEdges_.tell(notes_, "edge", "edges", "without two good vertices; left out");
    unknownLetters_.tell(notes_, "edge", "edges",
                         "with an assignment that FOLD does not know; taken as unassigned");
    badAngles_.tell(notes_, "edge", "edges",
                    "with a fold angle that is no number from -180 to 180; left out");
    disagreeing_.tell(notes_, "edge", "edges",
                      "whose fold angle and assignment disagree; the assignment was kept");
  }

  void measure() {
    Vec3 low = graph_.vertices[graph_.edges.front().from];
    Vec3 high = low;
    for (const FoldGraphEdge& edge : graph_.edges) {
      for (const std::uint32_t v : {edge.from, edge.to}) {
        const Vec3 p = graph_.vertices[v];
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
    }
    graph_.size = length(high - low);
  }

  const FoldFrameView& frame_;
  std::vector<std::string>& notes_;
  FoldGraph graph_;
  std::vector<bool> isPlaced_;
  std::vector<std::uint32_t> faceCounts_;
  Tally badEdges_;
  Tally unknownLetters_;
  Tally badAngles_;
  Tally disagreeing_;
};

}  // namespace

Result<FoldGraph> foldGraphOf(const FoldFrameView& frame, std::vector<std::string>& notes) {
  return GraphReader(frame, notes).read();
}

bool isLevel(const FoldGraph& graph) {
  const double allowed = Tolerance(graph.size).match();
  const double level = graph.vertices[graph.edges.front().from].z;
  const auto isAway = [&](std::uint32_t v) {
    return std::abs(graph.vertices[v].z - level) > allowed;
  };
  return std::none_of(graph.edges.begin(), graph.edges.end(), [&](const FoldGraphEdge& edge) {
    return isAway(edge.from) || isAway(edge.to);
  });
}

double doubledArea(const FoldGraph& graph, const std::vector<std::uint32_t>& face) {
  const Vec2 origin = flatten(graph.vertices[face.front()]);
  double sum = 0;
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    sum += cross(flatten(graph.vertices[face[i]]) - origin,
                 flatten(graph.vertices[face[i + 1]]) - origin);
  }
  return sum;
}

}  // namespace kiri
