// Which class stands behind each tool.
// SPDX-License-Identifier: MIT
#include "core/base/check.h"
#include "editor/tools/add_edge_tool.h"
#include "editor/tools/angle_tool.h"
#include "editor/tools/curve_cut_tool.h"
#include "editor/tools/fold_tool.h"
#include "editor/tools/line_tool.h"
#include "editor/tools/measure_tool.h"
#include "editor/tools/mend_tool.h"
#include "editor/tools/select_tool.h"
#include "editor/tools/straight_cut_tool.h"
#include "editor/tools/tear_tool.h"
#include "editor/tools/tool.h"
#include "editor/tools/top_layer_tool.h"

namespace kiri {

std::unique_ptr<Tool> makeTool(ToolId tool) {
  switch (tool) {
    case ToolId::Fold:
      return std::make_unique<FoldTool>();
    case ToolId::Line:
      return std::make_unique<LineTool>();
    case ToolId::Angle:
      return std::make_unique<AngleTool>();
    case ToolId::AddEdge:
      return std::make_unique<AddEdgeTool>();
    case ToolId::Tear:
      return std::make_unique<TearTool>();
    case ToolId::Mend:
      return std::make_unique<MendTool>();
    case ToolId::StraightCut:
      return std::make_unique<StraightCutTool>();
    case ToolId::CurveCut:
      return std::make_unique<CurveCutTool>();
    case ToolId::Select:
      return std::make_unique<SelectTool>();
    case ToolId::Measure:
      return std::make_unique<MeasureTool>();
    case ToolId::TopLayer:
      return std::make_unique<TopLayerTool>();
  }
  failCheck("every tool has a class", __FILE__, __LINE__);
}

}  // namespace kiri
