// SPDX-License-Identifier: MIT
#include "editor/document/step_slots.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace kiri {
namespace {

constexpr double kFarthest = 100000;  ///< mm; larger sheets are not folded
constexpr double kMostLayers = 10000;
constexpr double kMostTurn = 3600;

template <class T>
T& as(Step& step) {
  return std::get<T>(step.action);
}

/// The names in the order in which they are written, parted by commas; none when the lines are
/// named by places, or in a way that cannot be taken apart again.
std::optional<std::string> listOf(const std::vector<FoldLineName>& lines) {
  std::string list;
  for (const FoldLineName& line : lines) {
    const std::string* name = std::get_if<std::string>(&line);
    if (name == nullptr || name->empty() || name->find(',') != std::string::npos ||
        name->front() == ' ' || name->back() == ' ') {
      return std::nullopt;
    }
    list += (list.empty() ? "" : ", ") + *name;
  }
  return list;
}

std::vector<FoldLineName> namesIn(const std::string& list) {
  std::vector<FoldLineName> names;
  std::size_t from = 0;
  while (from <= list.size()) {
    const std::size_t to = std::min(list.find(',', from), list.size());
    const std::size_t first = list.find_first_not_of(' ', from);
    if (first < to)
      names.emplace_back(list.substr(first, list.find_last_not_of(' ', to - 1) + 1 - first));
    from = to + 1;
  }
  return names;
}

/// Collects the slots of one step. A number is reached by a function that gives a reference to it.
class Collecting {
 public:
  explicit Collecting(const Step& step) : step_(step) {}

  std::vector<StepSlot> collected() {
    std::visit([this](const auto& action) { collect(action); }, step_.action);
    addText({"title", {KIRI_TEXT("editor/document", "Title"), {}}},
            [](Step& step) -> std::string& { return step.title; });
    addText({"notes", {KIRI_TEXT("editor/document", "Notes"), {}}},
            [](Step& step) -> std::string& { return step.notes; });
    return std::move(slots_);
  }

 private:
  using Words = std::vector<Phrase>;

  void collect(const FoldStep& fold) {
    addText({"name", {KIRI_TEXT("editor/document", "Name"), {}}},
            [](Step& step) -> std::string& { return as<FoldStep>(step).name; });
    addChoice({"type", {KIRI_TEXT("editor/document", "Type"), {}}},
              {{KIRI_TEXT("editor/document", "Valley"), {}},
               {KIRI_TEXT("editor/document", "Mountain"), {}}},
              [](Step& step) -> FoldType& { return as<FoldStep>(step).type; });
    addAngle({"angle", {KIRI_TEXT("editor/document", "Angle"), {}}}, 0,
             [](Step& step) -> double& { return as<FoldStep>(step).angle; });
    addLine([](Step& step) -> DrawnLine& { return as<FoldStep>(step).line; });
    addSide(fold.moving);
    addLayers([](Step& step) -> LayerChoice& { return as<FoldStep>(step).layers; }, {});
  }

  void collect(const AngleStep& angle) {
    if (std::holds_alternative<std::string>(angle.line)) {
      addText({"line", {KIRI_TEXT("editor/document", "Fold"), {}}}, [](Step& step) -> std::string& {
        return std::get<std::string>(as<AngleStep>(step).line);
      });
    } else {
      addPoint("line",
               {{KIRI_TEXT("editor/document", "Place on the crease, x"), {}},
                {KIRI_TEXT("editor/document", "Place on the crease, y"), {}}},
               [](Step& step) -> Vec2& { return std::get<Place>(as<AngleStep>(step).line).point; });
    }
    addAngle({"angle", {KIRI_TEXT("editor/document", "Angle"), {}}}, -180,
             [](Step& step) -> double& { return as<AngleStep>(step).angle; });
  }

  void collect(const UnfoldStep&) { collectGroup<UnfoldStep>(); }
  void collect(const RefoldStep&) { collectGroup<RefoldStep>(); }
  void collect(const TearStep&) { collectPath<TearStep>(); }
  void collect(const MendStep&) { collectPath<MendStep>(); }

