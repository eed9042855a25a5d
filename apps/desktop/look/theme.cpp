// The colours of the window: light and dark, of its own things and of what is drawn over paper.
// SPDX-License-Identifier: MIT
#include "apps/desktop/look/theme.h"

#include <QApplication>
#include <QStyleFactory>

#include "apps/desktop/look/convert.h"
#include "apps/desktop/look/style_sheet.h"
#include "render/scene/line_looks.h"

namespace kiri::desktop {
namespace {

Theme lightTheme() {
  Theme t;
  t.shade = Shade::Light;
  t.ground = QColor(0xf3, 0xf4, 0xf2);
  t.sheetGround = QColor(0xe9, 0xeb, 0xe8);
  t.grid = QColor(0, 0, 0, 26);
  t.text = QColor(0x22, 0x2a, 0x27);
  t.faintText = QColor(0x66, 0x70, 0x6b);
  t.icon = QColor(0x39, 0x44, 0x3f);
  t.accent = QColor(0x2c, 0x7a, 0x52);
  t.accentText = Qt::white;
  t.line = QColor(0xd5, 0xd9, 0xd6);
  t.card = Qt::white;
  t.cardHover = QColor(0xf2, 0xf6, 0xf3);
  t.good = QColor(0x2c, 0x7a, 0x52);
  t.warning = QColor(0xa8, 0x5b, 0x00);
  t.fault = QColor(0xb4, 0x2a, 0x26);
  t.plate = QColor(255, 255, 255, 235);
  t.plateText = QColor(0x22, 0x2a, 0x27);
  return t;
}

Theme darkTheme() {
  Theme t;
  t.shade = Shade::Dark;
  t.ground = QColor(0x23, 0x27, 0x26);
  t.sheetGround = QColor(0x1d, 0x20, 0x1f);
  t.grid = QColor(255, 255, 255, 26);
  t.text = QColor(0xe3, 0xe8, 0xe5);
  t.faintText = QColor(0x9a, 0xa5, 0x9f);
  t.icon = QColor(0xcb, 0xd3, 0xcf);
  t.accent = QColor(0x4f, 0xb0, 0x7e);
  t.accentText = QColor(0x0e, 0x1a, 0x13);
  t.line = QColor(0x3c, 0x43, 0x40);
  t.card = QColor(0x2e, 0x33, 0x31);
  t.cardHover = QColor(0x36, 0x3d, 0x3a);
  t.good = QColor(0x6c, 0xc4, 0x95);
  t.warning = QColor(0xf0, 0xb2, 0x5a);
  t.fault = QColor(0xf2, 0x8b, 0x82);
  t.plate = QColor(0x14, 0x17, 0x16, 230);
  t.plateText = QColor(0xee, 0xf2, 0xf0);
  return t;
}

Theme& current() {
  static Theme chosen = lightTheme();
  return chosen;
}

QPalette paletteOf(const Theme& t) {
  const bool dark = t.isDark();
  const QColor window = dark ? QColor(0x2a, 0x2e, 0x2d) : QColor(0xfa, 0xfb, 0xfa);
  const QColor base = dark ? QColor(0x20, 0x24, 0x22) : QColor(Qt::white);
  const QColor button = dark ? QColor(0x35, 0x3b, 0x38) : QColor(0xf1, 0xf3, 0xf1);
  QPalette p(button, window);
  p.setColor(QPalette::Window, window);
  p.setColor(QPalette::Base, base);
  p.setColor(QPalette::AlternateBase, t.card);
  p.setColor(QPalette::Button, button);
  p.setColor(QPalette::Mid, t.line);
  p.setColor(QPalette::WindowText, t.text);
  p.setColor(QPalette::Text, t.text);
  p.setColor(QPalette::ButtonText, t.text);
  p.setColor(QPalette::PlaceholderText, t.faintText);
  p.setColor(QPalette::ToolTipBase, t.plate);
  p.setColor(QPalette::ToolTipText, t.plateText);
  p.setColor(QPalette::Highlight, t.accent);
  p.setColor(QPalette::HighlightedText, t.accentText);
  p.setColor(QPalette::Link, t.accent);
  p.setColor(QPalette::LinkVisited, t.accent);
  const QColor off = dark ? QColor(0x6d, 0x77, 0x72) : QColor(0xa4, 0xac, 0xa8);
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    p.setColor(QPalette::Disabled, role, off);
  }
  p.setColor(QPalette::Disabled, QPalette::Highlight, t.line);
  return p;
}

/// The colour that pictures give the same kind of line, made lighter where the ground is dark.
QColor creaseColour(LineKind kind, LineStyle style) {
  Appearance appearance;
  appearance.lineStyle = style;
  const QColor color = toQt(strokeFor(kind, appearance, 1).color);
  return style == LineStyle::Diagram ? theme().text : color;
}

}  // namespace

