// The faces of a drawing, for a FOLD file.
// SPDX-License-Identifier: MIT
#include "io/patterns/fold_faces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "core/creases/repair.h"

namespace kiri {

namespace {

struct LowerLeft {
  bool operator()(Vec2 a, Vec2 b) const { return a.x != b.x ? a.x < b.x : a.y < b.y; }
};

using VertexIndex = std::map<Vec2, std::uint32_t, LowerLeft>;
using Run = std::vector<std::uint32_t>;

std::set<std::pair<std::uint32_t, std::uint32_t>> sidesOf(const VertexList& vertices) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> out;
  for (const auto& [a, b] : vertices.edges) out.insert(std::minmax(a, b));
  return out;
}

VertexIndex indexOfPlaces(const VertexList& vertices) {
  VertexIndex out;
  for (std::uint32_t v = 0; v < vertices.places.size(); ++v) out.emplace(vertices.places[v], v);
  return out;
}

double doubledAreaOf(const VertexList& vertices, const Run& face) {
  double sum = 0;
  const Vec2 origin = vertices.places[face.front()];
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    sum += cross(vertices.places[face[i]] - origin, vertices.places[face[i + 1]] - origin);
  }
  return sum;
}

/// The faces that the drawing itself names; none when a side of them is no line.
std::optional<std::vector<Run>> ownFaces(const CreaseDrawing& drawing, const VertexList& vertices) {
  if (drawing.faces.empty()) return std::nullopt;
  const auto sides = sidesOf(vertices);
  const VertexIndex index = indexOfPlaces(vertices);
  std::vector<Run> out;
  for (const std::vector<Vec2>& face : drawing.faces) {
    Run& run = out.emplace_back();
    for (const Vec2 p : face) {
      const auto at = index.find(p);
      if (at == index.end()) return std::nullopt;
      run.push_back(at->second);
    }
    if (run.size() < 3) return std::nullopt;
    for (std::size_t i = 0; i < run.size(); ++i) {
      if (sides.count(std::minmax(run[i], run[(i + 1) % run.size()])) == 0) return std::nullopt;
    }
    if (doubledAreaOf(vertices, run) < 0) std::reverse(run.begin(), run.end());
  }
  return out;
}

/// The facets of the planar map as faces; fails where the map is not what was drawn.
FaceList facesOfMap(const CreaseDrawing& drawing, const VertexList& vertices) {
  const Result<RepairedPattern> repaired = patternOf(drawing);
  if (!repaired) return {{}, "the faces of the pattern were left out: " + repaired.error().message};
  if (!repaired->repairs.empty()) {
    return {{},
            "the faces of the pattern were left out: it needs repairs before it is a planar map (" +
                repaired->repairs.front().message + ")"};
  }
  const CreasePattern& pattern = repaired->creases.pattern;
  const VertexIndex index = indexOfPlaces(vertices);
  FaceList out;
  for (const Facet& facet : pattern.facets) {
    if (!facet.holeStarts.empty()) {
      return {{}, "the faces of the pattern were left out: FOLD has no faces with holes"};
    }
    Run& run = out.faces.emplace_back();
    for (const EdgeUse use : facet.border) {
      const auto at = index.find(pattern[startOf(pattern, use)]);
      if (at == index.end()) {
        return {{},
                "the faces of the pattern were left out: it needs repairs before it is a "
                "planar map"};
      }
      run.push_back(at->second);
    }
  }
  return out;
}

/// Finds faces by points, with the faces in strips by y.
class FaceFinder {
 public:
  FaceFinder(const VertexList& vertices, const std::vector<Run>& faces)
      : vertices_(vertices), faces_(faces) {
    for (const Vec2 p : vertices.places) {
      low_ = std::min(low_, p.y);
      high_ = std::max(high_, p.y);
    }
    strips_.resize(1 + static_cast<std::size_t>(std::sqrt(static_cast<double>(faces.size()))));
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
      double bottom = vertices.places[faces[f][0]].y;
      double top = bottom;
      for (const std::uint32_t v : faces[f]) {
        bottom = std::min(bottom, vertices.places[v].y);
        top = std::max(top, vertices.places[v].y);
      }
      for (std::size_t s = stripOf(bottom); s <= stripOf(top); ++s) strips_[s].push_back(f);
    }
  }

  std::optional<std::uint32_t> at(Vec2 p) {
    const auto [entry, isNew] = known_.emplace(p, std::nullopt);
    if (!isNew) return entry->second;
    for (const std::uint32_t f : strips_[stripOf(p.y)]) {
      if (!holds(faces_[f], p)) continue;
      entry->second = f;
      break;
    }
    return entry->second;
  }

 private:
  std::size_t stripOf(double y) const {
    const double part = high_ > low_ ? (y - low_) / (high_ - low_) : 0;
    const double strip = std::clamp(part, 0.0, 1.0) * static_cast<double>(strips_.size());
    return std::min(static_cast<std::size_t>(strip), strips_.size() - 1);
  }

  bool holds(const Run& face, Vec2 p) const {
    bool isInside = false;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Vec2 a = vertices_.places[face[i]];
      const Vec2 b = vertices_.places[face[(i + 1) % face.size()]];
      if ((a.y > p.y) == (b.y > p.y)) continue;
      const bool isLeft = (cross(b - a, p - a) > 0) == (b.y > a.y);
      if (isLeft) isInside = !isInside;
    }
    return isInside;
  }

  const VertexList& vertices_;
  const std::vector<Run>& faces_;
  double low_ = 0;
  double high_ = 0;
  std::vector<std::vector<std::uint32_t>> strips_;
  std::map<Vec2, std::optional<std::uint32_t>, LowerLeft> known_;
};

}  // namespace

VertexList verticesOf(const CreaseDrawing& drawing) {
  VertexList out;
  VertexIndex index;
  const auto vertexAt = [&](Vec2 p) {
    const auto [at, isNew] = index.emplace(p, static_cast<std::uint32_t>(out.places.size()));
    if (isNew) out.places.push_back(p);
    return at->second;
  };
  for (const DrawnCrease& line : drawing.lines) {
    const std::uint32_t from = vertexAt(line.from);
    out.edges.emplace_back(from, vertexAt(line.to));
  }
  return out;
}

FaceList facesOf(const CreaseDrawing& drawing, const VertexList& vertices) {
  if (std::optional<std::vector<Run>> own = ownFaces(drawing, vertices)) return {*own, ""};
  return facesOfMap(drawing, vertices);
}

std::vector<FoldOrder> ordersOf(const CreaseDrawing& drawing, const VertexList& vertices,
                                const FaceList& faces, std::size_t& lost) {
  std::vector<FoldOrder> out;
  lost = 0;
  if (faces.faces.empty()) {
    lost = drawing.orders.size();
    return out;
  }
  FaceFinder finder(vertices, faces.faces);
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
  for (const DrawnOrder& order : drawing.orders) {
    const std::optional<std::uint32_t> f = finder.at(order.upper);
    const std::optional<std::uint32_t> g = finder.at(order.lower);
    if (!f || !g || *f == *g) {
      ++lost;
    } else if (seen.emplace(*f, *g).second) {
      out.push_back({*f, *g, order.isFront ? 1 : -1});
    }
  }
  return out;
}

}  // namespace kiri