  void collect(const AddEdgeStep&) {
    addLine([](Step& step) -> DrawnLine& { return as<AddEdgeStep>(step).line; });
    addLayers([](Step& step) -> LayerChoice& { return as<AddEdgeStep>(step).layers; }, {});
  }

  void collect(const StraightCutStep& cut) {
    addLine([](Step& step) -> DrawnLine& { return as<StraightCutStep>(step).line; });
    addLayers([](Step& step) -> LayerChoice& { return as<StraightCutStep>(step).layers; },
              throughFrom(cut.line.frame));
  }

  void collect(const CurveCutStep& cut) {
    addSwitch({"closed", {KIRI_TEXT("editor/document", "Closed curve"), {}}},
              [](Step& step) -> bool& { return as<CurveCutStep>(step).isClosed; });
    addChoice({"ends", {KIRI_TEXT("editor/document", "Ends"), {}}},
              {{KIRI_TEXT("editor/document", "At the first and last point"), {}},
               {KIRI_TEXT("editor/document", "Free"), {}}},
              [](Step& step) -> SplineEnds& { return as<CurveCutStep>(step).ends; });
    addPoints(cut.controls.size(), "control",
              [](Step& step) -> std::vector<Vec2>& { return as<CurveCutStep>(step).controls; });
    addLayers([](Step& step) -> LayerChoice& { return as<CurveCutStep>(step).layers; },
              throughFrom(cut.frame));
  }

  void collect(const TurnOverStep&) {
    addChoice({"axis", {KIRI_TEXT("editor/document", "Axis"), {}}},
              {{KIRI_TEXT("editor/document", "Vertical"), {}},
               {KIRI_TEXT("editor/document", "Horizontal"), {}}},
              [](Step& step) -> TurnAxis& { return as<TurnOverStep>(step).axis; });
  }

  void collect(const RotateStep& rotate) {
    addNumber({"degrees", {KIRI_TEXT("editor/document", "Turn"), {}}}, -kMostTurn, kMostTurn, "°",
              [](Step& step) -> double& { return as<RotateStep>(step).degrees; });
    if (!rotate.about) return;
    addPoint("about",
             {{KIRI_TEXT("editor/document", "About x"), {}},
              {KIRI_TEXT("editor/document", "About y"), {}}},
             [](Step& step) -> Vec2& { return *as<RotateStep>(step).about; });
  }

  void collect(const MoveStep&) {
    addPoint("by",
             {{KIRI_TEXT("editor/document", "To the right"), {}},
              {KIRI_TEXT("editor/document", "Upwards"), {}}},
             [](Step& step) -> Vec2& { return as<MoveStep>(step).by; });
  }

  void collect(const PatternStep&) {
    addText({"name", {KIRI_TEXT("editor/document", "Name"), {}}},
            [](Step& step) -> std::string& { return as<PatternStep>(step).name; });
    addSwitch({"folded", {KIRI_TEXT("editor/document", "Folded"), {}}},
              [](Step& step) -> bool& { return as<PatternStep>(step).isFolded; });
  }

  template <class T>
  void collectGroup() {
    const auto lines = [](Step& step) -> std::vector<FoldLineName>& { return as<T>(step).lines; };
    addChoice({"sequence", {KIRI_TEXT("editor/document", "Sequence"), {}}},
              {{KIRI_TEXT("editor/document", "In order"), {}},
               {KIRI_TEXT("editor/document", "All together"), {}}},
              [](Step& step) -> Sequence& { return as<T>(step).sequence; });
    const std::optional<std::string> list = listOf(lines(step_));
    if (!list) return;
    Field field =
        fieldOf({"lines", {KIRI_TEXT("editor/document", "Folds"), {}}}, Field::Kind::Text);
    field.text = *list;
    field.help = {KIRI_TEXT("editor/document", "Names, parted by commas; empty: all folds"), {}};
    add(std::move(field),
        [lines](Step& step, const FieldValue& value) { lines(step) = namesIn(value.text); });
  }

