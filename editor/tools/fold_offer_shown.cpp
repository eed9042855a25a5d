// How an offered fold is shown and set: marks, tints, fields, keys.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/fold/fold.h"
#include "editor/tools/fold_offer.h"
#include "editor/tools/tool_fields.h"

namespace kiri {
namespace {

constexpr std::size_t kMostRims = 64;

}  // namespace

bool FoldOffer::key(const KeyEvent& event, const Scope& scope) {
  if (!event.isPress || !source_ || event.modifiers.control || event.modifiers.alt) return false;
  if (event.key == Key::Tab) {
    turnSide(scope);
    return true;
  }
  if (event.key != Key::Character) return false;
  if (event.character == 'k') {
    fan_.setOpen(!fan_.isOpen());
    return true;
  }
  if (event.character != 'v' && event.character != 'm') return false;
  setType(event.character == 'v' ? FoldType::Valley : FoldType::Mountain, scope);
  return true;
}

bool FoldOffer::wheel(const WheelEvent& event, const Scope& scope) {
  if (!plan_ || !event.modifiers.control || event.notches == 0) return false;
  isBySelection_ = false;
  layers_.walk(event.notches > 0 ? 1 : -1);
  lookAgain(scope);
  return true;
}

void FoldOffer::addFields(const Scope& scope, std::vector<Field>& fields) const {
  if (!plan_) return;
  if (!plan_->missing.empty()) {
    fields.push_back(buttonField(
        "remedy", {KIRI_TEXT("editor/tools", "Add the layers that must come along"), {}},
        {KIRI_TEXT("editor/tools", "Without them the fold would stretch the paper"), {}}));
  }
  fields.push_back(choiceField(
      "type", {KIRI_TEXT("editor/tools", "Fold"), {}},
      {{KIRI_TEXT("editor/tools", "Valley"), {}}, {KIRI_TEXT("editor/tools", "Mountain"), {}}},
      role(scope) == MarkRole::Valley ? 0 : 1,
      {KIRI_TEXT("editor/tools", "A valley turns the paper towards you, a mountain away (V, M)"),
       {}}));
  fields.push_back(
      numberField("angle", {KIRI_TEXT("editor/tools", "Angle"), {}}, angle_, {0, 180, 15, "°"},
                  {KIRI_TEXT("editor/tools", "How far the paper turns; 180 is flat"), {}}));
  fields.push_back(buttonField(
      "side", {KIRI_TEXT("editor/tools", "Other side"), {}},
      {KIRI_TEXT("editor/tools", "Turn the other side of the line instead (Tab)"), {}}));
  addLayerFields(fields);
  fields.push_back(
      textField("name", {KIRI_TEXT("editor/tools", "Name"), {}}, name_,
                {KIRI_TEXT("editor/tools", "Name of the fold line; empty: a number"), {}}));
}

void FoldOffer::addLayerFields(std::vector<Field>& fields) const {
  fields.push_back(choiceField(
      "layers", {KIRI_TEXT("editor/tools", "Layers"), {}},
      {{KIRI_TEXT("editor/tools", "This flap"), {}},
       {KIRI_TEXT("editor/tools", "Top layers"), {}},
       {KIRI_TEXT("editor/tools", "All"), {}},
       {KIRI_TEXT("editor/tools", "Picked"), {}}},
      static_cast<int>(layers_.mode()),
      {KIRI_TEXT("editor/tools",
                 "Which layers fold; Ctrl and the wheel walk through them, Ctrl and a click picks"),
       {}}));
  if (layers_.mode() == LayerMode::Top) {
    fields.push_back(
        numberField("count", {KIRI_TEXT("editor/tools", "Count"), {}}, layers_.count(),
                    {1, std::max<double>(1, static_cast<double>(layers_.stack().size())), 1, ""},
                    {KIRI_TEXT("editor/tools", "How many layers from the top"), {}}));
  }
  fields.push_back(switchField(
      "fan", {KIRI_TEXT("editor/tools", "Show layers"), {}}, fan_.isOpen(),
      {KIRI_TEXT("editor/tools", "Fans the layers under the line out, to be picked by a click (K)"),
       {}}));
}

bool FoldOffer::setField(const std::string& id, const FieldValue& value, const Scope& scope) {
  const bool isNumber = std::isfinite(value.number);
  if (id == "layers" || id == "count" || id == "remedy") isBySelection_ = false;
  if (id == "type") {
    setType(value.number > 0.5 ? FoldType::Mountain : FoldType::Valley, scope);
  } else if (id == "angle") {
    if (isNumber) angle_ = std::clamp(value.number, 0.0, 180.0);
  } else if (id == "side") {
    turnSide(scope);
  } else if (id == "layers") {
    const int mode = isNumber ? static_cast<int>(std::clamp(value.number, 0.0, 3.0)) : 0;
    if (mode == static_cast<int>(LayerMode::Chosen)) {
      layers_.choose(*scope.state, layers_.taken());
    } else {
      layers_.setMode(static_cast<LayerMode>(mode));
    }
    lookAgain(scope);
  } else if (id == "count") {
    if (isNumber) layers_.setCount(static_cast<int>(std::clamp(value.number, 1.0, 1e6)));
    lookAgain(scope);
  } else if (id == "fan") {
    fan_.setOpen(value.number > 0.5);
  } else if (id == "remedy") {
    if (isFor(*scope.state) && !plan_->missing.empty()) {
      std::vector<FacetId> all = plan_->taken;
      all.insert(all.end(), plan_->missing.begin(), plan_->missing.end());
      layers_.choose(*scope.state, all);
      lookAgain(scope);
    }
  } else if (id == "name") {
    name_ = value.text;
  } else {
    return false;
  }
  return true;
}

void FoldOffer::addArrow(const Scope& scope, Marks& marks) const {
  if (!plan_->mover || !(angle_ > 0)) return;
  const FoldedState& state = *scope.state;
  const Spot mover = *plan_->mover;
  const Rigid& pose = state.poseOf(plan_->segment.facet);
  const Vec3 origin = pose.apply(plan_->segment.from);
  Vec3 axis = normalized(pose.apply(plan_->segment.to) - origin);
  if (!plan_->leftMoves) axis = -axis;
  const double degrees = stepType_ == FoldType::Valley ? angle_ : -angle_;
  const Vec3 from = state.poseOf(mover.facet).apply(mover.paper);
  const Vec3 to = rotationAbout(origin, axis, degrees).apply(from);
  // Between the way of the paper and a bow beside it, so that it shows from every side.
  const Vec3 rise = rotationAbout(origin, axis, degrees / 2).apply(from) - (from + to) / 2;
  const Vec3 bow = rise * 0.5 + axis * (0.12 * distance(from, to));
  constexpr int kPieces = 12;
  PathMark arrow{role(scope), {}, false, true};
  for (int i = 0; i <= kPieces; ++i) {
    const double t = static_cast<double>(i) / kPieces;
    arrow.places.push_back(from * (1 - t) + to * t + bow * (4 * t * (1 - t)));
  }
  marks.push_back(arrow);
  // On the flat sheet: across the line as it lies on the same facet.
  const FacetLine here = lineOn(state, plan_->segment, mover.facet);
  const Vec2 along = normalized(here.to - here.from);
  const Vec2 away = mover.paper - here.from;
  const Vec2 foot = here.from + along * dot(away, along);
  const auto at = [&](Vec2 paper) {
    return PixelPlace{Pane::Sheet, scope.sheet.toPixels(state, {mover.facet, paper})};
  };
  marks.push_back(
      PathMark{role(scope), {at(mover.paper), at(foot + (foot - mover.paper) * 0.5)}, false, true});
}

void FoldOffer::addMarks(const Scope& scope, Marks& marks) const {
  if (!isFor(*scope.state)) return;
  for (std::size_t i = 0; i < std::min(plan_->rims.size(), kMostRims); ++i) {
    PathMark rim{MarkRole::Ghost, {}, true, false};
    rim.places.assign(plan_->rims[i].begin(), plan_->rims[i].end());
    marks.push_back(rim);
  }
  for (const auto& [from, to] : plan_->creases)
    marks.push_back(PathMark{role(scope), {from, to}, false, false});
  addArrow(scope, marks);
  fan_.addMarks(scope, plan_->segment, source_->pane, plan_->taken, marks);
}

std::vector<TintedFacet> FoldOffer::tints(const Scope& scope) const {
  std::vector<TintedFacet> tints;
  if (!isFor(*scope.state)) return tints;
  for (const FacetId f : plan_->taken) tints.push_back({f, FacetTint::Selected});
  for (const FacetId f : plan_->missing) tints.push_back({f, FacetTint::Stretched});
  return tints;
}

std::optional<Phrase> FoldOffer::trouble(const Scope& scope) const {
  if (plan_ && !plan_->missing.empty()) {
    return Phrase{KIRI_TEXT("editor/tools",
                            "The paper would have to stretch at the marked hinge; add the layers "
                            "that must come along"),
                  {}};
  }
  if (scope.preview != nullptr && scope.preview->error) {
    return Phrase{KIRI_TEXT("editor/tools",
                            "This fold cannot be made; move the line by its handles, or choose "
                            "other layers"),
                  {}};
  }
  return std::nullopt;
}

}  // namespace kiri
