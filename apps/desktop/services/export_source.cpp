// The open model as values that work beside the window can read.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/export_source.h"

#include <QFileInfo>

namespace kiri::desktop {

ExportSource exportSourceOf(const Document& document, const ViewFrame& screen) {
  ExportSource source;
  source.model = document.modelToSave();
  source.cursor = document.cursor();
  for (std::size_t i = 1; i <= source.cursor; ++i) {
    const auto state = document.stateAfter(i);
    if (!state) break;
    source.after.push_back(state);
  }
  source.state = document.state();
  source.path = QString::fromStdString(document.path());
  source.title = QString::fromStdString(document.model().title);
  if (source.title.isEmpty()) source.title = QFileInfo(source.path).completeBaseName();
  source.screen = screen;
  return source;
}

}  // namespace kiri::desktop
