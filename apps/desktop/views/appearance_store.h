// The colours and textures of the open model, read once and shared by both panes.
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <memory>

#include "apps/desktop/look/display.h"
#include "apps/desktop/services/session_hub.h"
#include "editor/base/task.h"
#include "render/scene/appearance.h"

namespace kiri::desktop {

/// Textures are read beside the window; until one is there its side has its plain colour.
class AppearanceStore final : public QObject {
  Q_OBJECT
 public:
  explicit AppearanceStore(SessionHub& hub, QObject* parent = nullptr);

  const Appearance& appearance() const { return appearance_; }
  const Display& display() const { return display_; }
  void setDisplay(const Display& display);
  /// Another number whenever `appearance()` or `display()` is another.
  std::uint64_t revision() const { return revision_; }

 signals:
  void changed();
  /// A texture cannot be read; its side keeps the plain colour.
  void failed(const QString& sentence);

 private:
  void refresh();
  void apply();

  /// One side's texture: where it lies and what was read there.
  struct Texture {
    QString file;
    std::shared_ptr<const Image> image;
  };
  void read(Texture& texture, LatestTask& task, const QString& file);

  SessionHub& hub_;
  Display display_;
  Appearance appearance_;
  Texture front_;
  Texture back_;
  LatestTask readFront_;
  LatestTask readBack_;
  std::uint64_t revision_ = 1;
};

}  // namespace kiri::desktop
