// The command line as a person or a script meets it: what it writes, says and returns.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/cli/exit_codes.h"
#include "tests/apps/cli/run_kiri.h"

namespace kiri::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kHalf =
    R"({"do": "fold", "name": "half", "line": {"paper": [[50, 0], [50, 100]]}, "type": "valley", "move": "left"})";
/// Folds the upper layer down through the lower one.
constexpr const char* kThrough =
    R"({"do": "fold", "name": "through", "line": {"model": [[75, 0], [75, 100]]}, "type": "mountain",
        "layers": {"top": 1}, "move": {"point": [90, 50]}})";
constexpr const char* kMissing =
    R"({"do": "angle", "title": "Open it", "fold": "nothing", "angle": 90})";

std::string model(const std::string& steps, const std::string& more = "") {
  return R"({"format": "kiri", "version": 1, "title": "Test", "sheet": {"shape": "square", "side": 100},)" +
         more + "\n\"steps\": [" + steps + "]}";
}

using Cli = KiriFolder;

TEST_F(Cli, ExplainsEveryCommandWithExamples) {
  EXPECT_EQ(runKiri({"--help"}).code, kDone);
  EXPECT_TRUE(contains(runKiri({"--help"}).out, "Exit codes:"));
  EXPECT_TRUE(contains(runKiri({"--version"}).out, "KiriSim"));
  for (const std::string command :
       {"render", "sheet", "animate", "info", "steps", "export", "resolve", "check", "states",
        "convert", "leaf", "measure", "gallery"}) {
    const Answer answer = runKiri({command, "--help"});
    EXPECT_EQ(answer.code, kDone) << command;
    EXPECT_TRUE(contains(answer.out, "Examples:\n  kiri " + command)) << answer.out;
    EXPECT_EQ(answer.err, "");
  }
}

