// The mesh of a state out of that of another one, when nothing but poses differs.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "render/mesh/paper_mesh.h"

namespace kiri {

/// The mesh of `state`, made by carrying the parts of `base`, the mesh of `baseState`, to where
/// their facets are now: many times as fast as meshOf, for sliders and films. Nothing when more
/// than poses has changed: paper, what folds, which facets lie in one plane, how, and in which
/// order. Moved meshes may be a grain of a float less exact, so `base` is best one by meshOf.
std::optional<PaperMesh> movedMesh(const PaperMesh& base, const FoldedState& baseState,
                                   const FoldedState& state);

}  // namespace kiri
