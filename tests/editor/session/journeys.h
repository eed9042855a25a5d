// Whole journeys of a person through the program, for a session without a window and for the real
// window alike: the same hand, the same paper.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "editor/session/session.h"

namespace kiri::test {

/// What a person can do. Places are mm: of the model frame (z = 0) in the model pane, of the paper
/// frame in the sheet pane.
class Person {
 public:
  virtual ~Person() = default;
  virtual Session& session() = 0;
  virtual void take(ToolId tool) = 0;
  /// `isFree`: only the start of the drag may snap.
  virtual void drag(Pane pane, Vec2 from, Vec2 to, bool isFree = false) = 0;
  virtual void click(Pane pane, Vec2 at) = 0;
  virtual void press(Key key) = 0;
  virtual void press(char key) = 0;
  /// A field of the bar, by its id; for a choice the number of the option.
  virtual void set(const std::string& field, double value) = 0;
  /// "unfold-all", "refold-all", "undo"...: a command of menus and keys.
  virtual void command(const std::string& name) = 0;
  /// Until nothing is being computed.
  virtual void wait() = 0;
  /// Snaps are suspended while this is true.
  virtual void holdControl(bool isHeld) = 0;
};

/// Folds along a line drawn on the sheet from a snapped start towards a free end, so that the paper
/// at `moving` moves; true when the step was made.
inline bool foldOnSheet(Person& person, Vec2 from, Vec2 to, char type, Vec2 moving) {
  const std::size_t before = person.session().document().count();
  person.take(ToolId::Line);
  person.drag(Pane::Sheet, from, to, true);
  person.press(type);
  person.wait();
  const auto movesIt = [&] {
    const Shown shown = person.session().shown();
    const auto facet = facetAt(shown.state->pattern, moving);
    return facet && facet->index < shown.tints.size() &&
           shown.tints[facet->index] == FacetTint::Pale;
  };
  if (!movesIt()) {
    person.press(Key::Tab);
    person.wait();
  }
  if (!movesIt()) return false;
  person.press(Key::Enter);
  person.wait();
  return person.session().document().count() == before + 1;
}

/// The veins and anti-veins of one half of Figure 7.2 a, as examples/leaf_palmate.kiri has them:
/// where the line ends, and paper beside it that moves. The other half is the mirror image.
inline const std::vector<std::pair<Vec2, Vec2>>& palmateLines() {
  static const std::vector<std::pair<Vec2, Vec2>> lines = {{{153.9641, 200}, {106.2135, 19.0103}},
                                                           {{196.6838, 200}, {109.6351, 17.5261}},
                                                           {{200, 101.7607}, {114.7455, 13.5118}},
                                                           {{200, 66.6917}, {117.197, 10.2109}},
                                                           {{200, 18.1731}, {119.8185, 2.6884}}};
  return lines;
}

inline const std::vector<Vec2>& palmateMargin() {
  static const std::vector<Vec2> controls = {
      {70.8924, 136.9407},  {85.2197, 140.6254},  {100, 140},          {110.2573, 133.306},
      {116.7564, 119.2283}, {121.1132, 102.8554}, {123.2736, 85.074},  {125.5245, 74.1287},
      {127.3512, 64.4353},  {128.3909, 52.2896},  {125.9022, 37.4076}, {127.1667, 30.1717},
      {129.7868, 23.272}};
  return controls;
}

/// From a blank sheet of 200 mm to the folded palmate leaf; the name of the line that failed, or
/// nothing.
inline std::string foldPalmateLeaf(Person& person) {
  if (!foldOnSheet(person, {100, 0}, {100, 200}, 'm', {50, 100})) return "mid-vein";
  person.command("unfold-all");
  person.wait();
  for (const bool isLeft : {false, true}) {
    const auto sided = [&](Vec2 p) { return isLeft ? Vec2{200 - p.x, p.y} : p; };
    char type = 'v';  // as seen on the sheet: each fold turns the flap over
    for (const auto& [end, moving] : palmateLines()) {
      const char seen = std::exchange(type, type == 'v' ? 'm' : 'v');
      if (!foldOnSheet(person, {100, 0}, sided(end), seen, sided(moving))) {
        return std::string(isLeft ? "left" : "right") + " line to " + std::to_string(end.x) + "," +
               std::to_string(end.y);
      }
    }
  }
  person.command("refold-all");
  person.wait();
  return {};
}

/// Cuts the margin through all layers and keeps the leaf.
inline void cutPalmateMargin(Person& person) {
  person.take(ToolId::CurveCut);
  person.holdControl(true);
  for (const Vec2 control : palmateMargin()) person.click(Pane::Model, control);
  person.holdControl(false);
  person.press(Key::Enter);  // the curve is complete
  person.wait();
  if (person.session().canCommit()) person.press(Key::Enter);
  person.wait();
}

}  // namespace kiri::test
