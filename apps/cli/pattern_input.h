// The crease pattern that a command works on: read, repaired, and said what was repaired.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/cli/console.h"
#include "apps/cli/input_text.h"
#include "apps/cli/json_parts.h"
#include "core/creases/repair.h"
#include "io/patterns/pattern_file.h"

namespace kiri::cli {

struct PatternInput {
  std::string name;                 ///< for sentences
  std::string title;                ///< of the file, or its name
  std::string formatName;           ///< "FOLD", "model"
  std::optional<PatternFile> file;  ///< none for a .kiri model
  AssignedPattern creases;          ///< mm, or units of the file where those have no size
  std::vector<Repair> repairs;
  std::vector<std::string> notes;  ///< what was ignored or guessed while reading
  std::size_t bentCreases = 0;     ///< angles that were neither flat nor 180, taken as 180
  std::string unit;                ///< "mm" or "units"
  std::vector<VertexId> standing;  ///< ends of those creases: they stand in space, by number
};

/// The crease pattern in a text, repaired. Angles are those of the file. Errors: BadFile;
/// Cancelled.
Result<PatternInput> patternFrom(Console& console, const InputText& text);

/// Angles other than 0 and 180 degrees become 180; says how many.
std::size_t flattenAngles(AssignedPattern& creases);

/// The ends of creases with such angles, by number.
std::vector<VertexId> standingVertices(const AssignedPattern& creases);

/// Reads FILE ("-": standard input): a pattern in any format, or the creases of a .kiri model after
/// its last step, each folded as it last was. Angles other than 0 and 180 degrees become 180.
/// Errors: BadFile; Cancelled; those of the model's steps.
Result<PatternInput> loadPattern(Console& console, const std::string& path);

/// Prints what was guessed and repaired as notes.
void noteRepairs(Console& console, const PatternInput& input);

/// The name of a kind of repair in JSON: "merged_vertices".
const char* nameOf(RepairKind kind);
JsonValue repairsJson(const std::vector<Repair>& repairs);

/// "FOLD", "CP", "OPX", "SVG", "DXF".
const char* nameOf(PatternFormat format);

/// How many edges of a pattern have an assignment.
std::size_t countOf(const AssignedPattern& creases, Assignment assignment);

/// "18 facets, 40 creases (12 mountain, 20 valley, 8 unassigned)".
std::string describedAs(const AssignedPattern& creases);

}  // namespace kiri::cli
