// How paper and lines look in pictures.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "core/geometry/cubic.h"
#include "core/model/model.h"
#include "render/scene/image.h"

namespace kiri {

/// How the kinds of lines are told apart.
enum class LineStyle {
  Thesis,   ///< colours of the thesis: mountain blue, valley red
  Diagram,  ///< black and white, the dashes of printed diagrams: valley dashed, mountain
            ///< dash-dot-dot, cut dotted
  Program,  ///< colours that origami programs read (Origami Simulator, Rabbit Ear): mountain red,
            ///< valley blue, cut green
  Safe,     ///< told apart by all eyes: mountain dark blue with dash-dot-dot, valley orange and
            ///< dashed, cut dark purple
};

/// How one side of the paper looks.
struct SideLook {
  Color color;
  std::shared_ptr<const Image> texture;  ///< covers Appearance::textureBox; none: plain colour
};

/// How paper and lines look. Widths in mm on the finished picture.
struct Appearance {
  SideLook front{{90, 140, 70}, nullptr};
  SideLook back{{214, 226, 190}, nullptr};
  /// Box of the uncut sheet, paper frame. A texture fills it; that of the back is seen upright from
  /// the back when the sheet is turned over about a vertical line.
  Box textureBox{{0, 0}, {150, 150}};
  LineStyle lineStyle = LineStyle::Thesis;
  double edgeWidth = 0.35;   ///< visible borders of paper, hinges that are folded, tears
  double creaseWidth = 0.2;  ///< creases that lie flat again
  double drawnWidth = 0.5;   ///< the next line, on sheets of steps; lines of the crease pattern
  Color edgeColor{30, 30, 30};
  Color creaseColor{75, 85, 80};
  bool showEdges = true;
  bool showCreases = true;  ///< creases that lie flat again, and added edges
  bool isShaded = false;    ///< facets are the darker the more they are turned away
  double gridSpacing = 0;   ///< mm between the lines of a grid behind the paper; 0: none
};

/// Colours of a model and the box of its sheet. Textures are not read: put them into front.texture
/// and back.texture (decodePng in render/canvas/png.h reads one). A sheet that is no sheet gives
/// the default box.
Appearance appearanceOf(const Model& model);

}  // namespace kiri
