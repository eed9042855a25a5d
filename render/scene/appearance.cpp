// How paper and lines look in pictures.
// SPDX-License-Identifier: MIT
#include "render/scene/appearance.h"

namespace kiri {

Appearance appearanceOf(const Model& model) {
  Appearance out;
  out.front.color = model.front.color;
  out.back.color = model.back.color;
  if (const Result<Sheet> sheet = makeSheet(model.sheet)) out.textureBox = boundsOf(sheet->outline);
  return out;
}

}  // namespace kiri
