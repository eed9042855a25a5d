// All that an SVG drawing shows, in the coordinates of its root.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "io/patterns/svg_document.h"
#include "io/patterns/svg_look.h"
#include "io/patterns/svg_path.h"

namespace kiri {

struct SvgDrawn {
  SvgChain chain;  ///< root coordinates, y down
  LineMeaning meaning;
};

/// What the drawing holds besides lines, to be told.
struct SvgCounts {
  std::size_t hidden = 0;
  std::size_t filledOnly = 0;
  std::size_t invisible = 0;  ///< neither stroke nor fill
  std::size_t texts = 0;
  std::size_t images = 0;
  std::size_t clipped = 0;  ///< elements with clip-path or mask
  std::size_t foreign = 0;
  std::size_t lostUses = 0;
  std::size_t tooDeep = 0;
  std::size_t damagedShapes = 0;
  std::size_t damagedTransforms = 0;
  std::size_t wildPlaces = 0;  ///< coordinates that are no numbers or beyond all measure
};

struct UnlistedColour {
  Assignment assignment = Assignment::Unassigned;
  std::size_t count = 0;  ///< of chains
};

struct SvgContents {
  std::vector<SvgDrawn> drawn;
  std::vector<SvgChain> filled;  ///< closed, with a fill and no stroke
  SvgCounts counts;
  std::map<std::string, UnlistedColour> unlisted;  ///< by "#rrggbb"
};

/// Walks the tree, through <use> too. Errors: BadFile - drawings that multiply themselves beyond
/// what can be a pattern, style sheets too large for them.
Result<SvgContents> svgContentsOf(const SvgDocument& document, const SvgHead& head,
                                  const std::string& fileName);

}  // namespace kiri
