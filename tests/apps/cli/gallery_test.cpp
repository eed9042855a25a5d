// kiri gallery on the command line.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "apps/cli/run.h"
#include "io/file.h"
#include "io/kiri_reader.h"

namespace kiri::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolded = R"({"format": "kiri", "version": 1, "title": "One & two",
  "notes": "a <fold>", "sheet": {"shape": "square", "side": 40}, "steps": [
  {"do": "fold", "title": "Fold in half", "line": {"paper": [[20, 0], [20, 40]]},
   "type": "valley", "move": "left"}]})";

/// A folder that goes when the test ends.
struct Scratch {
  fs::path path = fs::path(testing::TempDir()) / "kiri_gallery_test";
  Scratch() {
    fs::remove_all(path);
    fs::create_directories(path / "models");
  }
  ~Scratch() { fs::remove_all(path); }
};

int galleryRun(const std::vector<std::string>& arguments, std::string& err,
               bool isCancelled = false) {
  std::istringstream in;
  std::ostringstream out;
  std::ostringstream errors;
  Console console{in, out, errors, false, [=] { return isCancelled; }};
  const int code = run(arguments, console);
  err = errors.str();
  return code;
}

std::string contentOf(const fs::path& path) {
  const Result<std::string> text = readFile(path.string());
  EXPECT_TRUE(text) << path;
  return text ? *text : "";
}

TEST(GalleryCommand, MakesAPageOfEachModelInAFolderAndOneOfAll) {
  const Scratch scratch;
  std::ofstream(scratch.path / "models" / "half.kiri") << kFolded;
  const std::string out = (scratch.path / "out").string();
  std::string err;
  ASSERT_EQ(galleryRun(
                {"gallery", (scratch.path / "models").string(), "-o", out, "--no-animations"}, err),
            kDone)
      << err;
  const std::string index = contentOf(out + "/index.html");
  EXPECT_NE(index.find("One &amp; two"), std::string::npos);
  EXPECT_NE(index.find("a &lt;fold&gt;"), std::string::npos);
  EXPECT_NE(index.find("half/index.html"), std::string::npos);
  const std::string page = contentOf(out + "/half/index.html");
  EXPECT_NE(page.find("<li>Fold in half"), std::string::npos);
  // What the pages show is there.
  for (const char* name : {"finished.png", "folded.png", "half.png", "unfolded.png", "pattern.svg",
                           "steps.svg", "half.kiri", "half.fold"}) {
    EXPECT_NE(page.find(name), std::string::npos) << name;
    EXPECT_TRUE(fs::exists(out + "/half/" + name)) << name;
  }
  EXPECT_TRUE(readKiri(contentOf(out + "/half/half.kiri"), "half.kiri"));
}

TEST(GalleryCommand, TwoModelsOfOneNameAreRefused) {
  const Scratch scratch;
  std::string err;
  EXPECT_EQ(galleryRun({"gallery", "a/x.kiri", "b/x.kiri", "-o", scratch.path.string()}, err),
            kBadUsage);
  EXPECT_NE(err.find("two models are named x"), std::string::npos) << err;
}

TEST(GalleryCommand, CanBeStopped) {
  const Scratch scratch;
  std::ofstream(scratch.path / "models" / "half.kiri") << kFolded;
  std::string err;
  EXPECT_EQ(galleryRun({"gallery", (scratch.path / "models").string(), "-o",
                        (scratch.path / "out").string()},
                       err, true),
            kCancelled);
}

}  // namespace
}  // namespace kiri::cli
