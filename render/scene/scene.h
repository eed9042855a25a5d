// What to draw, in mm, before anyone has chosen a file format.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/vec.h"
#include "core/geometry/cubic.h"
#include "core/geometry/region.h"
#include "core/model/model.h"
#include "render/scene/image.h"

namespace kiri {

/// x' = a x + c y + e, y' = b x + d y + f (the order of SVG and cairo).
struct Affine {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
  constexpr Vec2 apply(Vec2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  constexpr Vec2 direction(Vec2 p) const { return {a * p.x + c * p.y, b * p.x + d * p.y}; }
};
/// first `second`, then `first`.
Affine compose(const Affine& first, const Affine& second);
Arc transformed(const Affine& map, const Arc& arc);

/// A plain colour, and over it an image whose unit square (0,0 lower left to 1,1 upper right)
/// `imageToScene` places.
struct Fill {
  Color color;
  std::shared_ptr<const Image> image;
  Affine imageToScene;
  double opacity = 1;  ///< of the colour; less than 1 only without an image
};

enum class LineCap { Butt, Round };

struct Stroke {
  Color color;
  double width = 0.25;         ///< mm
  std::vector<double> dashes;  ///< mm, drawn and left out in turn; empty: solid
  LineCap cap = LineCap::Round;
  std::shared_ptr<const Image> image;  ///< over the colour, as in Fill
  Affine imageToScene;
};

/// A filled region: loops closed, even-odd and non-zero fill agree.
struct FillItem {
  std::vector<Loop> loops;
  Fill fill;
};

/// Stroked chains of arcs; a chain that ends where it starts is closed.
struct StrokeItem {
  std::vector<std::vector<Arc>> chains;
  Stroke stroke;
};

enum class TextAnchor { Start, Middle, End };

struct TextItem {
  Vec2 at;            ///< baseline
  std::string text;   ///< UTF-8
  double height = 4;  ///< font size, mm
  TextAnchor anchor = TextAnchor::Start;
  bool isBold = false;
  Color color{0, 0, 0};
};

/// One thing to draw. `kind` says what it is (paper, seam, mountain, valley, border...), `id` is
/// unique in the scene or empty. `data` are facts for other programs: name and value (SVG writes
/// them as data-name="value").
struct Item {
  std::variant<FillItem, StrokeItem, TextItem> shape;
  std::string kind;
  std::string id;
  std::vector<std::pair<std::string, std::string>> data;
};

/// Items that belong together: a layer for cutters and drawing programs.
struct Group {
  std::string id;     ///< unique in the scene, an XML name
  std::string label;  ///< for people
  std::vector<Item> items;
  std::vector<Loop> clip;  ///< only what lies inside is drawn; empty: everything
};

/// A picture of width x height mm, x to the right, y up from the lower left corner. Groups are
/// drawn in order.
struct Scene {
  double width = 0;
  double height = 0;
  std::string title;
  std::string description;
  std::optional<Color> background;  ///< none: transparent
  std::vector<Group> groups;
};

}  // namespace kiri
