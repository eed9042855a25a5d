// SPDX-License-Identifier: MIT
#include "core/creases/build_pattern.h"
#include "core/geometry/bounds.h"

#include <algorithm>
#include <cmath>

namespace kiri {
namespace {

constexpr double kFolded = 180;

/// The target angle of a hinge: what the drawing says, in the direction that its assignment says.
double targetAngle(const MapLine& line) {
  const double drawn =
      line.angle && std::isfinite(*line.angle) ? std::min(std::abs(*line.angle), kFolded) : kFolded;
  switch (line.assignment) {
    case Assignment::Mountain:
      return drawn == 0 ? 0 : -drawn;
    case Assignment::Valley:
      return drawn;
    case Assignment::Unassigned:
      return drawn == 0 ? kFolded : drawn;
    default:
      return 0;
  }
}

double diagonalOf(const std::vector<Vec2>& points) {
  const Box box = boundsOf(points);
  return distance(box.low, box.high);
}

class PatternBuilder {
 public:
  PatternBuilder(const LineMap& map, const MapFaces& faces, const std::vector<bool>& isPaper,
                 RepairLog& log)
      : map_(map), faces_(faces), isPaper_(isPaper), log_(log), facetOf_(faces.count()) {
    std::uint32_t count = 0;
    for (std::size_t f = 0; f < facetOf_.size(); ++f) {
      if (isPaper[f]) facetOf_[f] = FacetId(count++);
    }
  }

  AssignedPattern build(double scale) {
    chooseLines();
    const std::vector<VertexId> vertexOf = chooseVertices(scale);
    CreasePattern pattern{Tolerance(diagonalOf(vertices_))};
    pattern.vertices = vertices_;
    std::vector<Assignment> assignments;
    for (std::uint32_t i = 0; i < map_.lines.size(); ++i) {
      if (!edgeOf_[i].isValid()) continue;
      const MapLine line = meantAs(i);
      Edge edge;
      edge.from = vertexOf[line.from];
      edge.to = vertexOf[line.to];
      edge.left = facetOf_[faces_.left(i)];
      edge.right = facetOf_[faces_.right(i)];
      edge.kind = kindOf(line.assignment);
      if (edge.kind == EdgeKind::Hinge) edge.angle = targetAngle(line);
      pattern.edges.push_back(edge);
      assignments.push_back(line.assignment);
    }
    addFacets(pattern);
    AssignedPattern creases{std::move(pattern)};
    creases.assignments = std::move(assignments);
    return creases;
  }

 private:
  bool isPaperLeft(std::uint32_t i) const { return isPaper_[faces_.left(i)]; }
  bool isPaperRight(std::uint32_t i) const { return isPaper_[faces_.right(i)]; }
  Vec2 middleOf(const MapLine& line) const { return lerp(map_.from(line), map_.to(line), 0.5); }

  static EdgeKind kindOf(Assignment assignment) {
    if (assignment == Assignment::Border) return EdgeKind::Border;
    return assignment == Assignment::Cut ? EdgeKind::Cut : EdgeKind::Hinge;
  }

  /// The line as the paper beside it makes it.
  MapLine meantAs(std::uint32_t i) const {
    MapLine line = map_.lines[i];
    const bool isRim = isPaperLeft(i) != isPaperRight(i);
    if (isRim) {
      line.assignment = Assignment::Border;
    } else if (line.assignment == Assignment::Border) {
      line.assignment = Assignment::Cut;
    }
    return line;
  }

  void chooseLines() {
    edgeOf_.resize(map_.lines.size());
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < map_.lines.size(); ++i) {
      const MapLine& line = map_.lines[i];
      if (!isPaperLeft(i) && !isPaperRight(i)) {
        log_.add(RepairKind::DroppedOutside, middleOf(line));
        continue;
      }
      edgeOf_[i] = EdgeId(count++);
      const Assignment meant = meantAs(i).assignment;
      if (meant == line.assignment) continue;
      const bool isRim = meant == Assignment::Border;
      log_.add(isRim ? RepairKind::AddedBorder : RepairKind::SlitBorders, middleOf(line));
    }
  }

  /// By point; numbered as the lines come to them.
  std::vector<VertexId> chooseVertices(double scale) {
    std::vector<VertexId> vertexOf(map_.points.size());
    for (std::size_t i = 0; i < map_.lines.size(); ++i) {
      if (!edgeOf_[i].isValid()) continue;
      for (const std::uint32_t p : {map_.lines[i].from, map_.lines[i].to}) {
        if (vertexOf[p].isValid()) continue;
        vertexOf[p] = VertexId(vertices_.size());
        vertices_.push_back(map_.points[p] * scale);
      }
    }
    return vertexOf;
  }

  void addFacets(CreasePattern& pattern) const {
    for (std::size_t f = 0; f < faces_.count(); ++f) {
      if (!isPaper_[f]) continue;
      Facet facet;
      for (const std::vector<std::uint32_t>& loop : faces_.loops[f]) {
        std::vector<EdgeUse> uses;
        for (const std::uint32_t half : loop) {
          if (edgeOf_[half / 2].isValid()) uses.push_back({edgeOf_[half / 2], half % 2 == 1});
        }
        if (!facet.border.empty() && !uses.empty())
          facet.holeStarts.push_back(static_cast<std::uint32_t>(facet.border.size()));
        facet.border.insert(facet.border.end(), uses.begin(), uses.end());
      }
      pattern.facets.push_back(std::move(facet));
    }
  }

  const LineMap& map_;
  const MapFaces& faces_;
  const std::vector<bool>& isPaper_;
  RepairLog& log_;
  std::vector<FacetId> facetOf_;
  std::vector<EdgeId> edgeOf_;  ///< by line
  std::vector<Vec2> vertices_;
};

}  // namespace

AssignedPattern buildPattern(const LineMap& map, const MapFaces& faces,
                             const std::vector<bool>& isPaper, double scale, RepairLog& log) {
  return PatternBuilder(map, faces, isPaper, log).build(scale);
}

}  // namespace kiri
