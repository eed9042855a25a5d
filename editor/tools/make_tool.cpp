// Which class stands behind each tool.
// SPDX-License-Identifier: MIT
#include "editor/tools/angle_tool.h"
#include "editor/tools/fold_tool.h"
#include "editor/tools/line_tool.h"
#include "editor/tools/measure_tool.h"
#include "editor/tools/select_tool.h"
#include "editor/tools/tool.h"

namespace kiri {
namespace {

/// Stands for a tool that is not written yet: does nothing.
class IdleTool final : public Tool {
 public:
  Reaction pointer(const PointerEvent&, const Scope&) override { return Reaction::ignored(); }
  void reset() override {}
  bool isBusy() const override { return false; }
  std::optional<Proposal> proposal(const Scope&) const override { return std::nullopt; }
  Marks marks(const Scope&) const override { return {}; }
  Phrase hint(const Scope&) const override { return {}; }
  CursorShape cursor(const Scope&) const override { return CursorShape::Arrow; }
};

}  // namespace

std::unique_ptr<Tool> makeTool(ToolId tool) {
  switch (tool) {
    case ToolId::Fold:
      return std::make_unique<FoldTool>();
    case ToolId::Line:
      return std::make_unique<LineTool>();
    case ToolId::Angle:
      return std::make_unique<AngleTool>();
    case ToolId::Select:
      return std::make_unique<SelectTool>();
    case ToolId::Measure:
      return std::make_unique<MeasureTool>();
    case ToolId::AddEdge:
    case ToolId::Tear:
    case ToolId::Mend:
    case ToolId::StraightCut:
    case ToolId::CurveCut:
      return std::make_unique<IdleTool>();
  }
  return std::make_unique<IdleTool>();
}

}  // namespace kiri
