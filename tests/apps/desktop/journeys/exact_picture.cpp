// The window against the exact picture that needs no window.
// SPDX-License-Identifier: MIT
#include <QImage>
#include <cstdlib>

#include "render/canvas/rasterise.h"
#include "render/scene/model_scene.h"
#include "tests/apps/desktop/journeys/journey.h"

namespace kiri::desktop {
namespace {

constexpr int kLine = 2;        // pixels on both sides of a border
constexpr int kSoftLight = 48;  // of all three channels together, at most

Image exactPicture(const Session& session, const PaneMap& map) {
  const Document& document = session.document();
  Appearance look = appearanceOf(document.model());
  look.showEdges = false;
  look.showCreases = false;
  ModelSceneOptions options;
  options.margin = 0;
  const Vec2 half = map.size / (2 * map.pixelsPerMm);
  options.box = Box{map.centre - half, map.centre + half};
  Scene scene = modelScene(*document.state(), look, map.frame, options);
  const QColor ground = theme().ground;
  scene.background =
      Color{static_cast<std::uint8_t>(ground.red()), static_cast<std::uint8_t>(ground.green()),
            static_cast<std::uint8_t>(ground.blue())};
  Result<Image> image =
      rasterise(scene, static_cast<int>(map.size.x), static_cast<int>(map.size.y));
  KIRI_CHECK(image.isOk(), "a pane is a picture of a possible size");
  return std::move(*image);
}

QRgb at(const Image& image, int x, int y) {
  const auto i = (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                  static_cast<std::size_t>(x)) *
                 4;
  return qRgb(image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]);
}

bool isPlain(const Image& image, int x, int y) {
  for (int dy = -kLine; dy <= kLine; ++dy) {
    for (int dx = -kLine; dx <= kLine; ++dx) {
      if (at(image, x + dx, y + dy) != at(image, x, y)) return false;
    }
  }
  return true;
}

int apart(QRgb a, QRgb b) {
  return std::abs(qRed(a) - qRed(b)) + std::abs(qGreen(a) - qGreen(b)) +
         std::abs(qBlue(a) - qBlue(b));
}

}  // namespace

double Journey::differenceFromExactPicture() {
  take(ToolId::Measure);  // draws nothing where the pointer is not
  QTest::mouseMove(&window->sheetView(), QPoint(2, 2));
  settle();
  QTest::qWait(100);
  const Image exact = exactPicture(session(), session().camera().map());
  const QImage shown = model()->grab().toImage().scaled(exact.width, exact.height);
  int looked = 0;
  int differ = 0;
  for (int y = kLine; y + kLine < exact.height; ++y) {
    for (int x = kLine; x + kLine < exact.width; ++x) {
      if (!isPlain(exact, x, y)) continue;
      ++looked;
      differ += apart(at(exact, x, y), shown.pixel(x, y)) > kSoftLight ? 1 : 0;
    }
  }
  return looked == 0 ? 1 : static_cast<double>(differ) / looked;
}

}  // namespace kiri::desktop
