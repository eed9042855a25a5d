// kiri gallery on the command line.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "apps/cli/exit_codes.h"
#include "io/kiri_reader.h"
#include "tests/apps/cli/html_check.h"
#include "tests/apps/cli/run_kiri.h"
#include "tests/support/state_check.h"

namespace kiri::cli {
namespace {

namespace fs = std::filesystem;

/// A model of one fold.
std::string foldedModel(const std::string& title, const std::string& notes = "") {
  return R"({"format": "kiri", "version": 1, "title": ")" + title + R"(", "notes": ")" + notes +
         R"(", "sheet": {"shape": "square", "side": 40}, "steps": [
  {"do": "fold", "title": "Fold in half", "notes": "Left over right.",
   "line": {"paper": [[20, 0], [20, 40]]}, "type": "valley", "move": "left"}]})";
}

/// Its second step asks for a fold that is not there.
std::string brokenModel() {
  std::string text = foldedModel("Broken");
  text.insert(text.rfind(']'), R"(, {"do": "angle", "fold": "nothing", "angle": 90})");
  return text;
}

bool hasFfmpeg() { return std::system("ffmpeg -version >/dev/null 2>&1") == 0; }

/// Every file below a folder, by its path from there.
std::map<std::string, std::string> filesBelow(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& file : fs::recursive_directory_iterator(folder)) {
    if (!file.is_regular_file()) continue;
    std::ifstream in(file.path(), std::ios::binary);
    files[fs::relative(file.path(), folder).string()] = {std::istreambuf_iterator<char>(in), {}};
  }
  return files;
}

/// A value of the environment for as long as it lives.
class Environment {
 public:
  Environment(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    ::setenv(name, value.c_str(), 1);
  }
  ~Environment() {
    if (before_.empty()) {
      ::unsetenv(name_);
    } else {
      ::setenv(name_, before_.c_str(), 1);
    }
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
  std::string before_;
};

class GalleryCommand : public KiriFolder {
 protected:
  void SetUp() override {
    KiriFolder::SetUp();
    fs::create_directories(path("models"));
  }

