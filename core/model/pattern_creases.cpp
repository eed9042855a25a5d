// Drawing the creases of a PatternStep on the sheet.
// SPDX-License-Identifier: MIT
#include "core/model/pattern_creases.h"

#include <algorithm>
#include <optional>
#include <string>

#include "core/base/text.h"
#include "core/paper/pattern_edit.h"

namespace kiri {
namespace {

Error wrongPattern(std::string message, std::vector<Vec2> points) {
  return {ErrorCode::BadValue, std::move(message), {std::move(points), {}, {}}};
}

/// Puts the vertices and creases of a step on a sheet, or says why that cannot be.
class Creasing {
 public:
  Creasing(const CreasePattern& sheet, const PatternStep& step)
      : pattern_(sheet), step_(step), border_(sheet.edges.size()) {}

  Result<CreasedSheet> run() {
    if (pattern_.facets.size() != 1) return notEmpty();
    if (const Status found = findUsed(); !found) return found.error();
    if (const Status placed = placeVertices(); !placed) return placed.error();
    splitBorder();
    if (const Status apart = checkApart(); !apart) return apart.error();
    const std::size_t first = pattern_.edges.size();
    std::vector<NewEdge> edges;
    for (const PatternCrease& crease : step_.creases) {
      const bool isCut = crease.assignment == Assignment::Cut;
      edges.push_back({places_[crease.from].vertex, places_[crease.to].vertex,
                       isCut ? EdgeKind::Cut : EdgeKind::Hinge, std::nullopt});
    }
    divideFacet(pattern_, FacetId(0), edges);
    for (std::size_t e = first; e < pattern_.edges.size(); ++e) {
      const Edge& edge = pattern_.edges[e];
      if (edge.kind == EdgeKind::Hinge && edge.left == edge.right) return dangling(edge);
    }
    if (const Status thick = checkThickness(); !thick) return thick.error();
    return CreasedSheet{std::move(pattern_), first};
  }

 private:
  /// Where a vertex of the step lies: on a border edge of the sheet, at `t`, or elsewhere.
  struct VertexPlace {
    VertexId vertex;
    EdgeId border;
    double t = 0;
    bool isUsed = false;
  };

  Error notEmpty() const {
    return {ErrorCode::BadValue,
            "a crease pattern is drawn on a sheet without creases, but this one has " +
                std::to_string(pattern_.facets.size()) +
                " facets; put the pattern before the other steps, or start a new model with it",
            {}};
  }

  Status findUsed() {
    places_.resize(step_.vertices.size());
    for (const PatternCrease& crease : step_.creases) {
      if (crease.from >= places_.size() || crease.to >= places_.size()) {
        return wrongPattern("a crease goes from vertex " + std::to_string(crease.from) + " to " +
                                std::to_string(crease.to) + ", but the pattern has " +
                                std::to_string(places_.size()) + " vertices, counted from 0",
                            {});
      }
      if (crease.from == crease.to) {
        return wrongPattern("a crease begins and ends at vertex " + std::to_string(crease.from) +
                                "; give it two different ends",
                            {step_.vertices[crease.from]});
      }
      if (crease.assignment == Assignment::Border) {
        return wrongPattern("the border of the paper is no crease; leave it to the sheet",
                            {step_.vertices[crease.from]});
      }
      places_[crease.from].isUsed = true;
      places_[crease.to].isUsed = true;
    }
    return std::monostate{};
  }

  Status placeVertices() {
    const Region region = regionOf(pattern_, FacetId(0));
    std::vector<Box> boxes;
    for (std::size_t e = 0; e < border_; ++e) boxes.push_back(boundsOf(arcOf(pattern_, EdgeId(e))));
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (!places_[i].isUsed) continue;
      const Vec2 p = step_.vertices[i];
      if (placeOnBorder(p, boxes, places_[i])) continue;
      if (locate(region, p, pattern_.tolerance.length()) == Where::Outside) {
        return wrongPattern("the vertex " + text(p) +
                                " mm of the pattern lies outside of the sheet; make the sheet as "
                                "large as the pattern, or leave its creases out",
                            {p});
      }
      places_[i].vertex = addVertex(pattern_, p);
    }
    return checkVertices();
  }

