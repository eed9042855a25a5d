// Which paper stays after a cut: a side, everything, or pieces picked one by one.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/model/step.h"
#include "editor/base/field.h"
#include "editor/tools/tool.h"

namespace kiri {

/// What is thrown away when nobody says anything.
enum class CutHabit {
  Trim,   ///< straight cuts and windows: the smaller part goes
  Shape,  ///< an open curve cuts a shape out of the sheet: the part with more of the rim goes,
          ///< unless little would be left
};

/// The second half of a cut: the parts that it leaves are looked at, one is proposed to stay, a
/// mark says which; the mark can be dragged, and a click on a part keeps or drops it.
class KeepChoice {
 public:
  enum class Mode { Side, All, Pieces };

  void reset() { *this = KeepChoice(); }
  Mode mode() const { return mode_; }
  /// The hand holds the mark.
  bool isMoving() const { return isHeld_; }

  /// Chooses what a person most likely wants to stay, unless the person has chosen. `cut` is the
  /// step; what it keeps does not matter. Applies it: call when a gesture ends, not while it lasts.
  void suggest(const Scope& scope, const Step& cut, CutHabit habit);
  /// Keeps the part that holds the place and drops it when it is kept already; what stays last
  /// cannot be dropped: the rest is kept instead. Applies the cut.
  void toggle(const Scope& scope, const Step& cut, Vec2 paper);

  /// Finds the outlines of what goes, which are drawn where it was: the preview shows what stays.
  /// Applies the cut; does nothing for large models.
  void showDropped(const Scope& scope, const Step& cut);

  /// Takes the mark when the pointer is on it.
  bool takeMark(const PointerEvent& press, const Scope& scope);
  /// The pointer moved or was released while the mark is held.
  void follow(const PointerEvent& event, const Scope& scope);

  Keep keep(const FoldedState& state) const;
  void addMarks(const FoldedState& state, Marks& marks) const;
  /// "keep".
  void addFields(std::vector<Field>& fields) const;
  bool setField(const std::string& id, const FieldValue& value);

 private:
  bool isChosen_ = false;
  bool isHeld_ = false;
  Mode mode_ = Mode::All;
  std::optional<Vec2> mark_;  ///< paper frame, on the paper
  std::vector<PathMark> dropped_;
  std::vector<Vec2> pieces_;  ///< paper frame, one in each piece that stays
};

/// The places that a cut keeps. Requires a step that cuts.
Keep& keepOf(Step& cut);

}  // namespace kiri