TEST_F(Cli, SaysWhatIsWrongWithACommandLine) {
  const std::string file = put("m.kiri", model(kHalf));
  const std::string out = path("o.png");
  struct Case {
    std::vector<std::string> arguments;
    std::string sentence;
  };
  const std::vector<Case> cases = {
      {{}, "say what to do; see kiri --help"},
      {{"redner", file}, "there is no command \"redner\"; did you mean \"render\"?"},
      {{"unknowable"}, "there is no command \"unknowable\"; see kiri --help"},
      {{"--hepl"}, "there is no option --hepl; did you mean --help?"},
      {{"render", file, "--setp", "1", "-o", out},
       "there is no option --setp; did you mean --step?"},
      {{"render", file}, "--output is required"},
      {{"render"}, "see kiri render --help"},
      {{"info"}, "MODEL is required"},
      {{"info", file, "--step", "two"}, "--step = two is no number that fits here"},
      {{"info", file, "--step", "2"}, "has 1 step, so --step takes 0 (the sheet) to 1"},
      {{"info", file, "--step", "-1"}, "there is no step -1"},
      {{"render", file, "-o", path("o.gif")},
       "ends in .gif; this command writes .svg, .png or .pdf"},
      {{"render", file, "-o", path("o")}, "has no ending; this command writes"},
      {{"render", file, "-o", "-"}, "add --format svg, png or pdf"},
      {{"render", file, "-o", out, "--format", "tiff"},
       "--format tiff is not known here; it takes svg, png or pdf"},
      {{"render", file, "-o", out, "--view", "top"},
       "--view top is not known; it takes front, back, pattern or AZ,EL like 30,40"},
      {{"render", file, "-o", out, "--style", "x"}, "--style x is not known"},
      {{"render", file, "-o", out, "--dpi", "0"}, "--dpi must lie between 1 and 10000"},
      {{"render", file, "-o", out, "--dpi", "nan"}, "--dpi must lie between"},
      {{"render", file, "-o", out, "--scale", "0"}, "--scale must be above 0"},
      {{"render", file, "-o", out, "--margin", "-1"}, "--margin must lie between"},
      {{"render", file, "-o", out, "--grid", "-1"}, "--grid must lie between"},
      {{"render", file, "-o", out, "--background", "white"}, "--background white is no colour"},
      {{"render", file, "-o", out, "--lines-only"}, "--lines-only goes with --view pattern"},
      {{"sheet", file, "-o", out, "--steps", "1-x"}, "--steps: \"1-x\" is no panel"},
      {{"sheet", file, "-o", out, "--steps", "3"}, "there is no panel 3; the panels are 1 to 2"},
      {{"sheet", file, "-o", out, "--steps", "0"}, "there is no panel 0"},
      {{"sheet", file, "-o", out, "--steps", "2-1"}, "runs backwards"},
      {{"sheet", file, "-o", out, "--view", "pattern"}, "it takes front, back or AZ,EL"},
      {{"render", file, "-o", out, "--view", "30,x"}, "--view 30,x is not known"},
      {{"render", file, "-o", out, "--view", "30,91"},
       "the elevation of a view must lie between -90 and 90"},
      {{"render", file, "-o", out, "--perspective", "170"},
       "the field of view must lie between 0 and 120 degrees"},
      {{"render", file, "-o", out, "--explode", "-1"},
       "the gap between exploded layers must lie between 0 and 1000 mm"},
      {{"render", file, "-o", out, "--thickness", "nan"},
       "the thickness of the paper must lie between 0 and 1000 mm"},
      {{"render", file, "-o", out, "--view", "pattern", "--shade"},
       "go with views of the folded model, not with --view pattern"},
      {{"sheet", file, "-o", out, "--perspective", "30"}, "there is no option --perspective"},
      {{"sheet", file, "-o", out, "--columns", "-1"}, "--columns must lie between"},
      {{"sheet", file, "-o", out, "--width", "1"}, "--width must lie between"},
      {{"sheet", file, "-o", out, "--panel", "0"}, "--panel must be above 0"},
      {{"export", file, "-o", path("o.3ds")},
       "this command writes .fold, .svg, .obj, .stl or .glb"},
      {{"export", file, "-o", path("o.svg"), "--view", "folded"},
       "for the folded model use kiri render"},
      {{"export", file, "-o", path("o.fold"), "--as-folded"},
       "--as-folded goes with --view pattern"},
      {{"export", file, "-o", path("o.fold"), "--two-sided"}, "goes with obj"},
      {{"export", file, "-o", path("o.stl"), "--two-sided"}, "--two-sided goes with obj"},
      {{"export", file, "-o", path("o.fold"), "--thickness", "1"}, "go with obj, stl and glb"},
      {{"export", file, "-o", path("o.stl"), "--thickness", "nan"}, "--thickness must lie between"},
      {{"export", file, "-o", path("o.stl"), "--animate"}, "--animate goes with glb"},
      {{"export", file, "-o", path("o.glb"), "--animate", "--step", "1"}, "leave --step out"},
      {{"export", file, "-o", path("o.glb"), "--hold", "1"}, "go with --animate"},
      {{"export", file, "-o", path("o.glb"), "--animate", "--steps", "4"}, "--steps 4 is not"},
      {{"export", file, "-o", path("o.glb"), "--as-folded"}, "--as-folded goes with fold and svg"},
      {{"export", file, "-o", path("o.obj"), "--layer-gap", "-1"}, "--layer-gap must lie between"},
      {{"export", file, "-o", path("o.fold"), "--view", "flat"}, "it takes folded or pattern"},
  };
  for (const Case& one : cases) {
    const Answer answer = runKiri(one.arguments);
    EXPECT_EQ(answer.code, kBadUsage) << one.sentence << "\n" << answer.err;
    EXPECT_TRUE(contains(answer.err, one.sentence)) << answer.err << "should say: " << one.sentence;
    EXPECT_EQ(answer.err.rfind("error: ", 0), 0u) << answer.err;
    EXPECT_EQ(answer.out, "");
  }
  EXPECT_EQ(fileCount(), 1u) << "nothing was written";
}

