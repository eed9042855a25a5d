// The measures of an outline by name.
// SPDX-License-Identifier: MIT
#include "apps/cli/measure_names.h"

#include <utility>

#include "core/base/text.h"

namespace kiri::cli {

namespace {

using NamedMeasures = std::vector<NamedMeasure>;

NamedMeasures sizes(const LeafMeasures& m) {
  return {
      {"length", "mm", "length, petiole to apex", m.length, "petiole to apex, along the axis"},
      {"fullLength", "mm", "length of all of it", m.fullLength,
       "extent along the axis, also below the petiole"},
      {"width", "mm", "width", m.width, "extent across the axis"},
      {"area", "mm2", "area", m.area, "of the paper, without holes"},
      {"perimeter", "mm", "perimeter", m.perimeter, "of the outer contour"},
      {"major", "mm", "long axis of the ellipse", m.major,
       "long axis of the fitted ellipse: same area and moments (ImageJ)"},
      {"minor", "mm", "short axis of the ellipse", m.minor,
       "short axis of the fitted ellipse (ImageJ)"},
      {"feret", "mm", "greatest diameter", m.feret, "greatest distance of two points (ImageJ)"}};
}

NamedMeasures shapes(const LeafMeasures& m) {
  return {
      {"aspectRatio", "", "aspect ratio, length to width", m.aspectRatio, "length / width"},
      {"fullAspectRatio", "", "aspect ratio of all of it", m.fullAspectRatio, "fullLength / width"},
      {"circularity", "", "circularity, 4π area / perimeter²", m.circularity,
       "4 pi area / perimeter^2 (ImageJ)"},
      {"roundness", "", "roundness, 4 area / π long axis²", m.roundness,
       "4 area / (pi major^2) (ImageJ)"},
      {"solidity", "", "solidity, area to area of the hull", m.solidity,
       "area / area of the convex hull (ImageJ)"},
      {"perimeterRatio", "", "perimeter to perimeter of the hull", m.perimeterRatio,
       "perimeter / perimeter of the convex hull"},
      {"apexAngle", "deg", "angle of the apex", m.apexAngle,
       "at the apex, to the margin beside the axis at 3/4 of the length (Manual of Leaf "
       "Architecture)"},
      {"baseAngle", "deg", "angle of the base", m.baseAngle,
       "at the petiole, to the margin beside the axis at 1/4 of the length (Manual of Leaf "
       "Architecture)"}};
}

NamedMeasures symmetries(const LeafMeasures& m) {
  return {
      {"asymmetry", "mm", "greatest distance to the mirror image", m.asymmetry,
       "greatest distance of the contour to its mirror image in the axis"},
      {"leftArea", "mm2", "area left of the axis", m.leftArea,
       "left of the axis, seen from petiole to apex"},
      {"rightArea", "mm2", "area right of the axis", m.rightArea, "right of the axis"},
      {"leftWidth", "mm", "width left of the axis", m.leftWidth, "extent to the left of the axis"},
      {"rightWidth", "mm", "width right of the axis", m.rightWidth,
       "extent to the right of the axis"},
      {"areaAsymmetry", "", "unevenness of the areas", m.areaAsymmetry,
       "|right - left| / mean of both (FA2 of Palmer and Strobeck 1986)"},
      {"widthAsymmetry", "", "unevenness of the widths", m.widthAsymmetry,
       "|right - left| / mean of both (FA2 of Palmer and Strobeck 1986)"}};
}

NamedMeasures counts(const LeafMeasures& m, double prominence) {
  return {{"lobes", "", "lobes", m.lobeCount,
           "tips that stand out by " + text(prominence) + " of the longest radius"},
          {"sinuses", "", "sinuses", m.sinusCount, "nearest points between those tips"},
          {"royerLobes", "", "lobes by Royer's rule", m.royerLobeCount,
           "tips whose sinus reaches more than 0.25 down their axis to the petiole (Royer et al. "
           "2005); 0: unlobed"},
          {"royerTeeth", "", "teeth by Royer's rule", m.royerToothCount,
           "the other tips but the apex (Royer et al. 2005)"}};
}

/// "oiv607Right": OIV's list for grape varieties, on either side.
NamedMeasures oivOf(const LeafMeasures& m) {
  NamedMeasures out;
  const auto add = [&out](const OivMeasure& measure, const char* side,
                          const std::optional<double>& value) {
    if (!value) return;
    std::string convention =
        std::string("OIV ") + std::to_string(measure.code) + ": " + measure.name;
    if (measure.isAngle) {
      convention += ", class " + std::to_string(oivAngleClass(*value)) + " of 1, 3, 5, 7, 9";
    }
    out.push_back({"oiv" + std::to_string(measure.code) + side, measure.isAngle ? "deg" : "mm",
                   std::string(measure.name) + (*side == 'R' ? ", right" : ", left"), *value,
                   std::move(convention)});
  };
  for (const OivMeasure& measure : m.oiv) {
    add(measure, "Right", measure.right);
    add(measure, "Left", measure.left);
  }
  return out;
}

}  // namespace

std::vector<NamedMeasure> namedMeasures(const LeafMeasures& m, double prominence) {
  NamedMeasures all;
  for (NamedMeasures part : {sizes(m), shapes(m), symmetries(m), counts(m, prominence), oivOf(m)}) {
    for (NamedMeasure& measure : part) all.push_back(std::move(measure));
  }
  return all;
}

}  // namespace kiri::cli
