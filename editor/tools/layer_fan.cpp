// SPDX-License-Identifier: MIT
#include "editor/tools/layer_fan.h"

#include <algorithm>

#include "editor/tools/tool_marks.h"
#include "editor/view/picking.h"

namespace kiri {
namespace {

// Pixels: half the size of a card, from one to the next, and from the line to the first.
constexpr double kHalf = 11;
constexpr Vec2 kNext{0, -36};
constexpr Vec2 kFirst{36, -12};
constexpr std::size_t kMostCards = 16;
// The number stands to the upper right of its card, and belongs to it.
constexpr Vec2 kNumber{42, -24};
constexpr double kRim = 30;

}  // namespace

std::vector<LayerFan::Card> LayerFan::cards(const Scope& scope, const FacetLine& line,
                                            Pane pane) const {
  const FoldedState& state = *scope.state;
  const PaneMap& map = scope.map(pane);
  const Vec2 middle = map.toPixels(state, {line.facet, lerp(line.from, line.to, 0.5)});
  std::vector<Card> cards;
  // On the sheet nothing lies on anything: there the stack of the model is asked.
  const Vec2 onModel = scope.model.toPixels(state, {line.facet, lerp(line.from, line.to, 0.5)});
  for (const PaperPick& pick : pickStack(state, scope.model, onModel)) {
    if (cards.size() >= kMostCards) break;
    if (!state.layers.areCoplanar(pick.spot.facet, line.facet)) continue;
    cards.push_back({pick.spot.facet, {}});
  }
  // The column stays in the pane.
  const double height = kNext.y * (1 - static_cast<double>(cards.size()));
  Vec2 first = middle + kFirst;
  if (first.x + kNumber.x > map.size.x) first.x = middle.x - kFirst.x - kNumber.x;
  first.y = std::min(std::max(first.y, height + kRim), map.size.y - kRim);
  for (Card& card : cards) {
    card.at = first;
    first = first + kNext;
  }
  return cards;
}

std::optional<FacetId> LayerFan::cardUnder(const PointerEvent& event, const Scope& scope,
                                           const FacetLine& line, Pane pane) const {
  if (!isOpen_ || event.pane != pane) return std::nullopt;
  for (const Card& card : cards(scope, line, pane)) {
    const Vec2 away = event.at - card.at;
    const bool isOver =
        away.x >= -kHalf && away.x <= kNumber.x && away.y >= kNumber.y && away.y <= kHalf;
    if (isOver) return card.facet;
  }
  return std::nullopt;
}

void LayerFan::hover(const PointerEvent& event, const Scope& scope, const FacetLine& line,
                     Pane pane) {
  hovered_ = cardUnder(event, scope, line, pane);
}

void LayerFan::addMarks(const Scope& scope, const FacetLine& line, Pane pane,
                        const std::vector<FacetId>& taken, Marks& marks) const {
  if (!isOpen_) return;
  std::size_t number = 0;
  for (const Card& card : cards(scope, line, pane)) {
    const bool isTaken = std::find(taken.begin(), taken.end(), card.facet) != taken.end();
    const MarkRole role = isTaken ? MarkRole::Selected : MarkRole::Possible;
    const auto corner = [&](double x, double y) { return PixelPlace{pane, card.at + Vec2{x, y}}; };
    marks.push_back(PathMark{role,
                             {corner(-kHalf, -kHalf), corner(kHalf, -kHalf), corner(kHalf, kHalf),
                              corner(-kHalf, kHalf)},
                             true,
                             false});
    marks.push_back(TextMark{role, PixelPlace{pane, card.at}, {"%1", {std::to_string(++number)}}});
  }
  if (hovered_ && hovered_->index < scope.state->pattern.facets.size())
    marks.push_back(outlineOf(*scope.state, *hovered_, MarkRole::Hovered));
}

}  // namespace kiri
