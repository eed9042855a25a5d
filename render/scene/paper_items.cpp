// The paper of a picture: fills without cracks between them, and their borders.
// SPDX-License-Identifier: MIT
#include "render/scene/paper_items.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "render/scene/edge_on.h"
#include "render/scene/line_looks.h"
#include "render/scene/seen_texture.h"
#include "render/scene/silhouette.h"
#include "render/visibility/grid.h"
#include "render/visibility/slits.h"

namespace kiri {
namespace {

enum class SeamKind { Crease, Edge };

/// A hinge that lies flat between the two facets that are seen beside it is a crease; all else ends
/// paper or hides it.
SeamKind kindOf(const FoldedState& state, FacetId facet, const BoundaryPiece& piece) {
  if (piece.isSilhouette() || !piece.edge.isValid()) return SeamKind::Edge;
  const Edge& edge = state.pattern[piece.edge];
  const bool joins = (edge.left == facet && edge.right == piece.beyond) ||
                     (edge.right == facet && edge.left == piece.beyond);
  const bool isFlat = edge.kind == EdgeKind::Hinge && std::abs(edge.angle) <= kSameAngle;
  return joins && isFlat ? SeamKind::Crease : SeamKind::Edge;
}

/// A colour mixed with black, or with white beyond 1.
Color shaded(Color color, double brightness) {
  const auto mixed = [&](std::uint8_t c) {
    const double value = brightness <= 1 ? c * brightness : c + (255 - c) * (brightness - 1);
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
  };
  return {mixed(color.red), mixed(color.green), mixed(color.blue)};
}

class PaperItems {
 public:
  PaperItems(const FoldedState& state, const VisibleRegions& regions, const ViewFrame& view,
             const Affine& viewToScene, const Appearance& appearance)
      : state_(state),
        regions_(regions),
        view_(view),
        viewToScene_(viewToScene),
        appearance_(appearance) {
    for (const VisibleFacet& facet : regions.facets) fills_.emplace(facet.facet, fillFor(facet));
  }

  /// One chain for each seam, in the fill of the facet with the lower number.
  Group seams() const {
    Group group;
    for (const VisibleFacet& facet : regions_.facets) {
      StrokeItem item;
      for (const auto& loop : facet.loops) {
        for (const BoundaryPiece& piece : loop) {
          if (!piece.isSilhouette() && facet.facet < piece.beyond)
            item.chains.push_back({inScene(piece.arc)});
        }
      }
      if (item.chains.empty()) continue;
      const Fill& fill = fills_.at(facet.facet);
      item.stroke = {fill.color, kSeamWidth, {}, LineCap::Round, fill.image, fill.imageToScene};
      group.items.push_back({std::move(item), "seam", "", {}});
    }
    if (group.items.empty()) return group;
    group.clip = silhouetteOf(regions_);
    for (Loop& loop : group.clip) {
      for (Arc& arc : loop) arc = inScene(arc);
    }
    return group;
  }

  Group paper(const std::string& prefix) const {
    Group group;
    for (const VisibleFacet& facet : regions_.facets) {
      FillItem item{loopsOf(facet), fills_.at(facet.facet)};
      group.items.push_back({std::move(item),
                             facet.showsFront ? "front" : "back",
                             prefix + "facet-" + std::to_string(facet.facet.index),
                             {}});
    }
    return group;
  }

  /// Veils over textures, which cannot be shaded as colours can.
  Group veils() const {
    Group group;
    for (const VisibleFacet& facet : regions_.facets) {
      const double brightness = brightnessOf(facet);
      constexpr double kUnseen = 1.0 / 512;
      if (std::abs(brightness - 1) < kUnseen || !fills_.at(facet.facet).image) continue;
      FillItem item{loopsOf(facet), {}};
      const bool isDarker = brightness < 1;
      item.fill.color = isDarker ? Color{0, 0, 0} : Color{255, 255, 255};
      item.fill.opacity = isDarker ? 1 - brightness : brightness - 1;
      group.items.push_back({std::move(item), "shade", "", {}});
    }
    return group;
  }

  /// Creases, or the edges of paper; each seam once.
  Group lines(SeamKind kind, const Stroke& stroke, const char* name) const {
    StrokeItem item;
    item.stroke = stroke;
    if (kind == SeamKind::Edge) {
      item.chains = slits();
      for (const Arc& arc : edgeOnLines(state_, regions_, view_)) {
        item.chains.push_back({inScene(arc)});
      }
    }
    for (const VisibleFacet& facet : regions_.facets) {
      for (const auto& loop : facet.loops) {
        bool goesOn = false;
        for (const BoundaryPiece& piece : loop) {
          const bool isDrawn = (piece.isSilhouette() || facet.facet < piece.beyond) &&
                               kindOf(state_, facet.facet, piece) == kind;
          if (isDrawn && !goesOn) item.chains.emplace_back();
          if (isDrawn) item.chains.back().push_back(inScene(piece.arc));
          goesOn = isDrawn;
        }
      }
    }
    Group group;
    if (!item.chains.empty()) group.items.push_back({std::move(item), name, "", {}});
    return group;
  }

