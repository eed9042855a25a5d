// kiri measure on the command line.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apps/cli/exit_codes.h"
#include "tests/apps/cli/run_kiri.h"

namespace kiri::cli {
namespace {

constexpr const char* kKite = R"({"format": "kiri", "version": 1, "sheet": {"shape": "polygon",
  "outline": [[0, 0], [10, 20], [0, 40], [-10, 20]]}, "steps": []})";

Answer measureRun(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"measure", "-", "--petiole", "0", "0"});
  return runKiri(arguments, {kKite});
}

TEST(MeasureCommand, JsonHoldsTheMeasuresAndNamesTheConventions) {
  const Answer done = measureRun({"--json"});
  ASSERT_EQ(done.code, kDone) << done.err;
  const auto measures = nlohmann::json::parse(done.out);
  EXPECT_NEAR(measures["length"].get<double>(), 40, 1e-9);
  EXPECT_NEAR(measures["width"].get<double>(), 20, 1e-9);
  EXPECT_NEAR(measures["area"].get<double>(), 400, 1e-9);
  EXPECT_NEAR(measures["solidity"].get<double>(), 1, 1e-12);
  EXPECT_EQ(measures["lobes"], 1);
  EXPECT_EQ(measures["margin"][0]["kind"], "lobe");
  EXPECT_EQ(measures["petioleFrom"], "given");
  for (const auto& [name, value] : measures.items()) {
    const bool isMeasure = value.is_number() || name == "margin";
    EXPECT_EQ(measures["conventions"].contains(name), isMeasure) << name;
  }
  EXPECT_TRUE(contains(measures["conventions"]["solidity"], "hull"));
}

TEST(MeasureCommand, CsvHasOneMeasureARow) {
  const Answer done = measureRun({"--csv"});
  ASSERT_EQ(done.code, kDone) << done.err;
  EXPECT_EQ(done.out.substr(0, done.out.find('\n')), "measure,value,unit,angle,x,y,convention");
  EXPECT_NE(done.out.find("\nwidth,20,mm,,,,\"extent across the axis\"\n"), std::string::npos)
      << done.out;
  EXPECT_NE(done.out.find("\nlobe,40,mm,0,0,40,\"from the petiole"), std::string::npos) << done.out;
}

nlohmann::json measured(const std::vector<std::string>& arguments, const std::string& input) {
  std::vector<std::string> all = {"measure", "-", "--json"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const Answer done = runKiri(all, {input});
  EXPECT_EQ(done.code, kDone) << done.err;
  return done.code == kDone ? nlohmann::json::parse(done.out) : nlohmann::json{};
}

TEST(MeasureCommand, TakesPointsAsItTakesAModel) {
  const auto model = measured({"--petiole", "0", "0"}, kKite);
  auto points = measured({}, "x,y\n0,0\n1,2\n0,4\n-1,2\n0,0\n");
  EXPECT_EQ(points["petioleFrom"], "origin of the file");
  for (const char* name : {"length", "width", "perimeter", "major"}) {
    EXPECT_NEAR(points[name].get<double>() * 10, model[name].get<double>(), 1e-9) << name;
  }
  points = measured({"--mm-per-unit", "10"}, "0 0\n1 2\n0 4\n-1 2\n");
  EXPECT_NEAR(points["area"].get<double>(), 400, 1e-9);
}

TEST(MeasureCommand, TakesPatternsThatAreNothingButAnOutline) {
  const std::string fold = R"({"file_spec": 1.1, "vertices_coords": [[0,0],[10,20],[0,40],[-10,20]],
    "edges_vertices": [[0,1],[1,2],[2,3],[3,0]], "edges_assignment": ["B","B","B","B"],
    "file_frames": [], "frame_unit": "mm"})";
  const auto measures = measured({}, fold);
  EXPECT_NEAR(measures["area"].get<double>(), 400, 1e-6);
  const std::string svg =
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="40mm" viewBox="0 0 40 40">
    <path d="M10 0 L20 20 L10 40 L0 20 Z" fill="none" stroke="#000"/></svg>)";
  EXPECT_NEAR(measured({}, svg)["area"].get<double>(), 400, 1e-6);
}

TEST(MeasureCommand, YDownMirrorsWhatAnImageShows) {
  const std::string outline = "0 0\n10 -20\n0 -40\n-13 -20\n";
  const auto measures = measured({"--y-down", "--axis", "0"}, outline);
  EXPECT_NEAR(measures["leftWidth"].get<double>(), 13, 1e-9);
  EXPECT_NEAR(measures["length"].get<double>(), 40, 1e-9);
}

TEST(MeasureCommand, SaysWhichLineIsNoPointAndWhereAnOutlineCrossesItself) {
  const Answer bad = runKiri({"measure", "-"}, {"x,y\n0,0\n1,one\n"});
  EXPECT_EQ(bad.code, kBadModel);
  EXPECT_TRUE(contains(bad.err, "standard input line 3: \"1,one\" is no point")) << bad.err;
  const Answer crossed = runKiri({"measure", "-"}, {"0,0\n10,10\n10,0\n0,10\n"});
  EXPECT_EQ(crossed.code, kBadModel);
  EXPECT_TRUE(contains(crossed.err, "(5, 5)")) << crossed.err;
  EXPECT_EQ(runKiri({"measure", "-", "--mm-per-unit", "0"}, {"0 0\n1 0\n0 1"}).code, kBadUsage);
}

TEST(MeasureCommand, JsonAndCsvDoNotGoTogether) {
  EXPECT_EQ(measureRun({"--json", "--csv"}).code, kBadUsage);
}

}  // namespace
}  // namespace kiri::cli