  /// True when the point lies on the border: on a corner, or on the edge that is noted.
  bool placeOnBorder(Vec2 p, const std::vector<Box>& boxes, VertexPlace& place) const {
    const double near = pattern_.tolerance.length();
    for (std::size_t e = 0; e < border_; ++e) {
      if (!areNear(boxes[e], {p, p}, near)) continue;
      const Edge& edge = pattern_.edges[e];
      for (const VertexId corner : {edge.from, edge.to}) {
        if (distance(pattern_[corner], p) > near) continue;
        place.vertex = corner;
        return true;
      }
      const Nearest nearest = nearestOn(arcOf(pattern_, EdgeId(e)), p);
      if (nearest.distance > near) continue;
      place.border = EdgeId(e);
      place.t = nearest.t;
      return true;
    }
    return false;
  }

  /// No two vertices of the step are one.
  Status checkVertices() const {
    const double near = pattern_.tolerance.length();
    std::vector<std::pair<Vec2, std::uint32_t>> order;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (places_[i].isUsed) order.emplace_back(step_.vertices[i], static_cast<std::uint32_t>(i));
    }
    std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
      return a.first.x != b.first.x ? a.first.x < b.first.x : a.second < b.second;
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t k = i + 1; k < order.size(); ++k) {
        if (order[k].first.x - order[i].first.x > near) break;
        if (distance(order[i].first, order[k].first) > near) continue;
        return wrongPattern("vertices " + std::to_string(order[i].second) + " and " +
                                std::to_string(order[k].second) +
                                " of the pattern are one place, " + text(order[i].first) +
                                " mm; make them one vertex",
                            {order[i].first});
      }
    }
    return std::monostate{};
  }

  /// Vertices on the sheet's border become its vertices, each edge split from its end on.
  void splitBorder() {
    std::vector<std::size_t> onBorder;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (places_[i].border.isValid()) onBorder.push_back(i);
    }
    std::stable_sort(onBorder.begin(), onBorder.end(), [&](std::size_t a, std::size_t b) {
      if (places_[a].border != places_[b].border) return places_[a].border < places_[b].border;
      return places_[a].t > places_[b].t;
    });
    EdgeId last;
    double end = 1;
    for (const std::size_t i : onBorder) {
      VertexPlace& place = places_[i];
      if (place.border != last) end = 1;
      last = place.border;
      place.vertex = splitEdge(pattern_, place.border, place.t / end);
      pattern_.vertices[place.vertex.index] = step_.vertices[i];
      end = place.t;
    }
  }

  struct Side {
    Arc arc;
    Box box;
    VertexId from;
    VertexId to;
    bool isCrease = false;
  };

  std::vector<Side> sidesByPlace() const {
    std::vector<Side> sides;
    for (std::size_t e = 0; e < pattern_.edges.size(); ++e) {
      const Edge& edge = pattern_.edges[e];
      const Arc arc = arcOf(pattern_, EdgeId(e));
      sides.push_back({arc, boundsOf(arc), edge.from, edge.to, false});
    }
    for (const PatternCrease& crease : step_.creases) {
      const VertexId from = places_[crease.from].vertex;
      const VertexId to = places_[crease.to].vertex;
      const Arc arc = Arc::line(pattern_[from], pattern_[to]);
      sides.push_back({arc, boundsOf(arc), from, to, true});
    }
    std::stable_sort(sides.begin(), sides.end(),
                     [](const Side& a, const Side& b) { return a.box.low.x < b.box.low.x; });
    return sides;
  }

  /// Creases meet each other and the border at shared vertices only.
  Status checkApart() const {
    const std::vector<Side> sides = sidesByPlace();
    const double near = pattern_.tolerance.length();
    for (std::size_t i = 0; i < sides.size(); ++i) {
      for (std::size_t k = i + 1; k < sides.size(); ++k) {
        if (sides[k].box.low.x > sides[i].box.high.x + near) break;
        if (!sides[i].isCrease && !sides[k].isCrease) continue;
        if (!areNear(sides[i].box, sides[k].box, near)) continue;
        if (areOne(sides[i], sides[k])) return repeated(sides[i], sides[k]);
        if (const std::optional<Vec2> where = clash(sides[i], sides[k]))
          return clashing(sides[i], sides[k], *where);
      }
    }
    return std::monostate{};
  }

  static bool areOne(const Side& a, const Side& b) {
    if (a.arc.isCurved || b.arc.isCurved) return false;
    return (a.from == b.from && a.to == b.to) || (a.from == b.to && a.to == b.from);
  }

  static Error repeated(const Side& a, const Side& b) {
    const bool isBorder = !a.isCrease || !b.isCrease;
    return wrongPattern("the crease from " + text(a.arc.start) + " to " + text(a.arc.end) +
                            (isBorder ? " mm lies on the border of the sheet; leave it out"
                                      : " mm is drawn twice; leave one of the two out"),
                        {a.arc.start, a.arc.end});
  }

  /// Where two sides meet that should not.
  std::optional<Vec2> clash(const Side& a, const Side& b) const {
    for (const Meeting& m : meetings(a.arc, b.arc, pattern_.tolerance)) {
      const VertexId atA = m.t == 0 ? a.from : a.to;
      const VertexId atB = m.u == 0 ? b.from : b.to;
      const bool isShared = (m.t == 0 || m.t == 1) && (m.u == 0 || m.u == 1) && atA == atB;
      if (!isShared) return pointAt(a.arc, m.t);
    }
    return std::nullopt;
  }

  static Error clashing(const Side& a, const Side& b, Vec2 where) {
    const Side& crease = a.isCrease ? a : b;
    const Side& other = a.isCrease ? b : a;
    return wrongPattern(
        "the crease from " + text(crease.arc.start) + " to " + text(crease.arc.end) + " mm meets " +
            (other.isCrease ? "that from " + text(other.arc.start) + " to " + text(other.arc.end)
                            : "the border of the sheet") +
            " at " + text(where) + " mm without a vertex; divide it there",
        {where});
  }

  Status checkThickness() const {
    for (std::size_t f = 0; f < pattern_.facets.size(); ++f) {
      const Region region = regionOf(pattern_, FacetId(f));
      const double width = 2 * areaOf(region) / perimeterOf(region, pattern_.tolerance.length());
      if (width > pattern_.tolerance.thin()) continue;
      const Vec2 p = region.loops[0][0].start;
      return Error{ErrorCode::TooThin,
                   "the creases leave a sliver of paper at " + text(p) +
                       " mm that is too thin to be folded; move its corners apart, or together",
                   {{p}, {}, {}}};
    }
    return std::monostate{};
  }

  Error dangling(const Edge& edge) const {
    const Vec2 a = pattern_[edge.from];
    const Vec2 b = pattern_[edge.to];
    return {ErrorCode::WouldStretch,
            "the crease from " + text(a) + " to " + text(b) +
                " mm ends inside a facet, so it cannot fold; lead it on to other creases or to "
                "the border, or leave it out",
            {{a, b}, {{a, b}}, {}}};
  }

  CreasePattern pattern_;
  const PatternStep& step_;
  std::size_t border_;  ///< edges of the sheet
  std::vector<VertexPlace> places_;
};

}  // namespace

Result<CreasedSheet> creasedSheet(const CreasePattern& sheet, const PatternStep& step) {
  return Creasing(sheet, step).run();
}

}  // namespace kiri
