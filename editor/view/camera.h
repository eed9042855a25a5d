// The eye of the model pane and of the sheet pane: trackball, pan, zoom about the pointer.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/base/vec.h"
#include "core/geometry/cubic.h"
#include "editor/view/pane_map.h"
#include "render/scene/view_spec.h"

namespace kiri {

/// The eye that looks at the folded model. Orbiting turns it about the middle of the ball that
/// holds the model; a place under the pointer stays there when zooming. A value: keep the camera of
/// the moment when a drag began and start from it at every move, and a way there and back, by
/// whatever route, ends where it began:
///   camera = atPress; camera.orbit(press, now);
class Camera {
 public:
  enum class Preset { Front, Back, Angled };

  /// Sees all of the ball from the given side.
  void look(Preset preset, const Sphere& ball);
  /// Keeps the direction and shows the whole ball.
  void fit(const Sphere& ball);
  /// Pixels of the pane. What is in its middle stays there; a picture that was fitted and not
  /// touched since is fitted again.
  void resize(Vec2 pixels);
  /// A trackball: the point of the ball that was under `from` follows the pointer to `to`; pixels.
  /// Beside the ball the picture rolls. `about`: a place of the model that stays where it is in the
  /// picture, instead of the middle of the ball.
  void orbit(Vec2 from, Vec2 to, std::optional<Vec3> about = std::nullopt);
  /// Degrees by which the near side of the model goes to the right and up, and by which the picture
  /// turns counter-clockwise; for keys and two fingers.
  void turn(double degreesRight, double degreesUp, double degreesRoll = 0);
  /// Moves the picture; y down.
  void pan(Vec2 byPixels);
  /// `factor` above 1: nearer. What is under `about` stays, at every depth. Ends at limits that let
  /// nobody get lost.
  void zoom(Vec2 about, double factor);
  /// The ball that the eye turns about and that perspective must hold. The picture does not change
  /// at all, but for an eye in perspective that would be inside the ball or too near to it: that
  /// one steps back, and the middle of the ball stays where it is, as large as it was.
  void setBall(const Sphere& ball);
  /// Degrees, up to 120; 0: orthographic. The middle of the ball stays where it is, as large as it
  /// was.
  void setPerspective(double fieldOfView);
  double perspective() const { return fieldOfView_; }
  bool seesFront() const;  ///< the eye is on the side of +z
  const Sphere& ball() const { return ball_; }

  PaneMap map() const;

  /// A camera on the way from one to the other: `t` is 0 at `a`, 1 at `b`. Direction, place and
  /// size of the picture change evenly.
  static Camera interpolated(const Camera& a, const Camera& b, double t);

 private:
  double scale() const;  ///< pixels a mm, at the middle of the ball
  Vec3 onTrackball(Vec2 pixels) const;
  void turnModel(Vec3 unitAxis, double cos, double sin);
  void placeEye(double distance);

  ViewFrame frame_;  ///< in perspective the eye is above frame_.centre
  Sphere ball_{{0, 0, 0}, 100};
  double fieldOfView_ = 0;
  double pixelsPerMm_ = 3;
  Vec2 aside_;  ///< view coordinates of the middle of the pane, from frame_.centre, mm
  Vec2 size_{800, 600};
  bool isFitted_ = false;
};

/// The eye above the flat sheet: pan and zoom; front or back.
class SheetCamera {
 public:
  void fit(const Box& sheet);
  void resize(Vec2 pixels);
  void pan(Vec2 byPixels);
  void zoom(Vec2 about, double factor);
  /// Walks round the sheet: what is in the middle of the pane stays there.
  void setShowsBack(bool showsBack);
  bool showsBack() const { return showsBack_; }

  PaneMap map() const;

 private:
  Box sheet_{{0, 0}, {100, 100}};
  bool showsBack_ = false;
  double pixelsPerMm_ = 3;
  Vec2 centre_{50, 50};  ///< paper frame
  Vec2 size_{400, 600};
  bool isFitted_ = false;
};

}  // namespace kiri
