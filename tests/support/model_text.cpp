// A few words of text for a model.
// SPDX-License-Identifier: MIT
#include "tests/support/model_text.h"

#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/model/apply.h"

namespace kiri::test {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::invalid_argument("model text: " + what);
}

std::vector<std::string> split(std::string_view text, std::string_view separators) {
  std::vector<std::string> parts;
  std::string part;
  for (const char c : text) {
    if (separators.find(c) == std::string_view::npos) {
      part += c;
    } else {
      if (!part.empty()) parts.push_back(part);
      part.clear();
    }
  }
  if (!part.empty()) parts.push_back(part);
  return parts;
}

std::optional<double> asNumber(const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (end == word.c_str() || *end != '\0') return std::nullopt;
  return value;
}

/// The words of one statement, read from the left.
class Words {
 public:
  explicit Words(std::string_view statement) : words_(split(statement, " \t\r")) {
    std::vector<std::string> rest;
    for (std::string& word : words_) {
      if (word == "@model") {
        frame_ = Frame::Model;
      } else {
        rest.push_back(std::move(word));
      }
    }
    words_ = std::move(rest);
  }

  bool isEmpty() const { return at_ == words_.size(); }
  Frame frame() const { return frame_; }

  std::string next() {
    if (isEmpty()) fail("a word is missing");
    return words_[at_++];
  }
  bool take(const std::string& word) {
    if (isEmpty() || words_[at_] != word) return false;
    ++at_;
    return true;
  }
  std::string peek() const { return isEmpty() ? std::string() : words_[at_]; }

  std::optional<double> number() {
    if (isEmpty()) return std::nullopt;
    const std::optional<double> value = asNumber(words_[at_]);
    if (value) ++at_;
    return value;
  }
  double needNumber() {
    const std::optional<double> value = number();
    if (!value) fail("a number is expected instead of '" + peek() + "'");
    return *value;
  }

  std::optional<Place> place() {
    if (isEmpty()) return std::nullopt;
    std::string word = words_[at_];
    Place place{frame_, {}};
    if (word.size() > 2 && word[1] == ':' && (word[0] == 'm' || word[0] == 'p')) {
      place.frame = word[0] == 'm' ? Frame::Model : Frame::Paper;
      word = word.substr(2);
    }
    const std::size_t comma = word.find(',');
    if (comma == std::string::npos) return std::nullopt;
    const std::optional<double> x = asNumber(word.substr(0, comma));
    const std::optional<double> y = asNumber(word.substr(comma + 1));
    if (!x || !y) return std::nullopt;
    place.point = {*x, *y};
    ++at_;
    return place;
  }
  Vec2 needPoint() {
    const std::optional<Place> found = place();
    if (!found) fail("a place is expected instead of '" + peek() + "'");
    return found->point;
  }
  std::vector<Place> places() {
    std::vector<Place> all;
    while (const std::optional<Place> found = place()) all.push_back(*found);
    return all;
  }
  std::vector<Vec2> points() {
    std::vector<Vec2> all;
    for (const Place& found : places()) all.push_back(found.point);
    return all;
  }

 private:
  std::vector<std::string> words_;
  std::size_t at_ = 0;
  Frame frame_ = Frame::Paper;
};

std::optional<LayerChoice> layersOf(Words& words) {
  if (words.take("top")) return TopLayers{static_cast<int>(words.needNumber())};
  if (words.take("facets")) return ChosenLayers{words.places()};
  if (words.take("through")) return ThroughAll{};
  if (words.take("layers")) {
    words.take("all");
    return AllLayers{};
  }
  return std::nullopt;
}

/// What may follow in any order: layers, the facet of a line, what to keep.
struct Tail {
  std::optional<LayerChoice> chosen;
  LayerChoice layers = AllLayers{};  ///< those chosen, or all
  std::optional<Vec2> facet;
  Keep keep;
};

bool readTailWord(Words& words, Tail& tail) {
  if (const std::optional<LayerChoice> layers = layersOf(words)) {
    tail.chosen = layers;
    tail.layers = *layers;
  } else if (words.take("in")) {
    tail.facet = words.needPoint();
  } else if (words.take("keep")) {
    tail.keep.places = words.places();
    if (tail.keep.places.empty()) words.take("all");
  } else {
    return false;
  }
  return true;
}

