// Facets whose orders contradict each other: on the paper and where they lie folded.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <utility>

#include "core/paper/boxes.h"
#include "render/scene/assigned_items.h"
#include "render/scene/label_room.h"
#include "render/scene/page.h"
#include "render/scene/page_text.h"
#include "render/scene/paled.h"
#include "render/scene/pattern_check_scene.h"
#include "render/scene/pattern_page.h"

namespace kiri {
namespace {

/// Apart for all eyes (after Okabe and Ito).
constexpr std::array<Color, 7> kFacetColors{{{230, 159, 0},
                                             {86, 180, 233},
                                             {0, 158, 115},
                                             {240, 228, 66},
                                             {0, 114, 178},
                                             {213, 94, 0},
                                             {204, 121, 167}}};

Color colorOfFacet(std::size_t number) { return kFacetColors[number % kFacetColors.size()]; }

Affine affineOf(const FlatPose& pose) {
  return {pose.x.x, pose.x.y, pose.y.x, pose.y.y, pose.origin.x, pose.origin.y};
}

Item filledFacet(std::vector<Loop> loops, Color color, double opacity, const std::string& kind) {
  FillItem item;
  item.loops = std::move(loops);
  item.fill.color = color;
  item.fill.opacity = opacity;
  return {std::move(item), kind, "", {}};
}

Item outlinedFacet(std::vector<Loop> loops, Color color, double width, const std::string& kind) {
  StrokeItem item;
  item.chains = std::move(loops);
  item.stroke.color = color;
  item.stroke.width = width;
  return {std::move(item), kind, "", {}};
}

/// The box of the folded paper, folded plane.
Box foldedBox(const AssignedPattern& creases, const FlatMap& map) {
  Box box;
  bool isEmpty = true;
  for (std::size_t f = 0; f < creases.pattern.facets.size(); ++f) {
    for (const Loop& loop : facetLoops(creases.pattern, FacetId(f), affineOf(map.poses[f]))) {
      for (const Arc& arc : loop) {
        box = isEmpty ? boundsOf(arc) : joined(box, boundsOf(arc));
        isEmpty = false;
      }
    }
  }
  return box;
}

class ConflictItems {
 public:
  ConflictItems(const AssignedPattern& creases, const OrderConflict& conflict, const Box& page)
      : creases_(creases), conflict_(conflict), page_(page) {}

  /// The facets on the paper.
  Group facets(const Affine& toScene) const {
    Group group{"facets", "facets of the conflict", {}, {}};
    for (std::size_t i = 0; i < conflict_.facets.size(); ++i) {
      std::vector<Loop> loops = facetLoops(creases_.pattern, conflict_.facets[i], toScene);
      group.items.push_back(filledFacet(std::move(loops), colorOfFacet(i), 0.75, "facet"));
    }
    return group;
  }

  /// All paper as it lies folded, and its edges.
  Group folded(const FlatMap& map, const Affine& toScene, const Appearance& appearance) const {
    Group group{"folded", "the folded paper", {}, {}};
    for (std::size_t f = 0; f < creases_.pattern.facets.size(); ++f) {
      const Affine place = compose(toScene, affineOf(map.poses[f]));
      group.items.push_back(filledFacet(facetLoops(creases_.pattern, FacetId(f), place),
                                        appearance.front.color, 1, "paper"));
    }
    constexpr double kThin = 0.1;
    for (std::size_t f = 0; f < creases_.pattern.facets.size(); ++f) {
      const Affine place = compose(toScene, affineOf(map.poses[f]));
      group.items.push_back(outlinedFacet(facetLoops(creases_.pattern, FacetId(f), place),
                                          {190, 190, 190}, kThin, "edge"));
    }
    return group;
  }

  Group foldedFacets(const FlatMap& map, const Affine& toScene) const {
    Group group{"folded-facets", "facets of the conflict, folded", {}, {}};
    for (std::size_t i = 0; i < conflict_.facets.size(); ++i) {
      const FacetId f = conflict_.facets[i];
      const Affine place = compose(toScene, affineOf(map.poses[f.index]));
      const std::vector<Loop> loops = facetLoops(creases_.pattern, f, place);
      group.items.push_back(filledFacet(loops, colorOfFacet(i), 0.35, "facet"));
      group.items.push_back(outlinedFacet(loops, colorOfFacet(i), kMarkWidth, "facet"));
    }
    return group;
  }

  Group numbers(const std::string& id, const Affine& toScene, const FlatMap* map) const {
    Group group{id, "numbers of the facets", {}, {}};
    LabelRoom labels(page_);
    for (std::size_t i = 0; i < conflict_.facets.size(); ++i) {
      const FacetId f = conflict_.facets[i];
      Vec2 at = interiorPointOf(creases_.pattern, f);
      if (map != nullptr) at = map->poses[f.index].apply(at);
      const std::string number = std::to_string(i + 1);
      const Vec2 middle = labels.takeAround(
          toScene.apply(at), {widthOf(number, kWordHeight), kWordHeight}, -kWordHeight / 2);
      const TextItem text = centredText(number, kWordHeight, middle, {0, 0, 0});
      group.items.push_back({text, "number", "", {{"facet", std::to_string(f.index)}}});
    }
    return group;
  }

 private:
  const AssignedPattern& creases_;
  const OrderConflict& conflict_;
  Box page_;
};

}  // namespace

Scene orderConflictScene(const AssignedPattern& creases, const FlatMap& map,
                         const OrderConflict& conflict, const Appearance& appearance,
                         const PatternCheckOptions& options) {
  const Box box = paperBoxOf(creases.pattern);
  const Box folded = foldedBox(creases, map);
  const Vec2 size = box.high - box.low;
  const double larger = std::max(size.x, size.y);
  const double scale = larger > 0 ? options.size / larger : 1;
  // Folded paper is smaller: as large as the pattern is high, if that is not too much.
  const Vec2 foldedSize = folded.high - folded.low;
  const double foldedLarger = std::max(foldedSize.x, foldedSize.y);
  constexpr double kMostLarger = 3;
  const double foldedScale =
      foldedLarger > 0 ? std::min(options.size / foldedLarger, kMostLarger * scale) : scale;
  const double gap = 2 * options.margin;
  const Vec2 pictures{size.x * scale + gap + foldedSize.x * foldedScale,
                      std::max(size.y * scale, foldedSize.y * foldedScale)};
  std::vector<LegendLine> legend;
  if (!conflict.message.empty()) legend.push_back({{}, conflict.message, {}});
  const PatternPage page(pictures, legend, options);
  const Affine toScene = placed(box, scale, page.corner());
  const Affine toFolded =
      placed(folded, foldedScale, page.corner() + Vec2{size.x * scale + gap, 0});
  const Appearance pale = paledFor(appearance);
  const double width = std::min(appearance.drawnWidth, kMarkWidth * 0.7);
  std::vector<Group> groups = assignedGroups(creases, toScene, pale, width);
  const ConflictItems items(creases, conflict, page.pictures());
  // The facets lie on the paper, below the creases.
  groups.insert(groups.begin() + 1, items.facets(toScene));
  groups.push_back(items.numbers("numbers", toScene, nullptr));
  groups.push_back(items.folded(map, toFolded, pale));
  groups.push_back(items.foldedFacets(map, toFolded));
  groups.push_back(items.numbers("folded-numbers", toFolded, &map));
  return page.scene(std::move(groups));
}

}  // namespace kiri
