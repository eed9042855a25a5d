// The steps of a model side by side, as in thesis Figures 1.2 and 7.2.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/model/model.h"
#include "core/model/replay.h"
#include "render/scene/appearance.h"
#include "render/scene/scene.h"
#include "render/visibility/view_frame.h"

namespace kiri {

/// What the panel of a state tells about.
enum class PanelCaption {
  NextStep,  ///< the step to be done on it: its number, title and line, as in printed diagrams
  LastStep,  ///< the step that led to it: its number and title
};

struct SheetSceneOptions {
  /// Which panels: n means the state after n steps (0: the sheet). Empty: all.
  std::vector<std::size_t> states;
  int columns = 0;         ///< 0: as many as the page width holds
  double pageWidth = 210;  ///< mm; rows are wrapped to it
  std::optional<double>
      panel;  ///< side of a panel, mm; none: the width is shared among the columns (at most 60)
  double gap = 6;  ///< mm between panels and around the page
  bool showNumbers = true;
  bool showTitles = true;
  ViewFrame view = frontView();
  std::string title;  ///< empty: the title of the model
  PanelCaption caption = PanelCaption::NextStep;
};

/// One panel for each chosen state, all at one scale, numbered, the title of its step below, the
/// line or curve of the next step drawn on it. Errors: BadValue - a state that the model does not
/// have, or sizes that leave no room; and the error of the first step that does not apply, when a
/// panel after it is asked for.
Result<Scene> sheetScene(const Model& model, const Replay& replay, const Appearance& appearance,
                         const SheetSceneOptions& options = {});

/// Where a drawn line lies on the folded model, in the model frame: as it is when drawn there,
/// through the pose of the facet it names when drawn on the paper. None when the facet it names
/// does not exist.
struct ModelSegment {
  Vec3 from;
  Vec3 to;
};
std::optional<ModelSegment> onModel(const FoldedState& state, const DrawnLine& line);

}  // namespace kiri