Tail tailOf(Words& words) {
  Tail tail;
  while (!words.isEmpty()) {
    if (!readTailWord(words, tail)) fail("unknown word '" + words.peek() + "'");
  }
  return tail;
}

DrawnLine lineOf(Words& words) {
  const Vec2 from = words.needPoint();
  const Vec2 to = words.needPoint();
  return {words.frame(), from, to, std::nullopt};
}

MovingSide movingOf(Words& words) {
  if (words.take("left")) return Hand::Left;
  if (words.take("right")) return Hand::Right;
  if (words.take("to")) {
    const std::optional<Place> place = words.place();
    if (!place) fail("'to' needs a place");
    return MovingPoint{*place};
  }
  if (words.take("moving")) return MovingFacets{words.places()};
  fail("left, right, to or moving is expected instead of '" + words.peek() + "'");
}

FoldStep foldOf(Words& words) {
  FoldStep fold;
  if (words.peek() != "valley" && words.peek() != "mountain") fold.name = words.next();
  const std::string type = words.next();
  if (type != "valley" && type != "mountain")
    fail("valley or mountain is expected instead of '" + type + "'");
  fold.type = type == "valley" ? FoldType::Valley : FoldType::Mountain;
  if (const std::optional<double> angle = words.number()) fold.angle = *angle;
  fold.line = lineOf(words);
  fold.moving = movingOf(words);
  const Tail tail = tailOf(words);
  fold.layers = tail.layers;
  fold.line.facet = tail.facet;
  return fold;
}

FoldLineName foldLineOf(Words& words) {
  if (const std::optional<Place> place = words.place()) return *place;
  return words.next();
}

template <class Unfolding>
Unfolding unfoldingOf(Words& words) {
  Unfolding step;
  while (!words.isEmpty()) {
    if (words.take("all")) continue;
    if (words.take("together")) {
      step.sequence = Sequence::Together;
    } else {
      step.lines.push_back(foldLineOf(words));
    }
  }
  return step;
}

CurveCutStep curveOf(Words& words) {
  CurveCutStep cut;
  cut.frame = words.frame();
  cut.controls = words.points();
  Tail tail;
  while (!words.isEmpty()) {
    if (words.take("closed")) {
      cut.isClosed = true;
    } else if (words.take("free")) {
      cut.ends = SplineEnds::Free;
    } else if (!readTailWord(words, tail)) {
      fail("unknown word '" + words.peek() + "'");
    }
  }
  cut.layers = tail.layers;
  cut.facet = tail.facet;
  cut.keep = tail.keep;
  return cut;
}

Action pathActionOf(const std::string& kind, Words& words) {
  const DrawnPath path{words.frame(), words.points()};
  const LayerChoice layers = tailOf(words).chosen.value_or(OwnEdges{});
  if (kind == "tear") return TearStep{path, layers};
  return MendStep{path, layers};
}

Action lineActionOf(const std::string& kind, Words& words) {
  DrawnLine line = lineOf(words);
  const Tail tail = tailOf(words);
  line.facet = tail.facet;
  if (kind == "edge") return AddEdgeStep{line, tail.layers};
  return StraightCutStep{line, tail.layers, tail.keep};
}

Action actionOf(Words& words) {
  const std::string kind = words.next();
  if (kind == "fold") return foldOf(words);
  if (kind == "angle") {
    const FoldLineName line = foldLineOf(words);
    return AngleStep{line, words.needNumber()};
  }
  if (kind == "unfold") return unfoldingOf<UnfoldStep>(words);
  if (kind == "refold") return unfoldingOf<RefoldStep>(words);
  if (kind == "tear" || kind == "mend") return pathActionOf(kind, words);
  if (kind == "edge" || kind == "cut") return lineActionOf(kind, words);
  if (kind == "curve") return curveOf(words);
  if (kind == "turn") {
    const bool isHorizontal = words.take("horizontal");
    if (!isHorizontal) words.take("vertical");
    return TurnOverStep{isHorizontal ? TurnAxis::Horizontal : TurnAxis::Vertical};
  }
  if (kind == "rotate") {
    RotateStep step{words.needNumber(), std::nullopt};
    if (const std::optional<Place> about = words.place()) step.about = about->point;
    return step;
  }
  if (kind == "move") return MoveStep{words.needPoint()};
  fail("unknown statement '" + kind + "'");
}

