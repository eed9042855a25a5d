// Folded states as FOLD files: what other programs find in them.
// SPDX-License-Identifier: MIT
#include "io/patterns/states_fold.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/creases/repair.h"

namespace kiri {
namespace {

using nlohmann::json;

struct SolvedPattern {
  AssignedPattern creases;
  FlatMap map;
  LayerStates states;
};

SolvedPattern solved(const std::vector<DrawnCrease>& lines) {
  CreaseDrawing drawing;
  drawing.lines = lines;
  Result<RepairedPattern> repaired = patternOf(drawing);
  EXPECT_TRUE(repaired.isOk()) << (repaired.isOk() ? "" : repaired.error().message);
  Result<FlatMap> map = flatMapOf(repaired->creases);
  EXPECT_TRUE(map.isOk());
  Result<GroundAndOrders> ground = overlapsOf(repaired->creases, *map);
  EXPECT_TRUE(ground.isOk());
  Result<LayerStates> states = LayerStates::find(ground->problem);
  EXPECT_TRUE(states.isOk() && states->exist());
  EXPECT_TRUE(states->count().isOk());
  return {std::move(repaired->creases), std::move(*map), std::move(*states)};
}

json written(const SolvedPattern& one, const std::vector<StateFrame>& frames,
             const StatesFoldOptions& options = {}) {
  return json::parse(writeStates(one.creases, one.map, one.states.problem(), frames, options).text);
}

std::vector<StateFrame> allStates(const SolvedPattern& one) {
  std::vector<StateFrame> frames;
  for (StateCount i = 0; i < one.states.total(); ++i)
    frames.push_back({"state " + i.str(), *one.states.state(i)});
  return frames;
}

constexpr Assignment kB = Assignment::Border;
constexpr Assignment kM = Assignment::Mountain;
constexpr Assignment kV = Assignment::Valley;
constexpr Assignment kU = Assignment::Unassigned;

std::vector<DrawnCrease> square(double side) {
  const Vec2 a{0, 0};
  const Vec2 b{side, 0};
  const Vec2 c{side, side};
  const Vec2 d{0, side};
  return {{a, b, kB, {}}, {b, c, kB, {}}, {c, d, kB, {}}, {d, a, kB, {}}};
}

std::vector<DrawnCrease> with(std::vector<DrawnCrease> lines,
                              const std::vector<DrawnCrease>& more) {
  lines.insert(lines.end(), more.begin(), more.end());
  return lines;
}

/// A map of three by two, its creases as given or unassigned.
std::vector<DrawnCrease> mapOfSix(Assignment across, Assignment along) {
  return with(square(60), {{{20, 0}, {20, 60}, across, {}},
                           {{40, 0}, {40, 60}, across, {}},
                           {{0, 30}, {60, 30}, along, {}}});
}

/// The two faces of an edge that folds.
std::map<std::pair<int, int>, std::string> hinges(const json& file, const json& frame) {
  std::map<std::pair<int, int>, std::string> out;
  for (std::size_t e = 0; e < file["edges_faces"].size(); ++e) {
    const json& faces = file["edges_faces"][e];
    const std::string letter = frame["edges_assignment"][e];
    if (faces[0].is_null() || faces[1].is_null() || letter == "F") continue;
    out[std::minmax(faces[0].get<int>(), faces[1].get<int>())] = letter;
  }
  return out;
}

TEST(StatesFold, ValleysBringFrontsTogetherInEveryState) {
  const SolvedPattern one = solved(mapOfSix(kU, kU));
  const json file = written(one, allStates(one));
  ASSERT_EQ(file["file_frames"].size(), 60u) << "a map of 2 x 3 has 60 states";
  for (const json& frame : file["file_frames"]) {
    const auto sides = hinges(file, frame);
    std::size_t seen = 0;
    for (const json& order : frame["faceOrders"]) {
      const auto hinge = sides.find(std::minmax(order[0].get<int>(), order[1].get<int>()));
      if (hinge == sides.end()) continue;
      EXPECT_EQ(order[2], hinge->second == "V" ? 1 : -1);
      ++seen;
    }
    EXPECT_EQ(seen, 7u);
    EXPECT_EQ(frame["faceOrders"].size(), 15u) << "all six lie on each other";
  }
}

TEST(StatesFold, StatesDifferAndInheritThePattern) {
  const SolvedPattern one = solved(mapOfSix(kU, kU));
  const json file = written(one, allStates(one));
  std::set<std::string> orders;
  for (const json& frame : file["file_frames"]) {
    EXPECT_EQ(frame["frame_inherit"], true);
    EXPECT_EQ(frame["frame_parent"], 0);
    EXPECT_EQ(frame["vertices_coords"].size(), file["vertices_coords"].size());
    for (const json& p : frame["vertices_coords"]) {
      EXPECT_LE(std::abs(p[0].get<double>() - 30), 30);
    }
    for (const json& letter : frame["edges_assignment"]) EXPECT_NE(letter, "U");
    orders.insert(frame["faceOrders"].dump());
  }
  EXPECT_EQ(orders.size(), 60u);
  const json& letters = file["edges_assignment"];
  EXPECT_EQ(std::count(letters.begin(), letters.end(), "U"), 7) << "the pattern keeps what it says";
}

TEST(StatesFold, OrdersLeftOutFollowFromThoseThatAreThere) {
  const SolvedPattern one = solved(mapOfSix(kU, kU));
  StatesFoldOptions few;
  few.mostOrders = 0;
  const json reduced = written(one, allStates(one), few);
  const json all = written(one, allStates(one));
  for (std::size_t s = 0; s < 60; ++s) {
    const json& frame = reduced["file_frames"][s];
    EXPECT_TRUE(frame.contains("kiri:faceOrders"));
    EXPECT_EQ(frame["faceOrders"].size(), 5u);
    // Facets alternate as on a chess board, so the sign says above or below but for the facet's
    // side.
    std::vector<std::vector<bool>> above(6, std::vector<bool>(6, false));
    const auto add = [&](const json& order) {
      const std::size_t f = order[0];
      const std::size_t g = order[1];
      const bool isUp = (order[2] == 1) != one.map.poses[g].isFlipped;
      above[isUp ? f : g][isUp ? g : f] = true;
    };
    for (const json& order : frame["faceOrders"]) add(order);
    for (std::size_t k = 0; k < 6; ++k)
      for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j)
          if (above[i][k] && above[k][j]) above[i][j] = true;
    const auto reached = above;
    for (const json& order : all["file_frames"][s]["faceOrders"]) add(order);
    EXPECT_EQ(above, reached);
  }
}

TEST(StatesFold, SidesOfASlitThatLieApartHaveVerticesOfTheirOwn) {
  // The lower right quarter is folded up; a slit sets it free from the lower left one.
  const SolvedPattern one = solved(
      with(square(100), {{{50, 0}, {50, 50}, Assignment::Cut, {}}, {{50, 50}, {100, 50}, kV, {}}}));
  const json file = written(one, {{"folded", one.states.first()}});
  EXPECT_EQ(file["vertices_coords"].size(), 7u);
  const json& frame = file["file_frames"][0];
  EXPECT_EQ(frame["frame_inherit"], false);
  ASSERT_EQ(frame["vertices_coords"].size(), 8u);
  EXPECT_EQ(frame["edges_vertices"].size(), file["edges_vertices"].size() + 1);
  std::set<std::pair<double, double>> places;
  for (std::size_t v = 0; v < 8; ++v) {
    if (frame["vertices_kiri:paper"][v] != json({50, 0})) continue;
    const json& at = frame["vertices_coords"][v];
    places.insert({at[0].get<double>(), at[1].get<double>()});
  }
  EXPECT_EQ(places, (std::set<std::pair<double, double>>{{50, 0}, {50, 100}}));
  // Every side of every face is an edge, and knows the face.
  for (std::size_t f = 0; f < frame["faces_vertices"].size(); ++f) {
    const json& loop = frame["faces_vertices"][f];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t e = frame["faces_edges"][f][i];
      const std::set<int> ends{loop[i].get<int>(), loop[(i + 1) % loop.size()].get<int>()};
      EXPECT_EQ(ends,
                (std::set<int>{frame["edges_vertices"][e][0], frame["edges_vertices"][e][1]}));
      const json& faces = frame["edges_faces"][e];
      EXPECT_TRUE(faces[0] == f || faces[1] == f);
    }
  }
}

