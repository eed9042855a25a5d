// Files that hold scenes: sizes, text, textures, same bytes, no cracks.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include "render/canvas/number_text.h"
#include "render/canvas/png.h"
#include "render/canvas/write.h"
#include "render/scene/model_scene.h"
#include "render/scene/pattern_scene.h"
#include "tests/support/model_text.h"

namespace kiri {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

bool isThere(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

std::string fileBytes(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string tempFile(const std::string& name, const std::string& bytes) {
  const std::string path = ::testing::TempDir() + "kiri_canvas_" + name;
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

/// A sheet with many creases at odd angles, in one colour, on a ground that no mixture of it
/// resembles.
Scene crackScene() {
  Appearance looks;
  looks.front.color = looks.back.color = {0, 200, 0};
  looks.showEdges = looks.showCreases = false;
  const FoldedState state = test::run(
      "square 100; fold valley 13,0 71,100 left; unfold all; fold valley 0,37 100,51 left; unfold "
      "all;"
      "fold valley 0,88 100,11 left; unfold all; fold valley 55,0 54,100 left; unfold all;"
      "fold valley 3,0 97,100 left; unfold all");
  Scene scene = modelScene(state, looks, frontView(), {5.3, 1, ""});
  scene.background = Color{255, 0, 255};
  return scene;
}

/// Pixels well inside the square whose colour is not that of the paper.
int tintedPixels(const Image& image, const Scene& scene) {
  const double perMm = image.width / scene.width;
  const double rim = 5.3 * perMm + 2;
  int tinted = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (x + 0.5 < rim || y + 0.5 < rim || x + 0.5 > image.width - rim ||
          y + 0.5 > image.height - rim)
        continue;
      const std::size_t i = (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                             static_cast<std::size_t>(x)) *
                            4;
      const bool isPaper =
          image.rgba[i] <= 1 && std::abs(image.rgba[i + 1] - 200) <= 1 && image.rgba[i + 2] <= 1;
      if (!isPaper) ++tinted;
    }
  }
  return tinted;
}

TEST(Cracks, PngShowsNoGroundBetweenNeighbours) {
  const Scene scene = crackScene();
  for (const double dpi : {30.0, 72.0, 96.0, 150.0, 300.0}) {
    const Result<Image> image = decodePng(*writePng(scene, {dpi}));
    ASSERT_TRUE(image.isOk());
    EXPECT_EQ(tintedPixels(*image, scene), 0) << dpi << " dpi";
  }
}

TEST(Cracks, WithoutTheUnderlayThereWouldBe) {
  Scene scene = crackScene();
  ASSERT_EQ(scene.groups.front().id, "seams");
  scene.groups.erase(scene.groups.begin());
  EXPECT_GT(tintedPixels(*decodePng(*writePng(scene, {96})), scene), 50);
}

TEST(Cracks, SvgShowsNoneInAnotherRenderer) {
  if (!isThere("rsvg-convert")) GTEST_SKIP() << "rsvg-convert is not installed";
  const Scene scene = crackScene();
  const std::string svg = tempFile("cracks.svg", *writeSvg(scene));
  for (const char* dpi : {"96", "150"}) {
    const std::string png = svg + ".png";
    ASSERT_EQ(std::system(
                  ("rsvg-convert -d " + std::string(dpi) + " -p " + dpi + " " + svg + " -o " + png)
                      .c_str()),
              0);
    EXPECT_EQ(tintedPixels(*decodePng(fileBytes(png)), scene), 0) << dpi << " dpi";
  }
}

TEST(Cracks, PdfShowsNoneInAnotherRenderer) {
  if (!isThere("pdftoppm")) GTEST_SKIP() << "pdftoppm is not installed";
  const Scene scene = crackScene();
  const std::string pdf = tempFile("cracks.pdf", *writePdf(scene));
  for (const char* dpi : {"96", "150"}) {
    ASSERT_EQ(
        std::system(
            ("pdftoppm -singlefile -png -r " + std::string(dpi) + " " + pdf + " " + pdf).c_str()),
        0);
    EXPECT_EQ(tintedPixels(*decodePng(fileBytes(pdf + ".png")), scene), 0) << dpi << " dpi";
  }
}

TEST(Cracks, UnderlayDoesNotStandOutOfTheSilhouette) {
  const Scene scene = crackScene();
  const Image image = *decodePng(*writePng(scene, {300}));
  const double perMm = image.width / scene.width;
  const double rim = 5.3 * perMm - 1.5;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const bool isOutside = x + 0.5 < rim || y + 0.5 < rim || x + 0.5 > image.width - rim ||
                             y + 0.5 > image.height - rim;
      const std::size_t i = (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                             static_cast<std::size_t>(x)) *
                            4;
      if (isOutside) {
        ASSERT_EQ(image.rgba[i + 1], 0) << x << ", " << y;
      }
    }
  }
}

