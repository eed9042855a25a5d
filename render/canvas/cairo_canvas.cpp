// Draws scenes with cairo.
// SPDX-License-Identifier: MIT
#include "render/canvas/cairo_canvas.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <variant>

namespace kiri {
namespace {

class CairoCanvas {
 public:
  CairoCanvas(cairo_t* cr, const Scene& scene, double leastSeam)
      : cr_(cr), scene_(scene), leastSeam_(leastSeam) {}
  CairoCanvas(const CairoCanvas&) = delete;
  CairoCanvas& operator=(const CairoCanvas&) = delete;
  ~CairoCanvas() {
    for (const auto& [image, surface] : surfaces_) cairo_surface_destroy(surface);
  }

  void run() {
    if (scene_.background) {
      setColor(*scene_.background);
      cairo_rectangle(cr_, 0, 0, scene_.width, scene_.height);
      cairo_fill(cr_);
    }
    for (const Group& group : scene_.groups) {
      cairo_save(cr_);
      if (!group.clip.empty()) {
        for (const Loop& loop : group.clip) addChain(loop, true);
        cairo_clip(cr_);
      }
      for (const Item& item : group.items) {
        std::visit([&](const auto& shape) { draw(shape, item); }, item.shape);
      }
      cairo_restore(cr_);
    }
  }

 private:
  double down(double y) const { return scene_.height - y; }

  void setColor(Color color, double opacity = 1) {
    constexpr double kFull = 255;
    cairo_set_source_rgba(cr_, color.red / kFull, color.green / kFull, color.blue / kFull, opacity);
  }

  void addChain(const std::vector<Arc>& chain, bool isClosed) {
    if (chain.empty()) return;
    cairo_move_to(cr_, chain.front().start.x, down(chain.front().start.y));
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const Arc& arc = chain[i];
      if (arc.isCurved) {
        cairo_curve_to(cr_, arc.control1.x, down(arc.control1.y), arc.control2.x,
                       down(arc.control2.y), arc.end.x, down(arc.end.y));
      } else if (!isClosed || i + 1 < chain.size()) {
        cairo_line_to(cr_, arc.end.x, down(arc.end.y));
      }
    }
    if (isClosed) cairo_close_path(cr_);
  }

  void draw(const FillItem& item, const Item&) {
    for (const Loop& loop : item.loops) addChain(loop, true);
    setColor(item.fill.color, item.fill.opacity);
    cairo_fill_preserve(cr_);
    if (item.fill.image) {
      setImage(*item.fill.image, item.fill.imageToScene);
      cairo_fill_preserve(cr_);
    }
    cairo_new_path(cr_);
  }

  void draw(const StrokeItem& item, const Item& about) {
    for (const std::vector<Arc>& chain : item.chains) {
      addChain(chain, chain.size() > 1 && chain.front().start == chain.back().end);
    }
    const Stroke& stroke = item.stroke;
    cairo_set_line_width(cr_,
                         about.kind == "seam" ? std::max(stroke.width, leastSeam_) : stroke.width);
    cairo_set_line_cap(cr_,
                       stroke.cap == LineCap::Round ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
    cairo_set_line_join(cr_, CAIRO_LINE_JOIN_ROUND);
    cairo_set_dash(cr_, stroke.dashes.data(), static_cast<int>(stroke.dashes.size()), 0);
    setColor(stroke.color);
    cairo_stroke_preserve(cr_);
    if (stroke.image) {
      setImage(*stroke.image, stroke.imageToScene);
      cairo_stroke_preserve(cr_);
    }
    cairo_new_path(cr_);
  }

  void draw(const TextItem& item, const Item&) {
    cairo_select_font_face(cr_, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           item.isBold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cr_, item.height);
    cairo_text_extents_t extents;
    cairo_text_extents(cr_, item.text.c_str(), &extents);
    const double left = item.anchor == TextAnchor::Start    ? 0
                        : item.anchor == TextAnchor::Middle ? extents.x_advance / 2
                                                            : extents.x_advance;
    setColor(item.color);
    cairo_move_to(cr_, item.at.x - left, down(item.at.y));
    cairo_show_text(cr_, item.text.c_str());
    cairo_new_path(cr_);
  }

  /// The image as the source, lying in the scene as `imageToScene` says; its rim goes on beyond it.
  void setImage(const Image& image, const Affine& imageToScene) {
    cairo_pattern_t* pattern = cairo_pattern_create_for_surface(surfaceOf(image));
    const Affine toUnit{1.0 / image.width, 0, 0, -1.0 / image.height, 0, 1};
    const Affine toPage = compose({1, 0, 0, -1, 0, scene_.height}, compose(imageToScene, toUnit));
    cairo_matrix_t matrix;
    cairo_matrix_init(&matrix, toPage.a, toPage.b, toPage.c, toPage.d, toPage.e, toPage.f);
    if (cairo_matrix_invert(&matrix) == CAIRO_STATUS_SUCCESS) {
      cairo_pattern_set_matrix(pattern, &matrix);
      cairo_pattern_set_extend(pattern, CAIRO_EXTEND_PAD);
      cairo_set_source(cr_, pattern);
    }
    cairo_pattern_destroy(pattern);
  }

  /// cairo wants premultiplied native-endian words.
  cairo_surface_t* surfaceOf(const Image& image) {
    cairo_surface_t*& surface = surfaces_[&image];
    if (surface != nullptr) return surface;
    surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height);
    cairo_surface_flush(surface);
    unsigned char* rows = cairo_image_surface_get_data(surface);
    if (rows == nullptr) return surface;
    const int stride = cairo_image_surface_get_stride(surface);
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const std::size_t i = (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                               static_cast<std::size_t>(x)) *
                              4;
        const std::uint32_t alpha = image.rgba[i + 3];
        const auto times = [&](std::uint32_t c) { return (c * alpha + 127) / 255; };
        const std::uint32_t word = alpha << 24 | times(image.rgba[i]) << 16 |
                                   times(image.rgba[i + 1]) << 8 | times(image.rgba[i + 2]);
        std::copy_n(reinterpret_cast<const unsigned char*>(&word), 4,
                    rows + std::ptrdiff_t{y} * stride + std::ptrdiff_t{x} * 4);
      }
    }
    cairo_surface_mark_dirty(surface);
    return surface;
  }

  cairo_t* cr_;
  const Scene& scene_;
  double leastSeam_;
  std::map<const Image*, cairo_surface_t*> surfaces_;  ///< looked up; walked only to free them
};

}  // namespace

void drawScene(cairo_t* cr, const Scene& scene, double leastSeam) {
  CairoCanvas(cr, scene, leastSeam).run();
}

}  // namespace kiri
