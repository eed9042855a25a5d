// About: version, licences, and what draws the window.
// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>

namespace kiri::desktop {

/// `renderer`: what the model pane says about OpenGL ("Mesa llvmpipe, OpenGL 4.5").
class AboutDialog final : public QDialog {
  Q_OBJECT
 public:
  AboutDialog(const QString& version, const QString& renderer, QWidget* parent = nullptr);

  /// The facts as plain text, for reports of errors; a button copies them.
  QString facts() const { return facts_; }

 private:
  QString facts_;
};

}  // namespace kiri::desktop
