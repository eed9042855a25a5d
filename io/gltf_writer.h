// glTF 2.0 files (binary, GLB) of the folded model (docs/formats/gltf.md).
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/geometry/cubic.h"
#include "core/model/model.h"
#include "core/paper/folded_state.h"
#include "io/fold_writer.h"

namespace kiri {

/// One side of the paper in a file.
struct GltfSide {
  Color color;
  std::string png;  ///< a PNG file that covers the sheet instead of the colour; empty: none
};

struct GltfOptions {
  std::string generator = "KiriSim";
  std::string title;
  Box sheet{{0, 0}, {150, 150}};  ///< box of the uncut sheet: a texture spans it
  GltfSide front{{90, 140, 70}, ""};
  GltfSide back{{214, 226, 190}, ""};
  double layerGap = kLayerGap;  ///< mm between a layer of a plane and the one below it
  double thickness = 0;         ///< mm; above zero each facet is a closed plate
  bool isPattern = false;       ///< the sheet at rest instead of the folded model
  double chordError = 0;        ///< mm by which polylines may miss curves; 0: the finest
  /// Animations: how far, as a share of the sheet's size, a facet may be off its true place between
  /// two key frames.
  double motionError = 0.0002;

  /// Enough for viewers to tell layers apart in a model of ordinary size, too little to see.
  static constexpr double kLayerGap = 0.05;
};

/// The model as it lies: a node for each facet, carrying its place in the model frame, below one
/// node that makes metres of mm and turns z up to y up: the model lies on the ground, the far edge
/// of the sheet towards -z. Front and back are primitives of their own with one-sided materials, so
/// that each side shows its colour everywhere. Curves become polylines.
Exported writeGlb(const FoldedState& state, const GltfOptions& options);

}  // namespace kiri
