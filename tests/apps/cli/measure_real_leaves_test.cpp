// kiri measure against what others measured on real leaves.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "apps/cli/exit_codes.h"
#include "tests/apps/cli/run_kiri.h"

namespace kiri::cli {
namespace {

namespace fs = std::filesystem;

const std::string kLeaves = KIRI_SOURCE_DIR "/../shared/data/leaves/";

using Row = std::map<std::string, std::string>;

/// The rows of a table by the names of its columns.
std::vector<Row> rowsOf(const std::string& path) {
  std::ifstream in(path);
  std::vector<std::string> names;
  std::vector<Row> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream fields(line);
    std::vector<std::string> values;
    for (std::string value; std::getline(fields, value, ',');) values.push_back(value);
    if (names.empty()) {
      names = values;
      continue;
    }
    Row& row = rows.emplace_back();
    for (std::size_t i = 0; i < names.size() && i < values.size(); ++i) row[names[i]] = values[i];
  }
  return rows;
}

nlohmann::json measuresOfFile(const std::string& path, std::vector<std::string> more) {
  more.insert(more.begin(), {"measure", path, "--json", "--axis", "0"});
  const Answer done = runKiri(more);
  EXPECT_EQ(done.code, kDone) << done.err;
  return done.code == kDone ? nlohmann::json::parse(done.out) : nlohmann::json{};
}

/// Outlines of the Kew leaves by their number.
std::map<std::string, std::string> kewOutlines() {
  std::map<std::string, std::string> found;
  for (const auto& entry : fs::directory_iterator(kLeaves + "kew100")) {
    const std::string name = entry.path().stem().string();
    const std::string digits = name.substr(name.size() - std::min<std::size_t>(4, name.size()));
    if (!std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; })) {
      continue;
    }
    found[std::to_string(std::stoi(digits))] = entry.path().string();
  }
  return found;
}

/// Their unit is the mid-lobe, and they are rounded to three or four digits; lobes were counted
/// with a prominence of 6 to 8 %.
TEST(MeasureOfRealLeaves, AgreesWithTheTableOfTheKewLeaves) {
  if (!fs::exists(kLeaves + "kew100")) GTEST_SKIP() << "no leaves beside the checkout";
  const auto outlines = kewOutlines();
  int leaves = 0;
  int sameLobes = 0;
  for (const Row& row : rowsOf(kLeaves + "kew100/metrics.csv")) {
    const auto outline = outlines.find(row.at("kew_id"));
    if (outline == outlines.end()) continue;
    ++leaves;
    const auto m = measuresOfFile(outline->second, {"--prominence", "0.06"});
    const auto expectNear = [&](const char* name, const char* column, double within) {
      EXPECT_NEAR(m[name].get<double>(), std::stod(row.at(column)), within)
          << outline->second << " " << name;
    };
    expectNear("area", "area_over_midlobe2", 1e-4);
    expectNear("perimeter", "perimeter_over_midlobe", 1e-4);
    expectNear("fullAspectRatio", "aspect_L_over_W", 6e-4);
    expectNear("circularity", "circularity", 6e-4);
    expectNear("solidity", "solidity", 6e-4);
    EXPECT_NEAR(m["length"].get<double>(), 1, 0.02) << outline->second;
    sameLobes += m["lobes"] == std::stoi(row.at("n_lobes")) ? 1 : 0;
  }
  EXPECT_GE(leaves, 40);
  EXPECT_GE(sameLobes, leaves * 9 / 10);
}

/// Landmarks of the Kew leaves count angles counter-clockwise and were found on another trace.
TEST(MeasureOfRealLeaves, FindsTheLandmarksOfTheKewLeaves) {
  if (!fs::exists(kLeaves + "kew100")) GTEST_SKIP() << "no leaves beside the checkout";
  std::map<std::string, std::vector<Row>> landmarks;
  for (const Row& row : rowsOf(kLeaves + "kew100/landmarks.csv")) {
    landmarks[row.at("file")].push_back(row);
  }
  std::vector<double> off;
  for (const auto& [id, path] : kewOutlines()) {
    const auto m = measuresOfFile(path, {});
    for (const Row& row : landmarks[fs::path(path).filename().string()]) {
      const double angle = -std::stod(row.at("angle_deg_from_midlobe(ccw+)"));
      const double radius = std::stod(row.at("radius_over_midlobe"));
      double best = HUGE_VAL;
      for (const auto& point : m["margin"]) {
        if ((point["kind"] == "sinus") != (row.at("kind") == "sinus")) continue;
        best = std::min(best, std::hypot(point["angle"].get<double>() - angle,
                                         100 * (point["length"].get<double>() - radius)));
      }
      off.push_back(best);
    }
  }
  ASSERT_GT(off.size(), 300u);
  std::sort(off.begin(), off.end());
  EXPECT_LT(off[off.size() / 2], 0.5);  // degrees, or hundredths of the mid-lobe
  EXPECT_LT(off.back(), 2);
}

/// The half leaf of a Syrah, whose lobes do not overlap, in cm; veins were traced apart from the
/// margin.
TEST(MeasureOfRealLeaves, AgreesWithTheVinesTable) {
  const std::string path = kLeaves + "grape/Syrah_L0849A1_margin.csv";
  if (!fs::exists(path)) GTEST_SKIP() << "no leaves beside the checkout";
  const auto m = measuresOfFile(path, {"--mm-per-unit", "10", "--petiole", "0", "0"});
  const std::vector<Row> table = rowsOf(kLeaves + "grape/grape_vein_table.csv");
  const auto row = std::find_if(table.begin(), table.end(),
                                [](const Row& r) { return r.at("leaf") == "L0849A1"; });
  ASSERT_NE(row, table.end());
  const double length = m["length"].get<double>();
  EXPECT_NEAR(length, 10 * std::stod(row->at("midvein_cm")), 0.5);
  const auto expectPoint = [&](const std::string& kind, const std::string& angle,
                               const std::string& ratio) {
    const bool isThere = std::any_of(m["margin"].begin(), m["margin"].end(), [&](const auto& p) {
      return p["kind"] == kind &&
             std::abs(p["angle"].template get<double>() - std::stod(row->at(angle))) < 0.5 &&
             std::abs(p["length"].template get<double>() / length - std::stod(row->at(ratio))) <
                 0.005;
    });
    EXPECT_TRUE(isThere) << kind << " at " << row->at(angle) << " degrees";
  };
  expectPoint("lobe", "distal_tip_angle_deg", "distal_len_ratio");
  expectPoint("lobe", "proximal_tip_angle_deg", "proximal_len_ratio");
  expectPoint("sinus", "upper_sinus_angle_deg", "upper_sinus_ratio");
  expectPoint("sinus", "lower_sinus_angle_deg", "lower_sinus_ratio");
}

}  // namespace
}  // namespace kiri::cli