TEST_F(Cli, SaysWhatIsWrongWithAModel) {
  const Answer missing = runKiri({"info", path("nothing.kiri")});
  EXPECT_EQ(missing.code, kBadModel);
  EXPECT_TRUE(contains(missing.err, "nothing.kiri: there is no such file")) << missing.err;
  EXPECT_TRUE(contains(runKiri({"info", path("")}).err, "it is a folder"));
  const Answer broken = runKiri({"info", put("b.kiri", "{")});
  EXPECT_EQ(broken.code, kBadModel);
  EXPECT_TRUE(contains(broken.err, "b.kiri:1:2: this is not valid JSON")) << broken.err;
  const Answer sheet = runKiri({"info", "-"}, {R"({"format": "kiri", "version": 1, "steps": [],
    "sheet": {"shape": "polygon", "outline": [[0, 0], [10, 10], [10, 0], [0, 10]]}})"});
  EXPECT_EQ(sheet.code, kBadModel);
  EXPECT_TRUE(contains(sheet.err, "standard input: sheet: ")) << sheet.err;
}

TEST_F(Cli, NamesTheStepThatDoesNotApplyAndWorksBeforeIt) {
  const std::string file = put("m.kiri", model(std::string(kHalf) + "," + kMissing));
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"render", file, "-o", path("o.svg")},
                                             {"sheet", file, "-o", path("o.svg")},
                                             {"export", file, "-o", path("o.fold")},
                                             {"resolve", file, "-o", path("o.kiri")},
                                             {"info", file}}) {
    const Answer answer = runKiri(command);
    EXPECT_EQ(answer.code, kBadModel) << command[0];
    EXPECT_TRUE(contains(answer.err, "m.kiri: step 2 (angle \"Open it\"): ")) << answer.err;
  }
  EXPECT_EQ(fileCount(), 1u);
  EXPECT_EQ(runKiri({"render", file, "--step", "1", "-o", path("o.svg")}).code, kDone);
  EXPECT_EQ(runKiri({"sheet", file, "--steps", "1-2", "-o", path("s.svg")}).code, kDone);
  EXPECT_EQ(runKiri({"info", file, "--step", "1"}).code, kDone);

  const Answer steps = runKiri({"steps", file, "--json"});
  EXPECT_EQ(steps.code, kBadModel);
  const json list = json::parse(steps.out)["steps"];
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0]["applies"], true);
  EXPECT_EQ(list[1]["applies"], false);
  EXPECT_TRUE(list[1]["error"].is_string());
  EXPECT_TRUE(contains(runKiri({"steps", file}).out, "2 (angle \"Open it\"): does not apply: "));
}

TEST_F(Cli, GoesOnAfterACollisionWithAWarning) {
  const std::string file = put("m.kiri", model(std::string(kHalf) + "," + kThrough));
  const Answer answer = runKiri({"render", file, "-o", path("o.png")});
  EXPECT_EQ(answer.code, kDone) << answer.err;
  EXPECT_TRUE(contains(answer.err, "warning: ")) << answer.err;
  EXPECT_TRUE(contains(answer.err, "m.kiri: step 2 (fold \"through\"): ")) << answer.err;
  EXPECT_EQ(get("o.png").substr(1, 3), "PNG");
  const json info = json::parse(runKiri({"info", file, "--json"}).out);
  ASSERT_GE(info["collisions"].size(), 1u);
  EXPECT_EQ(info["collisions"][0]["step"], 2);
  EXPECT_TRUE(info["collisions"][0]["message"].is_string());
}

