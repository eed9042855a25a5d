// How a picture of the folded model is taken, in the words of a person.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/base/result.h"
#include "core/paper/folded_state.h"
#include "render/visibility/view_frame.h"

namespace kiri {

/// Where the eye is, and what helps it to read the folds. All of it is about the picture; the paper
/// is never touched.
struct ViewSpec {
  double azimuth = 0;      ///< degrees, see viewFrom
  double elevation = 90;   ///< degrees, see viewFrom
  double fieldOfView = 0;  ///< degrees; 0: orthographic, parallel lines stay parallel
  double explode = 0;      ///< mm that layers are lifted off each other, to be read one by one
  double thickness = 0;    ///< mm that the paper seems to be thick: layers lifted, but joined
  bool isShaded = false;   ///< facets are the darker the more they are turned away
  bool hasShadow = false;  ///< a soft shadow on the table, for an eye above it
};

constexpr ViewSpec frontSpec() { return {0, 90}; }
constexpr ViewSpec backSpec() { return {180, -90}; }

/// Errors: BadValue - a number that means nothing, or one out of range; the sentence says which.
Status checkViewSpec(const ViewSpec& spec);

/// A ball of the model frame, mm. One that holds a model holds it however it is turned.
struct Sphere {
  Vec3 centre;
  double radius = 0;
};

/// A ball about the middle of the model's box that holds what `spec` shows of the state.
Sphere sphereOf(const FoldedState& state, const ViewSpec& spec = {});
/// A ball that holds both.
Sphere joined(const Sphere& a, const Sphere& b);

/// What is drawn of the state: layers spread as the spec asks; nothing when it asks for none.
std::optional<FoldedState> spreadFor(const FoldedState& state, const ViewSpec& spec);

/// The frame of a view at what lies in `sphere`. In perspective the eye is as far away as makes the
/// ball fill the field of view, so that nothing is behind it, and the middle of the ball appears in
/// true size. Errors: those of checkViewSpec.
Result<ViewFrame> frameOf(const ViewSpec& spec, const Sphere& sphere);

/// The same view in perspective, from an eye `distance` mm above the middle of the ball. Errors:
/// BadValue - an eye inside the ball, or so near to it that the paper would seem ten times as
/// large.
Result<ViewFrame> withEye(const ViewFrame& view, const Sphere& sphere, double distance);

/// The box, view coordinates, that holds the picture of everything inside the ball: one and the
/// same size for every view of it, the middle of the ball in its middle.
Box boxOf(const ViewFrame& view, const Sphere& sphere);

}  // namespace kiri
