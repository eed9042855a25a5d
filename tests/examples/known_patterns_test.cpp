// Crease patterns of traditional models against files that other people have drawn.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/file.h"
#include "tests/examples/example_models.h"

namespace kiri::test {
namespace {

/// A crease of a square sheet, in the frame of its middle, half a diagonal the unit. Mountain -1,
/// valley 1, border 0.
struct KnownCrease {
  Vec2 from;
  Vec2 to;
  int fold = 0;
};

struct KnownPattern {
  std::vector<Vec2> vertices;
  std::vector<KnownCrease> creases;
};

/// Moves and scales the square to its frame, corners on the axes.
void placeOnCorner(KnownPattern& pattern) {
  Vec2 low = pattern.vertices.front();
  Vec2 high = low;
  for (const Vec2 p : pattern.vertices) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const Vec2 middle = (low + high) / 2;
  const bool isUpright = std::any_of(pattern.vertices.begin(), pattern.vertices.end(), [&](Vec2 p) {
    return distance(p, low) < 1e-6 * distance(low, high);
  });
  const Vec2 x = isUpright ? Vec2{1, 1} / (high.x - low.x) : Vec2{2, 0} / (high.x - low.x);
  const auto place = [&](Vec2 p) {
    const Vec2 d = p - middle;
    return Vec2{dot(x, d), cross(x, d)};
  };
  for (Vec2& p : pattern.vertices) p = place(p);
  for (KnownCrease& crease : pattern.creases) {
    crease.from = place(crease.from);
    crease.to = place(crease.to);
  }
}

/// None where the data is not beside the checkout.
std::optional<KnownPattern> knownFile(const std::string& name) {
  const std::string path = KIRI_SOURCE_DIR "/../shared/data/patterns/" + name;
  if (!std::filesystem::exists(path)) return std::nullopt;
  const nlohmann::json fold = nlohmann::json::parse(*readFile(path));
  KnownPattern out;
  for (const auto& place : fold["vertices_coords"]) out.vertices.push_back({place[0], place[1]});
  for (std::size_t i = 0; i < fold["edges_vertices"].size(); ++i) {
    const auto& ends = fold["edges_vertices"][i];
    const std::string kind = fold["edges_assignment"][i];
    out.creases.push_back({out.vertices[ends[0].get<std::size_t>()],
                           out.vertices[ends[1].get<std::size_t>()],
                           kind == "M"   ? -1
                           : kind == "V" ? 1
                                         : 0});
  }
  placeOnCorner(out);
  return out;
}

KnownPattern patternFrom(const FoldedState& state) {
  KnownPattern out;
  out.vertices = state.pattern.vertices;
  for (const Edge& edge : state.pattern.edges) {
    const int fold = edge.kind != EdgeKind::Hinge ? 0 : edge.angle > 0 ? 1 : -1;
    out.creases.push_back({state.pattern[edge.from], state.pattern[edge.to], fold});
  }
  placeOnCorner(out);
  return out;
}

/// One of the eight ways in which a square lies on itself.
Vec2 turned(Vec2 p, int way) {
  if (way >= 4) p.y = -p.y;
  for (int i = 0; i < way % 4; ++i) p = {-p.y, p.x};
  return p;
}

bool areSame(Vec2 a, Vec2 b) { return distance(a, b) <= 1e-9; }

/// How many creases of `a`, turned, are creases of `b` with the same fold, or with the opposite.
std::size_t sameCreases(const KnownPattern& a, const KnownPattern& b, int way, int sign) {
  return static_cast<std::size_t>(
      std::count_if(a.creases.begin(), a.creases.end(), [&](const KnownCrease& crease) {
        const Vec2 from = turned(crease.from, way);
        const Vec2 to = turned(crease.to, way);
        return std::any_of(b.creases.begin(), b.creases.end(), [&](const KnownCrease& other) {
          const bool isHere = (areSame(from, other.from) && areSame(to, other.to)) ||
                              (areSame(from, other.to) && areSame(to, other.from));
          return isHere && crease.fold * sign == other.fold;
        });
      }));
}

/// The best of all turns, mirror images and inversions.
std::size_t mostSameCreases(const KnownPattern& a, const KnownPattern& b) {
  std::size_t most = 0;
  for (int way = 0; way < 8; ++way) {
    for (const int sign : {1, -1}) most = std::max(most, sameCreases(a, b, way, sign));
  }
  return most;
}

std::size_t mostSameVertices(const KnownPattern& a, const KnownPattern& b) {
  std::size_t most = 0;
  for (int way = 0; way < 8; ++way) {
    const auto same = std::count_if(a.vertices.begin(), a.vertices.end(), [&](Vec2 p) {
      return std::any_of(b.vertices.begin(), b.vertices.end(),
                         [&](Vec2 q) { return areSame(turned(p, way), q); });
    });
    most = std::max(most, static_cast<std::size_t>(same));
  }
  return most;
}

#define KIRI_KNOWN_OR_SKIP(name, path)                      \
  const std::optional<KnownPattern> name = knownFile(path); \
  if (!name) GTEST_SKIP() << "no collection of patterns beside the checkout"

/// But for the back layer, which the file folds behind and the model tucks in: one crease.
TEST(KnownPatterns, TheSamuraiHatIsTheKabutoOfFlatFolder) {
  KIRI_KNOWN_OR_SKIP(known, "flat-folder/original/kabuto.fold");
  const KnownPattern hat = patternFrom(exampleModel("origami_samurai_hat").last());
  EXPECT_EQ(hat.vertices.size(), known->vertices.size());
  EXPECT_EQ(hat.creases.size(), known->creases.size());
  EXPECT_EQ(mostSameVertices(hat, *known), known->vertices.size());
  EXPECT_GE(mostSameCreases(hat, *known), known->creases.size() - 1);
}

TEST(KnownPatterns, TheBirdBaseIsThatOfOriedita) {
  KIRI_KNOWN_OR_SKIP(known, "oriedita/bird_base.fold");
  const KnownPattern base = patternFrom(*exampleModel("pattern_bird_base").states.at(1));
  EXPECT_EQ(mostSameVertices(*known, base), known->vertices.size());
}

/// The angles of neck and tail are everybody's own; what lies between the wings is not.
TEST(KnownPatterns, TheMiddleOfTheCraneIsThatOfRabbitEar) {
  KIRI_KNOWN_OR_SKIP(known, "rabbit-ear/fold/crane-cp.fold");
  const KnownPattern crane = patternFrom(exampleModel("origami_crane").last());
  KnownPattern middle;
  for (const Vec2 p : known->vertices) {
    const bool isBase = areSame(p, {0, 0}) || std::abs(std::abs(p.x) - std::abs(p.y)) < 1e-9 ||
                        std::abs(p.x) + std::abs(p.y) > 1 - 1e-9;
    const bool isCorner = std::max(std::abs(p.x), std::abs(p.y)) > 1 - 1e-9;
    if (isBase && (isCorner || std::abs(p.x) + std::abs(p.y) < 0.99)) middle.vertices.push_back(p);
  }
  EXPECT_GE(middle.vertices.size(), 13u);
  EXPECT_EQ(mostSameVertices(middle, crane), middle.vertices.size());
}

TEST(KnownPatterns, AnotherPatternIsNoticed) {
  KIRI_KNOWN_OR_SKIP(known, "flat-folder/original/kabuto.fold");
  const KnownPattern cup = patternFrom(exampleModel("origami_cup").last());
  EXPECT_LT(mostSameCreases(cup, *known), known->creases.size() / 2);
}

}  // namespace
}  // namespace kiri::test
