// The paper around a pixel: what lies there, in which order, and what of it is seen.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "editor/view/picking.h"
#include "render/visibility/projection.h"

namespace kiri {

/// An edge of a facet as it appears in the pane. Curved edges may come in several parts.
struct EdgeInView {
  FacetId facet;
  EdgeUse use;
  SeenArc seen;  ///< view coordinates; runs as the use does
};

/// The facets that appear within some pixels of a place of the pane, looked up once for many
/// questions. Facets seen edge-on are left out. Keeps references to state and map. Cost: one walk
/// along all borders; then each question costs the facets near it, and for a stack those that are
/// tried from the top down.
class Neighbourhood {
 public:
  Neighbourhood(const FoldedState& state, const PaneMap& map, Vec2 pixels, double radius);

  /// The paper seen at a pixel not farther than the radius.
  std::optional<PaperPick> top(Vec2 pixels) const;
  /// All paper there, from the eye on.
  std::vector<PaperPick> stack(Vec2 pixels) const;

  /// The facets that are seen at a point of the pane or in some direction right beside it: at a
  /// corner, all that meet there and are not covered. Directions are told apart exactly, by the
  /// edges that pass through the point.
  std::vector<FacetId> seenAround(Vec2 pixels) const;

  /// True when `a` is over `b` where both appear at the pixel.
  bool isOver(FacetId a, FacetId b, Vec2 pixels) const;

  /// All facets near, by layer-set.
  const std::vector<FacetId>& facets() const { return ids_; }
  /// The edges of the facets near, those of one facet after the other.
  std::vector<EdgeInView> edges() const;

  const FoldedState& state() const { return state_; }
  const PaneMap& map() const { return map_; }

 private:
  struct Near {
    FacetId id;
    Box paper;  ///< of the border, in the paper frame
  };
  /// Near facets of one layer-set, the uppermost to the eye first as its list says.
  struct Layers {
    std::uint32_t set = 0;
    bool isFlipped = false;
    std::vector<Near> facets;
  };
  struct Hit {
    PaperPick pick;
    bool isInside = false;  ///< not on the border
  };

  void gather(Vec2 pixels, double radius);
  void sortLayers();
  std::optional<Hit> hit(const Near& facet, Vec2 pixels) const;
  std::optional<Hit> topOf(const Layers& layers, Vec2 pixels) const;
  std::optional<Hit> topHit(Vec2 pixels) const;
  bool isOverInSet(const Layers& layers, FacetId a, FacetId b) const;
  void collectDirections(const Near& facet, Vec2 pixels, std::vector<double>& degrees) const;

  const FoldedState& state_;
  const PaneMap& map_;
  std::vector<Layers> sets_;
  std::vector<FacetId> ids_;
};

/// What is seen around points of a neighbourhood, remembered: in a stack, many things lie at few
/// points. Keeps a reference.
class SeenPlaces {
 public:
  explicit SeenPlaces(const Neighbourhood& near) : near_(near) {}

  /// True when paper of the facet is seen at the pixel or right beside it.
  bool has(FacetId facet, Vec2 pixels);

 private:
  const Neighbourhood& near_;
  std::map<std::pair<double, double>, std::vector<FacetId>> known_;  ///< by rounded pixels
};

/// A point of an edge, exactly on the paper's own curve, wherever its picture is only near.
struct EdgePoint {
  double t = 0;  ///< on the part of the edge that is looked at
  Vec2 paper;
  Vec2 at;            ///< pixels
  double pixels = 0;  ///< from what it was asked for
};

/// The point of an edge at `t`, and how far it is from a pixel.
EdgePoint pointOf(const EdgeInView& edge, double t, const Neighbourhood& near, Vec2 pixels);

/// An edge within a radius.
struct EdgeNear {
  std::size_t number = 0;  ///< in the list of edges
  EdgePoint nearest;
};

/// The edges within `radius` pixels, hidden or not, the nearest first.
std::vector<EdgeNear> edgesNear(const std::vector<EdgeInView>& edges, const Neighbourhood& near,
                                Vec2 pixels, double radius);

/// The nearest point of an edge that is seen, where its nearest point `hidden` is not: found among
/// points along the edge, then between a hidden and a seen one.
std::optional<EdgePoint> nearestSeen(const EdgeInView& edge, const Neighbourhood& near,
                                     SeenPlaces& seen, Vec2 pixels, double radius, double hidden);

/// pickVertex and pickEdge within the radius of a neighbourhood.
std::optional<VertexPick> pickVertex(const Neighbourhood& near, Vec2 pixels, double radius);
std::optional<EdgePick> pickEdge(const Neighbourhood& near, Vec2 pixels, double radius);

}  // namespace kiri
