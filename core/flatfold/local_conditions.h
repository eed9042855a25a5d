// What must hold around each vertex for a pattern to fold flat.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/creases/assigned_pattern.h"

namespace kiri {

enum class VertexRule {
  EvenDegree,    ///< an even number of folded creases
  Kawasaki,      ///< alternate angles add up to 180 degrees
  Maekawa,       ///< mountains and valleys differ by two
  BigLittleBig,  ///< creases beside a smallest angle, or a run of equal smallest ones
  SelfCrossing,  ///< no order of the layers around the vertex lets paper past paper
};

struct VertexFault {
  VertexId vertex;
  VertexRule rule = VertexRule::Kawasaki;
  double amount = 0;    ///< Kawasaki: degrees by which it is missed; else counts, see message
  std::string message;  ///< a sentence with place (mm) and amount
};

/// The faults of all vertices inside the paper, ordered by vertex, then rule. Flat creases, joins
/// and cuts do not count as folded; a vertex on a border or cut has no condition. Unassigned
/// creases may be either: a rule is broken only when no choice keeps it. `within`: degrees by which
/// Kawasaki may be missed and equal angles differ; 0: as much as ends of creases drawn within
/// Tolerance::thin() of their places explain (real drawings miss by up to a fifth of that).
/// SelfCrossing is told where all other rules hold. Sources: Hull, Project Origami; guide to
/// algorithms 4.1; single-vertex crimping.
std::vector<VertexFault> vertexFaults(const AssignedPattern& creases, double within = 0);

}  // namespace kiri
