// What a leaf is made from: a few angles and lengths (thesis 7.1).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/model/model.h"

namespace kiri {

/// A ray from the petiole, on both sides of the mid-vein: a vein ends in the tip of a lobe, an
/// anti-vein in a sinus.
struct LeafRay {
  double angle = 0;   ///< degrees from the mid-vein
  double length = 0;  ///< as part of the mid-vein's length
  bool operator==(const LeafRay&) const = default;
};

/// Where the petiole meets the blade (thesis 7.1, cases a and b).
enum class Petiole {
  OnEdge,  ///< on the lower edge of the sheet; the blade ends there, at 90 degrees
  Inside,  ///< inside the sheet, opened by a straight cut along the basal edge
};

/// A pair of lobes on a lobe, alike on both sides of its vein: only what has its mirror image can
/// be folded (thesis 7.1, case c). Angles are from the outer part of that vein at the junction,
/// lengths from the junction, as part of the mid-vein's.
struct SecondaryLobes {
  std::size_t lobe = 0;  ///< 0: the mid-lobe, 1: that of veins[0], ... in both halves
  double at = 0.5;       ///< where they leave the vein, as part of its length from the petiole
  LeafRay antiVein;      ///< to the sinus between the lobe's tip and the secondary lobe
  LeafRay vein;          ///< to the tip of the secondary lobe
  bool isTorn = false;  ///< folded one by one with a tear along the mid-vein (thesis Fig 7.4), else
                        ///< all creases at once, without a tear
  bool operator==(const SecondaryLobes&) const = default;
};

/// A palmate leaf. From the mid-vein outward anti-veins and veins take turns: antiVeins[0],
/// veins[0], antiVeins[1], veins[1], ...; the basal edge comes last.
struct LeafRecipe {
  std::string title;
  std::string notes;
  double midVein = 100;  ///< mm, petiole to tip
  Petiole petiole = Petiole::Inside;
  std::vector<LeafRay> veins;      ///< beside the mid-vein, outward
  std::vector<LeafRay> antiVeins;  ///< as many as veins
  LeafRay base{120, 0.3};          ///< the basal edge, and where the margin meets it
  /// Further places of the right half that the margin passes, wherever it would not go by itself.
  std::vector<LeafRay> margin;
  std::vector<SecondaryLobes> secondary;
  PaperSide front{{79, 138, 58}, ""};
  PaperSide back{{169, 201, 139}, ""};
  bool operator==(const LeafRecipe&) const = default;
};

}  // namespace kiri