  /// kiri gallery on the folder of models, without films.
  Answer gallery(const std::vector<std::string>& more = {}, const Setting& setting = {}) const {
    std::vector<std::string> arguments = {"gallery", path("models"), "-o", path("out"),
                                          "--no-animations"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runKiri(arguments, setting);
  }

  /// Three models in two groups; one model of the folder is not shown.
  void putGallery() const {
    put("models/a.kiri", foldedModel("First"));
    put("models/b.kiri", foldedModel("Second"));
    put("models/c.kiri", foldedModel("Third"));
    put("models/d.kiri", foldedModel("Hidden"));
    put("models/gallery.json", R"({"format": "kiri gallery", "version": 1, "title": "My folds",
      "groups": [{"title": "Late & early", "notes": "Two of them.", "models": ["c.kiri", "a.kiri"]},
                 {"title": "Others", "models": ["b.kiri"]}]})");
  }
};

TEST_F(GalleryCommand, MakesAPageOfEachModelInAFolderAndOneOfAll) {
  put("models/half.kiri", foldedModel("One & two", "a <fold>"));
  const Answer answer = gallery();
  ASSERT_EQ(answer.code, kDone) << answer.err;
  EXPECT_EQ(answer.err, "");
  EXPECT_EQ(test::joined(htmlMistakes(path("out"))), "");
  const std::string page = get("out/half/index.html");
  EXPECT_TRUE(contains(page, "<p>Fold in half</p>")) << page;
  EXPECT_TRUE(contains(page, "Left over right."));
  // What a gallery promises of each model.
  for (const std::string name :
       {"finished.png", "back.png", "half.png", "unfolded.png", "pattern.png", "pattern.svg",
        "steps.svg", "steps.pdf", "half.kiri", "half.fold", "half.glb"}) {
    EXPECT_TRUE(contains(page, "\"" + name + "\"")) << name;
    EXPECT_TRUE(fs::exists(path("out/half/" + name))) << name;
  }
  EXPECT_TRUE(contains(page, "Half unfolded"));
  EXPECT_FALSE(contains(page, "<video"));
  EXPECT_TRUE(readKiri(get("out/half/half.kiri"), "half.kiri"));
}

TEST_F(GalleryCommand, ShowsGroupsInTheOrderOfGalleryJsonWithLinksToTheNeighbours) {
  putGallery();
  const Answer answer = gallery();
  ASSERT_EQ(answer.code, kDone) << answer.err;
  EXPECT_EQ(test::joined(htmlMistakes(path("out"))), "");
  const std::string index = get("out/index.html");
  std::size_t at = 0;
  for (const std::string part : {"<h1>My folds</h1>", "Late &amp; early</h2>", "Two of them.",
                                 "Third", "First", "Others</h2>", "Second"}) {
    const std::size_t next = index.find(part, at);
    ASSERT_NE(next, std::string::npos) << part << " is not where it should be in " << index;
    at = next;
  }
  EXPECT_FALSE(contains(index, "Hidden"));
  const std::string middle = get("out/a/index.html");
  EXPECT_TRUE(contains(middle, "href=\"../c/index.html\" rel=\"prev\">← Third<")) << middle;
  EXPECT_TRUE(contains(middle, "href=\"../b/index.html\" rel=\"next\">Second →<")) << middle;
  EXPECT_TRUE(contains(middle, "href=\"../index.html#group-1\"")) << middle;
  EXPECT_FALSE(contains(get("out/c/index.html"), "rel=\"prev\""));
  EXPECT_FALSE(contains(get("out/b/index.html"), "rel=\"next\""));
}

TEST_F(GalleryCommand, TakesGalleriesFoldersAndModelsTogether) {
  putGallery();
  const std::string alone = put("alone.kiri", foldedModel("Alone"));
  const Answer answer = runKiri(
      {"gallery", path("models/gallery.json"), alone, "-o", path("out"), "--no-animations"});
  ASSERT_EQ(answer.code, kDone) << answer.err;
  EXPECT_EQ(pagesBelow(path("out")).size(), 1U + 3U + 1U);
  EXPECT_EQ(test::joined(htmlMistakes(path("out"))), "");
}

TEST_F(GalleryCommand, WithoutArgumentsShowsTheExamples) {
  putGallery();
  const Environment examples("KIRI_EXAMPLES", path("models"));
  const Answer answer = runKiri({"gallery", "-o", path("out"), "--no-animations"});
  ASSERT_EQ(answer.code, kDone) << answer.err;
  EXPECT_TRUE(contains(get("out/index.html"), "<h1>My folds</h1>"));
}

TEST_F(GalleryCommand, WordsAndNamesOfAnyKindStayWhatTheyAre) {
  put("models/ä #1 & 100%.kiri", foldedModel("<b>\\\"x\\\" & 'y'</b>\\u0007", "1 < 2 > 0"));
  put("models/plain.kiri", foldedModel(""));
  const Answer answer = gallery();
  ASSERT_EQ(answer.code, kDone) << answer.err;
  EXPECT_EQ(test::joined(htmlMistakes(path("out"))), "");
  const std::string page = get("out/ä #1 & 100%/index.html");
  EXPECT_TRUE(contains(page, "<h1>&lt;b&gt;&quot;x&quot; &amp; 'y'&lt;/b&gt;</h1>")) << page;
  EXPECT_TRUE(contains(page, "1 &lt; 2 &gt; 0"));
  EXPECT_TRUE(contains(get("out/plain/index.html"), "<h1>plain</h1>"));
}

TEST_F(GalleryCommand, ADownloadedModelBringsItsTextures) {
  std::string text = foldedModel("Patterned");
  text.insert(text.find("\"steps\""), R"("paper": {"back": {"texture": "in/back.png"}}, )");
  put("models/m.kiri", text);
  fs::create_directory(path("models/in"));
  // The name that a texture has is that of a picture of the gallery.
  fs::copy_file(KIRI_SOURCE_DIR "/examples/frog.png", path("models/in/back.png"));
  const Answer answer = gallery();
  ASSERT_EQ(answer.code, kDone) << answer.err;
  EXPECT_EQ(test::joined(htmlMistakes(path("out"))), "");
  const Answer again = runKiri({"render", path("out/m/m.kiri"), "-o", path("again.png")});
  EXPECT_EQ(again.code, kDone);
  EXPECT_EQ(again.err, "") << "the texture is found";
  ASSERT_EQ(runKiri({"render", path("models/m.kiri"), "-o", path("first.png")}).code, kDone);
  EXPECT_TRUE(get("again.png") == get("first.png"));
}

TEST_F(GalleryCommand, TheFoldFileIsThePatternThatFoldsAndTheFoldedForm) {
  const std::string name = "leaf_three_lobes";
  fs::copy_file(KIRI_SOURCE_DIR "/examples/" + name + ".kiri", path("models/" + name + ".kiri"));
  ASSERT_EQ(gallery().code, kDone);
  const nlohmann::json fold =
      nlohmann::json::parse(get("out/" + name + "/" + name + ".fold"), nullptr, false);
  ASSERT_TRUE(fold.is_object());
  // The leaf lies open at its end, but its creases are mountains and valleys in the file.
  const nlohmann::json& letters = fold.at("edges_assignment");
  EXPECT_GT(std::count(letters.begin(), letters.end(), "V"), 0);
  EXPECT_GT(std::count(letters.begin(), letters.end(), "M"), 0);
  ASSERT_EQ(fold.at("file_frames").size(), 1U);
  EXPECT_EQ(fold["file_frames"][0].at("frame_classes"), nlohmann::json({"foldedForm"}));
  ASSERT_EQ(runKiri({"export", path("models/" + name + ".kiri"), "-o", path("all.fold")}).code,
            kDone);
  EXPECT_LT(5 * fs::file_size(path("out/" + name + "/" + name + ".fold")),
            fs::file_size(path("all.fold")));
}

TEST_F(GalleryCommand, AModelThatDoesNotApplyIsNamedAndTheOthersAreShown) {
  putGallery();
  put("models/a.kiri", brokenModel());
  const Answer answer = gallery();
  EXPECT_EQ(answer.code, kBadModel);
  EXPECT_TRUE(contains(answer.err, "a.kiri: step 2: ")) << answer.err;
  EXPECT_TRUE(contains(answer.err, "the pages show 2 of 3 models")) << answer.err;
  EXPECT_EQ(test::joined(htmlMistakes(path("out"))), "");
  EXPECT_FALSE(fs::exists(path("out/a/index.html")));
  EXPECT_TRUE(contains(get("out/b/index.html"), "← Third"));
}

TEST_F(GalleryCommand, AModelThatIsNotThereIsNamedToo) {
  putGallery();
  fs::remove(path("models/b.kiri"));
  const Answer answer = gallery();
  EXPECT_EQ(answer.code, kBadModel);
  EXPECT_TRUE(contains(answer.err, "b.kiri")) << answer.err;
  EXPECT_FALSE(contains(get("out/index.html"), "Others"));
}

TEST_F(GalleryCommand, SaysWhatIsWrongWithWhatItIsGiven) {
  const Answer empty = gallery();
  EXPECT_EQ(empty.code, kBadUsage);
  EXPECT_TRUE(contains(empty.err, "holds neither gallery.json nor .kiri files")) << empty.err;
  const Answer twice = runKiri({"gallery", "a/x.kiri", "b/x.kiri", "-o", path("out")});
  EXPECT_EQ(twice.code, kBadUsage);
  EXPECT_TRUE(contains(twice.err, "two models are named x (a/x.kiri and b/x.kiri)")) << twice.err;
  put("models/gallery.json", R"({"format": "kiri gallery", "version": 1, "groups": [
    {"title": "A", "models": ["../x.kiri"]}]})");
  const Answer outside = gallery();
  EXPECT_EQ(outside.code, kBadUsage);
  EXPECT_TRUE(contains(outside.err, "gallery.json:2:")) << outside.err;
  put("models/gallery.json", R"({"format": "kiri gallery", "version": 1, "groups": []})");
  EXPECT_EQ(gallery().code, kBadUsage);
  put("models/gallery.json", R"({"format": "kiri gallery", "version": 1, "groups": [
    {"title": "A", "models": ["nothing.kiri"]}]})");
  const Answer none = gallery();
  EXPECT_EQ(none.code, kBadModel);
  EXPECT_TRUE(contains(none.err, "no pages were written")) << none.err;
  EXPECT_TRUE(pagesBelow(path("out")).empty());
}

