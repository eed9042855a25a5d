// Looking around a point, sector by sector.
// SPDX-License-Identifier: MIT
#include "editor/view/seen_places.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/rigid.h"

namespace kiri {
namespace {

constexpr double kFullTurn = 360;

bool holdsFacet(const std::vector<FacetId>& facets, FacetId facet) {
  return std::find(facets.begin(), facets.end(), facet) != facets.end();
}

/// Adds a direction; false when it is there already.
bool insert(std::vector<double>& sorted, double degrees) {
  constexpr double kNarrow = 1.0 / 1024;  // degrees: no paper is seen between two edges there
  for (const double known : sorted) {
    const double apart = std::abs(known - degrees);
    if (std::min(apart, kFullTurn - apart) < kNarrow) return false;
  }
  sorted.insert(std::upper_bound(sorted.begin(), sorted.end(), degrees), degrees);
  return true;
}

}  // namespace

SeenPlaces::Key SeenPlaces::keyOf(Vec2 pixels) {
  constexpr double kCells = 1 << 16;  // a pixel, each way: far finer than a hand, above rounding
  return {std::round(pixels.x * kCells), std::round(pixels.y * kCells)};
}

SeenPlaces::Point& SeenPlaces::at(Vec2 pixels) {
  const auto [found, isNew] = known_.try_emplace(keyOf(pixels));
  Point& point = found->second;
  if (!isNew) return point;
  point.pixels = pixels;
  if (const std::optional<PaperPick> top = near_.top(pixels)) {
    point.isCovered = near_.coversAllAround(*top, pixels);
    if (point.isCovered) point.seen.push_back(top->spot.facet);
    if (!point.isCovered) look(point, top->spot.facet);
  }
  return point;
}

/// The paper in the middle of the sector that begins at an edge.
FacetId SeenPlaces::uppermostAfter(const Point& point, std::size_t edge) const {
  const bool isLast = edge + 1 == point.edges.size();
  const double next = isLast ? point.edges.front() + kFullTurn : point.edges[edge + 1];
  const CosSin towards = cosSinDegrees((point.edges[edge] + next) / 2);
  // Near enough that nothing else comes in, farther than borders are wide.
  constexpr double kStep = 0.25;  // pixels
  constexpr double kBorderWidths = 8;
  const Tolerance& tolerance = near_.state().tolerance();
  const double perMm = near_.map().pixelsPerMm;
  const double step = std::max(std::min(tolerance.thin() * perMm, kStep),
                               kBorderWidths * tolerance.match() * perMm);
  const std::optional<PaperPick> top =
      near_.top(point.pixels + Vec2{towards.cos, -towards.sin} * step);
  return top ? top->spot.facet : FacetId();
}

/// Lets the edges of a facet divide the directions around the point; then those of all facets that
/// turn out to be seen, until nothing new turns up. In each sector the uppermost facet then covers
/// all of it, and this facet is over or under that one in all of it.
void SeenPlaces::look(Point& point, FacetId facet) const {
  std::vector<FacetId> waiting{facet};
  std::vector<double> directions;
  while (!waiting.empty()) {
    directions.clear();
    near_.addDirections(waiting.back(), point.pixels, directions);
    waiting.pop_back();
    bool isDivided = false;
    for (const double degrees : directions) isDivided = insert(point.edges, degrees) || isDivided;
    if (!isDivided) continue;
    for (std::size_t i = 0; i < point.edges.size(); ++i) {
      const FacetId uppermost = uppermostAfter(point, i);
      if (!uppermost.isValid() || holdsFacet(point.seen, uppermost)) continue;
      point.seen.push_back(uppermost);
      waiting.push_back(uppermost);
    }
  }
}

bool SeenPlaces::has(FacetId facet, Vec2 pixels) {
  Point& point = at(pixels);
  if (holdsFacet(point.seen, facet)) return true;
  if (point.isCovered) return false;
  look(point, facet);
  return holdsFacet(point.seen, facet);
}

}  // namespace kiri
