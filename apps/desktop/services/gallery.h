// The examples that come with the program, and what cards say and show of model files.
// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>
#include <QList>
#include <QString>
#include <QStringList>

#include "core/base/progress.h"

namespace kiri::desktop {

/// The folder with the examples, see io/examples_folder.h; empty when none is there.
QString examplesFolder();

struct ExampleGroup {
  QString title;
  QString notes;  ///< a sentence, or nothing
  QStringList models;
};
/// The models of a folder in the groups of its gallery, see galleryIn; titles and notes in the
/// language of the window.
QList<ExampleGroup> exampleGroups(const QString& folder = examplesFolder());

struct ModelCard {
  QString title;   ///< of the model, or made from the name of its file
  QString figure;  ///< see ModelWords
  QString notes;
  int steps = 0;
  QImage picture;  ///< null: not made yet, or the file is no model
};
/// What is known of a file before it is read.
ModelCard blankCard(const QString& path);
/// Reads the file without folding anything: a card without a picture. For work beside the window.
ModelCard readCard(const QString& path);
/// Reads a file, does its steps and draws the last state, seen from the front, on a transparent
/// ground. A picture that was made before, also by an earlier run, comes from the disk. For work
/// beside the window.
QImage drawCard(const QString& path, int pixels, const Progress& progress = {});

}  // namespace kiri::desktop
