// The fold along a line that is there: type, angle, side, layers, name, and how it is shown.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "editor/tools/facet_name.h"
#include "editor/tools/layer_fan.h"
#include "editor/tools/layer_picker.h"
#include "editor/tools/tool.h"

namespace kiri {

/// Where the fold is to be.
struct FoldPlace {
  FacetLine line;
  Pane pane = Pane::Model;      ///< that the hand works in: its eye says valley and uppermost
  std::optional<Spot> grabbed;  ///< the paper that the hand holds, on the side that moves
  bool isEndless = false;       ///< the line goes as far as the paper that is taken
  bool isNew = true;  ///< still being drawn: valley and side are found anew; else they stay
};

/// What both the fold tool and the line tool offer once they have a line. Everything it keeps is
/// named by places on the paper.
class FoldOffer {
 public:
  void reset() { *this = FoldOffer(); }
  bool isThere() const { return plan_.has_value(); }
  void drop() { plan_.reset(); }

  /// Finds layers, moving side and extent of the fold. The selection counts: selected facets on the
  /// line are the layers, others must move, a selected point names the side (thesis 4.5, E26, E28).
  void look(const Scope& scope, const FoldPlace& place);
  /// The same again, after something else was set.
  void lookAgain(const Scope& scope);
  LayerPicker& layers() { return layers_; }
  void setType(FoldType asSeen, const Scope& scope);
  void turnSide(const Scope& scope);
  /// A press that picks layers: on a card of the fan, or with Ctrl on paper. False: it is none.
  bool pressLayers(const PointerEvent& event, const Scope& scope);
  void hoverLayers(const PointerEvent& event, const Scope& scope);

  std::optional<FoldStep> step() const;
  /// The line as far as it goes; none when nothing is offered for this state.
  std::optional<FacetLine> segment(const FoldedState& state) const;
  /// Why the fold cannot be made as it is offered, and what to do; none where it can.
  std::optional<Phrase> trouble(const Scope& scope) const;
  /// V, M, Tab, and K for the fan of layers; true when the key meant something.
  bool key(const KeyEvent& event, const Scope& scope);
  bool wheel(const WheelEvent& event, const Scope& scope);
  void addFields(const Scope& scope, std::vector<Field>& fields) const;
  bool setField(const std::string& id, const FieldValue& value, const Scope& scope);
  void addMarks(const Scope& scope, Marks& marks) const;
  std::vector<TintedFacet> tints(const Scope& scope) const;
  MarkRole role(const Scope& scope) const;  ///< valley or mountain, as it is seen

 private:
  /// A place on the paper of a facet.
  struct Named {
    FacetName facet;
    Vec2 paper;
    std::optional<Spot> in(const FoldedState& state) const;
  };
  struct Source {
    FacetName facet;
    Vec2 from;
    Vec2 to;
    Pane pane;
    std::optional<Named> grabbed;
    bool isEndless;
  };
  /// What the step says, and what is drawn of it. Facets are those of the state it was made for.
  struct Plan {
    DrawnLine line;
    LayerChoice layers;
    MovingSide moving = Hand::Left;
    std::size_t facetCount = 0;
    FacetLine segment;
    std::vector<std::pair<Spot, Spot>> creases;
    std::vector<std::vector<Spot>> rims;
    std::vector<FacetId> taken;
    std::vector<FacetId> missing;  ///< layers that must come along; empty: none
    std::optional<Spot> mover;     ///< a place on the moving side
    bool leftMoves = true;
  };

  std::optional<Plan> planFor(const Scope& scope, const FoldPlace& place);
  bool chooseSide(const Scope& scope, const FoldPlace& place, const PartedPaper& paper);
  std::optional<bool> sideBySelection(const Scope& scope, const PartedPaper& paper) const;
  bool smallerIsLeft(const Scope& scope, const FoldPlace& place, const PartedPaper& paper);
  void takeSelected(const Scope& scope, const FacetLine& line);
  std::vector<Vec2> selectedMovers(const Plan& plan, const PartedPaper& paper) const;
  bool isFor(const FoldedState& state) const;
  bool isTurned(const Scope& scope) const;
  void addLayerFields(std::vector<Field>& fields) const;
  void addArrow(const Scope& scope, Marks& marks) const;

  LayerPicker layers_;
  LayerFan fan_;
  FoldType seenType_ = FoldType::Valley;  ///< as the person chose it
  FoldType stepType_ = FoldType::Valley;  ///< as steps count
  double angle_ = 180;
  std::string name_;
  std::optional<Named> side_;  ///< a place on the moving side, once it is settled
  bool isTurnedByHand_ = false;
  bool isBySelection_ = false;  ///< the layers are those selected
  std::optional<Source> source_;
  std::optional<Plan> plan_;
  std::vector<Spot> selected_;  ///< facets, each with a place well inside; of the last look
};

}  // namespace kiri