TEST_F(Cli, PrintsTheFiguresOfAState) {
  const std::string file = put("m.kiri", model(kHalf));
  const json folded = json::parse(runKiri({"info", file, "--json"}).out);
  EXPECT_EQ(folded["steps"], 1);
  EXPECT_EQ(folded["step"], 1);
  EXPECT_EQ(folded["facets"], 2);
  EXPECT_EQ(folded["hinges"], 1);
  EXPECT_EQ(folded["fold_lines"], 1);
  EXPECT_EQ(folded["pieces"], 1);
  EXPECT_DOUBLE_EQ(folded["area_mm2"].get<double>(), 10000);
  EXPECT_EQ(folded["flat"], true);
  EXPECT_EQ(folded["layers"], 2);
  EXPECT_EQ(folded["stretch_mm"], 0);
  EXPECT_EQ(folded["collisions"], json::array());
  EXPECT_EQ(folded["fold_line_list"][0]["name"], "half");
  EXPECT_EQ(folded["fold_line_list"][0]["angle"], 180);
  EXPECT_EQ(folded["model_box_mm"]["low"], json({50, 0, 0}));
  EXPECT_EQ(folded["model_box_mm"]["high"], json({100, 100, 0}));
  const json sheet = json::parse(runKiri({"info", file, "--step", "0", "--json"}).out);
  EXPECT_EQ(sheet["facets"], 1);
  EXPECT_EQ(sheet["layers"], 1);
  EXPECT_EQ(sheet["fold_lines"], 0);
  EXPECT_TRUE(contains(runKiri({"info", file}).out, "layers      2\n"));
}

TEST_F(Cli, ShowsAnyMomentBetweenTwoSteps) {
  const std::string file = put("m.kiri", model(std::string(kHalf) + ", " + kMissing));
  const auto figures = [&](const std::string& step) {
    return json::parse(runKiri({"info", file, "--step", step, "--json"}).out);
  };
  EXPECT_EQ(figures("0.5")["step"], 0.5);
  EXPECT_EQ(figures("0.5")["fold_line_list"][0]["angle"], 90);
  EXPECT_EQ(figures("0.25")["fold_line_list"][0]["angle"], 45);
  EXPECT_EQ(figures("1")["fold_line_list"][0]["angle"], 180);
  EXPECT_TRUE(contains(runKiri({"info", file, "--step", "0.5"}).out, "0.5 of 2\n"));
  for (const std::string ending : {"fold", "obj", "stl", "glb", "svg"}) {
    const std::string out = path("half." + ending);
    EXPECT_EQ(runKiri({"export", file, "--step", "0.5", "-o", out}).code, kDone) << ending;
    EXPECT_GT(get("half." + ending).size(), 100u) << ending;
  }
  const json frames = json::parse(get("half.fold"))["file_frames"];
  EXPECT_EQ(frames.back()["frame_title"], "in step 1 (fold \"half\")");
  EXPECT_TRUE(contains(get("half.obj"), " 50\n")) << "the moving half stands upright";
  EXPECT_EQ(runKiri({"render", file, "--step", "0.5", "-o", path("half.png")}).code, kDone);

  const Answer answer = runKiri({"info", file, "--step", "1.5"});
  EXPECT_EQ(answer.code, kBadModel);
  EXPECT_TRUE(contains(answer.err, file + ": step 2 (angle \"Open it\"): there is no fold"))
      << answer.err;
  EXPECT_TRUE(contains(runKiri({"info", file, "--step", "nan"}).err, "there is no step nan"));
}

TEST_F(Cli, ReadsStandardInputAndWritesStandardOutput) {
  const std::string text = model(kHalf);
  const Answer svg = runKiri({"render", "-", "--format", "svg", "-o", "-"}, {text});
  EXPECT_EQ(svg.code, kDone) << svg.err;
  EXPECT_EQ(svg.out.rfind("<?xml", 0), 0u);
  EXPECT_EQ(runKiri({"render", "-", "--format", "png", "-o", "-"}, {text}).out.substr(1, 3), "PNG");
  EXPECT_EQ(runKiri({"render", "-", "--format", "pdf", "-o", "-"}, {text}).out.substr(0, 4),
            "%PDF");
  EXPECT_EQ(json::parse(runKiri({"info", "-", "--json"}, {text}).out)["facets"], 2);
  EXPECT_EQ(
      json::parse(runKiri({"export", "-", "--format", "fold", "-o", "-"}, {text}).out)["file_spec"],
      1.2);
  EXPECT_EQ(runKiri({"info", "-", "--json"}, {text}).err, "");
}

