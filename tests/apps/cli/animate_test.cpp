// kiri animate as a person or a script meets it.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "apps/cli/exit_codes.h"
#include "render/canvas/png.h"
#include "tests/apps/cli/run_kiri.h"

namespace kiri::cli {
namespace {

constexpr const char* kModel =
    R"({"format": "kiri", "version": 1, "sheet": {"shape": "square", "side": 100}, "steps": [
{"do": "fold", "name": "a", "line": {"paper": [[50, 0], [50, 100]]}, "type": "valley", "move": "left"},
{"do": "fold", "name": "b", "line": {"model": [[50, 50], [100, 50]]}, "type": "valley", "move": "left"},
{"do": "unfold", "folds": ["b"]}]})";

class Animate : public KiriFolder {
 protected:
  void SetUp() override {
    KiriFolder::SetUp();
    put("m.kiri", kModel);
  }

  /// kiri animate with small frames; stops after asking `patience` times.
  Answer animate(const std::vector<std::string>& more, int patience = 1000000) const {
    std::vector<std::string> arguments = {"animate", path("m.kiri")};
    if (std::find(more.begin(), more.end(), "--size") == more.end()) {
      arguments.insert(arguments.end(), {"--size", "64x48"});
    }
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runKiri(arguments, {"", false, patience});
  }
  Image picture(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    const Result<Image> image = decodePng({std::istreambuf_iterator<char>(file), {}});
    EXPECT_TRUE(image.isOk()) << name;
    return image.isOk() ? *image : Image{};
  }
};

std::string answerOf(const std::string& command) {
  std::string out;
  FILE* pipe = ::popen(command.c_str(), "r");
  std::array<char, 4096> buffer = {};
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) out += buffer.data();
  ::pclose(pipe);
  return out;
}

bool isThere(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

TEST_F(Animate, WritesNumberedPicturesOfEveryFrame) {
  // Rests of 0.6, 0.5, 0.5 and 1.2 s, three half turns of 1 s: 5.8 s at 5 frames a second.
  const Answer answer =
      animate({"--fps", "5", "--speed", "180", "--hold", "0.5", "-o", path("f_%03d.png")});
  ASSERT_EQ(answer.code, kDone) << answer.err;
  EXPECT_EQ(answer.err, "");
  EXPECT_EQ(fileCount(), 1u + 29u);
  EXPECT_EQ(picture("f_001.png").width, 64);
  EXPECT_EQ(picture("f_001.png").height, 48);
  EXPECT_EQ(picture("f_001.png").rgba, picture("f_003.png").rgba) << "the rest at the start";
  EXPECT_NE(picture("f_003.png").rgba, picture("f_007.png").rgba);
  EXPECT_EQ(picture("f_026.png").rgba, picture("f_029.png").rgba) << "the rest at the end";
}

TEST_F(Animate, ShowsTheStepsThatWereAskedFor) {
  ASSERT_EQ(animate({"--fps", "5", "--speed", "180", "--steps", "2", "-o", path("f_%d.png")}).code,
            kDone);
  EXPECT_EQ(fileCount(), 1u + 14u);  // 0.6 + 1 + 1.2 s
  ASSERT_EQ(animate({"--fps", "5", "--steps", "end", "--hold", "1", "-o", path("e_%d.png")}).code,
            kDone);
  EXPECT_EQ(picture("e_1.png").rgba, picture("e_5.png").rgba);
}

TEST_F(Animate, MakesFilmsThatFfprobeReads) {
  if (!isThere("ffmpeg") || !isThere("ffprobe")) GTEST_SKIP() << "ffmpeg is not installed";
  for (const std::string format : {"mp4", "gif"}) {
    const std::string film = path("film." + format);
    const Answer answer =
        animate({"--fps", "10", "--speed", "180", "--hold", "0.5", "--turntable", "-o", film});
    ASSERT_EQ(answer.code, kDone) << answer.err;
    EXPECT_EQ(answerOf("ffprobe -v error -count_frames -of csv=p=0 -show_entries "
                       "stream=width,height,duration,nb_read_frames '" +
                       film + "'"),
              "64,48,5.800000,58\n");
  }
  EXPECT_EQ(fileCount(), 3u);
}

TEST_F(Animate, LeavesNothingBehindWhenItIsStopped) {
  for (const std::string name : {"f.mp4", "f.gif", "f_%d.png"}) {
    for (const int patience : {0, 2, 40, 150}) {
      if (name != "f_%d.png" && !isThere("ffmpeg")) continue;
      const Answer answer = animate({"--fps", "20", "-o", path(name)}, patience);
      EXPECT_EQ(answer.code, kCancelled) << name << " " << patience << answer.err;
      EXPECT_EQ(answer.err, "error: stopped; nothing was written\n");
      EXPECT_EQ(fileCount(), 1u) << name << " " << patience;
    }
  }
}

TEST_F(Animate, SaysWhatIsWrong) {
  const std::string out = path("f_%d.png");
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"-o", path("f.png")}, "has no place for the numbers of the pictures"},
      {{"-o", path("f_%d_%d.png")}, "has no place for the numbers"},
      {{"-o", path("f.avi")}, "this command writes .gif, .mp4, .webp or .png"},
      {{"-o", "-", "--format", "gif"}, "films are not written to standard output"},
      {{"-o", path("f.mp4"), "--size", "63x48"}, "MP4 films have even sides"},
      {{"-o", out, "--size", "640"}, "--size 640 is no size of a film; write one like 640x480"},
      {{"-o", out, "--size", "8x8"}, "is no size of a film"},
      {{"-o", out, "--fps", "0"}, "--fps must lie between 1 and 240"},
      {{"-o", out, "--fps", "nan"}, "--fps must lie between"},
      {{"-o", out, "--speed", "0"}, "--speed must be above 0"},
      {{"-o", out, "--hold", "-1"}, "--hold must lie between"},
      {{"-o", out, "--ease", "in"}, "--ease in is not known; it takes smooth or none"},
      {{"-o", out, "--steps", "2-9"}, "--steps 2-9 is not understood; the model has 3 steps"},
      {{"-o", out, "--steps", "0"}, "--steps 0 is not understood"},
      {{"-o", out, "--steps", "3-2"}, "--steps 3-2 is not understood"},
      {{"-o", out, "--view", "top"}, "--view top is not known"},
      {{"-o", out, "--camera", "1,2"}, "--camera: 1,2 is not understood"},
      {{"-o", out, "--camera", "1,2@0.5 3,4@0.5"}, "--camera: 3,4@0.5 is not understood"},
      {{"-o", out, "--camera", "1,2@0 3,100@1"}, "the elevation of a view"},
      {{"-o", out, "--camera", "1,2@0", "--turntable"}, "both say where the camera goes"},
      {{"-o", out, "--background", "white"}, "--background white is no colour"},
      {{"-o", out, "--speed", "0.001"}, "choose a higher --speed"},
  };
  for (const auto& [arguments, sentence] : cases) {
    const Answer answer = animate(arguments);
    EXPECT_EQ(answer.code, kBadUsage) << answer.err;
    EXPECT_NE(answer.err.find(sentence), std::string::npos)
        << answer.err << "should say: " << sentence;
  }
  EXPECT_EQ(fileCount(), 1u);
  const Answer answer = animate({"-o", path("nowhere/f.mp4")});
  EXPECT_EQ(answer.code, kCannotWrite) << answer.err;
  EXPECT_EQ(animate({"-o", path("nowhere/f_%d.png")}).code, kCannotWrite);
}

}  // namespace
}  // namespace kiri::cli
