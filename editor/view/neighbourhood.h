// The paper around a pixel: what lies there, in which order, and what of it is seen.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "editor/view/picking.h"

namespace kiri {

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

  /// True when all that is seen right around a pixel is the paper of `top`, seen there: the pixel
  /// is not on its border, and no other plane touches it there.
  bool coversAllAround(const PaperPick& top, Vec2 pixels) const;

  /// Adds the directions, degrees counter-clockwise in the view, 0 to 360, in which what is seen
  /// may change around a point of the pane for the sake of a facet: in which its edges leave the
  /// point, and in which planes that touch it there cross its plane.
  void addDirections(FacetId facet, Vec2 pixels, std::vector<double>& degrees) const;

  /// True when `a` is over `b` where both appear at the pixel.
  bool isOver(FacetId a, FacetId b, Vec2 pixels) const;

  /// The facets near that may be seen, by layer-set. Left out are those that lie exactly under
  /// another one as far as the radius goes, as in a stack.
  const std::vector<FacetId>& facets() const { return ids_; }

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
    std::vector<Near> all;
    std::vector<Near> open;  ///< without those that lie exactly under another
  };
  struct Hit {
    PaperPick pick;
    bool isInside = false;  ///< not on the border
  };

  void gather(Vec2 pixels, double radius);
  void sortLayers();
  void leaveOutCovered(Layers& layers, Vec2 pixels, double radius) const;
  std::optional<Hit> hit(const Near& facet, Vec2 pixels) const;
  std::optional<Hit> topOf(const Layers& layers, Vec2 pixels) const;
  std::optional<Hit> topHit(Vec2 pixels) const;
  bool isOverInSet(const Layers& layers, FacetId a, FacetId b) const;
  std::vector<FacetId> touchingAt(const PaperPick& place, Vec2 pixels) const;
  void addEdgeDirections(const Spot& spot, std::vector<double>& degrees) const;
  void addDirection(const Spot& spot, Vec3 direction, std::vector<double>& degrees) const;

  const FoldedState& state_;
  const PaneMap& map_;
  std::vector<Layers> sets_;
  std::vector<FacetId> ids_;
};

}  // namespace kiri
