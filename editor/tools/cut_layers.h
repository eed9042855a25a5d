// Which layers a cut or an added edge goes through, counted from the eye.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/model/step.h"
#include "editor/base/field.h"
#include "editor/tools/tool.h"

namespace kiri {

/// A drawn line or curve as a polyline in the plane of a facet (paper frame of the facet, mm).
struct PlaneTrace {
  Pane pane = Pane::Model;  ///< where it was drawn
  FacetId frame;
  std::vector<Vec2> points;
};

/// The choice of layers of a tool that works on what lies under a line or curve. On the model the
/// default is all layers of the plane; on the sheet, where paper is folded, only the paper that
/// lies there as it is drawn.
class CutLayers {
 public:
  enum class Mode {
    All,      ///< all layers of the plane
    Top,      ///< the uppermost so many along the line, as the eye sees them
    Drawn,    ///< facets that the line crosses on the sheet as well as in the model
    Through,  ///< all paper straight below and above, in whatever plane
  };

  /// `canGoThrough`: the tool makes cuts, which may go through paper in several planes.
  explicit CutLayers(bool canGoThrough) : canGoThrough_(canGoThrough) {}
  void reset();

  /// What is meant where nothing was chosen yet.
  Mode modeFor(const FoldedState& state, const PlaneTrace& trace) const;
  /// For a step: places on the paper.
  LayerChoice choice(const Scope& scope, const PlaneTrace& trace) const;
  /// The facets that the choice takes, of those that the trace crosses.
  std::vector<FacetId> taken(const Scope& scope, const PlaneTrace& trace) const;
  /// The wheel: takes one layer more (positive) or fewer, from the eye on.
  void walk(int layers, const Scope& scope, const PlaneTrace& trace);

  /// "layers" (choice), and "count" while that is "uppermost".
  void addFields(const Scope& scope, const PlaneTrace& trace, std::vector<Field>& fields) const;
  /// True when `id` is one of these fields.
  bool setField(const std::string& id, const FieldValue& value, const FoldedState& state,
                const PlaneTrace& trace);

 private:
  std::vector<Mode> offered(const FoldedState& state, const PlaneTrace& trace) const;

  bool canGoThrough_;
  bool isChosen_ = false;
  Mode mode_ = Mode::All;
  int count_ = 1;
};

}  // namespace kiri
