// Files made to break readers: nesting, bombs, numbers beyond sense. Each ends soon, in a sentence
// or a drawing. SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <ctime>
#include <string>

#include "io/patterns/pattern_file.h"

namespace kiri {
namespace {

std::string repeated(const std::string& part, int count) {
  std::string out;
  out.reserve(part.size() * static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) out += part;
  return out;
}

/// What is said of the file; "" when it was read. Fails when that takes long.
std::string saidOf(const std::string& text, const std::string& fileName) {
  const std::clock_t start = std::clock();
  const Result<PatternFile> file = readPattern(text, fileName);
  EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 5);
  if (!file) {
    EXPECT_EQ(file.error().message.rfind(fileName, 0), 0u) << file.error().message;
    return file.error().message;
  }
  return "";
}

constexpr int kMany = 200'000;

TEST(HostileFiles, DeepNestingEndsInASentence) {
  EXPECT_NE(saidOf(repeated("[", kMany), "a.fold"), "");
  EXPECT_NE(saidOf("{\"a\":" + repeated("{\"a\":", kMany), "a.fold"), "");
  EXPECT_NE(saidOf(repeated("<a>", kMany), "a.opx"), "");
  EXPECT_NE(saidOf("<svg>" + repeated("<g>", kMany), "a.svg"), "");
  const std::string line =
      R"(<object class="oripa.OriLineProxy"><void property="x0"><double>1</double></void>)";
  EXPECT_EQ(saidOf("<java>" + repeated(line, kMany / 10), "a.opx"), "");
}

TEST(HostileFiles, FramesThatInheritEachOtherInALongRowAreFollowedOnce) {
  std::string frames;
  for (int i = 0; i < kMany / 10; ++i) {
    if (i > 0) frames += ",";
    frames += R"({"frame_inherit":true,"frame_classes":["creasePattern"],"faceOrders":[],)"
              R"("frame_parent":)" +
              std::to_string(i) + "}";
  }
  EXPECT_NE(saidOf("{\"file_frames\":[" + frames + "]}", "a.fold"), "");
  EXPECT_EQ(saidOf(R"({"vertices_coords":[[0,0],[1,0]],"edges_vertices":[[0,1]],"file_frames":[)" +
                       frames + "]}",
                   "a.fold"),
            "");
}

TEST(HostileFiles, ManyFacesAtOneEdgeAreRolledOutSoon) {
  const std::string text =
      R"({"frame_classes":["foldedForm"],"vertices_coords":[[0,0,0],[1,0,0],[0,1,1]],)"
      R"("faces_vertices":[[0,1,2])" +
      repeated(",[1,0,2],[0,1,2]", kMany / 4) + "]}";
  EXPECT_EQ(saidOf(text, "a.fold"), "");
}

TEST(HostileFiles, NumbersBeyondSenseAreLeftOut) {
  EXPECT_NE(saidOf(R"({"vertices_coords":[[1e308,-1e308],[0,1e300]],"edges_vertices":[[0,1]]})",
                   "a.fold"),
            "");
  EXPECT_NE(saidOf(R"({"vertices_coords":[[1e999,0]],"edges_vertices":[[0,0]]})", "a.fold"), "");
  EXPECT_NE(saidOf("2 1e308 1e308 -1e308 0\n", "a.cp"), "");
  EXPECT_NE(saidOf("2 " + repeated("9", kMany) + " 0 1 1\n", "a.cp"), "");
  EXPECT_EQ(saidOf("0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nCutLine\n11\n1\n0\nCIRCLE\n10\n1e308\n40\n"
                   "1e308\n0\nEOF\n",
                   "a.dxf"),
            "");
}

TEST(HostileFiles, SplinesOfManyPointsAreDrawnCoarselyButSoon) {
  std::string spline = "0\nSECTION\n2\nENTITIES\n0\nSPLINE\n8\nCutLine\n71\n7\n";
  for (int i = 0; i < kMany / 10; ++i) {
    spline += "10\n" + std::to_string(i % 2 * 1000) + "\n20\n" + std::to_string(i) + "\n";
  }
  for (int i = 0; i < kMany / 10 + 8; ++i) spline += "40\n" + std::to_string(i) + "\n";
  saidOf(spline + "0\nENDSEC\n0\nEOF\n", "a.dxf");
}

TEST(HostileFiles, SymbolsThatUseEachOtherEndSoon) {
  std::string text = "<svg xmlns:xlink='http://www.w3.org/1999/xlink'><defs>";
  for (int i = 0; i < 30; ++i) {
    const std::string use = "<use xlink:href='#g" + std::to_string(i + 1) + "'/>";
    text += "<g id='g" + std::to_string(i) + "'>" + repeated(use, 10) + "</g>";
  }
  text += "<g id='g30'><line x2='1' stroke='red'/></g></defs><use xlink:href='#g0'/></svg>";
  saidOf(text, "a.svg");
}

TEST(HostileFiles, EntitiesThatMultiplyAreNotFollowed) {
  const std::string text =
      "<!DOCTYPE lolz [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;&a;&a;\">]><java>&b;</java>";
  EXPECT_NE(saidOf(text, "a.opx"), "");
  EXPECT_NE(saidOf(text, "a.svg"), "");
}

TEST(HostileFiles, OtherFilesAreRefusedWithWhatIsRead) {
  EXPECT_NE(saidOf("", "a.fold").find("empty"), std::string::npos);
  EXPECT_NE(saidOf("\xEF\xBB\xBF \n", "a").find("empty"), std::string::npos);
  EXPECT_NE(saidOf("%PDF-1.4", "a.pdf").find("FOLD, .cp, .opx, SVG and DXF"), std::string::npos);
  EXPECT_NE(saidOf("{\"a\": 1}", "a.ori").find("Oriedita"), std::string::npos);
}

}  // namespace
}  // namespace kiri
