// Faults, repairs and conflicts of crease patterns stand on the page where they are.
// SPDX-License-Identifier: MIT
#include "render/scene/pattern_check_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "core/flatfold/flat_folding.h"
#include "render/scene/page_text.h"

namespace kiri {
namespace {

void addBorder(CreaseDrawing& drawing, double size) {
  const Vec2 corners[] = {{0, 0}, {size, 0}, {size, size}, {0, size}};
  for (std::size_t i = 0; i < 4; ++i) {
    drawing.lines.push_back({corners[i], corners[(i + 1) % 4], Assignment::Border, {}});
  }
}

RepairedPattern repaired(const CreaseDrawing& drawing) {
  const Result<RepairedPattern> found = patternOf(drawing);
  EXPECT_TRUE(found) << (found ? "" : found.error().message);
  return *found;
}

/// A square with crosses that miss Kawasaki, Maekawa, or both, on a grid.
RepairedPattern faultyPattern(int side) {
  CreaseDrawing drawing;
  addBorder(drawing, 10.0 * side);
  for (int i = 0; i < side; ++i) {
    const double at = 10.0 * i + 5;
    drawing.lines.push_back({{0, at}, {10.0 * side, at}, Assignment::Mountain, {}});
    const auto across = i % 2 == 0 ? Assignment::Valley : Assignment::Mountain;
    drawing.lines.push_back({{at, 0}, {at + (i % 2), 10.0 * side}, across, {}});
  }
  return repaired(drawing);
}

const Group* groupOf(const Scene& scene, const std::string& id) {
  for (const Group& group : scene.groups) {
    if (group.id == id) return &group;
  }
  return nullptr;
}

Box boxOfLoops(const std::vector<std::vector<Arc>>& loops) {
  Box box = boundsOf(loops.front().front());
  for (const auto& loop : loops) {
    for (const Arc& arc : loop) box = joined(box, boundsOf(arc));
  }
  return box;
}

Box boxOfItem(const Item& item) {
  if (const auto* fill = std::get_if<FillItem>(&item.shape)) return boxOfLoops(fill->loops);
  if (const auto* stroke = std::get_if<StrokeItem>(&item.shape)) {
    const Box box = boxOfLoops(stroke->chains);
    const Vec2 half{stroke->stroke.width / 2, stroke->stroke.width / 2};
    return {box.low - half, box.high + half};
  }
  const auto& text = std::get<TextItem>(item.shape);
  const double width = widthOf(text.text, text.height);
  const double left = text.anchor == TextAnchor::Start    ? text.at.x
                      : text.anchor == TextAnchor::Middle ? text.at.x - width / 2
                                                          : text.at.x - width;
  return {{left, text.at.y - 0.2 * text.height}, {left + width, text.at.y + 0.8 * text.height}};
}

void expectAllOnPage(const Scene& scene) {
  constexpr double kSlack = 1e-9;
  for (const Group& group : scene.groups) {
    for (const Item& item : group.items) {
      const Box box = boxOfItem(item);
      EXPECT_GE(box.low.x, -kSlack) << group.id;
      EXPECT_GE(box.low.y, -kSlack) << group.id;
      EXPECT_LE(box.high.x, scene.width + kSlack) << group.id;
      EXPECT_LE(box.high.y, scene.height + kSlack) << group.id;
    }
  }
}

std::string wordsOf(const Scene& scene) {
  std::string words;
  for (const Group& group : scene.groups) {
    for (const Item& item : group.items) {
      if (const auto* text = std::get_if<TextItem>(&item.shape)) words += text->text + "\n";
    }
  }
  return words;
}

/// The map from paper to page, from the drawn paper.
struct Placing {
  explicit Placing(const Scene& scene, const AssignedPattern& creases) {
    const Item& paper = groupOf(scene, "print")->items.front();
    const Box page = boxOfLoops(std::get<FillItem>(paper.shape).loops);
    Box box{creases.pattern.vertices[0], creases.pattern.vertices[0]};
    for (const Vec2 v : creases.pattern.vertices) box = joined(box, Box{v, v});
    scale = (page.high.x - page.low.x) / (box.high.x - box.low.x);
    corner = page.low - box.low * scale;
  }
  Vec2 operator()(Vec2 p) const { return p * scale + corner; }
  double scale = 1;
  Vec2 corner;
};

TEST(PatternCheckScene, EveryFaultHasARingAtItsVertexAndALabel) {
  const RepairedPattern found = faultyPattern(4);
  const std::vector<VertexFault> faults = vertexFaults(found.creases);
  ASSERT_GT(faults.size(), 16U);
  const Scene scene = patternCheckScene(found.creases, faults, found.repairs, {});
  const Placing place(scene, found.creases);
  const Group* rings = groupOf(scene, "faults");
  ASSERT_NE(rings, nullptr);
  ASSERT_EQ(rings->items.size(), faults.size());
  for (std::size_t i = 0; i < faults.size(); ++i) {
    const Box box = boxOfItem(rings->items[i]);
    const Vec2 at = place(found.creases.pattern[faults[i].vertex]);
    EXPECT_NEAR((box.low.x + box.high.x) / 2, at.x, 1e-6);
    EXPECT_NEAR((box.low.y + box.high.y) / 2, at.y, 1e-6);
  }
  const std::string words = wordsOf(scene);
  for (const VertexFault& fault : faults) {
    EXPECT_NE(words.find(labelOf(found.creases, fault)), std::string::npos);
  }
  EXPECT_NE(words.find("Maekawa 4-0"), std::string::npos);
  EXPECT_NE(words.find("Kawasaki 2.8"), std::string::npos);
  expectAllOnPage(scene);
}

TEST(PatternCheckScene, RingsOfOneVertexDoNotLieOnEachOther) {
  const RepairedPattern found = faultyPattern(4);
  const std::vector<VertexFault> faults = vertexFaults(found.creases);
  const Scene scene = patternCheckScene(found.creases, faults, {}, {});
  const Group* rings = groupOf(scene, "faults");
  std::size_t pairs = 0;
  for (std::size_t i = 1; i < faults.size(); ++i) {
    if (faults[i].vertex != faults[i - 1].vertex) continue;
    ++pairs;
    EXPECT_GT(boxOfItem(rings->items[i]).high.x, boxOfItem(rings->items[i - 1]).high.x + 0.4);
  }
  EXPECT_GT(pairs, 0U);
}

TEST(PatternCheckScene, EveryEdgeIsDrawnOnceInItsGroup) {
  CreaseDrawing drawing;
  addBorder(drawing, 10);
  const Assignment kinds[] = {Assignment::Mountain, Assignment::Valley, Assignment::Unassigned,
                              Assignment::Flat};
  for (std::size_t i = 0; i < 4; ++i) {
    const double x = 2 * static_cast<double>(i) + 2;
    drawing.lines.push_back({{x, 0}, {x, 10}, kinds[i], {}});
  }
  const RepairedPattern found = repaired(drawing);
  const Scene scene = patternCheckScene(found.creases, {}, {}, {});
  std::set<std::string> ids;
  std::size_t edges = 0;
  for (const char* id : {"mountain", "valley", "unassigned", "flat", "cut"}) {
    const Group* group = groupOf(scene, id);
    ASSERT_NE(group, nullptr) << id;
    edges += group->items.size();
    for (const Item& item : group->items) ids.insert(item.id);
  }
  EXPECT_EQ(edges, found.creases.pattern.edges.size());
  EXPECT_EQ(ids.size(), edges);
  EXPECT_NE(wordsOf(scene).find("every vertex folds flat"), std::string::npos);
}

TEST(PatternCheckScene, RepairsAreMarkedWhereTheyWereMadeAndTold) {
  CreaseDrawing drawing;
  addBorder(drawing, 10);
  drawing.lines.push_back({{5, 0}, {5, 10}, Assignment::Mountain, {}});
  drawing.lines.push_back({{0, 5}, {10, 5}, Assignment::Valley, {}});
  drawing.lines.push_back({{0, 5}, {10, 5}, Assignment::Valley, {}});
  const RepairedPattern found = repaired(drawing);
  ASSERT_FALSE(found.repairs.empty());
  std::size_t places = 0;
  for (const Repair& repair : found.repairs) places += repair.places.size();
  ASSERT_GT(places, 0U);
  const Scene scene = patternCheckScene(found.creases, {}, found.repairs, {});
  ASSERT_NE(groupOf(scene, "repairs"), nullptr);
  EXPECT_EQ(groupOf(scene, "repairs")->items.size(), places);
  for (const Repair& repair : found.repairs) {
    EXPECT_NE(wordsOf(scene).find(repair.message.substr(0, 20)), std::string::npos);
  }
  expectAllOnPage(scene);
}

TEST(PatternCheckScene, MoreFaultsThanCanBeReadKeepTheirRings) {
  const RepairedPattern found = faultyPattern(14);
  const std::vector<VertexFault> faults = vertexFaults(found.creases);
  ASSERT_GT(faults.size(), 120U);
  PatternCheckOptions options;
  options.title =
      "a title that is rather long for the page that it stands on, but on it all the same";
  options.verdict = "a verdict";
  const Scene scene = patternCheckScene(found.creases, faults, found.repairs, {}, options);
  EXPECT_EQ(groupOf(scene, "faults")->items.size(), faults.size());
  EXPECT_EQ(groupOf(scene, "labels"), nullptr);
  EXPECT_NE(wordsOf(scene).find("too many faults"), std::string::npos);
  EXPECT_NE(wordsOf(scene).find("a verdict"), std::string::npos);
  expectAllOnPage(scene);
}

TEST(PatternCheckScene, SizesOnThePageDoNotDependOnThoseOfTheFile) {
  RepairedPattern small = faultyPattern(2);
  const Scene one = patternCheckScene(small.creases, vertexFaults(small.creases), {}, {});
  for (Vec2& v : small.creases.pattern.vertices) v = v * 1000;
  const Scene other = patternCheckScene(small.creases, vertexFaults(small.creases), {}, {});
  EXPECT_NEAR(one.width, other.width, 1e-9);
  EXPECT_NEAR(one.height, other.height, 1e-9);
}

/// A strip of unequal facets rolled the way it cannot be: three equal widths between longer ends,
/// all valleys.
FlatFolding impossibleStrip() {
  CreaseDrawing drawing;
  const Vec2 corners[] = {{0, 0}, {9, 0}, {9, 2}, {0, 2}};
  for (std::size_t i = 0; i < 4; ++i) {
    drawing.lines.push_back({corners[i], corners[(i + 1) % 4], Assignment::Border, {}});
  }
  for (const double x : {4.0, 5.0}) {
    drawing.lines.push_back({{x, 0}, {x, 2}, Assignment::Valley, {}});
  }
  const Result<FlatFolding> folded = flatFold(repaired(drawing).creases);
  EXPECT_TRUE(folded) << (folded ? "" : folded.error().message);
  return *folded;
}

TEST(OrderConflictScene, TheFacetsAreFilledAndNumberedOnBothPictures) {
  const FlatFolding folding = impossibleStrip();
  ASSERT_FALSE(folding.states.exist());
  const OrderConflict& conflict = folding.states.conflict();
  ASSERT_GE(conflict.facets.size(), 2U);
  const Scene scene = orderConflictScene(folding.creases, folding.map, conflict, {});
  EXPECT_EQ(groupOf(scene, "facets")->items.size(), conflict.facets.size());
  EXPECT_EQ(groupOf(scene, "folded-facets")->items.size(), 2 * conflict.facets.size());
  for (const char* id : {"numbers", "folded-numbers"}) {
    ASSERT_NE(groupOf(scene, id), nullptr);
    ASSERT_EQ(groupOf(scene, id)->items.size(), conflict.facets.size());
    for (std::size_t i = 0; i < conflict.facets.size(); ++i) {
      const Item& number = groupOf(scene, id)->items[i];
      EXPECT_EQ(std::get<TextItem>(number.shape).text, std::to_string(i + 1));
      EXPECT_EQ(number.data.front().second, std::to_string(conflict.facets[i].index));
    }
  }
  EXPECT_NE(wordsOf(scene).find(conflict.message.substr(0, 15)), std::string::npos);
  // The pictures stand beside each other.
  const Box paper = boxOfItem(groupOf(scene, "print")->items.front());
  for (const Item& item : groupOf(scene, "folded")->items) {
    EXPECT_GT(boxOfItem(item).low.x, paper.high.x);
  }
  expectAllOnPage(scene);
}

TEST(PageText, ParagraphsKeepAllWordsWithinTheirWidth) {
  const std::string text = "one two three four five six seven eight nine ten";
  std::string joinedUp;
  for (const std::string& line : wrapped(text, 3, 30)) {
    EXPECT_LE(widthOf(line, 3), 30);
    joinedUp += (joinedUp.empty() ? "" : " ") + line;
  }
  EXPECT_EQ(joinedUp, text);
}

}  // namespace
}  // namespace kiri
