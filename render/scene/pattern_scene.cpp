// A picture of the unfolded sheet with its crease pattern.
// SPDX-License-Identifier: MIT
#include "render/scene/pattern_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/paper/contours.h"
#include "render/scene/line_looks.h"
#include "render/scene/page.h"
#include "render/scene/paper_items.h"

namespace kiri {
namespace {

bool isFolded(const Edge& edge) { return std::abs(edge.angle) > kSameAngle; }

/// Mountain or valley as the front of the paper shows it.
LineKind kindOf(const Edge& edge) {
  if (edge.kind == EdgeKind::Border || edge.kind == EdgeKind::Cut) return LineKind::Border;
  if (edge.kind == EdgeKind::Tear) return LineKind::Tear;
  if (isFolded(edge)) return edge.angle > 0 ? LineKind::Valley : LineKind::Mountain;
  if (!edge.line.isValid()) return LineKind::Flat;
  return edge.sign > 0 ? LineKind::Valley : LineKind::Mountain;
}

/// The letter that FOLD files and Rabbit Ear use for the kind.
const char* assignmentOf(LineKind kind, bool isFoldedNow) {
  if (kind == LineKind::Tear || kind == LineKind::Border) return "C";
  if (!isFoldedNow) return "F";
  return kind == LineKind::Valley ? "V" : "M";
}

std::string degrees(double angle) {
  constexpr double kSteps = 1000;  // a thousandth of a degree is enough for a drawing
  std::string text = std::to_string(std::round(angle * kSteps) / kSteps);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

class PatternItems {
 public:
  PatternItems(const FoldedState& state, const Appearance& appearance, const Affine& toScene)
      : pattern_(state.pattern), appearance_(appearance), toScene_(toScene) {}

  std::vector<Loop> rim() const {
    std::vector<Loop> loops;
    for (const std::vector<EdgeUse>& contour : contoursOf(pattern_)) {
      Loop& loop = loops.emplace_back();
      for (const EdgeUse use : contour) loop.push_back(transformed(toScene_, arcOf(pattern_, use)));
    }
    return loops;
  }

  /// The paper as it lies unfolded: one region, so that there are no seams.
  Group print(const std::vector<Loop>& rim) const {
    FillItem item{rim, fillOf(appearance_, true, toScene_)};
    return {"print", "paper", {{std::move(item), "paper", "", {}}}, {}};
  }

  Group cut(const std::vector<Loop>& rim) const {
    Group group{"cut", "cut", {}, {}};
    for (const Loop& loop : rim) {
      const Stroke stroke = strokeFor(LineKind::Border, appearance_, appearance_.edgeWidth);
      group.items.push_back({StrokeItem{{loop}, stroke}, "border", "", {{"assignment", "B"}}});
    }
    for (std::size_t e = 0; e < pattern_.edges.size(); ++e) {
      const EdgeKind kind = pattern_.edges[e].kind;
      const bool isOpen = kind == EdgeKind::Tear || kind == EdgeKind::Cut;
      if (isOpen) group.items.push_back(lineItem(EdgeId(e)));
    }
    return group;
  }

  Group hinges(LineKind kind) const {
    Group group{nameOf(kind), nameOf(kind), {}, {}};
    for (std::size_t e = 0; e < pattern_.edges.size(); ++e) {
      const Edge& edge = pattern_.edges[e];
      if (edge.kind != EdgeKind::Hinge || kindOf(edge) != kind) continue;
      if (!appearance_.showCreases && !isFolded(edge)) continue;
      group.items.push_back(lineItem(EdgeId(e)));
    }
    return group;
  }

 private:
  Item lineItem(EdgeId id) const {
    const Edge& edge = pattern_[id];
    const LineKind kind = kindOf(edge);
    const bool isThin = edge.kind == EdgeKind::Hinge && !isFolded(edge);
    const double width = isThin ? appearance_.creaseWidth : appearance_.drawnWidth;
    StrokeItem item{{{transformed(toScene_, arcOf(pattern_, id))}},
                    strokeFor(kind, appearance_, width)};
    Item out{std::move(item), nameOf(kind), "edge-" + std::to_string(id.index), {}};
    out.data.emplace_back("assignment", assignmentOf(kind, isFolded(edge)));
    if (edge.kind == EdgeKind::Hinge) out.data.emplace_back("foldAngle", degrees(edge.angle));
    return out;
  }

  const CreasePattern& pattern_;
  const Appearance& appearance_;
  Affine toScene_;
};

Box boxOf(const CreasePattern& pattern) {
  Box box;
  bool isEmpty = true;
  for (std::size_t e = 0; e < pattern.edges.size(); ++e) {
    if (!pattern.edges[e].left.isValid() && !pattern.edges[e].right.isValid()) continue;
    const Box b = boundsOf(arcOf(pattern, EdgeId(e)));
    box = isEmpty ? b : joined(box, b);
    isEmpty = false;
  }
  return box;
}

}  // namespace

Affine patternPlacement(const CreasePattern& pattern, const PatternSceneOptions& options) {
  return placed(boxOf(pattern), options.scale, {options.margin, options.margin});
}

Scene patternScene(const FoldedState& state, const Appearance& appearance,
                   const PatternSceneOptions& options) {
  const Box box = boxOf(state.pattern);
  const Affine toScene = patternPlacement(state.pattern, options);
  Scene scene;
  scene.width = (box.high.x - box.low.x) * options.scale + 2 * options.margin;
  scene.height = (box.high.y - box.low.y) * options.scale + 2 * options.margin;
  scene.title = options.title;
  const PatternItems items(state, appearance, toScene);
  const std::vector<Loop> rim = items.rim();
  const auto append = [&](Group group) {
    if (!group.items.empty()) scene.groups.push_back(std::move(group));
  };
  if (options.fill == PatternFill::Paper) append(items.print(rim));
  append(gridGroup(box, appearance.gridSpacing, toScene));
  for (const LineKind kind : {LineKind::Flat, LineKind::Mountain, LineKind::Valley})
    append(items.hinges(kind));
  append(items.cut(rim));
  return scene;
}

}  // namespace kiri
