// kiri convert, and crease patterns where a command takes a model.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "apps/cli/exit_codes.h"
#include "io/patterns/pattern_file.h"
#include "tests/apps/cli/pattern_cli.h"
#include "tests/apps/cli/run_kiri.h"

namespace kiri::cli {
namespace {

using nlohmann::json;

using ConvertCommand = KiriFolder;

const std::vector<std::string> kPatternEndings = {"fold", "cp", "opx", "svg", "dxf"};

CreaseDrawing drawingIn(const std::string& text, const std::string& name) {
  const Result<PatternFile> file = readPattern(text, name);
  EXPECT_TRUE(file.isOk()) << name << ": " << (file.isOk() ? "" : file.error().message);
  return file.isOk() ? file->drawing : CreaseDrawing{};
}

using PlainLine = std::tuple<double, double, double, double, Assignment>;

/// The lines in an order of their own: SVG has them by colour.
std::vector<PlainLine> linesOf(const CreaseDrawing& drawing) {
  std::vector<PlainLine> out;
  for (const DrawnCrease& line : drawing.lines)
    out.emplace_back(line.from.x, line.from.y, line.to.x, line.to.y, line.assignment);
  std::sort(out.begin(), out.end());
  return out;
}

TEST_F(ConvertCommand, KeepsEveryLineBitByBitBetweenPatternFormats) {
  // Lines with coordinates that have no short decimals, unrepaired crossings and repeats.
  const std::string odd = starAsCp(7) + "2 -13.1 1.7000000000000001 3.3333333333333335 -50\n" +
                          "2 0 0 0 -50\n3 -40 -40 40 40\n";
  const std::string first = put("a.cp", odd);
  const auto lines = linesOf(drawingIn(odd, "a.cp"));
  ASSERT_EQ(lines.size(), 11u);
  for (const std::string& ending : kPatternEndings) {
    ASSERT_EQ(runKiri({"convert", first, path("b." + ending)}).code, kDone) << ending;
    EXPECT_TRUE(linesOf(drawingIn(get("b." + ending), "b." + ending)) == lines) << ending;
    for (const std::string& next : kPatternEndings) {
      const std::string name = "c_" + ending + "." + next;
      ASSERT_EQ(runKiri({"convert", path("b." + ending), path(name)}).code, kDone) << name;
      EXPECT_TRUE(linesOf(drawingIn(get(name), name)) == lines) << name;
    }
  }
}

TEST_F(ConvertCommand, SaysWhatAFormatCannotHold) {
  const std::string file = put("map.fold", mapAsFold("U"));
  ASSERT_EQ(runKiri({"states", file, "-o", path("folded.fold")}).code, kDone);
  const Answer answer = runKiri({"convert", path("folded.fold"), path("o.cp")});
  EXPECT_EQ(answer.code, kDone);
  EXPECT_TRUE(contains(answer.err, "note: ") && contains(answer.err, "layer orders")) << answer.err;
}

TEST_F(ConvertCommand, MakesModelsThatAreFoldedOrFlat) {
  const std::string file = put("map.fold", mapAsFold("U"));
  ASSERT_EQ(runKiri({"convert", file, path("m.kiri")}).code, kDone);
  json facts = json::parse(runKiri({"info", path("m.kiri"), "--json"}).out);
  EXPECT_EQ(facts["facets"], 6);
  EXPECT_EQ(facts["layers"], 6);
  EXPECT_EQ(facts["paper_box_mm"]["high"], json({60, 60})) << "the file says mm";
  ASSERT_EQ(runKiri({"convert", file, path("f.kiri"), "--flat", "--size", "90"}).code, kDone);
  facts = json::parse(runKiri({"info", path("f.kiri"), "--json"}).out);
  EXPECT_EQ(facts["layers"], 1);
  EXPECT_EQ(facts["hinges"], 7);
  EXPECT_EQ(facts["paper_box_mm"]["high"], json({90, 90}));
}

/// Pairs of faces with the side on which they lie, from the frame of a folded state.
std::vector<std::vector<int>> ordersIn(const std::string& fold, const std::string& key) {
  const json file = json::parse(fold);
  const json& frame = key.empty() ? file : file[key][0];
  return frame["faceOrders"].get<std::vector<std::vector<int>>>();
}

TEST_F(ConvertCommand, FoldsTheStateThatWasAskedFor) {
  const std::string file = put("map.fold", mapAsFold("U"));
  for (const std::string number : {"0", "1", "33", "59"}) {
    ASSERT_EQ(runKiri({"states", file, "--state", number, "-o", path("s.fold")}).code, kDone);
    ASSERT_EQ(runKiri({"convert", file, path("m.kiri"), "--state", number}).code, kDone);
    const std::string count = runKiri({"states", path("m.kiri"), "--count"}).out;
    EXPECT_GE(std::stoi(count), 1) << "the creases have the directions of the state";
    ASSERT_EQ(runKiri({"convert", path("m.kiri"), path("m.fold")}).code, kDone);
    EXPECT_EQ(ordersIn(get("m.fold"), "").size(), 15u);
    const json model = json::parse(get("m.fold"));
    const json state = json::parse(get("s.fold"))["file_frames"][0];
    std::size_t valleys = 0;
    std::size_t wanted = 0;
    for (const json& letter : model["edges_assignment"]) valleys += letter == "V" ? 1U : 0U;
    for (const json& letter : state["edges_assignment"]) wanted += letter == "V" ? 1U : 0U;
    EXPECT_EQ(valleys, wanted) << number;
  }
  const Answer beyond = runKiri({"convert", file, path("n.kiri"), "--state", "60"});
  EXPECT_EQ(beyond.code, kBadModel);
  EXPECT_TRUE(contains(beyond.err, "60")) << beyond.err;
}

TEST_F(ConvertCommand, TakesModelsToPatternsAndBack) {
  const std::string file = put("map.fold", mapAsFold("U"));
  ASSERT_EQ(runKiri({"convert", file, path("m.kiri")}).code, kDone);
  const std::string count = runKiri({"states", path("m.kiri"), "--count"}).out;
  for (const std::string& ending : kPatternEndings) {
    const std::string name = path("p." + ending);
    ASSERT_EQ(runKiri({"convert", path("m.kiri"), name}).code, kDone) << ending;
    EXPECT_EQ(runKiri({"states", name, "--count"}).out, count) << ending;
    ASSERT_EQ(runKiri({"convert", name, path("again.kiri")}).code, kDone) << ending;
    const json facts = json::parse(runKiri({"info", path("again.kiri"), "--json"}).out);
    EXPECT_EQ(facts["layers"], 6);
    EXPECT_NEAR(facts["area_mm2"].get<double>(), 3600, 1e-9);
  }
}

TEST_F(ConvertCommand, WorksInPipes) {
  const Answer cp = runKiri({"convert", "-", "-", "--format", "cp"}, {mapAsFold("M")});
  EXPECT_EQ(cp.code, kDone) << cp.err;
  EXPECT_EQ(drawingIn(cp.out, "o.cp").lines.size(), 17u);
  const Answer kiri = runKiri({"convert", "-", "-", "--format", "kiri"}, {starAsCp(0)});
  EXPECT_EQ(json::parse(kiri.out)["format"], "kiri") << kiri.err;
  EXPECT_EQ(json::parse(runKiri({"info", "-", "--json"}, {kiri.out}).out)["layers"], 4);
}

TEST_F(ConvertCommand, SaysWhatIsWrong) {
  const std::string file = put("map.fold", mapAsFold("U"));
  const std::string model = path("m.kiri");
  ASSERT_EQ(runKiri({"convert", file, model}).code, kDone);
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"convert", file}, "B is required"},
      {{"convert", file, path("o.gif")}, "this command writes .fold, .cp, .opx"},
      {{"convert", file, "-"}, "add --format fold"},
      {{"convert", file, path("o.cp"), "--size", "10"}, "nothing is moved"},
      {{"convert", file, path("o.kiri"), "--size", "-1"}, "--size must be above 0"},
      {{"convert", file, path("o.kiri"), "--state", "x"}, "--state x is no number"},
      {{"convert", file, path("o.kiri"), "--flat", "--state", "1"}, "--flat folds nothing"},
      {{"convert", model, path("o.cp"), "--flat"}, "is a model already"},
  };
  for (const auto& [arguments, sentence] : cases) {
    const Answer answer = runKiri(arguments);
    EXPECT_EQ(answer.code, kBadUsage) << sentence;
    EXPECT_TRUE(contains(answer.err, sentence)) << answer.err << "should say: " << sentence;
  }
  EXPECT_EQ(runKiri({"convert", put("bad.cp", "nothing"), path("o.fold")}).code, kBadModel);
  EXPECT_EQ(runKiri({"convert", path("none.cp"), path("o.fold")}).code, kBadModel);
  EXPECT_EQ(runKiri({"convert", file, path("none/o.cp")}).code, kCannotWrite);
  EXPECT_EQ(runKiri({"convert", file, path("o.kiri")}, {"", false, 0}).code, kCancelled);
  EXPECT_EQ(fileCount(), 3u);
}

TEST_F(ConvertCommand, OtherCommandsTakePatternsAsModels) {
  const std::string file = put("map.cp", starAsCp(0));
  const json facts = json::parse(runKiri({"info", file, "--json"}).out);
  EXPECT_EQ(facts["layers"], 4);
  EXPECT_EQ(facts["steps"], 1);
  EXPECT_EQ(json::parse(runKiri({"steps", file, "--json"}).out)["steps"][0]["do"], "pattern");
  const std::vector<std::vector<std::string>> commands = {
      {"render", file, "-o", path("o.svg")},
      {"sheet", file, "-o", path("s.svg")},
      {"export", file, "-o", path("o.glb")},
      {"resolve", file, "-o", path("r.kiri")},
      {"animate", file, "-o", path("f_%d.png"), "--size", "64x48", "--fps", "2"},
  };
  for (const std::vector<std::string>& command : commands) {
    const Answer answer = runKiri(command);
    EXPECT_EQ(answer.code, kDone) << command[0] << answer.err;
  }
  EXPECT_GT(fileCount(), 6u);
}

}  // namespace
}  // namespace kiri::cli
