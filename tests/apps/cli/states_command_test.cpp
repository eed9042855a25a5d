// kiri check and kiri states as a person or a script meets them.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/cli/exit_codes.h"
#include "tests/apps/cli/pattern_cli.h"
#include "tests/apps/cli/run_kiri.h"

namespace kiri::cli {
namespace {

using nlohmann::json;

using CheckCommand = KiriFolder;
using StatesCommand = KiriFolder;

TEST_F(CheckCommand, SaysThatAGoodPatternFolds) {
  const std::string file = put("good.cp", starAsCp(0));
  const Answer answer = runKiri({"check", file, "--exit-code"});
  EXPECT_EQ(answer.code, kDone) << answer.err;
  EXPECT_TRUE(contains(answer.out, "CP, 4 facets, 4 creases (3 mountain, 1 valley)\n"));
  EXPECT_TRUE(contains(answer.out, "\nfolds flat around every vertex\ncloses as a whole"))
      << answer.out;
}

TEST_F(CheckCommand, NamesVertexRuleAndAmountOfEveryFault) {
  const std::string file = put("bad.cp", starAsCp(7));
  const Answer answer = runKiri({"check", file});
  EXPECT_EQ(answer.code, kDone) << "it could be judged";
  EXPECT_TRUE(contains(answer.out, "\n1 vertex does not fold flat\n")) << answer.out;
  EXPECT_TRUE(contains(answer.out, "does not close as a whole: ")) << answer.out;
  EXPECT_EQ(runKiri({"check", file, "--exit-code"}).code, kVerdictNo);
  const json report = json::parse(runKiri({"check", file, "--json"}).out);
  EXPECT_EQ(report["locally_flat_foldable"], false);
  EXPECT_EQ(report["closes"], false);
  EXPECT_EQ(report["closing_error"], nullptr);
  EXPECT_EQ(report["faulty_vertices"], 1);
  ASSERT_GE(report["faults"].size(), 1u);
  EXPECT_EQ(report["faults"][0]["rule"], "kawasaki");
  EXPECT_EQ(report["faults"][0]["place"], json({0, 0}));
  EXPECT_NEAR(report["faults"][0]["amount"].get<double>(), 7, 1e-9);
}

/// A sheet with a cross of four valleys, each meant for these degrees.
std::string crossOfValleys(const std::string& degrees) {
  std::string creases;
  for (const std::string ends : {"0, 1", "1, 2", "3, 1", "1, 4"})
    creases += (creases.empty() ? "[" : ", [") + ends + ", \"V\", " + degrees + "]";
  return R"({"format": "kiri", "version": 1, "sheet": {"shape": "square", "side": 100},
             "steps": [{"do": "pattern", "vertices": [[50, 0], [50, 50], [50, 100], [0, 50],
                        [100, 50]], "creases": [)" +
         creases + "]}]}";
}

TEST_F(CheckCommand, DoesNotJudgeVerticesThatAreMeantToStandInSpace) {
  const std::string flat = put("flat.kiri", crossOfValleys("180"));
  EXPECT_TRUE(contains(runKiri({"check", flat}).out, "they must differ by two"));
  const std::string box = put("box.kiri", crossOfValleys("90"));
  const Answer answer = runKiri({"check", box});
  EXPECT_FALSE(contains(answer.out, "must differ")) << answer.out;
  EXPECT_TRUE(contains(answer.out,
                       "\nfolds flat around every vertex but 1 that stands in space, with creases "
                       "at other angles than 180 degrees\n"))
      << answer.out;
  EXPECT_TRUE(contains(answer.err, "4 creases have angles other than 180 degrees")) << answer.err;
  EXPECT_EQ(runKiri({"check", box, "--exit-code"}).code, kVerdictNo);
  const json report = json::parse(runKiri({"check", box, "--json"}).out);
  EXPECT_EQ(report["faulty_vertices"], 0);
  EXPECT_EQ(report["standing_vertices"], 1);
  EXPECT_EQ(report["locally_flat_foldable"], false);
}

TEST_F(CheckCommand, DrawsTheFaults) {
  const std::string file = put("bad.cp", starAsCp(7));
  for (const std::string ending : {"svg", "png", "pdf"}) {
    const Answer answer = runKiri({"check", file, "-o", path("o." + ending)});
    EXPECT_EQ(answer.code, kDone) << answer.err;
    EXPECT_TRUE(contains(answer.out, "1 vertex does not fold flat"));
    EXPECT_GT(get("o." + ending).size(), 1000u);
  }
  EXPECT_TRUE(contains(get("o.svg"), "Kawasaki 7"));
  EXPECT_TRUE(contains(runKiri({"check", file, "-o", "-", "--format", "svg"}).out, "</svg>"));
  EXPECT_EQ(runKiri({"check", file, "-o", path("o.gif")}).code, kBadUsage);
  EXPECT_EQ(runKiri({"check", file, "-o", "-", "--format", "svg", "--json"}).code, kBadUsage);
  EXPECT_EQ(runKiri({"check", file, "-o", path("n.svg")}, {"", false, 0}).code, kCancelled);
  EXPECT_EQ(fileCount(), 4u);
}

TEST_F(CheckCommand, CountsWhatItRepaired) {
  const std::string file = put("twice.cp", starAsCp(0) + "2 0 0 0 -50\n2 5 5 5 5\n");
  const Answer answer = runKiri({"check", file, "--json"});
  const json repairs = json::parse(answer.out)["repairs"];
  std::map<std::string, int> kinds;
  for (const json& repair : repairs) {
    kinds[repair["kind"]] = repair["count"];
    EXPECT_TRUE(contains(answer.err, "note: " + repair["message"].get<std::string>() + "\n"));
  }
  EXPECT_EQ(kinds, (std::map<std::string, int>{{"split_crossings", 4},  // creases end on the border
                                               {"dropped_duplicates", 1},
                                               {"dropped_points", 1}}));
}

TEST_F(CheckCommand, ReadsModelsAndPipes) {
  const std::string model =
      R"({"format": "kiri", "version": 1, "sheet": {"shape": "square", "side": 100}, "steps": [
          {"do": "fold", "name": "half", "line": {"paper": [[50, 0], [50, 100]]},
           "type": "valley", "move": "left"}, {"do": "unfold"}]})";
  for (const std::string name : {"m.kiri", "-"}) {
    if (name != "-") put(name, model);
    const Answer answer = runKiri({"check", name == "-" ? name : path(name), "--json"}, {model});
    ASSERT_EQ(answer.code, kDone) << answer.err;
    const json report = json::parse(answer.out);
    EXPECT_EQ(report["format"], "model");
    EXPECT_EQ(report["creases"]["valley"], 1) << "unfolded creases count as folded";
  }
  EXPECT_EQ(json::parse(runKiri({"check", "-", "--json"}, {starAsCp(0)}).out)["format"], "CP");
  EXPECT_EQ(json::parse(runKiri({"check", "-", "--json"}, {mapAsFold("U")}).out)["format"], "FOLD");
}

/// A paper hat with its brim in front: the crease "middle" only shows where the corners go.
std::string hatAsModel(const std::string& last) {
  return R"({"format": "kiri", "version": 1,
      "sheet": {"shape": "rectangle", "width": 80, "height": 140}, "steps": [
      {"do": "fold", "name": "half", "line": {"model": [[-5, 70], [85, 70]]}, "type": "valley",
       "move": {"point": [40, 120]}},
      {"do": "fold", "name": "middle", "line": {"model": [[40, -5], [40, 75]]}, "type": "valley",
       "move": {"point": [10, 25]}},
      {"do": "unfold", "folds": ["middle"]},
      {"do": "fold", "name": "left", "line": {"model": [[40, 70], [0, 30]]}, "type": "valley",
       "move": {"point": [5, 65]}},
      {"do": "fold", "name": "right", "line": {"model": [[40, 70], [80, 30]]}, "type": "valley",
       "move": {"point": [75, 65]}},
      {"do": "fold", "name": "brim", "line": {"model": [[-5, 30], [85, 30]]}, "type": "valley",
       "layers": {"facets": [{"paper": [20, 137]}, {"paper": [60, 137]}]},
       "move": {"point": [40, 10]}})" +
         last + "]}";
}

TEST_F(CheckCommand, TakesTheCreasesAsTheyAreWhereTheModelIsFolded) {
  for (const char* last : {"", R"(, {"do": "unfold"})",
                           R"(, {"do": "unfold"}, {"do": "angle", "fold": "half", "angle": 20})"}) {
    const Answer answer = runKiri({"check", "-", "--json"}, {hatAsModel(last)});
    ASSERT_EQ(answer.code, kDone) << answer.err;
    const json report = json::parse(answer.out);
    EXPECT_EQ(report["verdict"], "folds flat around every vertex") << last;
    EXPECT_EQ(report["creases"]["flat"], 3) << "the middle" << last;
    EXPECT_EQ(report["closes"], true) << last;
  }
}

TEST_F(StatesCommand, CountsAllStatesOfAMap) {
  const std::string file = put("map.fold", mapAsFold("U"));
  EXPECT_EQ(runKiri({"states", file, "--count"}).out, "60\n");
  const Answer answer = runKiri({"states", file});
  EXPECT_EQ(answer.code, kDone) << answer.err;
  EXPECT_TRUE(contains(answer.out, "\n60 folded states\n")) << answer.out;
  const json report = json::parse(runKiri({"states", file, "--json"}).out);
  EXPECT_EQ(report["faces"], 6);
  EXPECT_EQ(report["locally_flat_foldable"], true);
  EXPECT_EQ(report["states"], "60");
  EXPECT_EQ(report["pairs"], 15);
  EXPECT_GE(report["components"], 1);
  EXPECT_GT(report["seconds"], 0);
  EXPECT_EQ(report["component_list"].size(), report["components"]);
}

TEST_F(StatesCommand, EveryNumberIsAnotherState) {
  const std::string file = put("map.fold", mapAsFold("U"));
  ASSERT_EQ(runKiri({"states", file, "--all", "-o", path("all.fold")}).code, kDone);
  const json all = json::parse(get("all.fold"));
  ASSERT_EQ(all["file_frames"].size(), 60u);
  for (const std::string number : {"0", "17", "59", "007"}) {
    const Answer answer = runKiri({"states", file, "--state", number, "-o", path("o.fold")});
    ASSERT_EQ(answer.code, kDone) << answer.err;
    const json one = json::parse(get("o.fold"));
    ASSERT_EQ(one["file_frames"].size(), 1u);
    EXPECT_EQ(one["file_frames"][0]["faceOrders"],
              all["file_frames"][std::stoul(number)]["faceOrders"]);
  }
  const Answer beyond = runKiri({"states", file, "--state", "60"});
  EXPECT_EQ(beyond.code, kBadUsage);
  EXPECT_TRUE(contains(beyond.err, "60")) << beyond.err;
  const std::string list = runKiri({"states", file, "--all"}).out;
  EXPECT_TRUE(contains(list, "\nstate 59: ")) << list;
}

TEST_F(StatesCommand, TakesNoMoreStatesThanAreWanted) {
  const std::string file = put("map.fold", mapAsFold("U"));
  ASSERT_EQ(runKiri({"states", file, "--all", "--limit", "7", "-o", path("o.fold")}).code, kDone);
  EXPECT_EQ(json::parse(get("o.fold"))["file_frames"].size(), 7u);
}

TEST_F(StatesCommand, WritesPicturesOfOneStateOrOfMany) {
  const std::string file = put("map.fold", mapAsFold("U"));
  for (const std::string ending : {"svg", "png", "pdf"}) {
    const Answer answer = runKiri({"states", file, "-o", path("one." + ending)});
    EXPECT_EQ(answer.code, kDone) << answer.err;
    EXPECT_GT(get("one." + ending).size(), 500u);
  }
  ASSERT_EQ(runKiri({"states", file, "--all", "--limit", "3", "-o", path("s_%02d.svg")}).code,
            kDone);
  EXPECT_EQ(fileCount(), 1u + 3 + 3);
  EXPECT_TRUE(contains(get("s_02.svg"), "<svg"));
}

TEST_F(StatesCommand, WritesAModelInTheState) {
  const std::string file = put("map.fold", mapAsFold("U"));
  ASSERT_EQ(runKiri({"states", file, "--state", "33", "-o", path("s.kiri")}).code, kDone);
  ASSERT_EQ(runKiri({"convert", file, path("c.kiri"), "--state", "33"}).code, kDone);
  EXPECT_EQ(json::parse(get("s.kiri"))["steps"], json::parse(get("c.kiri"))["steps"]);
  EXPECT_EQ(runKiri({"states", file, "--all", "-o", path("s.kiri")}).code, kBadUsage);
}

TEST_F(StatesCommand, SaysWhyThereIsNone) {
  // All creases of one vertex as mountains: Maekawa is broken, no order exists.
  std::string all = starAsCp(0);
  all[all.rfind("\n3 ") + 1] = '2';
  const std::string file = put("none.cp", all);
  const Answer answer = runKiri({"states", file, "-o", path("o.fold")});
  EXPECT_EQ(answer.code, kBadModel);
  EXPECT_TRUE(contains(answer.out, "\nno folded state: ")) << answer.out;
  EXPECT_TRUE(contains(answer.err, "no state exists; ")) << answer.err;
  EXPECT_EQ(fileCount(), 1u);
  EXPECT_EQ(runKiri({"states", file, "-o", path("why.svg")}).code, kBadModel);
  EXPECT_TRUE(contains(get("why.svg"), "folded-facets")) << "the picture shows the conflict";
  const json report = json::parse(runKiri({"states", file, "--json"}).out);
  EXPECT_EQ(report["states"], "0");
  EXPECT_EQ(report["locally_flat_foldable"], false);
  EXPECT_EQ(report["conflict"]["facets"].size(), 4u);
  EXPECT_EQ(runKiri({"states", file}).code, kDone);
  EXPECT_EQ(runKiri({"states", file, "--exit-code"}).code, kVerdictNo);

  const json open = json::parse(runKiri({"states", "-", "--json"}, {starAsCp(7)}).out);
  EXPECT_EQ(open["states"], "0");
  EXPECT_EQ(open["closes"], false);
}

TEST_F(StatesCommand, LeavesNothingBehindWhenItIsStopped) {
  const std::string file = put("map.fold", mapAsFold("U"));
  for (const int patience : {0, 1, 3, 6}) {
    const Answer answer = runKiri({"states", file, "-o", path("o.fold")}, {"", false, patience});
    EXPECT_EQ(answer.code, kCancelled) << patience << answer.err;
    EXPECT_TRUE(contains(answer.err, "error: stopped; nothing was written\n")) << answer.err;
    EXPECT_EQ(fileCount(), 1u);
  }
}

TEST_F(StatesCommand, ShowsThePartsOfItsWork) {
  const std::string file = put("map.fold", mapAsFold("U"));
  const std::string shown = runKiri({"states", file}, {"", true}).err;
  for (const std::string part : {"reading", "folding", "overlaps", "searching", "counting"})
    EXPECT_TRUE(contains(shown, part)) << part;
  EXPECT_EQ(runKiri({"states", file}).err, "");
}

TEST_F(StatesCommand, EndsWhenItsTimeIsOver) {
  const std::string file = put("map.fold", mapAsFold("U"));
  const Answer answer = runKiri({"states", file, "--json", "--time", "0.000001"});
  EXPECT_EQ(answer.code, kLimitMet);
  EXPECT_TRUE(contains(answer.err, "error: the time was over while ")) << answer.err;
  const json report = json::parse(answer.out);
  EXPECT_EQ(report["states"], nullptr);
  EXPECT_TRUE(report["stopped"].is_string());
}

TEST_F(StatesCommand, SaysWhatIsWrongWithItsOptions) {
  const std::string file = put("map.fold", mapAsFold("U"));
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"--count", "--all"}, "choose one"},
      {{"--count", "-o", path("o.fold")}, "--count writes no states"},
      {{"--state", "-1"}, "--state -1 is no number"},
      {{"--state", "two"}, "--state two is no number; states count from 0"},
      {{"--limit", "3"}, "--limit goes with --all"},
      {{"--memory", "0"}, "--memory must lie between"},
      {{"--time", "-1"}, "--time must not be negative"},
      {{"--all", "-o", path("o.png")}, "has no place for the numbers of the states"},
      {{"-o", path("o.gif")}, "this command writes .fold"},
      {{"-o", "-"}, "add --format fold"},
      {{"-o", "-", "--format", "fold", "--json"}, "would mix on standard output"},
  };
  for (const auto& [options, sentence] : cases) {
    std::vector<std::string> arguments = {"states", file};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Answer answer = runKiri(arguments);
    EXPECT_EQ(answer.code, kBadUsage) << sentence;
    EXPECT_TRUE(contains(answer.err, sentence)) << answer.err << "should say: " << sentence;
  }
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(StatesCommand, WritesToStandardOutputAlone) {
  const Answer answer = runKiri({"states", "-", "-o", "-", "--format", "fold"}, {mapAsFold("U")});
  EXPECT_EQ(answer.code, kDone) << answer.err;
  EXPECT_EQ(json::parse(answer.out)["file_frames"].size(), 1u);
}

TEST_F(StatesCommand, SaysWhatIsWrongWithAFile) {
  for (const std::string text :
       {"", "{", "hello", "{\"file_spec\": 1.2}", "2 0 0 1 1\n", "<svg></svg>"}) {
    for (const std::string name : {"bad.fold", "bad.cp", "bad.txt"}) {
      for (const std::string command : {"states", "check"}) {
        const Answer answer = runKiri({command, put(name, text)});
        EXPECT_EQ(answer.code, kBadModel) << name << ": " << text;
        EXPECT_EQ(answer.err.rfind("error: " + path(name), 0), 0u) << answer.err;
        EXPECT_EQ(answer.out, "");
      }
    }
  }
}

}  // namespace
}  // namespace kiri::cli
