// SPDX-License-Identifier: MIT
#include "editor/tools/select_tool.h"

#include <algorithm>
#include <cmath>

#include "editor/tools/drawn_line.h"
#include "editor/tools/tool_fields.h"
#include "editor/tools/tool_marks.h"
#include "editor/view/picking.h"

namespace kiri {
namespace {

Selection with(Selection selection, const std::vector<Selected>& picked, bool adds) {
  if (!adds) {
    selection.set(picked);
    return selection;
  }
  for (const Selected& item : picked) selection.toggle(item);
  return selection;
}

Reaction selects(Selection selection) {
  Reaction reaction = Reaction::handled();
  reaction.selection = std::move(selection);
  return reaction;
}

}  // namespace

void SelectTool::reset() {
  pressed_.reset();
  hovered_.reset();
  isBand_ = false;
}

std::optional<Selected> SelectTool::under(const PointerEvent& event, const Scope& scope) const {
  const FoldedState& state = *scope.state;
  const PaneMap& map = scope.map(event.pane);
  const double reach = handleReach(event);
  switch (kind_) {
    case SelectedKind::Facet:
      if (const auto pick = pickPaper(state, map, event.at))
        return selectedFacet(state, pick->spot.facet);
      break;
    case SelectedKind::Vertex:
      if (const auto pick = pickVertex(state, map, event.at, reach))
        return selectedVertex(state, pick->vertex);
      break;
    case SelectedKind::Line:
      if (const auto pick = pickEdge(state, map, event.at, reach))
        return selectedLine(state, pick->edge);
      break;
    case SelectedKind::Point:
    case SelectedKind::Inside:
      if (const auto pick = pickPaper(state, map, event.at))
        return Selected{kind_, pick->spot.paper, {}, {}};
      break;
  }
  return std::nullopt;
}

Reaction SelectTool::pointer(const PointerEvent& event, const Scope& scope) {
  const bool isLeft = event.button == PointerButton::Left;
  if (event.action == PointerAction::Press && isLeft) {
    pressed_ = event;
    at_ = event.at;
    isBand_ = false;
    return Reaction::handled();
  }
  if (event.action == PointerAction::Release && isLeft && pressed_) return release(event, scope);
  if (event.action == PointerAction::Leave) hovered_.reset();
  if (event.action != PointerAction::Move) return Reaction::ignored();
  if (!pressed_) {
    hovered_ = under(event, scope);
    return Reaction::ignored();
  }
  if (event.pane == pressed_->pane) at_ = event.at;
  isBand_ |= kind_ == SelectedKind::Facet && distance(at_, pressed_->at) >= kDragBegins;
  return Reaction::handled();
}

Reaction SelectTool::release(const PointerEvent& event, const Scope& scope) {
  const PointerEvent press = *pressed_;
  const bool adds = press.modifiers.shift || event.modifiers.shift;
  std::vector<Selected> picked;
  if (isBand_) {
    for (const FacetId f : facetsWithin(*scope.state, scope.map(press.pane), press.at, at_))
      picked.push_back(selectedFacet(*scope.state, f));
  } else if (const auto found = under(press, scope)) {
    picked.push_back(*found);
  }
  reset();
  if (!adds) return selects(with(scope.selection, picked, false));
  // A rectangle adds; only a click takes away.
  if (picked.size() > 1) {
    const auto& known = scope.selection.items();
    std::erase_if(picked, [&](const Selected& item) {
      return std::find(known.begin(), known.end(), item) != known.end();
    });
  }
  return selects(with(scope.selection, picked, true));
}

Reaction SelectTool::key(const KeyEvent& event, const Scope& scope) {
  if (!event.isPress) return Reaction::ignored();
  if (event.key == Key::Escape) {
    if (!isBusy() && scope.selection.isEmpty()) return Reaction::ignored();
    const bool wasBusy = isBusy();
    reset();
    return wasBusy ? Reaction::handled() : selects(Selection());
  }
  if (event.key != Key::Character || event.character != 'a' || !event.modifiers.control)
    return Reaction::ignored();
  std::vector<Selected> all;
  for (std::size_t f = 0; f < scope.state->pattern.facets.size(); ++f)
    all.push_back(selectedFacet(*scope.state, FacetId(f)));
  return selects(with(scope.selection, all, false));
}

Marks SelectTool::marks(const Scope& scope) const {
  Marks marks;
  addSelected(*scope.state, scope.selection.items(), MarkRole::Selected, marks);
  if (hovered_) addSelected(*scope.state, {*hovered_}, MarkRole::Hovered, marks);
  if (pressed_ && isBand_) {
    const Vec2 a = pressed_->at;
    const Pane pane = pressed_->pane;
    marks.push_back(PathMark{MarkRole::Selected,
                             {PixelPlace{pane, a}, PixelPlace{pane, {at_.x, a.y}},
                              PixelPlace{pane, at_}, PixelPlace{pane, {a.x, at_.y}}},
                             true,
                             false});
  }
  return marks;
}

std::vector<TintedFacet> SelectTool::tints(const Scope& scope) const {
  std::vector<TintedFacet> tints;
  for (const FacetId f : facetsOf(*scope.state, scope.selection))
    tints.push_back({f, FacetTint::Selected});
  if (!hovered_ || hovered_->kind != SelectedKind::Facet) return tints;
  if (const auto facet = facetAt(scope.state->pattern, hovered_->place))
    tints.push_back({*facet, FacetTint::Hovered});
  return tints;
}

std::vector<Field> SelectTool::fields(const Scope&) const {
  return {choiceField("kind", {KIRI_TEXT("editor/tools", "Select"), {}},
                      {{KIRI_TEXT("editor/tools", "Facets"), {}},
                       {KIRI_TEXT("editor/tools", "Vertices"), {}},
                       {KIRI_TEXT("editor/tools", "Points"), {}},
                       {KIRI_TEXT("editor/tools", "Lines"), {}},
                       {KIRI_TEXT("editor/tools", "Inside"), {}}},
                      static_cast<int>(kind_),
                      {KIRI_TEXT("editor/tools",
                                 "Facets fold, a point names the side that moves, a line is a "
                                 "mirror, inside is the paper that a cut keeps"),
                       {}})};
}

Reaction SelectTool::setField(const std::string& id, const FieldValue& value, const Scope&) {
  if (id != "kind" || !std::isfinite(value.number)) return Reaction::ignored();
  kind_ = static_cast<SelectedKind>(static_cast<int>(std::clamp(value.number, 0.0, 4.0)));
  reset();
  return Reaction::handled();
}

Phrase SelectTool::hint(const Scope& scope) const {
  if (!scope.selection.isEmpty()) {
    return {KIRI_TEXT("editor/tools", "Selected: %1; Shift and a click adds, Esc clears"),
            {std::to_string(scope.selection.items().size())}};
  }
  if (kind_ == SelectedKind::Facet)
    return {KIRI_TEXT("editor/tools", "Click a facet, or drag a rectangle around several"), {}};
  return {KIRI_TEXT("editor/tools", "Click what is to be selected; Shift adds"), {}};
}

}  // namespace kiri
