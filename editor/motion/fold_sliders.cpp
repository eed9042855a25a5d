// What the folds panel shows: where each fold line stands and how far it goes.
// SPDX-License-Identifier: MIT
#include "editor/motion/fold_sliders.h"

#include <algorithm>
#include <cmath>

#include "core/fold/fold_line.h"
#include "core/geometry/tolerance.h"

namespace kiri {
namespace {

constexpr double kHalfTurn = 180;

/// The name without the number at its end; empty when it is all number.
std::string stemOf(const std::string& name) {
  std::size_t end = name.find_last_not_of("0123456789");
  if (end == std::string::npos || end + 1 == name.size()) return name;
  end = name.find_last_not_of(" .,-_#", end);
  return end == std::string::npos ? name : name.substr(0, end + 1);
}

}  // namespace

std::vector<FoldSlider> slidersOf(const FoldedState& state) {
  std::vector<FoldSlider> sliders(state.lines.size());
  for (std::size_t i = 0; i < sliders.size(); ++i)
    sliders[i] = {FoldLineId(i), state.lines[i].name, state.lines[i].isValley, std::nullopt, false};
  std::vector<bool> isTold(sliders.size(), false);
  for (const Edge& edge : state.pattern.edges) {
    if (edge.kind != EdgeKind::Hinge || !edge.line.isValid() || isTold[edge.line.index]) continue;
    FoldSlider& slider = sliders[edge.line.index];
    const double here = edge.sign * edge.angle;
    const bool isFirst = !slider.canMove;
    slider.canMove = true;
    if (isFirst || std::abs(*slider.amount - here) <= kSameAngle) {
      slider.amount = here;
    } else {
      slider.amount.reset();
      isTold[edge.line.index] = true;
    }
  }
  return sliders;
}

double opennessOf(const FoldedState& state) {
  double all = 0;
  double folded = 0;
  for (const FoldSlider& slider : slidersOf(state)) {
    if (!slider.canMove) continue;
    const double most = std::abs(state.lines[slider.line.index].foldedAmount);
    all += most;
    folded += std::min(most, std::abs(slider.amount.value_or(most)));
  }
  return all > 0 ? 1 - folded / all : 1;
}

std::vector<SliderGroup> groupsOf(const std::vector<FoldSlider>& sliders) {
  std::vector<SliderGroup> groups;
  for (std::size_t i = 0; i < sliders.size(); ++i) {
    const std::string stem = stemOf(sliders[i].name);
    const auto known = std::find_if(groups.begin(), groups.end(),
                                    [&](const SliderGroup& group) { return group.name == stem; });
    if (known != groups.end()) {
      known->rows.push_back(i);
    } else {
      groups.push_back({stem, {i}});
    }
  }
  for (SliderGroup& group : groups) {
    if (group.rows.size() == 1) group.name = sliders[group.rows.front()].name;
  }
  return groups;
}

SlideShow slideTo(const FoldedState& from, FoldLineId line, double amount) {
  Slide slide = slideAmount(from, line, std::clamp(amount, -kHalfTurn, kHalfTurn));
  SlideShow show;
  show.amount = slide.amount;
  show.stop = std::move(slide.why);
  const auto known = static_cast<std::ptrdiff_t>(from.collisions.size());
  show.collisions.assign(slide.state.collisions.begin() + known, slide.state.collisions.end());
  show.state = std::make_shared<const FoldedState>(std::move(slide.state));
  return show;
}

std::optional<Step> stepOfSlide(const FoldedState& from, FoldLineId line, double amount) {
  const std::optional<double> now = amountOf(from, line);
  if (now && std::abs(*now - amount) <= kSameAngle) return std::nullopt;
  return Step{AngleStep{from.lines[line.index].name, amount}, {}, {}, {}};
}

}  // namespace kiri