 private:
  Arc inScene(const Arc& arc) const { return transformed(viewToScene_, arc); }

  std::vector<Loop> loopsOf(const VisibleFacet& facet) const {
    std::vector<Loop> loops;
    for (const auto& loop : facet.loops) {
      Loop& arcs = loops.emplace_back();
      for (const BoundaryPiece& piece : loop) arcs.push_back(inScene(piece.arc));
    }
    return loops;
  }

  /// Tears and cuts that end inside a facet.
  std::vector<std::vector<Arc>> slits() const {
    std::vector<std::vector<Arc>> chains;
    for (const VisibleFacet& facet : regions_.facets) {
      for (const SlitPiece& piece : visibleSlits(state_, facet, view_)) {
        chains.push_back({inScene(piece.arc)});
      }
    }
    return chains;
  }

  /// How much lighter or darker than its own colour a facet looks: 1 where it is turned straight to
  /// the eye, whichever side of it. The lamp stands behind the left shoulder of the viewer, so that
  /// all that is seen is in its light.
  double brightnessOf(const VisibleFacet& facet) const {
    constexpr Vec3 kLamp{-0.42, 0.5, 0.757};  // in the axes of the view
    constexpr double kContrast = 0.6;
    constexpr double kDarkest = 0.5;
    if (!appearance_.isShaded) return 1;
    const Vec3 front = state_.poseOf(facet.facet).normal();
    const Vec3 normal = facet.showsFront ? front : -front;
    const Vec2 aside = view_.direction(normal);
    const double light = dot(Vec3{aside.x, aside.y, dot(normal, view_.toEye)}, kLamp);
    return std::max(kDarkest, 1 + kContrast * (light - kLamp.z));
  }

  Fill fillFor(const VisibleFacet& facet) const {
    Fill fill = unshadedFill(facet);
    fill.color = shaded(fill.color, brightnessOf(facet));
    return fill;
  }

  Fill unshadedFill(const VisibleFacet& facet) const {
    const Rigid& pose = state_.poseOf(facet.facet);
    if (!view_.isPerspective()) {
      return fillOf(appearance_, facet.showsFront, compose(viewToScene_, paperToView(pose, view_)));
    }
    Fill fill = fillOf(appearance_, facet.showsFront, {});
    if (!fill.image) return fill;
    const double scale = std::hypot(viewToScene_.a, viewToScene_.b);
    const Box box = grown(boundsOf(VisibleRegions{{facet}}), 2 * kSeamWidth / scale);
    const Vec2 size = box.high - box.low;
    fill.image = seenTexture(*fill.image, fill.imageToScene, pose, view_, box);
    fill.imageToScene = compose(viewToScene_, {size.x, 0, 0, size.y, box.low.x, box.low.y});
    return fill;
  }

  const FoldedState& state_;
  const VisibleRegions& regions_;
  const ViewFrame& view_;
  Affine viewToScene_;
  const Appearance& appearance_;
  std::map<FacetId, Fill> fills_;
};

void append(std::vector<Group>& groups, Group group, const std::string& id, const char* label) {
  if (group.items.empty()) return;
  group.id = id;
  group.label = label;
  groups.push_back(std::move(group));
}

}  // namespace

Affine paperToView(const Rigid& pose, const ViewFrame& view) {
  const Vec2 x = view.direction(pose.x);
  const Vec2 y = view.direction(pose.y);
  const Vec2 origin = view.project(pose.origin);
  return {x.x, x.y, y.x, y.y, origin.x, origin.y};
}

Fill fillOf(const Appearance& appearance, bool showsFront, const Affine& paperToScene) {
  const SideLook& side = showsFront ? appearance.front : appearance.back;
  Fill fill{side.color, side.texture, {}, 1};
  if (!side.texture) return fill;
  const Vec2 low = appearance.textureBox.low;
  const Vec2 size = appearance.textureBox.high - low;
  // The image of the back runs from right to left on the paper, so that it reads from left to right
  // there.
  const Affine imageToPaper = showsFront ? Affine{size.x, 0, 0, size.y, low.x, low.y}
                                         : Affine{-size.x, 0, 0, size.y, low.x + size.x, low.y};
  fill.imageToScene = compose(paperToScene, imageToPaper);
  return fill;
}

std::vector<Group> paperGroups(const FoldedState& state, const VisibleRegions& regions,
                               const ViewFrame& view, const Affine& viewToScene,
                               const Appearance& appearance, const std::string& prefix) {
  const PaperItems items(state, regions, view, viewToScene, appearance);
  std::vector<Group> groups;
  append(groups, items.seams(), prefix + "seams", "seams below the paper");
  append(groups, items.paper(prefix), prefix + "paper", "paper");
  append(groups, items.veils(), prefix + "shades", "shades over textures");
  if (appearance.showCreases) {
    append(groups, items.lines(SeamKind::Crease, creaseStroke(appearance), "crease"),
           prefix + "creases", "creases");
  }
  if (appearance.showEdges) {
    append(groups, items.lines(SeamKind::Edge, edgeStroke(appearance), "edge"), prefix + "edges",
           "edges");
  }
  return groups;
}

}  // namespace kiri
