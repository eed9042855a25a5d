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
  EXPECT_NE(measures["conventions"].get<std::string>().find("hull"), std::string::npos);
}

TEST(MeasureCommand, CsvHasOneMeasureARow) {
  const Answer done = measureRun({"--csv"});
  ASSERT_EQ(done.code, kDone) << done.err;
  EXPECT_EQ(done.out.substr(0, done.out.find('\n')), "measure,value,unit,angle,x,y");
  EXPECT_NE(done.out.find("\nwidth,20,mm,,,\n"), std::string::npos) << done.out;
  EXPECT_NE(done.out.find("\nlobe,40,mm,0,0,40\n"), std::string::npos) << done.out;
}

TEST(MeasureCommand, JsonAndCsvDoNotGoTogether) {
  EXPECT_EQ(measureRun({"--json", "--csv"}).code, kBadUsage);
}

}  // namespace
}  // namespace kiri::cli
