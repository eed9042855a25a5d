// The measure tool: distances, angles, lengths of edges and areas of facets.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "editor/tools/facet_name.h"
#include "editor/tools/tool.h"

namespace kiri {

/// Points are snapped. A distance is told on the sheet and in space, which differ where paper is
/// folded between. What was measured stays until the next click or Escape.
class MeasureTool final : public Tool {
 public:
  Reaction pointer(const PointerEvent& event, const Scope& scope) override;
  Reaction key(const KeyEvent& event, const Scope& scope) override;
  void reset() override;
  bool isBusy() const override { return !points_.empty() || edge_ || facet_; }
  std::optional<Proposal> proposal(const Scope&) const override { return std::nullopt; }
  Marks marks(const Scope& scope) const override;
  std::vector<Field> fields(const Scope& scope) const override;
  Reaction setField(const std::string& id, const FieldValue& value, const Scope& scope) override;
  Phrase hint(const Scope& scope) const override;
  CursorShape cursor(const Scope&) const override { return CursorShape::Cross; }

 private:
  enum class What { Distance, Angle, Edge, Facet };
  struct Point {
    FacetName facet;
    Vec2 paper;
  };

  std::size_t needed() const { return what_ == What::Angle ? 3 : 2; }
  void pick(const PointerEvent& event, const Scope& scope);
  std::vector<Spot> spots(const FoldedState& state, bool withNext) const;
  void addPoints(const Scope& scope, Marks& marks) const;
  void addThings(const Scope& scope, Marks& marks) const;
  std::vector<Field> results(const FoldedState& state) const;

  What what_ = What::Distance;
  std::vector<Point> points_;
  std::optional<Point> next_;  ///< under the pointer
  std::optional<Vec2> edge_;   ///< a place on it, paper frame
  std::optional<FacetName> facet_;
  Marks caught_;
};

}  // namespace kiri
