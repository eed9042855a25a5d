// SPDX-License-Identifier: MIT
#include "editor/tools/cut_layers.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/layers/topmost.h"
#include "core/paper/facet_line.h"
#include "core/paper/inscribe.h"
#include "editor/tools/seen_side.h"

namespace kiri {
namespace {

Box boxOf(const CreasePattern& pattern, FacetId facet) {
  Box box = boundsOf(arcOf(pattern, pattern[facet].border.front()));
  for (const EdgeUse use : pattern[facet].border) box = joined(box, boundsOf(arcOf(pattern, use)));
  return box;
}

/// The facets of the trace's plane along it: how far each reaches, and how near the eye it lies.
std::vector<Cover> coversOf(const Scope& scope, const PlaneTrace& trace) {
  const FoldedState& state = *scope.state;
  const Vec2 middle = trace.points[trace.points.size() / 2];
  const Vec3 up = seenUp(state, scope.map(trace.pane), {trace.frame, middle});
  std::vector<Cover> covers;
  for (const FacetId f : state.layers.sets()[state.layers.setOf(trace.frame)].upward) {
    const double height = seenHeight(state, f, up);
    const Box box = boxOf(state.pattern, f);
    for (std::size_t i = 0; i + 1 < trace.points.size(); ++i) {
      if (distance(trace.points[i], trace.points[i + 1]) <= state.tolerance().pick()) continue;
      const FacetLine here = lineOn(state, {trace.frame, trace.points[i], trace.points[i + 1]}, f);
      if (!areNear(box, boundsOf(Arc::line(here.from, here.to)), 0)) continue;
      const auto start = static_cast<double>(i);
      for (const Chord& chord : chordsOf(state.pattern, f, here.from, here.to)) {
        const double from = std::max(0.0, chord.t0);
        const double to = std::min(1.0, chord.t1);
        if (from < to) covers.push_back({f.index, start + from, start + to, height});
      }
    }
  }
  return covers;
}

std::vector<FacetId> uppermost(const std::vector<Cover>& covers, int count) {
  std::vector<FacetId> facets;
  for (const std::size_t f : topmost(covers, count, kParallel)) facets.push_back(FacetId(f));
  return facets;
}

std::vector<FacetId> crossed(const std::vector<Cover>& covers) {
  std::vector<FacetId> facets;
  for (const Cover& cover : covers) facets.push_back(FacetId(cover.id));
  std::sort(facets.begin(), facets.end());
  facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
  return facets;
}

/// How many layers lie on each other where most do.
int depthOf(const std::vector<Cover>& covers) {
  std::vector<std::pair<double, int>> ends;  // what ends comes before what begins at one place
  for (const Cover& cover : covers) {
    ends.emplace_back(cover.from, 1);
    ends.emplace_back(cover.to, -1);
  }
  std::sort(ends.begin(), ends.end());
  int most = 0;
  int now = 0;
  for (const auto& [at, change] : ends) most = std::max(most, now += change);
  return most;
}

/// True when two facets lie in the model as they lie on the sheet to each other.
bool lieAlike(const FoldedState& state, FacetId a, FacetId b) {
  const Rigid& p = state.poseOf(a);
  const Rigid& q = state.poseOf(b);
  const double size = state.tolerance().sheetSize();
  const double tol = state.tolerance().match();
  return length(p.x - q.x) * size <= tol && length(p.y - q.y) * size <= tol &&
         length(p.origin - q.origin) <= tol;
}

bool isUnfolded(const FoldedState& state, FacetId frame) {
  for (std::size_t f = 0; f < state.pattern.facets.size(); ++f) {
    if (!lieAlike(state, FacetId(f), frame)) return false;
  }
  return true;
}

}  // namespace

void CutLayers::reset() { *this = CutLayers(canGoThrough_); }

CutLayers::Mode CutLayers::modeFor(const FoldedState& state, const PlaneTrace& trace) const {
  if (isChosen_) return mode_;
  const bool isAsDrawn = trace.pane == Pane::Model || isUnfolded(state, trace.frame);
  return isAsDrawn ? Mode::All : Mode::Drawn;
}

std::vector<FacetId> CutLayers::taken(const Scope& scope, const PlaneTrace& trace) const {
  const std::vector<Cover> covers = coversOf(scope, trace);
  const Mode mode = modeFor(*scope.state, trace);
  if (mode == Mode::Top) return uppermost(covers, count_);
  std::vector<FacetId> facets = crossed(covers);
  if (mode != Mode::Drawn) return facets;
  const auto isElsewhere = [&](FacetId f) { return !lieAlike(*scope.state, f, trace.frame); };
  facets.erase(std::remove_if(facets.begin(), facets.end(), isElsewhere), facets.end());
  return facets;
}

LayerChoice CutLayers::choice(const Scope& scope, const PlaneTrace& trace) const {
  const Mode mode = modeFor(*scope.state, trace);
  if (mode == Mode::All) return AllLayers{};
  if (mode == Mode::Through) return ThroughAll{};
  ChosenLayers chosen;
  for (const FacetId f : taken(scope, trace))
    chosen.facets.push_back({Frame::Paper, interiorPointOf(scope.state->pattern, f)});
  if (chosen.facets.empty())  // the kernel says that nothing is crossed
    chosen.facets.push_back({Frame::Paper, interiorPointOf(scope.state->pattern, trace.frame)});
  return chosen;
}

void CutLayers::walk(int layers, const Scope& scope, const PlaneTrace& trace) {
  const int depth = depthOf(coversOf(scope, trace));
  const int now = modeFor(*scope.state, trace) == Mode::Top ? std::min(count_, depth) : depth;
  count_ = std::clamp(now + layers, 1, std::max(1, depth));
  mode_ = count_ >= depth ? Mode::All : Mode::Top;
  isChosen_ = true;
}

/// Only what can make a difference, so that the bar stays short.
std::vector<CutLayers::Mode> CutLayers::offered(const FoldedState& state,
                                                const PlaneTrace& trace) const {
  const Mode mode = modeFor(state, trace);
  std::vector<Mode> modes{Mode::All, Mode::Top};
  if (trace.pane == Pane::Sheet || mode == Mode::Drawn) modes.push_back(Mode::Drawn);
  if (canGoThrough_ && (!isFlat(state) || mode == Mode::Through)) modes.push_back(Mode::Through);
  return modes;
}

void CutLayers::addFields(const Scope& scope, const PlaneTrace& trace,
                          std::vector<Field>& fields) const {
  const Mode mode = modeFor(*scope.state, trace);
  const Phrase names[] = {{KIRI_TEXT("editor/tools", "All layers"), {}},
                          {KIRI_TEXT("editor/tools", "Uppermost"), {}},
                          {KIRI_TEXT("editor/tools", "As drawn on the sheet"), {}},
                          {KIRI_TEXT("editor/tools", "Straight through everything"), {}}};
  Field layers;
  layers.id = "layers";
  layers.label = {KIRI_TEXT("editor/tools", "Layers"), {}};
  layers.kind = Field::Kind::Choice;
  for (const Mode offer : offered(*scope.state, trace)) {
    if (offer == mode) layers.value = static_cast<double>(layers.options.size());
    layers.options.push_back(names[static_cast<std::size_t>(offer)]);
  }
  layers.help = {
      KIRI_TEXT("editor/tools", "Which layers are taken; the wheel with Ctrl walks them"), {}};
  fields.push_back(layers);
  if (mode != Mode::Top) return;
  Field count;
  count.id = "count";
  count.label = {KIRI_TEXT("editor/tools", "How many"), {}};
  count.value = count_;
  count.least = 1;
  count.most = std::max(1, depthOf(coversOf(scope, trace)));
  count.help = {KIRI_TEXT("editor/tools", "Layers taken, the one that is seen first"), {}};
  fields.push_back(count);
}

bool CutLayers::setField(const std::string& id, const FieldValue& value, const FoldedState& state,
                         const PlaneTrace& trace) {
  if (id != "layers" && id != "count") return false;
  if (!std::isfinite(value.number)) return true;
  if (id == "layers") {
    const std::vector<Mode> modes = offered(state, trace);
    const auto last = static_cast<double>(modes.size() - 1);
    mode_ = modes[static_cast<std::size_t>(std::clamp(value.number, 0.0, last))];
  } else {
    constexpr double kMost = 1000000;
    mode_ = Mode::Top;
    count_ = static_cast<int>(std::clamp(value.number, 1.0, kMost));
  }
  isChosen_ = true;
  return true;
}

}  // namespace kiri
