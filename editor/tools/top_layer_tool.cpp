// SPDX-License-Identifier: MIT
#include "editor/tools/top_layer_tool.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/tools/drawn_line.h"
#include "editor/tools/tool_fields.h"
#include "editor/tools/tool_marks.h"
#include "editor/view/picking.h"

namespace kiri {
namespace {

/// More outlines than that say nothing.
constexpr std::size_t kMostOutlines = 40;

}  // namespace

void TopLayerTool::reset() {
  layers_.clear();
  chosen_ = 0;
  isAlone_ = false;
}

bool TopLayerTool::take(const PointerEvent& event, const Scope& scope) {
  std::vector<Layer> found;
  for (const PaperPick& pick : pickStack(*scope.state, scope.model, event.at)) {
    found.push_back({interiorPointOf(scope.state->pattern, pick.spot.facet), pick.showsFront});
  }
  const bool isAgain =
      found.size() == layers_.size() && !found.empty() &&
      distance(event.at, at_) < 2 * handleReach(event) &&
      std::equal(found.begin(), found.end(), layers_.begin(),
                 [](const Layer& a, const Layer& b) { return a.inside == b.inside; });
  if (isAgain) {
    walk(1);
    return true;
  }
  reset();
  if (found.size() < 2) {
    isAlone_ = found.size() == 1;
    return false;
  }
  layers_ = std::move(found);
  chosen_ = 1;
  at_ = event.at;
  return true;
}

Reaction TopLayerTool::takeOnSheet(const PointerEvent& event, const Scope& scope) {
  const auto pick = pickPaper(*scope.state, scope.sheet, event.at);
  if (!pick) return Reaction::handled();
  const Vec2 inside = interiorPointOf(scope.state->pattern, pick->spot.facet);
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    if (!(layers_[i].inside == inside)) continue;
    chosen_ = i;
    return wish();
  }
  return Reaction::handled();
}

Reaction TopLayerTool::pointer(const PointerEvent& event, const Scope& scope) {
  if (event.action != PointerAction::Press || event.button != PointerButton::Left)
    return Reaction::ignored();
  if (event.pane == Pane::Sheet) return takeOnSheet(event, scope);
  const bool isPaper = take(event, scope) || isAlone_;
  return isPaper ? Reaction::handled() : Reaction::ignored();
}

void TopLayerTool::walk(int by) {
  if (layers_.size() < 2) return;
  // The uppermost is there already.
  const auto others = static_cast<int>(layers_.size()) - 1;
  const int next = (static_cast<int>(chosen_) - 1 + by % others + others) % others;
  chosen_ = static_cast<std::size_t>(next) + 1;
}

Reaction TopLayerTool::wish() {
  if (layers_.empty()) return Reaction::ignored();
  LayerWish wish{layers_[chosen_].inside, layers_[chosen_].showsFront, {}};
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    if (i != chosen_) wish.lower.push_back(layers_[i].inside);
  }
  reset();
  Reaction reaction = Reaction::handled();
  reaction.wish = std::move(wish);
  return reaction;
}

Reaction TopLayerTool::key(const KeyEvent& event, const Scope&) {
  if (!event.isPress || layers_.empty()) return Reaction::ignored();
  if (event.key == Key::Enter) return wish();
  if (event.key == Key::Tab) {
    walk(event.modifiers.shift ? -1 : 1);
    return Reaction::handled();
  }
  if (event.key != Key::Escape) return Reaction::ignored();
  reset();
  return Reaction::handled();
}

Reaction TopLayerTool::wheel(const WheelEvent& event, const Scope&) {
  if (!event.modifiers.control || layers_.empty()) return Reaction::ignored();
  walk(event.notches > 0 ? -1 : 1);
  return Reaction::handled();
}

Marks TopLayerTool::marks(const Scope& scope) const {
  Marks marks;
  const FoldedState& state = *scope.state;
  const auto outline = [&](std::size_t i, MarkRole role) {
    const auto facet = facetAt(state.pattern, layers_[i].inside);
    if (facet) marks.push_back(outlineOf(state, *facet, role));
  };
  for (std::size_t i = 0; i < std::min(layers_.size(), kMostOutlines); ++i) {
    if (i != chosen_) outline(i, MarkRole::Possible);
  }
  if (chosen_ >= layers_.size()) return marks;
  outline(chosen_, MarkRole::Selected);
  if (const auto facet = facetAt(state.pattern, layers_[chosen_].inside)) {
    marks.push_back(TextMark{MarkRole::Selected,
                             Spot{*facet, layers_[chosen_].inside},
                             {KIRI_TEXT("editor/tools", "Layer %1 of %2"),
                              {std::to_string(chosen_ + 1), std::to_string(layers_.size())}}});
  }
  return marks;
}

std::vector<Field> TopLayerTool::fields(const Scope&) const {
  if (layers_.empty()) return {};
  Field layer;
  layer.id = "layer";
  layer.label = {KIRI_TEXT("editor/tools", "Layer"), {}};
  layer.value = static_cast<double>(chosen_ + 1);
  layer.least = 2;
  layer.most = static_cast<double>(layers_.size());
  layer.help = {KIRI_TEXT("editor/tools", "Counted from the one that is seen"), {}};
  Field button;
  button.id = "top";
  button.label = {KIRI_TEXT("editor/tools", "Bring on top"), {}};
  button.kind = Field::Kind::Button;
  button.help = {
      KIRI_TEXT("editor/tools", "Finds the folded state nearest to this one that has it so"), {}};
  return {layer, button};
}

Reaction TopLayerTool::setField(const std::string& id, const FieldValue& value, const Scope&) {
  if (id == "top") return wish();
  if (id != "layer" || !std::isfinite(value.number) || layers_.size() < 2)
    return Reaction::ignored();
  const double most = static_cast<double>(layers_.size());
  chosen_ = static_cast<std::size_t>(std::lround(std::clamp(value.number, 2.0, most))) - 1;
  return Reaction::handled();
}

Phrase TopLayerTool::hint(const Scope&) const {
  if (!layers_.empty()) {
    return {KIRI_TEXT("editor/tools",
                      "Enter brings layer %1 on top; click again or Tab for the next of %2"),
            {std::to_string(chosen_ + 1), std::to_string(layers_.size())}};
  }
  if (isAlone_) return {KIRI_TEXT("editor/tools", "Only one layer lies there"), {}};
  return {KIRI_TEXT("editor/tools", "Click the folded model where another layer is to be on top"),
          {}};
}

}  // namespace kiri
