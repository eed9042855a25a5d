// Pictures of a model folded, half unfolded and unfolded.
// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>
#include <QList>
#include <QString>

#include "core/base/progress.h"

namespace kiri::desktop {

struct ModelMoment {
  enum class Kind { Folded, HalfUnfolded, HalfFolded, Unfolded };
  Kind kind = Kind::Folded;
  QImage picture;
};

/// Reads a model, does its steps and draws the moments that it has, on a transparent ground; those
/// that were drawn before come from the disk. None when the file is no model, or a step of it does
/// not apply. `density`: see thumbnailOf. For work beside the window.
QList<ModelMoment> momentsIn(const QString& path, int pixels, double density,
                             const Progress& progress = {});

}  // namespace kiri::desktop