TEST_F(Cli, WritesEveryPicture) {
  const std::string file = put("m.kiri", model(kHalf));
  EXPECT_EQ(runKiri({"render", file, "-o", path("a.SVG")}).code, kDone);
  EXPECT_EQ(runKiri({"render", file, "--view", "back", "-o", path("b.pdf")}).code, kDone);
  EXPECT_EQ(
      runKiri({"render", file, "--view", "-30,40", "--perspective", "40", "-o", path("d.png")})
          .code,
      kDone);
  EXPECT_EQ(runKiri({"render", file, "--view", "30,20", "--shade", "--shadow", "--explode", "3",
                     "--thickness", "0.2", "-o", path("f.svg")})
                .code,
            kDone);
  EXPECT_TRUE(contains(get("f.svg"), "fill-opacity"));
  EXPECT_EQ(runKiri({"sheet", file, "--view", "-30,40", "--shade", "-o", path("e.png")}).code,
            kDone);
  EXPECT_EQ(
      runKiri({"render", file, "--view", "pattern", "--lines-only", "-o", path("c.png")}).code,
      kDone);
  EXPECT_EQ(
      runKiri({"sheet", file, "--columns", "1", "--style", "diagram", "-o", path("d.svg")}).code,
      kDone);
  EXPECT_TRUE(contains(get("a.SVG"), "<svg"));
  EXPECT_EQ(get("b.pdf").substr(0, 4), "%PDF");
  EXPECT_EQ(get("c.png").substr(1, 3), "PNG");
  EXPECT_EQ(fileCount(), 8u) << "no temporary file is left";
}

TEST_F(Cli, DrawsPaperWithoutItsTextureWhenThatCannotBeRead) {
  const std::string file =
      put("m.kiri", model(kHalf, R"("paper": {"front": {"texture": "none.png"}},)"));
  const Answer missing = runKiri({"render", file, "-o", path("o.svg")});
  EXPECT_EQ(missing.code, kDone);
  EXPECT_TRUE(contains(missing.err, "warning: ") &&
              contains(missing.err, "the texture is left out"))
      << missing.err;
  put("none.png", "no image");
  const Answer broken = runKiri({"render", file, "-o", path("o.svg")});
  EXPECT_EQ(broken.code, kDone);
  EXPECT_TRUE(contains(broken.err, "none.png is left out: ")) << broken.err;
}

TEST_F(Cli, SaysWhyItCannotWrite) {
  const std::string file = put("m.kiri", model(kHalf));
  const Answer folder = runKiri({"render", file, "-o", path("none/o.svg")});
  EXPECT_EQ(folder.code, kCannotWrite);
  EXPECT_TRUE(contains(folder.err, "there is no folder ")) << folder.err;
  fs::create_directory(path("d.svg"));
  EXPECT_EQ(runKiri({"render", file, "-o", path("d.svg")}).code, kCannotWrite);
  EXPECT_EQ(fileCount(), 2u);
}

TEST_F(Cli, LeavesNothingBehindWhenItIsStopped) {
  const std::string file = put("m.kiri", model(kHalf));
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"render", file, "-o", path("o.svg")},
                                             {"sheet", file, "-o", path("o.svg")},
                                             {"export", file, "-o", path("o.fold")}}) {
    const Answer answer = runKiri(command, {"", false, 0});
    EXPECT_EQ(answer.code, kCancelled) << command[0];
    EXPECT_TRUE(contains(answer.err, "stopped; nothing was written"));
  }
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(Cli, ShowsProgressOnlyWhereItIsWanted) {
  const std::string file = put("m.kiri", model(kHalf));
  EXPECT_EQ(runKiri({"render", file, "-o", path("o.svg")}).err, "");
  EXPECT_TRUE(
      contains(runKiri({"render", file, "-o", path("o.svg"), "--progress"}).err, "drawing"));
  EXPECT_TRUE(contains(runKiri({"render", file, "-o", path("o.svg")}, {"", true}).err, "folding"));
}

