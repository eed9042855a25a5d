// What the panes show of the paper, by the person's choice. Nothing of it belongs to the model.
// SPDX-License-Identifier: MIT
#pragma once

#include "render/scene/appearance.h"

namespace kiri::desktop {

struct Display {
  bool showsCreases = true;  ///< creases that lie flat again
  bool showsEdges = true;    ///< folded hinges and visible rims
  bool showsBorders = true;  ///< the outline of the sheet and of cuts
  bool isShaded = true;
  bool showsGrid = false;
  double gridSpacing = 10;  ///< mm
  LineStyle lineStyle = LineStyle::Thesis;
};

}  // namespace kiri::desktop
