// Icons by name, in the colours of the theme, sharp at every size.
// SPDX-License-Identifier: MIT
#include "apps/desktop/look/icons.h"

#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>

#include "apps/desktop/look/theme.h"

static void initialiseResources() {
  Q_INIT_RESOURCE(icons);  // of a static library: nobody else would
}

namespace kiri::desktop {
namespace {

QString fileOf(const QString& name) { return ":/icons/" + name + ".svg"; }

/// Draws one SVG in the colour that the theme has at that moment.
class ThemedEngine final : public QIconEngine {
 public:
  explicit ThemedEngine(QString name) : name_(std::move(name)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    const QColor color = colorOf(mode);
    QByteArray svg = bytes();
    if (svg.isEmpty()) {
      painter->setPen(color);
      painter->drawText(rect, Qt::AlignCenter, name_.left(1).toUpper());
      return;
    }
    svg.replace("currentColor", color.name().toUtf8());
    QSvgRenderer renderer(svg);
    renderer.setAspectRatioMode(Qt::KeepAspectRatio);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    if (mode == QIcon::Disabled) painter->setOpacity(painter->opacity() * 0.35);
    renderer.render(painter, rect);
    painter->restore();
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    const QString key = QString("kiri-icon/%1/%2x%3/%4/%5")
                            .arg(name_)
                            .arg(size.width())
                            .arg(size.height())
                            .arg(mode)
                            .arg(colorOf(mode).name());
    QPixmap pixmap;
    if (QPixmapCache::find(key, &pixmap)) return pixmap;
    pixmap = QPixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(), size), mode, state);
    painter.end();
    QPixmapCache::insert(key, pixmap);
    return pixmap;
  }

  QIconEngine* clone() const override { return new ThemedEngine(name_); }
  QString key() const override { return "kiri-themed"; }

 private:
  static QColor colorOf(QIcon::Mode mode) {
    return mode == QIcon::Selected ? theme().accentText : theme().icon;
  }
  const QByteArray& bytes() {
    if (bytes_.isNull()) {
      QFile file(fileOf(name_));
      bytes_ = file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("");
    }
    return bytes_;
  }

  QString name_;
  QByteArray bytes_;
};

}  // namespace

QIcon icon(const QString& name) {
  initialiseResources();
  return QIcon(new ThemedEngine(name));
}

bool hasIcon(const QString& name) {
  initialiseResources();
  return QFile::exists(fileOf(name));
}

}  // namespace kiri::desktop
