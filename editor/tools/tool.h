// A tool: turns what the hand does into a step, without doing anything itself.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/base/events.h"
#include "editor/base/field.h"
#include "editor/base/phrase.h"
#include "editor/tools/layer_wish.h"
#include "editor/tools/proposal.h"
#include "editor/tools/scope.h"
#include "editor/view/marks.h"

namespace kiri {

enum class ToolId {
  Fold,   ///< grab paper and drag, or draw a line (guide/interface.md)
  Line,   ///< draw the fold line anywhere, or construct it
  Angle,  ///< open and close existing creases
  AddEdge,
  Tear,
  Mend,
  StraightCut,
  CurveCut,
  Select,
  Measure,
  TopLayer,  ///< choose what lies on top, among the states of a crease pattern
};

/// What came of an event.
struct Reaction {
  bool isHandled = false;                             ///< otherwise the pane may orbit or pan
  bool wantsCommit = false;                           ///< make the proposed step now
  std::optional<Selection> selection = std::nullopt;  ///< the selection becomes this
  std::optional<LayerWish> wish = std::nullopt;       ///< other layers of the crease pattern

  static Reaction handled() { return {.isHandled = true}; }
  static Reaction ignored() { return {}; }
};

/// A facet that a tool shows in another way.
struct TintedFacet {
  FacetId facet;
  FacetTint tint;
};

/// Tools hold what the hand has given so far, as places on the paper, and nothing of the model. A
/// committed or refused step, an undo, a new model: `reset`. Zoom and orbit between events are
/// normal.
class Tool {
 public:
  virtual ~Tool() = default;

  virtual Reaction pointer(const PointerEvent& event, const Scope& scope) = 0;
  /// Escape is handled while there is something to drop. Enter: commit, when complete.
  virtual Reaction key(const KeyEvent&, const Scope&) { return Reaction::ignored(); }
  /// Only with a modifier; without one the wheel zooms.
  virtual Reaction wheel(const WheelEvent&, const Scope&) { return Reaction::ignored(); }
  /// Drops what is half done.
  virtual void reset() = 0;
  /// True when Escape has something to drop.
  virtual bool isBusy() const = 0;

  /// The step as it stands; none when too little is known. It must mean the same whatever the view
  /// (places in the paper frame).
  virtual std::optional<Proposal> proposal(const Scope& scope) const = 0;
  virtual Marks marks(const Scope& scope) const = 0;
  /// Facets to tint: in the state of the scope, not in that of a preview.
  virtual std::vector<TintedFacet> tints(const Scope&) const { return {}; }
  /// Numbers and choices of what is being made, for the bar beside it; empty: no bar.
  virtual std::vector<Field> fields(const Scope&) const { return {}; }
  virtual Reaction setField(const std::string&, const FieldValue&, const Scope&) {
    return Reaction::ignored();
  }
  /// One line for the status bar: what to do next.
  virtual Phrase hint(const Scope& scope) const = 0;
  virtual CursorShape cursor(const Scope& scope) const = 0;
};

std::unique_ptr<Tool> makeTool(ToolId tool);

}  // namespace kiri