TEST_F(Cli, KeepsTheModelWhenItsChoicesAreResolved) {
  const std::string model_ = model(
      std::string(kHalf) +
      R"(, {"do": "fold", "line": {"model": [[50, 40], [100, 60]]}, "type": "mountain", "move": {"point": [60, 90]}})");
  const std::string file = put("m.kiri", model_);
  ASSERT_EQ(runKiri({"resolve", file, "-o", path("r.kiri")}).code, kDone);
  EXPECT_FALSE(contains(get("r.kiri"), "\"model\"")) << get("r.kiri");
  json before = json::parse(runKiri({"info", file, "--json"}).out);
  json after = json::parse(runKiri({"info", path("r.kiri"), "--json"}).out);
  before.erase("file");
  after.erase("file");
  EXPECT_EQ(before, after);
  EXPECT_EQ(runKiri({"resolve", path("r.kiri"), "-o", "-"}).out, get("r.kiri"))
      << "resolving again changes nothing";
}

TEST_F(Cli, ExportsWhatOtherProgramsRead) {
  const std::string file = put("m.kiri", model(kHalf));
  ASSERT_EQ(runKiri({"export", file, "-o", path("m.fold")}).code, kDone);
  const json fold = json::parse(get("m.fold"));
  EXPECT_EQ(fold["file_frames"].size(), 1u);
  EXPECT_EQ(fold["file_frames"][0]["frame_title"], "step 1 (fold \"half\")");
  ASSERT_EQ(runKiri({"export", file, "--view", "pattern", "-o", path("p.fold")}).code, kDone);
  EXPECT_FALSE(json::parse(get("p.fold")).contains("file_frames"));

  ASSERT_EQ(runKiri({"export", file, "-o", path("m.svg")}).code, kDone);
  const std::string svg = get("m.svg");
  EXPECT_TRUE(contains(svg, "width=\"100mm\" height=\"100mm\" viewBox=\"0 0 100 100\"")) << svg;
  EXPECT_TRUE(
      contains(svg, "<path d=\"M50 100 L50 0\" data-assignment=\"V\" data-foldAngle=\"180\"") ||
      contains(svg, "<path d=\"M50 0 L50 100\" data-assignment=\"V\" data-foldAngle=\"180\""))
      << svg;
  EXPECT_TRUE(contains(svg, "Z\" data-assignment=\"B\"")) << "the contour is closed";

  ASSERT_EQ(runKiri({"export", file, "--layer-gap", "0.5", "-o", path("m.obj")}).code, kDone);
  const std::string obj = get("m.obj");
  EXPECT_TRUE(contains(obj, "g facet_0\n") && contains(obj, "g facet_1\n"));
  EXPECT_TRUE(contains(obj, " 0.5\n")) << "the upper layer is lifted";

  // Two facets of half the sheet: two triangles on each side, four sides of two.
  ASSERT_EQ(runKiri({"export", file, "--thickness", "0.5", "-o", path("m.stl")}).code, kDone);
  EXPECT_EQ(get("m.stl").size(), 84u + 50u * 2 * (2 + 2 + 8));
  ASSERT_EQ(runKiri({"export", file, "-o", path("m.glb")}).code, kDone);
  EXPECT_EQ(get("m.glb").substr(0, 4), "glTF");
  ASSERT_EQ(runKiri({"export", file, "--animate", "-o", path("a.glb")}).code, kDone);
  EXPECT_TRUE(contains(get("a.glb"), "\"animations\""));
}

}  // namespace
}  // namespace kiri::cli
