// The models of examples/ name what is not as in whole paper: tears, slits and collisions that
// remain. SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <initializer_list>

#include "tests/examples/example_models.h"

namespace kiri::test {
namespace {

class EveryRemainder : public ExampleTest {};

/// Whether one of the words stands in the text, also as the beginning of a longer one.
bool speaksOf(std::string text, std::initializer_list<const char*> words) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
      if (at == 0 || std::isalpha(static_cast<unsigned char>(text[at - 1])) == 0) return true;
    }
    return false;
  });
}

/// Cuts and tears with paper on both sides.
std::size_t openEdges(const FoldedState& state, EdgeKind kind) {
  const auto& edges = state.pattern.edges;
  return static_cast<std::size_t>(std::count_if(edges.begin(), edges.end(), [&](const Edge& edge) {
    return edge.kind == kind && edge.left.isValid() && edge.right.isValid();
  }));
}

TEST_P(EveryRemainder, OfTearsIsNamed) {
  if (openEdges(example().last(), EdgeKind::Tear) == 0) return;
  EXPECT_TRUE(speaksOf(example().model.notes, {"tear", "torn"})) << example().model.notes;
}

TEST_P(EveryRemainder, OfSlitsIsNamed) {
  if (openEdges(example().last(), EdgeKind::Cut) == 0) return;
  EXPECT_TRUE(speaksOf(example().model.notes, {"cut", "slit"})) << example().model.notes;
}

TEST_P(EveryRemainder, OfCollisionsIsNamed) {
  const auto& collisions = example().last().collisions;
  if (collisions.empty()) return;
  EXPECT_TRUE(speaksOf(example().model.notes, {"collision", "collide", "passes through"}))
      << example().model.notes << "\n"
      << collisions.front().message;
}

KIRI_FOR_EVERY_EXAMPLE(EveryRemainder);

TEST(SpeaksOf, FindsWordsAndNoPartsOfOthers) {
  EXPECT_TRUE(speaksOf("Two tears stay.", {"tear"}));
  EXPECT_TRUE(speaksOf("Torn along the vein", {"torn"}));
  EXPECT_FALSE(speaksOf("Uncut paper, haircut", {"cut"}));
}

}  // namespace
}  // namespace kiri::test
