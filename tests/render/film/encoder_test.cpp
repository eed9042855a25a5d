// Films as ffprobe and webpinfo see them; ffmpeg missing, failing, or not wanted any more.
// SPDX-License-Identifier: MIT
#include "render/film/encoder.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/scratch_folder.h"

namespace kiri {
namespace {

namespace fs = std::filesystem;

bool isThere(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

std::string answerOf(const std::string& command) {
  std::string out;
  FILE* pipe = ::popen(command.c_str(), "r");
  std::array<char, 4096> buffer = {};
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) out += buffer.data();
  ::pclose(pipe);
  return out;
}

/// What ffprobe says of a film: codec, width, height, seconds, frames.
std::string probed(const std::string& path) {
  return answerOf(
      "ffprobe -v error -count_frames -select_streams v -of csv=p=0 -show_entries "
      "stream=codec_name,width,height,duration,nb_read_frames '" +
      path + "'");
}

/// A square that goes from left to right.
Image frame(int index) {
  Image image{64, 48, {}};
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      const bool isPaper = x >= index && x < index + 20 && y > 10 && y < 30;
      for (const int c : {isPaper ? 200 : 255, isPaper ? 30 : 255, isPaper ? 40 : 255, 255}) {
        image.rgba.push_back(static_cast<std::uint8_t>(c));
      }
    }
  }
  return image;
}

class EncoderTest : public test::ScratchFolder {
 protected:
  void SetUp() override {
    ScratchFolder::SetUp();
    path_ = std::getenv("PATH");
  }
  void TearDown() override {
    ::setenv("PATH", path_.c_str(), 1);
    ScratchFolder::TearDown();
  }

  /// A program named ffmpeg that does what the text says, before any other.
  void standIn(const std::string& script) const {
    fs::create_directory(path("bin"));
    std::ofstream(path("bin/ffmpeg")) << "#!/bin/sh\n" << script;
    fs::permissions(path("bin/ffmpeg"), fs::perms::owner_all);
    ::setenv("PATH", (path("bin") + ":" + path_).c_str(), 1);
  }

  Status write(const std::string& name, FilmFormat format, int frames = 10) const {
    Result<Encoder> encoder = Encoder::start(path(name), {format, 64, 48, 25});
    if (!encoder.isOk()) return encoder.error();
    for (int i = 0; i < frames; ++i) {
      const Status added = encoder->add(frame(2 * i), i == 3 ? 6 : 1);
      if (!added.isOk()) return added;
    }
    return encoder->finish();
  }

 private:
  std::string path_;
};

TEST_F(EncoderTest, WritesFilmsThatFfprobeReadsWithEveryFrame) {
  if (!isThere("ffmpeg") || !isThere("ffprobe")) GTEST_SKIP() << "ffmpeg is not installed";
  const Status gif = write("a.gif", FilmFormat::Gif);
  ASSERT_TRUE(gif.isOk()) << gif.error().message;
  EXPECT_EQ(probed(path("a.gif")), "gif,64,48,0.600000,15\n");
  const Status mp4 = write("a.mp4", FilmFormat::Mp4);
  ASSERT_TRUE(mp4.isOk()) << mp4.error().message;
  EXPECT_EQ(probed(path("a.mp4")), "h264,64,48,0.600000,15\n");
  EXPECT_EQ(fileCount(), 2u) << "nothing else is left";
}

TEST_F(EncoderTest, WritesWebPThatWebpinfoAccepts) {
  if (!isThere("ffmpeg") || !isThere("webpinfo")) GTEST_SKIP() << "webp is not installed";
  ASSERT_TRUE(write("a.webp", FilmFormat::WebP).isOk());
  const std::string info = answerOf("webpinfo '" + path("a.webp") + "'");
  EXPECT_NE(info.find("Canvas size 64 x 48"), std::string::npos) << info;
  EXPECT_NE(info.find("No error detected."), std::string::npos) << info;
  int milliseconds = 0;
  for (std::size_t at = info.find("Duration: "); at != std::string::npos;
       at = info.find("Duration: ", at + 1)) {
    milliseconds += std::stoi(info.substr(at + 10));
  }
  EXPECT_EQ(milliseconds, 600);
}

