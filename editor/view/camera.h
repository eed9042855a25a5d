// The eye of the model pane and of the sheet pane: trackball, pan, zoom about the pointer.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/vec.h"
#include "core/geometry/cubic.h"
#include "editor/view/pane_map.h"
#include "render/scene/view_spec.h"

namespace kiri {

/// The eye that looks at the folded model. Orbiting turns it about the middle of what it looks at;
/// a point of the model under the pointer stays there when zooming.
class Camera {
 public:
  enum class Preset { Front, Back, Angled };

  /// Sees all of the ball from the given side.
  void look(Preset preset, const Sphere& ball);
  /// Keeps the direction and shows the whole ball.
  void fit(const Sphere& ball);
  void resize(Vec2 pixels);
  /// A trackball: the point that was under `from` follows the pointer to `to`; pixels.
  void orbit(Vec2 from, Vec2 to);
  /// Degrees about the axes of the picture, for keys and two fingers.
  void turn(double degreesRight, double degreesUp, double degreesRoll = 0);
  void pan(Vec2 byPixels);
  /// `factor` above 1: nearer. The place under `about` stays.
  void zoom(Vec2 about, double factor);
  /// The ball that the eye turns about and that perspective must hold; the picture does not jump.
  void setBall(const Sphere& ball);
  void setPerspective(double fieldOfView);  ///< degrees; 0: orthographic
  double perspective() const { return fieldOfView_; }
  bool seesFront() const;  ///< the eye is on the side of +z

  PaneMap map() const;

 private:
  ViewFrame axes_;  ///< directions only
  Sphere ball_{{0, 0, 0}, 100};
  double fieldOfView_ = 0;
  double pixelsPerMm_ = 3;
  Vec2 centre_;  ///< of the pane, mm in the view, from the middle of the ball
  Vec2 size_{800, 600};
};

/// The eye above the flat sheet: pan and zoom; front or back.
class SheetCamera {
 public:
  void fit(const Box& sheet);
  void resize(Vec2 pixels);
  void pan(Vec2 byPixels);
  void zoom(Vec2 about, double factor);
  void setShowsBack(bool showsBack) { showsBack_ = showsBack; }
  bool showsBack() const { return showsBack_; }

  PaneMap map() const;

 private:
  bool showsBack_ = false;
  double pixelsPerMm_ = 3;
  Vec2 centre_;
  Vec2 size_{400, 600};
};

}  // namespace kiri
