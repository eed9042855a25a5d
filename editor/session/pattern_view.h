// What a window shows of the crease pattern in a model: faults, verdict, components of states.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/base/phrase.h"
#include "editor/document/pattern_import.h"
#include "editor/session/pattern_analysis.h"
#include "editor/view/marks.h"
#include "editor/view/pane_map.h"

namespace kiri {

enum class PatternVerdict {
  Unknown,    ///< still being looked at, or stopped
  FoldsFlat,  ///< there are folded states
  FoldsNot,   ///< the creases do not close, or have angles that are not flat: `why`
  NoState,    ///< it would lie flat, but paper would pass through paper: `why`, `conflict`
};

/// Layers that can be chosen whatever the others are. Numbers are counted from 1, in decimal.
struct PatternComponent {
  std::size_t facets = 0;
  std::string count;   ///< of states; empty: not counted
  std::string number;  ///< of the one that is shown; empty: not known
};

struct PatternView {
  std::optional<std::size_t> step;  ///< place of the pattern in the model; none: there is none
  PatternReport report;             ///< of the import, until another model is opened
  bool isSearching = false;
  bool isCounting = false;
  std::vector<VertexFault> faults;
  std::vector<Vec2> faultPlaces;  ///< paper frame
  PatternVerdict verdict = PatternVerdict::Unknown;
  std::string why;  ///< the kernel's sentence
  std::size_t conflictFacets = 0;
  std::vector<PatternComponent> components;
  std::string total;         ///< of all states, decimal; empty: not counted
  std::string countProblem;  ///< why counting ended without a number
};

/// One entry of the lists of a view.
struct PatternEntry {
  enum class Kind { None, Repair, Fault, Component, Conflict };
  Kind kind = Kind::None;
  std::size_t index = 0;
  bool operator==(const PatternEntry&) const = default;
};

/// The rule in a word or two, with its amount: "Kawasaki 2.5°".
Phrase labelOf(const VertexFault& fault);

/// The places that an entry is about, paper frame.
std::vector<Vec2> placesOf(const PatternView& view, const PatternAnalysis* analysis,
                           const PatternEntry& entry);

/// Marks of the sheet pane: all faults, where they are wanted, and what the entry points at.
Marks patternMarks(const PatternView& view, const PatternAnalysis* analysis,
                   const PatternEntry& entry, bool showsFaults, const PaneMap& sheet);

}  // namespace kiri
