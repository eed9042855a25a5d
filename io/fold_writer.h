// FOLD 1.2 files (docs/formats/fold.md).
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/paper/folded_state.h"

namespace kiri {

/// One state of the history, for a frame of its own.
struct FoldFrame {
  std::shared_ptr<const FoldedState> state;
  std::string title;
  std::string description;
};

struct FoldOptions {
  std::string creator = "KiriSim";
  std::string title;
  std::string description;
  double chordError = 0;  ///< mm by which polylines may miss curves; 0: the finest
  int decimals = 0;       ///< digits of coordinates after the point; 0: all that a double has
};

/// A text in another format, and what that format could not hold.
struct Exported {
  std::string text;
  std::vector<std::string> losses;  ///< sentences
};

/// A FOLD file. Its key frame is the crease pattern of `state` in the paper frame (y up, mm) with
/// assignments, fold angles (valley positive) and face orders, useful to programs that read no
/// frames; each entry of `history` becomes a folded form in the model frame with vertices, faces
/// and face orders of its own. Facets that are not convex become convex faces joined by J edges;
/// curves become polylines.
Exported writeFold(const FoldedState& state, const std::vector<FoldFrame>& history,
                   const FoldOptions& options);

}  // namespace kiri