TEST(WriteSvg, HasTrueSizeGroupsAndNoTrash) {
  const FoldedState state =
      test::run("rectangle 80 60; fold valley 30,0 30,60 left; fold mountain 55,0 55,60 right");
  const std::string svg = *writeSvg(patternScene(state, {}, {5, 1, "A & <B> \"C\""}));
  EXPECT_TRUE(has(svg, "width=\"90mm\" height=\"70mm\" viewBox=\"0 0 90 70\""))
      << svg.substr(0, 400);
  EXPECT_TRUE(has(svg, "<title>A &amp; &lt;B&gt; &quot;C&quot;</title>"));
  for (const char* id : {"print", "cut", "mountain", "valley"})
    EXPECT_TRUE(has(svg, "<g id=\"" + std::string(id) + "\""));
  EXPECT_TRUE(has(svg, "data-assignment=\"M\" data-foldAngle=\"-180\""));
  EXPECT_FALSE(has(svg, "nan"));
  EXPECT_FALSE(has(svg, "inf"));
}

TEST(WriteSvg, KeepsCurvesAndYPointsUp) {
  Scene scene;
  scene.width = scene.height = 10;
  StrokeItem item;
  item.chains = {{Arc::cubic({0, 0}, {1, 2}, {3, 4}, {5, 0.5})}};
  scene.groups.push_back({"g", "g", {{item, "cut", "", {}}}, {}});
  EXPECT_TRUE(has(*writeSvg(scene), "d=\"M0,10C1,8 3,6 5,9.5\""));
}

TEST(WriteSvg, IsReadByAnXmlReader) {
  if (!isThere("python3")) GTEST_SKIP() << "python3 is not installed";
  const std::string svg = tempFile("well_formed.svg", *writeSvg(crackScene()));
  EXPECT_EQ(
      std::system(
          ("python3 -c \"import sys, xml.dom.minidom as m; m.parse(sys.argv[1])\" " + svg).c_str()),
      0);
}

TEST(WriteFiles, SameSceneGivesSameBytes) {
  const Scene a = crackScene();
  const Scene b = crackScene();
  EXPECT_EQ(*writeSvg(a), *writeSvg(b));
  EXPECT_EQ(*writePng(a), *writePng(b));
  EXPECT_EQ(*writePdf(a), *writePdf(b));
  EXPECT_FALSE(has(*writePdf(a), "CreationDate"));
}

TEST(WriteFiles, SceneWithoutSizeIsAnErrorInEveryFormat) {
  const Scene nothing;
  for (const auto& result : {writeSvg(nothing), writePng(nothing), writePdf(nothing)}) {
    ASSERT_FALSE(result.isOk());
    EXPECT_EQ(result.error().code, ErrorCode::BadValue);
    EXPECT_TRUE(has(result.error().message, "0 x 0 mm")) << result.error().message;
  }
}