const Theme& theme() { return current(); }

void applyTheme(QApplication& application, Shade shade) {
  current() = shade == Shade::Dark ? darkTheme() : lightTheme();
  if (QStyle* fusion = QStyleFactory::create("Fusion")) QApplication::setStyle(fusion);
  QApplication::setPalette(paletteOf(current()));
  application.setStyleSheet(styleSheetOf(current()));
}

Shade shadeOfDesktop() {
  const QColor window = QGuiApplication::palette().color(QPalette::Window);
  return window.lightness() < 128 ? Shade::Dark : Shade::Light;
}

MarkPen penOf(MarkRole role, LineStyle style) {
  const Theme& t = theme();
  const QColor casing = t.isDark() ? QColor(0, 0, 0, 150) : QColor(255, 255, 255, 190);
  switch (role) {
    case MarkRole::Valley:
      return {creaseColour(LineKind::Valley, style), casing, 2, {5, 2.5}};
    case MarkRole::Mountain:
      return {creaseColour(LineKind::Mountain, style), casing, 2, {6, 2, 1, 2, 1, 2}};
    case MarkRole::Line:
      return {t.text, casing, 2, {}};
    case MarkRole::Axis:
      return {t.faintText, casing, 1, {5, 4}};
    case MarkRole::Curve:
      return {t.faintText, casing, 1, {2, 2}};
    case MarkRole::Handle:
    case MarkRole::ActiveHandle:
    case MarkRole::Selected:
    case MarkRole::Snap:
      return {t.accent, casing, 2, {}};
    case MarkRole::Hovered:
      return {t.accent, casing, 1.5, {}};
    case MarkRole::Possible:
      return {t.accent, casing, 2.5, {1, 1.5}};
    case MarkRole::Fault:
      return {t.fault, casing, 3, {}};
    case MarkRole::Collision:
      return {t.warning, casing, 2.5, {}};
    case MarkRole::Ghost:
      return {t.faintText, casing, 1, {3, 3}};
    case MarkRole::Measure:
      return {t.text, casing, 1.5, {}};
  }
  return {};
}

QColor tintOf(FacetTint tint) {
  const Theme& t = theme();
  const auto veil = [](QColor color, int alpha) {
    color.setAlpha(alpha);
    return color;
  };
  switch (tint) {
    case FacetTint::None:
      return Qt::transparent;
    case FacetTint::Pale:
      return veil(t.isDark() ? QColor(0xd8, 0xe2, 0xdc) : QColor(Qt::white), 110);
    case FacetTint::Hovered:
      return veil(t.isDark() ? QColor(Qt::white) : t.accent, 45);
    case FacetTint::Selected:
      return veil(t.accent, 110);
    case FacetTint::Colliding:
      return veil(QColor(0xe0, 0x82, 0x14), 150);
    case FacetTint::Stretched:
      return veil(QColor(0xc6, 0x2f, 0x2a), 140);
    case FacetTint::Dropped:
      return veil(t.isDark() ? QColor(0x20, 0x24, 0x22) : QColor(0xe0, 0xe2, 0xe0), 190);
  }
  return Qt::transparent;
}

}  // namespace kiri::desktop
