// The examples that come with the program, and small pictures of model files.
// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>
#include <QString>
#include <QStringList>

#include "core/base/progress.h"

namespace kiri::desktop {

/// The folder with the examples that come with this program (io/examples_folder.h).
QString examplesFolder();
/// The models in a folder, those for beginners first, else by name.
QStringList modelsIn(const QString& folder);

struct ModelCard {
  QString title;  ///< of the model, or made from the name of its file
  int steps = 0;
  QImage picture;  ///< null: the file is no model
};
/// Reads a file, does its steps and draws the last state, seen from the front, on a transparent
/// ground. For work beside the window.
ModelCard cardOf(const QString& path, int pixels, const Progress& progress = {});

}  // namespace kiri::desktop