TEST(WritePng, NotesItsResolutionAndFitsThePage) {
  Scene scene;
  scene.width = 50.8;
  scene.height = 25.4;
  const std::string bytes = *writePng(scene, {100});
  const Image image = *decodePng(bytes);
  EXPECT_EQ(image.width, 200);
  EXPECT_EQ(image.height, 100);
  EXPECT_EQ(image.rgba[3], 0) << "no background: transparent";
  const std::size_t at = bytes.find("pHYs");
  ASSERT_NE(at, std::string::npos);
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[at + 4 + i]); };
  EXPECT_EQ(byte(0) * 16777216 + byte(1) * 65536 + byte(2) * 256 + byte(3), 3937);
  const Result<std::string> large = writePng(scene, {100000});
  ASSERT_FALSE(large.isOk());
  EXPECT_TRUE(has(large.error().message, "at most 15000 dpi")) << large.error().message;
  EXPECT_FALSE(writePng(scene, {0}).isOk());
}

/// A texture of four colours, one in each quarter of the sheet.
std::shared_ptr<const Image> quarters() {
  Image image{64, 64, {}};
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const bool isLeft = x < 32;
      const bool isUpper = y < 32;
      image.rgba.insert(image.rgba.end(), {static_cast<std::uint8_t>(isLeft ? 250 : 0),
                                           static_cast<std::uint8_t>(isUpper ? 250 : 0), 100, 255});
    }
  }
  return std::make_shared<const Image>(std::move(image));
}

struct Rgb {
  int r, g, b;
};
Rgb pixel(const Image& image, const Scene& scene, Vec2 mm) {
  const auto x = static_cast<std::size_t>(mm.x * image.width / scene.width);
  const auto y = static_cast<std::size_t>((scene.height - mm.y) * image.height / scene.height);
  const std::size_t i = (y * static_cast<std::size_t>(image.width) + x) * 4;
  return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]};
}

void expectQuarter(const Image& image, const Scene& scene, Vec2 mm, bool isLeft, bool isUpper,
                   const char* what) {
  const Rgb p = pixel(image, scene, mm);
  EXPECT_NEAR(p.r, isLeft ? 250 : 0, 12) << what << " at " << mm.x << ", " << mm.y;
  EXPECT_NEAR(p.g, isUpper ? 250 : 0, 12) << what << " at " << mm.x << ", " << mm.y;
  EXPECT_NEAR(p.b, 100, 12) << what;
}

TEST(Textures, LieOnThePaperInEveryFormat) {
  Appearance looks;
  looks.textureBox = {{0, 0}, {100, 100}};
  looks.front.texture = looks.back.texture = quarters();
  // The left third is folded to the right: on it lies the back of the paper, mirrored.
  const FoldedState state = test::run("square 100; fold valley 30,0 30,100 left");
  const Scene scene = modelScene(state, looks, frontView(), {0, 1, ""});
  const auto check = [&](const Image& image, const char* what) {
    expectQuarter(image, scene, {65, 20}, false, false, what);  // front, paper (95, 20)
    expectQuarter(image, scene, {65, 80}, false, true, what);
    // The flap covers page x 0 to 30: paper 30 to 0; the back's image runs from right to left on
    // the paper, so that these are its right part.
    expectQuarter(image, scene, {10, 20}, false, false, what);
    expectQuarter(image, scene, {10, 80}, false, true, what);
    expectQuarter(image, scene, {45, 80}, false, true, what);
  };
  check(*decodePng(*writePng(scene, {100})), "png");
  if (isThere("rsvg-convert")) {
    const std::string svg = tempFile("texture.svg", *writeSvg(scene));
    ASSERT_EQ(std::system(("rsvg-convert -d 100 -p 100 " + svg + " -o " + svg + ".png").c_str()),
              0);
    check(*decodePng(fileBytes(svg + ".png")), "svg");
  }
  if (isThere("pdftoppm")) {
    const std::string pdf = tempFile("texture.pdf", *writePdf(scene));
    ASSERT_EQ(std::system(("pdftoppm -singlefile -png -r 100 " + pdf + " " + pdf).c_str()), 0);
    check(*decodePng(fileBytes(pdf + ".png")), "pdf");
  }
}