TEST_F(GalleryCommand, AFolderThatCannotBeWrittenToEndsIt) {
  put("models/half.kiri", foldedModel("Half"));
  put("out", "a file where the folder should be");
  const Answer answer = gallery();
  EXPECT_EQ(answer.code, kCannotWrite);
  EXPECT_TRUE(contains(answer.err, path("out"))) << answer.err;
  // And so does a file in the place of a model's folder.
  fs::remove(path("out"));
  fs::create_directory(path("out"));
  put("out/half", "");
  const Answer below = gallery();
  EXPECT_EQ(below.code, kCannotWrite);
  EXPECT_TRUE(contains(below.err, path("out/half"))) << below.err;
  EXPECT_FALSE(fs::exists(path("out/index.html")));
}

TEST_F(GalleryCommand, StoppedAtAnyTimeItLeavesWholeFilesAndNoPages) {
  for (const std::string name : {"a", "b", "c", "d"}) {
    put("models/" + name + ".kiri", foldedModel(name));
  }
  ASSERT_EQ(gallery({"--threads", "1"}).code, kDone);
  const std::map<std::string, std::string> whole = filesBelow(path("out"));
  for (const int patience : {0, 1, 2, 3}) {
    fs::remove_all(path("out"));
    const Answer answer = gallery({"--threads", "1"}, {"", false, patience});
    // How often it asks hangs on the machine; before the first model it always does.
    const bool isStopped = patience == 0 || answer.code != kDone;
    if (isStopped) {
      ASSERT_EQ(answer.code, kCancelled) << patience;
      EXPECT_TRUE(contains(answer.err, "of 4 models are in " + path("out"))) << answer.err;
      EXPECT_TRUE(pagesBelow(path("out")).empty()) << patience;
    }
    for (const auto& [file, bytes] : filesBelow(path("out"))) {
      ASSERT_EQ(whole.count(file), 1U) << file;
      EXPECT_EQ(bytes, whole.at(file)) << file;
    }
  }
}

