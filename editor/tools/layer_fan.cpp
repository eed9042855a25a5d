// SPDX-License-Identifier: MIT
#include "editor/tools/layer_fan.h"

#include <algorithm>
#include <cmath>

#include "editor/tools/tool_marks.h"
#include "editor/view/picking.h"

namespace kiri {
namespace {

// Pixels: half the size of a card, from one to the next, and from the line to the first.
constexpr double kHalf = 11;
constexpr Vec2 kNext{10, -26};
constexpr Vec2 kFirst{36, -12};
constexpr std::size_t kMostCards = 16;

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
    const auto number = static_cast<double>(cards.size());
    cards.push_back({pick.spot.facet, middle + kFirst + kNext * number});
  }
  return cards;
}

std::optional<FacetId> LayerFan::cardUnder(const PointerEvent& event, const Scope& scope,
                                           const FacetLine& line, Pane pane) const {
  if (!isOpen_ || event.pane != pane) return std::nullopt;
  for (const Card& card : cards(scope, line, pane)) {
    const Vec2 away = event.at - card.at;
    if (std::max(std::abs(away.x), std::abs(away.y)) <= kHalf) return card.facet;
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