TEST(Textures, StandInAnSvgOnce) {
  Appearance looks;
  looks.textureBox = {{0, 0}, {100, 100}};
  looks.front.texture = looks.back.texture = quarters();
  const FoldedState state =
      test::run("square 100; fold valley 30,0 30,100 left; fold valley m:60,0 m:60,100 right");
  const std::string svg = *writeSvg(modelScene(state, looks, frontView()));
  const std::size_t first = svg.find("<image");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(svg.find("<image", first + 1), std::string::npos);
}

TEST(DecodePng, RefusesWhatIsNoPng) {
  EXPECT_FALSE(decodePng("").isOk());
  EXPECT_FALSE(decodePng("GIF89a").isOk());
  std::string bytes = *encodePng({2, 2, std::vector<std::uint8_t>(16, 77)}, 0);
  EXPECT_TRUE(decodePng(bytes).isOk());
  bytes.resize(bytes.size() / 2);
  EXPECT_FALSE(decodePng(bytes).isOk());
}

TEST(EncodePng, KeepsEveryPixelOfNoise) {
  Image image{97, 31, {}};
  std::uint32_t seed = 1;
  for (int i = 0; i < 97 * 31 * 4; ++i) {
    seed = seed * 1664525U + 1013904223U;
    image.rgba.push_back(static_cast<std::uint8_t>(seed >> 24));
  }
  const Image back = *decodePng(*encodePng(image, 300));
  EXPECT_EQ(back.width, 97);
  EXPECT_EQ(back.rgba, image.rgba);
}

TEST(NumberText, IsShortAndExactToItsDecimals) {
  EXPECT_EQ(numberText(0, 6), "0");
  EXPECT_EQ(numberText(-0.0000001, 6), "0");
  EXPECT_EQ(numberText(1.5, 6), "1.5");
  EXPECT_EQ(numberText(-12.0340004, 6), "-12.034");
  EXPECT_EQ(numberText(100, 6), "100");
  EXPECT_EQ(numberText(0.000001, 6), "0.000001");
}

TEST(WritePng, ABackgroundReachesTheLastRowAndColumn) {
  Scene scene;
  scene.width = 10.03;
  scene.height = 7.01;
  scene.background = Color{255, 250, 240};
  const Image image = *decodePng(*writePng(scene, {100}));
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    ASSERT_EQ(image.rgba[i + 3], 255) << "pixel " << i / 4;
    ASSERT_EQ(image.rgba[i + 2], 240) << "pixel " << i / 4;
  }
}

TEST(Png, ShadowIsAsDarkAsTheSumOfItsFills) {
  ViewSpec spec{20, 40};
  spec.hasShadow = true;
  Scene scene = *modelScene(test::run("square 100; fold valley 90 50,0 50,100 left"), {}, spec);
  scene.background = Color{255, 255, 255};
  std::vector<Region> fills;
  std::vector<Region> paper;
  double light = 255;
  for (const Group& group : scene.groups) {
    if (group.id != "shadow" && group.id != "paper") continue;
    for (const Item& item : group.items) {
      const FillItem& fill = std::get<FillItem>(item.shape);
      (group.id == "shadow" ? fills : paper).push_back({fill.loops});
      if (group.id == "shadow") light *= 1 - fill.fill.opacity;
    }
  }
  const Image image = *decodePng(*writePng(scene, {50}));
  const double pixel = scene.width / image.width;
  int asked = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const Vec2 middle{(x + 0.5) * pixel, scene.height - (y + 0.5) * pixel};
      const auto holds = [&](const Region& region) {
        return locate(region, middle, 2 * pixel) == Where::Inside;
      };
      const auto misses = [&](const Region& region) {
        return locate(region, middle, 2 * pixel) == Where::Outside;
      };
      if (!std::all_of(fills.begin(), fills.end(), holds)) continue;
      if (!std::all_of(paper.begin(), paper.end(), misses)) continue;
      const std::size_t at = static_cast<std::size_t>(y * image.width + x) * 4;
      EXPECT_NEAR(image.rgba[at], light, 4);
      EXPECT_EQ(image.rgba[at], image.rgba[at + 2]) << "grey";
      ++asked;
    }
  }
  EXPECT_GT(asked, 100);
}

}  // namespace
}  // namespace kiri