TEST_F(GalleryCommand, ProgressCountsAndNamesTheModelsAtWork) {
  putGallery();
  const Answer answer = gallery({"--threads", "1"}, {"", true});
  ASSERT_EQ(answer.code, kDone);
  EXPECT_TRUE(contains(answer.err, "gallery 0 of 3: c")) << answer.err;
  EXPECT_EQ(gallery().err, "");
}

TEST_F(GalleryCommand, WritesTheSameBytesOnAnyNumberOfThreads) {
  putGallery();
  std::vector<std::string> more;
  const std::string films = hasFfmpeg() ? "" : "--no-animations";
  std::map<std::string, std::string> first;
  for (const std::string threads : {"1", "2"}) {
    const std::string out = path("out" + threads);
    std::vector<std::string> arguments = {"gallery", path("models"), "-o",
                                          out,       "--threads",    threads};
    if (!films.empty()) arguments.push_back(films);
    const Answer answer = runKiri(arguments);
    ASSERT_EQ(answer.code, kDone) << answer.err;
    const std::map<std::string, std::string> files = filesBelow(out);
    EXPECT_GT(files.size(), 30U);
    if (first.empty()) first = files;
    EXPECT_TRUE(files == first) << threads << " threads";
  }
}

TEST_F(GalleryCommand, ShowsModelsInMotion) {
  if (!hasFfmpeg()) GTEST_SKIP() << "there is no ffmpeg";
  put("models/a.kiri", foldedModel("First"));
  put("models/b.kiri", foldedModel("Second"));
  const Answer answer = runKiri({"gallery", path("models"), "-o", path("out")});
  ASSERT_EQ(answer.code, kDone) << answer.err;
  EXPECT_EQ(test::joined(htmlMistakes(path("out"))), "");
  for (const std::string name : {"a", "b"}) {
    EXPECT_TRUE(contains(get("out/" + name + "/index.html"), "<video src=\"motion.mp4\""));
    EXPECT_EQ(get("out/" + name + "/motion.mp4").substr(4, 4), "ftyp");
  }
}