  template <class T>
  void collectPath() {
    const auto points = [](Step& step) -> std::vector<Vec2>& { return as<T>(step).path.points; };
    addPoints(points(step_).size(), "point", points);
    addLayers([](Step& step) -> LayerChoice& { return as<T>(step).layers; }, OwnEdges{});
  }

  struct Label {
    std::string id;
    Phrase phrase;
  };

  static Field fieldOf(Label label, Field::Kind kind) {
    Field field;
    field.id = std::move(label.id);
    field.label = std::move(label.phrase);
    field.kind = kind;
    return field;
  }

  void add(Field field, std::function<void(Step&, const FieldValue&)> set) {
    slots_.push_back({std::move(field), std::move(set)});
  }

  template <class Reach>
  void addText(Label label, Reach reach) {
    Field field = fieldOf(std::move(label), Field::Kind::Text);
    field.text = reach(step_);
    field.hasLines = field.id == "notes";
    add(std::move(field),
        [reach](Step& step, const FieldValue& value) { reach(step) = value.text; });
  }

  template <class Reach>
  void addNumber(Label label, double least, double most, const char* unit, Reach reach) {
    Field field = fieldOf(std::move(label), Field::Kind::Number);
    field.value = reach(step_);
    // What is there can be kept, also from a file that goes further.
    field.least = std::min(least, field.value);
    field.most = std::max(most, field.value);
    field.unit = unit;
    add(std::move(field),
        [reach](Step& step, const FieldValue& value) { reach(step) = value.number; });
  }

  template <class Reach>
  void addAngle(Label label, double least, Reach reach) {
    addNumber(std::move(label), least, 180, "°", reach);
  }

  /// What the two coordinates of a point are called.
  struct PointLabel {
    Phrase x;
    Phrase y;
  };

  template <class Reach>
  void addPoint(const std::string& id, PointLabel label, Reach reach) {
    addNumber({id + ".x", std::move(label.x)}, -kFarthest, kFarthest, "mm",
              [reach](Step& step) -> double& { return reach(step).x; });
    addNumber({id + ".y", std::move(label.y)}, -kFarthest, kFarthest, "mm",
              [reach](Step& step) -> double& { return reach(step).y; });
  }

  template <class Reach>
  void addLine(Reach reach) {
    addPoint("from",
             {{KIRI_TEXT("editor/document", "From x"), {}},
              {KIRI_TEXT("editor/document", "From y"), {}}},
             [reach](Step& step) -> Vec2& { return reach(step).from; });
    addPoint(
        "to",
        {{KIRI_TEXT("editor/document", "To x"), {}}, {KIRI_TEXT("editor/document", "To y"), {}}},
        [reach](Step& step) -> Vec2& { return reach(step).to; });
  }

