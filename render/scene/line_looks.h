// The strokes of the kinds of lines.
// SPDX-License-Identifier: MIT
#pragma once

#include "render/scene/appearance.h"
#include "render/scene/scene.h"

namespace kiri {

/// The kinds of lines that pictures tell apart.
enum class LineKind { Mountain, Valley, Flat, Border, Tear, Cut };

/// The word for a kind, as SVG groups and classes use it: "mountain", "valley"...
const char* nameOf(LineKind kind);

/// How a line of that kind is drawn `width` mm wide. Dashes grow with the width.
Stroke strokeFor(LineKind kind, const Appearance& appearance, double width);

/// The visible border of paper, and a crease that lies flat again, on pictures of the folded model.
Stroke edgeStroke(const Appearance& appearance);
Stroke creaseStroke(const Appearance& appearance);

}  // namespace kiri
