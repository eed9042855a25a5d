// The soft shadow that a model casts on the table.
// SPDX-License-Identifier: MIT
#include "render/scene/shadow.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/paper/boxes.h"
#include "render/scene/silhouette.h"
#include "render/visibility/projection.h"
#include "render/visibility/visible_regions.h"

namespace kiri {
namespace {

constexpr int kLights = 24;
constexpr double kLampRadius = 0.08;  // of its distance: the softness
/// Of each fill: steps of an 8-bit picture, so that pixels sum up to what vectors do. A third in
/// all.
constexpr double kDarkness = 4.0 / 255;

/// Directions to the points of the lamp: a sunflower's seeds fill its disc evenly.
std::vector<Vec3> lights() {
  const Vec3 middle = normalized(Vec3{-0.42, 0.5, 1.2});
  const Vec3 side = normalized(cross(middle, Vec3{0, 0, 1}));
  const Vec3 up = cross(side, middle);
  constexpr double kGoldenAngle = 137.50776405003785;
  std::vector<Vec3> out;
  for (int i = 0; i < kLights; ++i) {
    const double radius = kLampRadius * std::sqrt((i + 0.5) / kLights);
    const CosSin turn = cosSinDegrees(kGoldenAngle * i);
    out.push_back(normalized(middle + side * (radius * turn.cos) + up * (radius * turn.sin)));
  }
  return out;
}

/// Where the table is: a little below the paper, so that even a flat sheet has a soft rim.
double tableOf(const FoldedState& state) {
  constexpr double kClear = 0.015;
  return modelBoxOf(state).low.z - kClear * state.tolerance().sheetSize();
}

/// A view along the light; only its axes matter.
ViewFrame viewAlong(Vec3 toLight) {
  const Vec3 right = normalized(cross(Vec3{0, 1, 0}, toLight));
  return {right, cross(toLight, right), toLight};
}

Vec2 fallen(Vec3 p, Vec3 toLight, double table) {
  return flatten(p - toLight * ((p.z - table) / toLight.z));
}

/// The silhouette seen from the light as it falls on the table: x and y of the model frame.
std::vector<Loop> fallenSilhouette(const FoldedState& state, Vec3 toLight, double table) {
  const ViewFrame along = viewAlong(toLight);
  const auto fall = [&](Vec2 p) {
    return fallen(along.right * p.x + along.up * p.y, toLight, table);
  };
  std::vector<Loop> loops = silhouetteOf(visibleRegions(state, along));
  for (Loop& loop : loops) {
    for (Arc& arc : loop) {
      arc = arc.isCurved
                ? Arc::cubic(fall(arc.start), fall(arc.control1), fall(arc.control2), fall(arc.end))
                : Arc::line(fall(arc.start), fall(arc.end));
    }
  }
  return loops;
}

}  // namespace

std::vector<Vec3> shadowPoints(const FoldedState& state) {
  const double table = tableOf(state);
  std::vector<Vec3> out;
  for (const Vec3 light : lights()) {
    const auto add = [&](Vec3 p) {
      const Vec2 on = fallen(p, light, table);
      out.push_back({on.x, on.y, table});
    };
    for (std::size_t f = 0; f < state.pattern.facets.size(); ++f) {
      for (const EdgeUse use : state.pattern.facets[f].border) {
        const Arc arc = arcOf(state.pattern, use);
        add(state.poses[f].apply(arc.start));
        if (!arc.isCurved) continue;
        add(state.poses[f].apply(arc.control1));
        add(state.poses[f].apply(arc.control2));
      }
    }
  }
  return out;
}

Result<Group> shadowGroup(const FoldedState& state, const ViewFrame& view,
                          const Affine& viewToScene, const Progress& progress) {
  Group group{"shadow", "shadow", {}, {}};
  const double table = tableOf(state);
  constexpr double kLowest = 0.03;  // seen flatter than this the table is a line
  if (view.facing({0, 0, 1}, {view.centre.x, view.centre.y, table}) < kLowest) return group;
  const Rigid onTable = translation({0, 0, table});
  int done = 0;
  for (const Vec3 light : lights()) {
    if (!goesOn(progress, 1.0 * done++ / kLights)) return Error{ErrorCode::Cancelled, "", {}};
    FillItem item;
    item.fill.color = {0, 0, 0};
    item.fill.opacity = kDarkness;
    for (const Loop& loop : fallenSilhouette(state, light, table)) {
      std::vector<SeenArc> seen;
      for (const Arc& arc : loop) {
        appendSeen(arc, onTable, view, state.tolerance().flattening(), seen);
      }
      Loop& arcs = item.loops.emplace_back();
      for (const SeenArc& piece : seen) arcs.push_back(transformed(viewToScene, piece.arc));
    }
    if (!item.loops.empty()) group.items.push_back({std::move(item), "shadow", "", {}});
  }
  return group;
}

}  // namespace kiri
