// The select tool: picks facets, points, vertices and lines (thesis 4.5, E).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "editor/tools/tool.h"

namespace kiri {

/// A click picks one thing of the kind that is filtered by, with Shift one more; a drag picks the
/// facets in a rectangle. A click beside the paper, or Escape, clears.
class SelectTool final : public Tool {
 public:
  Reaction pointer(const PointerEvent& event, const Scope& scope) override;
  Reaction key(const KeyEvent& event, const Scope& scope) override;
  void reset() override;
  bool isBusy() const override { return pressed_.has_value(); }
  std::optional<Proposal> proposal(const Scope&) const override { return std::nullopt; }
  Marks marks(const Scope& scope) const override;
  std::vector<TintedFacet> tints(const Scope& scope) const override;
  std::vector<Field> fields(const Scope& scope) const override;
  Reaction setField(const std::string& id, const FieldValue& value, const Scope& scope) override;
  Phrase hint(const Scope& scope) const override;
  CursorShape cursor(const Scope&) const override { return CursorShape::Arrow; }

 private:
  std::optional<Selected> under(const PointerEvent& event, const Scope& scope) const;
  Reaction release(const PointerEvent& event, const Scope& scope);

  SelectedKind kind_ = SelectedKind::Facet;
  std::optional<PointerEvent> pressed_;
  Vec2 at_;  ///< pixels, while pressed
  bool isBand_ = false;
  std::optional<Selected> hovered_;
};

}  // namespace kiri