TEST(StatesFold, HolesAreReachedByJoins) {
  const std::vector<DrawnCrease> hole = {{{20, 20}, {20, 40}, kB, {}},
                                         {{20, 40}, {40, 40}, kB, {}},
                                         {{40, 40}, {40, 20}, kB, {}},
                                         {{40, 20}, {20, 20}, kB, {}}};
  const SolvedPattern one = solved(with(with(square(100), hole), {{{70, 0}, {70, 100}, kM, {}}}));
  const WrittenPattern text =
      writeStates(one.creases, one.map, one.states.problem(), {{"folded", one.states.first()}}, {});
  ASSERT_EQ(text.losses.size(), 1u);
  const json file = json::parse(text.text);
  std::size_t joins = 0;
  for (const json& letter : file["edges_assignment"]) joins += letter == "J" ? 1U : 0U;
  EXPECT_EQ(joins, 1u);
  double area = 0;
  for (const json& loop : file["faces_vertices"]) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const json& p = file["vertices_coords"][loop[i].get<std::size_t>()];
      const json& q = file["vertices_coords"][loop[(i + 1) % loop.size()].get<std::size_t>()];
      area +=
          (p[0].get<double>() * q[1].get<double>() - p[1].get<double>() * q[0].get<double>()) / 2;
    }
  }
  EXPECT_DOUBLE_EQ(area, 100 * 100 - 20 * 20);
}

}  // namespace
}  // namespace kiri
