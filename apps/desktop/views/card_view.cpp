// How a pane's eye is told to the renderer.
// SPDX-License-Identifier: MIT
#include "apps/desktop/views/card_view.h"

#include <algorithm>
#include <cmath>

#include "apps/desktop/look/convert.h"
#include "apps/desktop/look/theme.h"

namespace kiri::desktop {
namespace {

constexpr double kRoom = 1.05;     // of the ball, so that nothing lies on the rim of the depths
constexpr double kNearest = 0.95;  // of the way to the eye, in perspective

}  // namespace

GlView cardViewOf(const PaneMap& map, const Sphere& ball, const Display& display, double ratio) {
  GlView view;
  view.frame = map.frame;
  view.pixelsPerMm = map.pixelsPerMm * ratio;
  view.centre = map.centre;
  view.width = std::max(1, static_cast<int>(std::lround(map.size.x * ratio)));
  view.height = std::max(1, static_cast<int>(std::lround(map.size.y * ratio)));
  const double radius = std::max(ball.radius, 1.0) * kRoom;
  double toNear = radius;
  if (map.frame.isPerspective()) {
    const double toEye =
        map.frame.eyeDistance - dot(ball.centre - map.frame.centre, map.frame.toEye);
    toNear = std::min(radius, toEye * kNearest);
  }
  view.nearDepth = map.frame.depth(ball.centre + map.frame.toEye * toNear);
  view.farDepth = map.frame.depth(ball.centre - map.frame.toEye * radius);
  view.background = toColor(theme().ground);
  view.showsEdges = display.showsEdges;
  view.showsCreases = display.showsCreases;
  view.showsBorders = display.showsBorders;
  view.gridSpacing = display.showsGrid ? display.gridSpacing : 0;
  view.isShaded = display.isShaded;
  view.lineScale = ratio;
  return view;
}

}  // namespace kiri::desktop
