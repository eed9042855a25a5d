// The edges around a pixel, and what is seen of them.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "editor/view/neighbourhood.h"
#include "editor/view/seen_places.h"
#include "render/visibility/projection.h"

namespace kiri {

/// A point of an edge: exactly on the paper's own curve, of which a picture in perspective is only
/// near.
struct EdgePoint {
  double t = 0;  ///< on the part of the edge that is looked at
  Vec2 paper;
  Vec2 at;            ///< pixels
  double pixels = 0;  ///< from the place that was asked about
};

/// An edge of a facet, or a part of a curved one, near a pixel.
struct EdgeInView {
  FacetId facet;
  EdgeUse use;
  SeenArc seen;       ///< view coordinates; runs as the use does
  EdgePoint nearest;  ///< hidden or not
};

/// Keeps references to what it is given.
class EdgesNear {
 public:
  /// The edges within `radius` of a pixel.
  EdgesNear(const Neighbourhood& near, SeenPlaces& seen, Vec2 pixels, double radius);

  /// Hidden or not, the nearest first.
  const std::vector<EdgeInView>& all() const { return edges_; }
  /// True when the nearest point is seen.
  bool isSeen(const EdgeInView& edge);
  /// The nearest point that is seen, of an edge whose nearest point is hidden: found among points
  /// along the edge, then between a hidden and a seen one.
  std::optional<EdgePoint> fromUnder(const EdgeInView& edge);

 private:
  using Key = std::tuple<SeenPlaces::Key, SeenPlaces::Key>;
  void add(FacetId facet, EdgeUse use, const SeenArc& part);
  EdgePoint pointOf(const EdgeInView& edge, double t) const;
  std::vector<EdgePoint> pointsBeside(const EdgeInView& edge, double side) const;
  Key keyOf(const EdgeInView& edge) const;

  const Neighbourhood& near_;
  SeenPlaces& seen_;
  Vec2 pixels_;
  double radius_;
  std::vector<EdgeInView> edges_;
  /// What is seen along straight edges that were looked along, by their ends and sides: the edges
  /// of a stack lie on each other.
  std::map<Key, std::vector<FacetId>> along_;
};

}  // namespace kiri
