// What a tool draws over the paper: lines, points, words. The window gives them colours.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "core/model/locate.h"
#include "editor/base/events.h"
#include "editor/base/phrase.h"

namespace kiri {

/// Why a mark is there; the window chooses colour, width and dashes by it.
enum class MarkRole {
  Line,      ///< the line of the fold or cut that is being made
  Valley,    ///< the same, known to be a valley
  Mountain,  ///< the same, known to be a mountain
  Axis,      ///< the part of a line beyond the paper, mirrors, axes
  Curve,     ///< control polygon of a curve
  Handle,    ///< a point that can be dragged
  ActiveHandle,
  Snap,  ///< what a snap has caught
  Selected,
  Hovered,
  Possible,  ///< what could be chosen next, such as edges that can be torn
  Fault,     ///< what is wrong: a hinge that would stretch
  Collision,
  Ghost,  ///< where paper was
  Measure,
};

/// A place that a mark is drawn at: on the paper (in both panes), in the space of the model (model
/// pane only), or a pixel of one pane.
struct PixelPlace {
  Pane pane = Pane::Model;
  Vec2 at;
};
using MarkPlace = std::variant<Spot, Vec3, PixelPlace>;

struct PointMark {
  MarkRole role = MarkRole::Handle;
  MarkPlace at;
};
/// Straight from place to place. A curve is a path of many places.
struct PathMark {
  MarkRole role = MarkRole::Line;
  std::vector<MarkPlace> places;
  bool isClosed = false;
  bool hasArrow = false;  ///< at its end
};
struct TextMark {
  MarkRole role = MarkRole::Snap;
  MarkPlace at;
  Phrase text;
};
/// A pie of `degrees` at a hinge: the dial of an angle. `from` is the direction of 0 degrees and
/// `axis` what it turns about, unit vectors of the model frame; radius in pixels.
struct DialMark {
  MarkPlace at;
  Vec3 axis;
  Vec3 from;
  double degrees = 0;
  double radius = 40;
};
using Mark = std::variant<PointMark, PathMark, TextMark, DialMark>;
using Marks = std::vector<Mark>;

/// How a facet is shown, beyond its own colours.
enum class FacetTint : std::uint8_t {
  None,
  Pale,  ///< part of a preview that has moved or changed
  Hovered,
  Selected,
  Colliding,  ///< pushed through other paper
  Stretched,  ///< would have to stretch
  Dropped,    ///< a piece that a cut throws away
};

}  // namespace kiri
