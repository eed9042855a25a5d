// The open model as values that work beside the window can read.
// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <cstddef>
#include <memory>
#include <vector>

#include "editor/document/document.h"
#include "render/visibility/view_frame.h"

namespace kiri::desktop {

/// What is exported, taken out of the session: values that nothing changes any more, so that work
/// beside the window can read them.
struct ExportSource {
  Model model;
  std::size_t cursor = 0;
  std::vector<std::shared_ptr<const FoldedState>> after;  ///< after each of the first steps
  std::shared_ptr<const FoldedState> state;               ///< at the cursor
  QString title;                                          ///< of the model, or of its file
  QString path;                                           ///< of the model; empty: never saved
  ViewFrame screen;                                       ///< as the model pane looks at it now
};
ExportSource exportSourceOf(const Document& document, const ViewFrame& screen);

}  // namespace kiri::desktop