  template <class Reach>
  void addPoints(std::size_t count, const std::string& id, Reach reach) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::string number = std::to_string(i + 1);
      std::string pointId = id;
      pointId.append(".").append(number);
      addPoint(pointId,
               {{KIRI_TEXT("editor/document", "Point %1, x"), {number}},
                {KIRI_TEXT("editor/document", "Point %1, y"), {number}}},
               [reach, i](Step& step) -> Vec2& { return reach(step)[i]; });
    }
  }

  template <class Reach>
  void addSwitch(Label label, Reach reach) {
    Field field = fieldOf(std::move(label), Field::Kind::Switch);
    field.value = reach(step_) ? 1 : 0;
    field.most = 1;
    add(std::move(field),
        [reach](Step& step, const FieldValue& value) { reach(step) = value.number != 0; });
  }

  template <class Reach>
  void addChoice(Label label, Words words, Reach reach) {
    using Choice = std::remove_reference_t<decltype(reach(step_))>;
    add(choiceOf(std::move(label), std::move(words), static_cast<int>(reach(step_))),
        [reach](Step& step, const FieldValue& value) {
          reach(step) = static_cast<Choice>(static_cast<int>(value.number));
        });
  }

  static Field choiceOf(Label label, Words words, int chosen) {
    Field field = fieldOf(std::move(label), Field::Kind::Choice);
    field.value = chosen;
    field.most = static_cast<double>(words.size()) - 1;
    field.options = std::move(words);
    return field;
  }

  /// By the direction of the line, or still the paper that was pointed at when the fold was made.
  void addSide(const MovingSide& now) {
    std::vector<MovingSide> sides{Hand::Left, Hand::Right};
    Words words{{KIRI_TEXT("editor/document", "Left of the line"), {}},
                {KIRI_TEXT("editor/document", "Right of the line"), {}}};
    int chosen = now == sides[1] ? 1 : 0;
    if (!std::holds_alternative<Hand>(now)) {
      chosen = static_cast<int>(sides.size());
      sides.push_back(now);
      words.push_back({KIRI_TEXT("editor/document", "The paper that was chosen"), {}});
    }
    add(choiceOf({"moving", {KIRI_TEXT("editor/document", "Moving side"), {}}}, std::move(words),
                 chosen),
        [sides](Step& step, const FieldValue& value) {
          as<FoldStep>(step).moving = sides[static_cast<std::size_t>(value.number)];
        });
  }

  /// Cuts drawn on the model may go straight down.
  static std::optional<LayerChoice> throughFrom(Frame frame) {
    return frame == Frame::Model ? std::optional<LayerChoice>(ThroughAll{}) : std::nullopt;
  }

  /// All, the uppermost, and what else there is: `special` to this kind of step, layers picked one
  /// by one.
  template <class Reach>
  void addLayers(Reach reach, const std::optional<LayerChoice>& special) {
    const LayerChoice now = reach(step_);
    std::vector<LayerChoice> choices{AllLayers{}, TopLayers{}};
    Words words{{KIRI_TEXT("editor/document", "All layers"), {}},
                {KIRI_TEXT("editor/document", "Top layers"), {}}};
    const auto has = [&](const LayerChoice& choice) { return special == choice || now == choice; };
    if (has(ThroughAll{})) {
      choices.push_back(ThroughAll{});
      words.push_back({KIRI_TEXT("editor/document", "Straight down through all"), {}});
    }
    if (has(OwnEdges{})) {
      choices.push_back(OwnEdges{});
      words.push_back({KIRI_TEXT("editor/document", "Only the edges of the path"), {}});
    }
    if (const ChosenLayers* chosen = std::get_if<ChosenLayers>(&now)) {
      choices.push_back(now);
      words.push_back({KIRI_TEXT("editor/document", "Chosen layers (%1)"),
                       {std::to_string(chosen->facets.size())}});
    }
    int chosen = 0;
    for (std::size_t i = 0; i < choices.size(); ++i) {
      if (choices[i].index() != now.index()) continue;
      choices[i] = now;
      chosen = static_cast<int>(i);
    }
    add(choiceOf({"layers", {KIRI_TEXT("editor/document", "Layers"), {}}}, std::move(words),
                 chosen),
        [reach, choices](Step& step, const FieldValue& value) {
          reach(step) = choices[static_cast<std::size_t>(value.number)];
        });
    if (std::holds_alternative<TopLayers>(now)) addCount(reach);
  }

  template <class Reach>
  void addCount(Reach reach) {
    const auto count = [reach](Step& step) -> int& {
      return std::get<TopLayers>(reach(step)).count;
    };
    Field field = fieldOf({"count", {KIRI_TEXT("editor/document", "How many layers"), {}}},
                          Field::Kind::Number);
    field.value = count(step_);
    field.least = std::min(1.0, field.value);
    field.most = std::max(kMostLayers, field.value);
    add(std::move(field), [count](Step& step, const FieldValue& value) {
      count(step) = static_cast<int>(std::lround(value.number));
    });
  }

  Step step_;
  std::vector<StepSlot> slots_;
};

}  // namespace

std::vector<StepSlot> slotsOf(const Step& step) { return Collecting(step).collected(); }

}  // namespace kiri
