// The style sheet of the window: calm tool buttons, panels and sliders.
// SPDX-License-Identifier: MIT
#include "apps/desktop/look/style_sheet.h"

#include <QHash>

#include "apps/desktop/look/theme.h"

namespace kiri::desktop {
namespace {

/// Words in dollars stand for colours.
constexpr const char* kSheet = R"(
QToolTip { background: $card$; color: $text$; border: 1px solid $line$; padding: 4px 6px; }
QMainWindow::separator { background: $line$; width: 1px; height: 1px; }
QSplitter::handle { background: $line$; }
QSplitter::handle:hover { background: $accent$; }
QToolBar { border: none; border-bottom: 1px solid $line$; spacing: 2px; padding: 3px 6px; }
QToolBar#tools { border-bottom: none; border-right: 1px solid $line$; padding: 6px 4px; }
QToolBar::separator { background: $line$; width: 1px; height: 1px; margin: 5px; }
QToolButton { border: 1px solid transparent; border-radius: 6px; padding: 5px; }
QToolButton:hover { background: $hover$; }
QToolButton:pressed { background: $line$; }
QToolButton:checked { background: $chosen$; border-color: $accent$; }
QToolButton:focus { border-color: $accent$; }
QStatusBar { border-top: 1px solid $line$; }
QStatusBar::item { border: none; }
QDockWidget { font-weight: 600; }
QDockWidget::title { padding: 7px 10px; border-bottom: 1px solid $line$; text-align: left; }
QLabel[faint="true"] { color: $faint$; }
QLabel[fault="true"] { color: $fault$; }
QLabel[warning="true"] { color: $warning$; }
QFrame#fieldBar { border-bottom: 1px solid $line$; }
QFrame#preview { border-left: 1px solid $line$; }
QFrame#caption { border-top: 1px solid $line$; }
QFrame#player { border-top: 1px solid $line$; }
QToolButton[segment="true"] { border: 1px solid $line$; border-radius: 0; padding: 3px 9px; }
QToolButton[segment="true"]:checked { background: $chosen$; border-color: $accent$; }
QToolButton#commit { background: $accent$; color: $accentText$; font-weight: 600; padding: 5px 14px; }
QToolButton#commit:hover { background: $accentHover$; }
QSlider::groove:horizontal { height: 4px; background: $line$; border-radius: 2px; }
QSlider::sub-page:horizontal { background: $accent$; border-radius: 2px; }
QSlider::sub-page:horizontal:disabled { background: $line$; }
QSlider::handle:horizontal { width: 14px; margin: -6px 0; border-radius: 8px; background: $card$;
  border: 1px solid $faint$; }
QSlider::handle:horizontal:hover, QSlider::handle:horizontal:focus { border: 2px solid $accent$; }
QListView#steps { border: none; background: $window$; }
QScrollArea { border: none; }
)";

}  // namespace

QString styleSheetOf(const Theme& theme) {
  QColor chosen = theme.accent;
  chosen.setAlpha(theme.isDark() ? 70 : 40);
  QColor hover = theme.text;
  hover.setAlpha(22);
  const QHash<QString, QColor> colors{
      {"card", theme.card},
      {"text", theme.text},
      {"line", theme.line},
      {"accent", theme.accent},
      {"accentText", theme.accentText},
      {"accentHover", theme.accent.lighter(115)},
      {"hover", hover},
      {"chosen", chosen},
      {"faint", theme.faintText},
      {"fault", theme.fault},
      {"warning", theme.warning},
      {"window", theme.isDark() ? QColor(0x26, 0x2a, 0x28) : QColor(0xf6, 0xf7, 0xf6)},
  };
  QString sheet = kSheet;
  for (auto it = colors.begin(); it != colors.end(); ++it) {
    const QColor& c = it.value();
    const QString value = QString("rgba(%1,%2,%3,%4)")
                              .arg(c.red())
                              .arg(c.green())
                              .arg(c.blue())
                              .arg(QString::number(static_cast<double>(c.alphaF()), 'f', 3));
    sheet.replace("$" + it.key() + "$", value);
  }
  return sheet;
}

}  // namespace kiri::desktop