SheetSpec polygonOf(Words& words) {
  SheetSpec sheet;
  sheet.shape = SheetSpec::Shape::Polygon;
  sheet.outline = words.points();
  while (words.take("hole")) sheet.holes.push_back(words.points());
  return sheet;
}

SheetSpec sheetOf(Words& words) {
  SheetSpec sheet;
  const std::string kind = words.next();
  if (kind == "polygon") return polygonOf(words);
  if (kind == "square") {
    sheet.shape = SheetSpec::Shape::Square;
  } else if (kind == "rectangle") {
    sheet.shape = SheetSpec::Shape::Rectangle;
  } else if (kind == "disc") {
    sheet.shape = SheetSpec::Shape::Disc;
  } else {
    fail("unknown sheet '" + kind + "'");
  }
  sheet.width = words.needNumber();
  sheet.height = kind == "rectangle" ? words.needNumber() : sheet.width;
  return sheet;
}

std::vector<Step> stepsFrom(const std::vector<std::string>& statements, std::size_t first) {
  std::vector<Step> steps;
  for (std::size_t i = first; i < statements.size(); ++i) {
    Words words(statements[i]);
    if (words.isEmpty()) continue;
    Step step;
    step.action = actionOf(words);
    if (!words.isEmpty()) fail("unknown word '" + words.peek() + "' in '" + statements[i] + "'");
    steps.push_back(std::move(step));
  }
  return steps;
}

Result<FoldedState> applyAll(FoldedState state, const std::vector<Step>& steps) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    Result<FoldedState> next = apply(state, steps[i], static_cast<int>(i) + 1);
    if (!next && i + 1 == steps.size()) return next.error();
    if (!next)
      throw std::runtime_error("step " + std::to_string(i + 1) + ": " + next.error().message);
    state = std::move(next).value();
  }
  return state;
}

FoldedState need(Result<FoldedState> result, std::size_t steps) {
  if (!result)
    throw std::runtime_error("step " + std::to_string(steps) + ": " + result.error().message);
  return std::move(result).value();
}

}  // namespace

Model modelOf(std::string_view text) {
  std::vector<std::string> statements;
  for (std::string& statement : split(text, ";\n")) {
    if (statement.find_first_not_of(" \t\r") != std::string::npos) statements.push_back(statement);
  }
  if (statements.empty()) fail("no sheet");
  Model model;
  Words sheet(statements.front());
  model.sheet = sheetOf(sheet);
  model.steps = stepsFrom(statements, 1);
  return model;
}

std::vector<Step> stepsOf(std::string_view text) { return stepsFrom(split(text, ";\n"), 0); }

Step stepOf(std::string_view text) {
  std::vector<Step> steps = stepsOf(text);
  if (steps.size() != 1) fail("one step is expected");
  return std::move(steps.front());
}

FoldedState startOf(const Model& model) {
  const Result<Sheet> sheet = makeSheet(model.sheet);
  if (!sheet) throw std::runtime_error("sheet: " + sheet.error().message);
  return flatState(*sheet);
}

FoldedState run(std::string_view text) {
  const Model model = modelOf(text);
  return need(applyAll(startOf(model), model.steps), model.steps.size());
}

FoldedState after(const FoldedState& state, std::string_view text) {
  const std::vector<Step> steps = stepsOf(text);
  return need(applyAll(state, steps), steps.size());
}

Result<FoldedState> tryRun(std::string_view text) {
  const Model model = modelOf(text);
  return applyAll(startOf(model), model.steps);
}

Result<FoldedState> tryAfter(const FoldedState& state, std::string_view text) {
  return applyAll(state, stepsOf(text));
}

}  // namespace kiri::test
