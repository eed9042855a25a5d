// The tool that chooses what lies on top: another state of the crease pattern.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "editor/tools/tool.h"

namespace kiri {

/// A click on the folded model names a place and the layer under the uppermost one, more clicks
/// there the deeper ones; so do Tab and Ctrl and the wheel. Enter or the button brings the layer on
/// top; a click on a layer of the place in the sheet pane does it at once. It makes no step: the
/// wish goes to the pattern's own.
class TopLayerTool final : public Tool {
 public:
  Reaction pointer(const PointerEvent& event, const Scope& scope) override;
  Reaction key(const KeyEvent& event, const Scope& scope) override;
  Reaction wheel(const WheelEvent& event, const Scope& scope) override;
  void reset() override;
  bool isBusy() const override { return !layers_.empty(); }
  std::optional<Proposal> proposal(const Scope&) const override { return std::nullopt; }
  Marks marks(const Scope& scope) const override;
  std::vector<Field> fields(const Scope& scope) const override;
  Reaction setField(const std::string& id, const FieldValue& value, const Scope& scope) override;
  Phrase hint(const Scope& scope) const override;
  CursorShape cursor(const Scope&) const override { return CursorShape::Arrow; }

 private:
  struct Layer {
    Vec2 inside;  ///< a point of the facet, paper frame
    bool showsFront = true;
  };
  bool take(const PointerEvent& event, const Scope& scope);
  Reaction takeOnSheet(const PointerEvent& event, const Scope& scope);
  void walk(int by);
  Reaction wish();

  std::vector<Layer> layers_;  ///< at the place, the one that is seen first
  std::size_t chosen_ = 0;
  Vec2 at_;               ///< pixels of the click
  bool isAlone_ = false;  ///< the last click met one layer only
};

}  // namespace kiri