TEST_F(EncoderTest, KeepsColours) {
  if (!isThere("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
  for (const auto& [name, format] :
       {std::pair{"a.gif", FilmFormat::Gif}, std::pair{"a.mp4", FilmFormat::Mp4}}) {
    ASSERT_TRUE(write(name, format).isOk());
    const std::string pixel =
        answerOf("ffmpeg -v error -i '" + path(name) +
                 "' -frames:v 1 -vf crop=2:2:8:20 -f rawvideo -pix_fmt rgb24 - | od -An -tu1 -N3");
    int red = 0;
    int green = 0;
    int blue = 0;
    ASSERT_EQ(std::sscanf(pixel.c_str(), "%d %d %d", &red, &green, &blue), 3) << pixel;
    EXPECT_NEAR(red, 200, 4) << name;
    EXPECT_NEAR(green, 30, 4) << name;
    EXPECT_NEAR(blue, 40, 4) << name;
  }
}

TEST_F(EncoderTest, GivesTheSameBytesForTheSameFrames) {
  if (!isThere("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
  for (const auto& [name, format] :
       {std::pair{"gif", FilmFormat::Gif}, std::pair{"mp4", FilmFormat::Mp4},
        std::pair{"webp", FilmFormat::WebP}}) {
    ASSERT_TRUE(write(std::string("a.") + name, format).isOk());
    ASSERT_TRUE(write(std::string("b.") + name, format).isOk());
    EXPECT_EQ(std::system(("cmp '" + path(std::string("a.") + name) + "' '" +
                           path(std::string("b.") + name) + "'")
                              .c_str()),
              0);
  }
}

TEST_F(EncoderTest, MakesSmallFilmsOfTheSameLength) {
  if (!isThere("ffmpeg") || !isThere("ffprobe")) GTEST_SKIP() << "ffmpeg is not installed";
  for (const bool isSmall : {false, true}) {
    EncoderOptions options{FilmFormat::Mp4, 64, 48, 25, isSmall};
    Result<Encoder> encoder = Encoder::start(path(isSmall ? "small.mp4" : "usual.mp4"), options);
    ASSERT_TRUE(encoder.isOk());
    for (int i = 0; i < 40; ++i) ASSERT_TRUE(encoder->add(frame(i)).isOk());
    ASSERT_TRUE(encoder->finish().isOk());
  }
  EXPECT_EQ(probed(path("small.mp4")), probed(path("usual.mp4")));
  EXPECT_LT(fs::file_size(path("small.mp4")), fs::file_size(path("usual.mp4")));
}

TEST_F(EncoderTest, SaysWhatToDoWithoutFfmpeg) {
  ::setenv("PATH", path("nowhere").c_str(), 1);
  const Status status = write("a.mp4", FilmFormat::Mp4);
  ASSERT_FALSE(status.isOk());
  EXPECT_EQ(status.error().code, ErrorCode::NotFound);
  EXPECT_NE(status.error().message.find("apt-get install ffmpeg"), std::string::npos);
  EXPECT_EQ(fileCount(), 0u);
}

TEST_F(EncoderTest, TellsWhatFfmpegSaidWhenItFailsAtOnceOrHalfWay) {
  std::ofstream(path("a.mp4")) << "the old film";
  for (const std::string script : {"echo one >&2; echo no such codec >&2; exit 3",
                                   "head -c 20000 >/dev/null; echo no such codec >&2; exit 1",
                                   "cat >/dev/null; echo no such codec >&2; exit 1"}) {
    standIn(script);
    const Status status = write("a.mp4", FilmFormat::Mp4, 200);
    ASSERT_FALSE(status.isOk()) << script;
    EXPECT_EQ(status.error().code, ErrorCode::Unwritable);
    EXPECT_NE(status.error().message.find("no such codec"), std::string::npos)
        << status.error().message;
    EXPECT_EQ(fileCount(), 2u) << "the old film and the stand-in";
    std::ifstream old(path("a.mp4"));
    std::string text;
    std::getline(old, text);
    EXPECT_EQ(text, "the old film");
  }
}

TEST_F(EncoderTest, StopsFfmpegAndLeavesNothingWhenItIsNotWantedAnyMore) {
  // The stand-in notes its number and would go on for a minute.
  standIn("echo $$ >'" + path("bin/number") + "'; cat >/dev/null; exec sleep 60");
  {
    Result<Encoder> encoder = Encoder::start(path("a.gif"), {FilmFormat::Gif, 64, 48, 25});
    ASSERT_TRUE(encoder.isOk());
    ASSERT_TRUE(encoder->add(frame(0)).isOk());
    int asked = 0;
    const Status status = encoder->finish([&](double) { return ++asked < 3; });
    EXPECT_EQ(status.error().code, ErrorCode::Cancelled);
  }
  EXPECT_EQ(fileCount(), 1u) << "only the stand-in";
  std::ifstream number(path("bin/number"));
  std::string process;
  if (std::getline(number, process)) EXPECT_FALSE(fs::exists("/proc/" + process));
}

TEST_F(EncoderTest, StopsWhileFfmpegTakesNothing) {
  standIn("exec sleep 60");
  Result<Encoder> encoder = Encoder::start(path("a.mp4"), {FilmFormat::Mp4, 64, 48, 25});
  ASSERT_TRUE(encoder.isOk());
  int asked = 0;
  const Status status = encoder->add(frame(0), 1000, [&](double) { return ++asked < 3; });
  ASSERT_FALSE(status.isOk());
  EXPECT_EQ(status.error().code, ErrorCode::Cancelled);
  EXPECT_EQ(asked, 3);
}

TEST_F(EncoderTest, RefusesPlacesAndSizesBeforeAnyWork) {
  EXPECT_EQ(Encoder::start(path("no/such/a.gif"), {}).error().code, ErrorCode::Unwritable);
  EXPECT_EQ(Encoder::start(path(""), {}).error().code, ErrorCode::Unwritable);
  EXPECT_EQ(Encoder::start(path("a.mp4"), {FilmFormat::Mp4, 63, 48, 25}).error().code,
            ErrorCode::BadValue);
  EXPECT_EQ(Encoder::start(path("a.gif"), {FilmFormat::Gif, 64, 48, 0}).error().code,
            ErrorCode::BadValue);
  EXPECT_EQ(fileCount(), 0u);
}

}  // namespace
}  // namespace kiri
