// The paper of a picture: fills without cracks between them, and their borders.
// SPDX-License-Identifier: MIT
#include "render/scene/paper_items.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "render/scene/line_looks.h"
#include "render/scene/seen_texture.h"
#include "render/visibility/grid.h"
#include "render/visibility/projection.h"

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
    if (!group.items.empty()) group.clip = silhouetteLoops();
    return group;
  }

  Group paper(const std::string& prefix) const {
    Group group;
    for (const VisibleFacet& facet : regions_.facets) {
      FillItem item;
      item.fill = fills_.at(facet.facet);
      for (const auto& loop : facet.loops) {
        Loop& arcs = item.loops.emplace_back();
        for (const BoundaryPiece& piece : loop) arcs.push_back(inScene(piece.arc));
      }
      group.items.push_back({std::move(item),
                             facet.showsFront ? "front" : "back",
                             prefix + "facet-" + std::to_string(facet.facet.index),
                             {}});
    }
    return group;
  }

  /// Creases, or the edges of paper; each seam once.
  Group lines(SeamKind kind, const Stroke& stroke, const char* name) const {
    StrokeItem item;
    item.stroke = stroke;
    if (kind == SeamKind::Edge) item.chains = slits();
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

  /// Tears and cuts that end inside a facet take nothing away from what is seen of it; what is seen
  /// of them is drawn all the same.
  std::vector<std::vector<Arc>> slits() const {
    std::vector<std::vector<Arc>> chains;
    for (const VisibleFacet& facet : regions_.facets) {
      for (const EdgeUse use : state_.pattern[facet.facet].border) {
        const Edge& edge = state_.pattern[use.edge];
        if (use.isReversed || edge.left != edge.right || edge.kind == EdgeKind::Hinge) continue;
        std::vector<SeenArc> seen;
        appendSeen(arcOf(state_.pattern, use), state_.poseOf(facet.facet), view_,
                   state_.tolerance().match(), seen);
        for (const SeenArc& piece : seen) {
          for (const Arc& part : partsInside(facet, piece.arc)) chains.push_back({inScene(part)});
        }
      }
    }
    return chains;
  }

  /// The parts of an arc that lie inside what is seen of a facet.
  std::vector<Arc> partsInside(const VisibleFacet& facet, const Arc& arc) const {
    const Tolerance& tolerance = state_.tolerance();
    Region region;
    std::vector<double> breaks{0, 1};
    for (const auto& loop : facet.loops) {
      Loop& arcs = region.loops.emplace_back();
      for (const BoundaryPiece& piece : loop) {
        arcs.push_back(piece.arc);
        for (const Meeting& meeting : meetings(arc, piece.arc, tolerance))
          breaks.push_back(meeting.t);
      }
    }
    std::sort(breaks.begin(), breaks.end());
    std::vector<Arc> inside;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      if (breaks[i + 1] - breaks[i] <= kParallel) continue;
      const Vec2 middle = pointAt(arc, (breaks[i] + breaks[i + 1]) / 2);
      if (locate(region, middle, tolerance.length()) != Where::Inside) continue;
      inside.push_back(part(arc, breaks[i], breaks[i + 1]));
    }
    return inside;
  }

  Fill fillFor(const VisibleFacet& facet) const {
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

  /// The silhouette as loops with the paper on their left. Pieces meet at the very same points.
  std::vector<Loop> silhouetteLoops() const {
    std::map<std::pair<double, double>, std::vector<const Arc*>> byStart;
    for (const VisibleFacet& facet : regions_.facets) {
      for (const auto& loop : facet.loops) {
        for (const BoundaryPiece& piece : loop) {
          if (piece.isSilhouette())
            byStart[{piece.arc.start.x, piece.arc.start.y}].push_back(&piece.arc);
        }
      }
    }
    std::vector<Loop> loops;
    for (auto it = byStart.begin(); it != byStart.end(); ++it) {
      while (!it->second.empty()) {
        Loop loop;
        for (auto at = it; at != byStart.end() && !at->second.empty();) {
          const Arc* arc = at->second.back();
          at->second.pop_back();
          loop.push_back(inScene(*arc));
          at = byStart.find({arc->end.x, arc->end.y});
        }
        loops.push_back(std::move(loop));
      }
    }
    return loops;
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
  Fill fill{side.color, side.texture, {}};
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