TEST_F(GalleryCommand, WithoutFfmpegSaysSoBeforeAnyWork) {
  put("models/a.kiri", foldedModel("First"));
  const Environment nothing("PATH", path("nowhere"));
  const Answer answer = runKiri({"gallery", path("models"), "-o", path("out")});
  EXPECT_EQ(answer.code, kCannotWrite);
  EXPECT_TRUE(contains(answer.err, "ffmpeg")) << answer.err;
  EXPECT_TRUE(contains(answer.err, "--no-animations")) << answer.err;
  EXPECT_TRUE(filesBelow(path("out")).empty());
  EXPECT_EQ(gallery().code, kDone);
}

TEST_F(GalleryCommand, OfALeafTheMeasuresAreShownAndOfNothingElse) {
  for (const std::string name : {"leaf_three_lobes", "origami_cat"}) {
    fs::copy_file(KIRI_SOURCE_DIR "/examples/" + name + ".kiri", path("models/" + name + ".kiri"));
  }
  const Answer answer = gallery();
  ASSERT_EQ(answer.code, kDone) << answer.err;
  EXPECT_EQ(test::joined(htmlMistakes(path("out"))), "");
  const std::string leaf = get("out/leaf_three_lobes/index.html");
  EXPECT_TRUE(contains(leaf, "<th scope=\"row\">lobes</th><td>3</td>")) << leaf;
  EXPECT_TRUE(contains(leaf, "\"measured.svg\""));
  EXPECT_TRUE(contains(leaf, "Finished and unfolded, front"));
  EXPECT_TRUE(contains(leaf, "\"folded.png\""));
  EXPECT_FALSE(contains(get("out/origami_cat/index.html"), "Measures"));
}

TEST(HtmlMistakes, AreFoundWhereTheyArePlanted) {
  const fs::path folder = fs::path(testing::TempDir()) / "kiri_html_check";
  fs::create_directories(folder);
  const std::string good =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\" />"
      "<meta name=\"viewport\" content=\"x\" /><title>T</title></head><body><main>"
      "<h1>H</h1><h2 id=\"i\">I</h2><ul><li><a href=\"#i\">w</a></li></ul>"
      "<img src=\"index.html\" srcset=\"index.html 1w, index.html 2w\" alt=\"\" width=\"1\" "
      "height=\"1\" /><video src=\"index.html\" poster=\"index.html\" preload=\"none\" "
      "controls=\"\" aria-label=\"x\" width=\"3\" height=\"1\">x</video></main></body></html>";
  const auto mistakesOf = [&](const std::string& text) {
    std::ofstream(folder / "index.html") << text;
    return htmlMistakes(folder).size();
  };
  EXPECT_EQ(mistakesOf(good), 0U);
  const std::pair<std::string, std::string> damages[] = {
      {"<!DOCTYPE html>", ""},
      {" lang=\"en\"", ""},
      {">T<", "><"},
      {"</ul>", ""},
      {" alt=\"\"", ""},
      {" width=\"1\"", ""},
      {" width=\"3\"", ""},
      {", index.html 2w", ", x.html 2w"},
      {", index.html 2w", ", index.html"},
      {" poster=\"index", " poster=\"x"},
      {" controls=\"\"", ""},
      {" controls=\"\"", " controls=\"\" autoplay=\"\""},
      {"\"none\"", "\"auto\""},
      {"src=\"index", "src=\"x"},
      {"href=\"#i", "href=\"#j"},
      {"href=\"#i", "href=\"http://x"},
      {"<h2", "<h3"},
      {"<h1>H</h1>", ""},
      {">w<", "><"},
      {"<ul>", "<ul>x"},
      {"<main>", "<main id=\"i\">"},
      {"<h1>", "<script>1</script><h1>"},
  };
  for (const auto& [from, to] : damages) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    if (from == "<h2") text.replace(text.find("</h2>"), 5, "</h3>");
    EXPECT_GE(mistakesOf(text), 1U) << from << " -> " << to;
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace kiri::cli
