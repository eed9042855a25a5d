// The line tool: a fold line drawn anywhere, or placed by a construction.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "editor/tools/drawn_line.h"
#include "editor/tools/fold_offer.h"
#include "editor/tools/line_builder.h"
#include "editor/tools/tool.h"

namespace kiri {

/// Draws a fold line with two ends, on paper too, or builds it from points and edges that are
/// clicked; where several lines do what was asked, Space and the arrow keys go through them. The
/// line has handles, and its length and direction can be typed. Enter folds along it.
class LineTool final : public Tool {
 public:
  Reaction pointer(const PointerEvent& event, const Scope& scope) override;
  Reaction key(const KeyEvent& event, const Scope& scope) override;
  Reaction wheel(const WheelEvent& event, const Scope& scope) override;
  void reset() override;
  bool isBusy() const override;
  std::optional<Proposal> proposal(const Scope& scope) const override;
  Marks marks(const Scope& scope) const override;
  std::vector<TintedFacet> tints(const Scope& scope) const override;
  std::vector<Field> fields(const Scope& scope) const override;
  Reaction setField(const std::string& id, const FieldValue& value, const Scope& scope) override;
  Phrase hint(const Scope& scope) const override;
  CursorShape cursor(const Scope& scope) const override;

 private:
  Reaction byHand(const PointerEvent& event, const Scope& scope);
  Reaction press(const PointerEvent& event, const Scope& scope);
  void look(const Scope& scope, bool isNew);
  void finish(const Scope& scope);
  void showBuilt(const Scope& scope);
  FoldPlace placed(FacetId frame, const Line2& line) const;
  void nextSolution(int by, const Scope& scope);
  void startConstruction(Construction kind, const Scope& scope);
  bool isDrawn() const;

  Construction kind_ = Construction::ByHand;
  LineBuilder builder_;
  std::size_t solution_ = 0;
  std::size_t solutions_ = 0;
  bool isEndless_ = false;
  bool isDrawing_ = false;  ///< a new line, not one that is moved by a handle
  Pane pane_ = Pane::Model;
  std::optional<PointerEvent> pressed_;  ///< while a line rests: a drag draws another
  LineHand line_;
  FoldOffer offer_;
};

}  // namespace kiri
