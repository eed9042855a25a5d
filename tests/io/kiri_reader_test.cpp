// Reading .kiri files: what they mean, and the sentence for every mistake.
// SPDX-License-Identifier: MIT
#include "io/kiri_reader.h"

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "tests/io/kiri_texts.h"

namespace kiri {
namespace {

using test::everyStep;
using test::fileWithEverything;
using test::fileWithSheet;
using test::fileWithSteps;

Model modelOf(const std::string& text) {
  const Result<LoadedModel> loaded = readKiri(text, "test.kiri");
  EXPECT_TRUE(loaded.isOk()) << (loaded.isOk() ? "" : loaded.error().message);
  return loaded.isOk() ? loaded->model : Model{};
}

template <class T>
T stepOf(const std::string& step) {
  const Model model = modelOf(fileWithSteps(step));
  EXPECT_EQ(model.steps.size(), 1u);
  const T* found = model.steps.empty() ? nullptr : std::get_if<T>(&model.steps[0].action);
  EXPECT_NE(found, nullptr) << step;
  return found != nullptr ? *found : T{};
}

TEST(KiriReader, ReadsTitleNotesAndLooks) {
  const Model model = modelOf(
      R"({"format":"kiri","version":1,"title":"Leaf","notes":"n","sheet":{"shape":"disc","diameter":80},
          "paper":{"front":{"color":"#0a141E","texture":"leaf.png"},"back":{"color":"#fff"}},"steps":[]})");
  EXPECT_EQ(model.title, "Leaf");
  EXPECT_EQ(model.notes, "n");
  EXPECT_EQ(model.sheet.shape, SheetSpec::Shape::Disc);
  EXPECT_EQ(model.sheet.width, 80);
  EXPECT_EQ(model.front.color, (Color{10, 20, 30}));
  EXPECT_EQ(model.front.texture, "leaf.png");
  EXPECT_EQ(model.back.color, (Color{255, 255, 255}));
}

TEST(KiriReader, ReadsEverySheet) {
  EXPECT_EQ(modelOf(fileWithSheet(R"({"shape":"square","side":12.5})")).sheet.width, 12.5);
  const SheetSpec a4 =
      modelOf(fileWithSheet(R"({"shape":"rectangle","width":210,"height":297})")).sheet;
  EXPECT_EQ(a4.shape, SheetSpec::Shape::Rectangle);
  EXPECT_EQ(a4.width, 210);
  EXPECT_EQ(a4.height, 297);
  const SheetSpec ring =
      modelOf(
          fileWithSheet(
              R"({"shape":"polygon","outline":[[0,0],[9,0],[0,9]],"holes":[[[1,1],[2,1],[1,2]]]})"))
          .sheet;
  EXPECT_EQ(ring.outline, (std::vector<Vec2>{{0, 0}, {9, 0}, {0, 9}}));
  ASSERT_EQ(ring.holes.size(), 1u);
  EXPECT_EQ(ring.holes[0], (std::vector<Vec2>{{1, 1}, {2, 1}, {1, 2}}));
}

TEST(KiriReader, ReadsAFoldWithItsDefaults) {
  const auto fold = stepOf<FoldStep>(
      R"({"do":"fold","line":{"paper":[[1,2],[3,4]]},"type":"mountain","move":"right"})");
  EXPECT_EQ(fold.name, "");
  EXPECT_EQ(fold.line.frame, Frame::Paper);
  EXPECT_EQ(fold.line.from, (Vec2{1, 2}));
  EXPECT_EQ(fold.line.to, (Vec2{3, 4}));
  EXPECT_FALSE(fold.line.facet.has_value());
  EXPECT_EQ(fold.type, FoldType::Mountain);
  EXPECT_EQ(fold.angle, 180);
  EXPECT_TRUE(std::holds_alternative<AllLayers>(fold.layers));
  EXPECT_EQ(std::get<Hand>(fold.moving), Hand::Right);
}

TEST(KiriReader, TakesBarePlacesInTheFrameOfTheLine) {
  const auto fold = stepOf<FoldStep>(everyStep()[2]);
  const auto& layers = std::get<ChosenLayers>(fold.layers).facets;
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_EQ(layers[0].frame, Frame::Model);
  EXPECT_EQ(layers[1].frame, Frame::Paper);
  EXPECT_EQ(layers[1].point, (Vec2{3, 4}));
  EXPECT_EQ(std::get<MovingPoint>(fold.moving).place.frame, Frame::Model);

  const auto onPaper = stepOf<FoldStep>(
      R"({"do":"fold","line":{"paper":[[1,2],[3,4]],"facet":[5,6]},"type":"valley","move":{"facets":[[7,8]]}})");
  EXPECT_EQ(onPaper.line.facet, (Vec2{5, 6}));
  EXPECT_EQ(std::get<MovingFacets>(onPaper.moving).facets[0].frame, Frame::Paper);
}

TEST(KiriReader, ReadsTheOtherSteps) {
  EXPECT_EQ(std::get<std::string>(stepOf<AngleStep>(everyStep()[4]).line), "mid-vein");
  EXPECT_EQ(stepOf<AngleStep>(everyStep()[4]).angle, -90);
  EXPECT_EQ(std::get<Place>(stepOf<AngleStep>(everyStep()[5]).line).frame, Frame::Model);
  EXPECT_TRUE(stepOf<UnfoldStep>(everyStep()[6]).lines.empty());
  const auto unfold = stepOf<UnfoldStep>(everyStep()[7]);
  ASSERT_EQ(unfold.lines.size(), 2u);
  EXPECT_EQ(std::get<Place>(unfold.lines[1]).frame, Frame::Paper);
  EXPECT_EQ(unfold.sequence, Sequence::Together);
  EXPECT_EQ(stepOf<RefoldStep>(everyStep()[8]).lines.size(), 1u);
  EXPECT_TRUE(std::holds_alternative<OwnEdges>(stepOf<TearStep>(everyStep()[9]).layers));
  EXPECT_EQ(stepOf<TearStep>(everyStep()[10]).path.points.size(), 3u);
  EXPECT_TRUE(stepOf<MendStep>(everyStep()[11]).path.points.empty());
  EXPECT_EQ(stepOf<AddEdgeStep>(everyStep()[13]).line.frame, Frame::Model);
  EXPECT_TRUE(stepOf<StraightCutStep>(everyStep()[14]).keep.places.empty());
  EXPECT_EQ(stepOf<StraightCutStep>(everyStep()[15]).keep.places[0].frame, Frame::Model);
  EXPECT_EQ(std::get<TopLayers>(stepOf<StraightCutStep>(everyStep()[15]).layers).count, 3);
  EXPECT_TRUE(stepOf<CurveCutStep>(everyStep()[17]).isClosed);
  EXPECT_EQ(stepOf<CurveCutStep>(everyStep()[17]).facet, (Vec2{5, 5}));
  EXPECT_EQ(stepOf<CurveCutStep>(everyStep()[18]).ends, SplineEnds::Free);
  EXPECT_EQ(stepOf<TurnOverStep>(everyStep()[20]).axis, TurnAxis::Horizontal);
  EXPECT_EQ(stepOf<RotateStep>(everyStep()[22]).about, (Vec2{75, 75}));
  EXPECT_EQ(stepOf<MoveStep>(everyStep()[23]).by, (Vec2{10, -5}));
  EXPECT_TRUE(std::holds_alternative<ThroughAll>(stepOf<StraightCutStep>(everyStep()[24]).layers));
}

TEST(KiriReader, WarnsOfTypingErrorsInOptionalFields) {
  const Result<LoadedModel> loaded = readKiri(
      fileWithSteps(
          R"({"do":"fold","line":{"paper":[[1,2],[3,4]],"faset":[1,1]},"type":"valley","move":"left","agnle":90,"colour":3})"),
      "leaf.kiri");
  ASSERT_TRUE(loaded.isOk()) << loaded.error().message;
  ASSERT_EQ(loaded->warnings.size(), 2u);
  EXPECT_EQ(loaded->warnings[0],
            "leaf.kiri:5:52: step 1 (fold): \"line.faset\" is not a field that is known here; did "
            "you mean "
            "\"facet\"? It is kept, but does nothing");
  EXPECT_NE(loaded->warnings[1].find("did you mean \"angle\"?"), std::string::npos);
}

/// A text with a mistake, and what the sentence must contain.
struct Mistake {
  std::string text;
  std::string sentence;
};

void expectSentences(const std::vector<Mistake>& mistakes) {
  for (const Mistake& mistake : mistakes) {
    const Result<LoadedModel> loaded = readKiri(mistake.text, "a.kiri");
    ASSERT_FALSE(loaded.isOk()) << mistake.text;
    EXPECT_EQ(loaded.error().code, ErrorCode::BadFile);
    EXPECT_NE(loaded.error().message.find(mistake.sentence), std::string::npos)
        << mistake.text << "\n is said to be: " << loaded.error().message
        << "\n and should be:  " << mistake.sentence;
    EXPECT_NE(loaded.error().message.back(), '.');
  }
}

TEST(KiriReader, NamesPlaceAndRemedyOfBrokenJson) {
  expectSentences({
      {"", "a.kiri: the file is empty"},
      {" \n ", "a.kiri: the file is empty"},
      {"{",
       "a.kiri:1:2: this is not valid JSON: the text ends too early; a bracket or quote is not "
       "closed"},
      {"{\"format\": \"kiri\",\n}",
       "a.kiri:2:1: this is not valid JSON: a comma stands before the closing bracket"},
      {"{\"format\": \"kiri\"\n \"version\": 1}", "a comma is missing before this"},
      {"{\"a\": [1 2]}", "a comma is missing before this"},
      {"{\"a\": [[1, 2] [3, 4]]}",
       "a.kiri:1:15: this is not valid JSON: a comma is missing before this"},
      {"{\"format\" \"kiri\"}", "a colon is missing between name and value"},
      {"{format: \"kiri\"}", "a field name in quotes is expected here"},
      {"{\"a\": 1} x", "there is more text after the end of the document"},
      {"{\"a\": 1e999}", "the number is too large"},
      {"{\"a\": NaN}", "a.kiri:1:7: this is not valid JSON: this is no number, no text"},
      {"// leaf\n{}", "JSON has no comments"},
      {"{\"a\": \"\xff\"}", "the text is not UTF-8"},
      {"{\"a\": \"b\n\"}", "a text must end on the line on which it starts"},
      {"{\"a\": 1,\n\"a\": 2}", "a.kiri:2:1: the field \"a\" is there twice; keep one of the two"},
      {"[]", "a.kiri:1:1: a model file is one JSON object"},
      {"7", "a model file is one JSON object"},
      {std::string(100, '['), "brackets are nested more than 64 deep"},
  });
}

TEST(KiriReader, NamesWhatIsWrongWithTheHeader) {
  expectSentences({
      {"{}",
       "a.kiri:1:1: \"format\" is missing: a model file starts with \"format\": \"kiri\", "
       "\"version\": 1"},
      {R"({"fromat": "kiri"})", "did you mean it by \"fromat\"?"},
      {R"({"format": "fold", "version": 1})",
       "\"format\" must be \"kiri\"; this is another kind of file"},
      {R"({"format": "kiri"})", "\"version\" is missing"},
      {R"({"format": "kiri", "version": 2})",
       "\"version\" is 2, but this program knows the format up to version 1; use a newer program"},
      {R"({"format": "kiri", "version": 0})", "\"version\" is 0, must lie between 1 and"},
      {R"({"format": "kiri", "version": 0.5})", "\"version\" is 0.5"},
      {R"({"format": "kiri", "version": "1"})", "\"version\" must be a number, but is \"1\""},
      {R"({"format": "kiri", "version": 1, "steps": []})",
       "\"sheet\" is missing: the paper, such as"},
      {R"({"format": "kiri", "version": 1, "sheet": {"shape":"square","side":1}})",
       "\"steps\" is missing"},
      {R"({"format": "kiri", "version": 1, "sheet": {"shape":"square","side":1}, "steps": {}})",
       "\"steps\" must be a list of steps [{\"do\": ...}, ...], but is an object"},
      {R"({"format": "kiri", "version": 1, "title": 3, "sheet": {"shape":"square","side":1}, "steps": []})",
       "\"title\" must be a text in quotes, but is 3"},
      {R"({"format": "kiri", "version": 1, "paper": {"front": {"color": "green"}}, "sheet": {}, "steps": []})",
       "\"paper.front.color\" must be a colour like \"#5a8c46\", but is \"green\""},
      {R"({"format": "kiri", "version": 1, "paper": {"front": "#fff"}, "sheet": {}, "steps": []})",
       "\"paper.front\" must be an object in braces { }, but is \"#fff\""},
  });
}

TEST(KiriReader, NamesWhatIsWrongWithTheSheet) {
  expectSentences({
      {fileWithSheet("{}"), "a.kiri:2:10: sheet: \"shape\" is missing"},
      {fileWithSheet("150"), "sheet: this must be an object in braces { }, but is 150"},
      {fileWithSheet(R"({"shape":"sqare","side":1})"),
       "sheet: \"shape\" is \"sqare\"; did you mean \"square\"?"},
      {fileWithSheet(R"({"shape":"blob"})"),
       "sheet: \"shape\" must be \"square\", \"rectangle\", \"disc\" or \"polygon\", but is "
       "\"blob\""},
      {fileWithSheet(R"({"shape":"square"})"),
       "sheet: \"side\" is missing: the side of the square in mm"},
      {fileWithSheet(R"({"shape":"square","side":0})"),
       "a.kiri:2:35: sheet: \"side\" is 0, must be above 0 and at most 1000000"},
      {fileWithSheet(R"({"shape":"square","side":-5})"), "\"side\" is -5"},
      {fileWithSheet(R"({"shape":"square","side":1e7})"), "\"side\" is 1e7"},
      {fileWithSheet(R"({"shape":"square","side":"150 mm"})"),
       "\"side\" must be a number, but is \"150 mm\""},
      {fileWithSheet(R"({"shape":"square","side":5,"width":3})"),
       "\"width\" does not go with a square"},
      {fileWithSheet(R"({"shape":"rectangle","width":5})"), "\"height\" is missing"},
      {fileWithSheet(R"({"shape":"disc","radius":5})"), "\"diameter\" is missing"},
      {fileWithSheet(R"({"shape":"polygon"})"), "\"outline\" is missing"},
      {fileWithSheet(R"({"shape":"polygon","outline":[[0,0],[1,0]]})"),
       "\"outline\" has 2 points, at least 3 are needed"},
      {fileWithSheet(R"({"shape":"polygon","outline":[0,0,1,0]})"), "put each point in brackets"},
      {fileWithSheet(R"({"shape":"polygon","outline":[[0,0],[1,0],[1]]})"),
       "\"outline[2]\" must be a point [x, y] of two numbers, but has 1"},
      {fileWithSheet(R"({"shape":"polygon","outline":[[0,0],[1,0],[1,"a"]]})"),
       "\"outline[2][1]\" must be a number, but is \"a\""},
      {fileWithSheet(R"({"shape":"polygon","outline":[[0,0],[1,0],[1,1]],"holes":[[[0,0]]]})"),
       "\"holes[0]\" has 1 point, at least 3 are needed"},
      {fileWithSheet(R"({"shape":"polygon","outline":[[0,0],[1,0],[1,1]],"holes":5})"),
       "\"holes\" must be a list of holes"},
  });
}

TEST(KiriReader, NamesStepAndFieldOfMistakesInFolds) {
  const std::string line = R"("line": {"paper": [[1, 2], [3, 4]]}, )";
  const std::string rest = R"("type": "valley", "move": "left"})";
  const std::string fold = R"({"do": "fold", "name": "mid-vein", )";
  expectSentences({
      {fileWithSteps("7"),
       "a.kiri:5:1: step 1: a step must be an object in braces { } with \"do\""},
      {fileWithSteps("{}"), "step 1: \"do\" is missing: one of: fold, angle, unfold"},
      {fileWithSteps(R"({"do": "foldd"})"),
       "step 1 (foldd): unknown step kind \"foldd\"; did you mean \"fold\"?"},
      {fileWithSteps(R"({"do": "crumple"})"),
       "unknown step kind \"crumple\"; the kinds are: fold, angle"},
      {fileWithSteps(R"({"do": 5})"), "step 1: \"do\" must be a text in quotes, but is 5"},
      {fileWithSteps(fold + rest),
       "a.kiri:5:1: step 1 (fold \"mid-vein\"): \"line\" is missing: the line to fold along"},
      {fileWithSteps(fold + line + R"("angle": 200, )" + rest),
       "step 1 (fold \"mid-vein\"): \"angle\" is 200, must lie between 0 and 180"},
      {fileWithSteps("{\"do\": \"turn over\"},\n" + fold + line + R"("angle": -1, )" + rest),
       "a.kiri:6:82: step 2 (fold \"mid-vein\"): \"angle\" is -1, must lie between 0 and 180"},
      {fileWithSteps(fold + line + R"("move": "left"})"),
       "\"type\" is missing: \"valley\" or \"mountain\""},
      {fileWithSteps(fold + line + R"("tpye": "valley", "move": "left"})"),
       "did you mean it by \"tpye\"?"},
      {fileWithSteps(fold + line + R"("type": "vallei", "move": "left"})"),
       "\"type\" is \"vallei\"; did you mean \"valley\"?"},
      {fileWithSteps(fold + line + R"("type": "valley"})"),
       "\"move\" is missing: the side that moves"},
      {fileWithSteps(fold + line + R"("type": "valley", "move": "up"})"),
       "\"move\" must be \"left\" or \"right\", but is \"up\""},
      {fileWithSteps(fold + line + R"("type": "valley", "move": [1, 2]})"),
       "\"move\" must be \"left\", \"right\", {"},
      {fileWithSteps(fold + line + R"("type": "valley", "move": {}})"),
       "\"move\" needs \"point\" or \"facets\""},
      {fileWithSteps(fold + line + R"("type": "valley", "move": {"point": [1]}})"),
       "\"move.point\" must be a point [x, y] of two numbers, but has 1"},
      {fileWithSteps(fold + line +
                     R"("type": "valley", "move": {"point": [1, 2], "facets": [[1, 2]]}})"),
       "\"move\" has several of \"point\" or \"facets\"; keep one"},
      {fileWithSteps(fold + line + R"("type": "valley", "move": {"facets": []}})"),
       "\"move.facets\" must be a list of places"},
      {fileWithSteps(fold + line + R"("type": "valley", "move": {"facets": [1, 2]}})"),
       "put the point in brackets once more"},
      {fileWithSteps(fold + R"("line": [[1, 2], [3, 4]], )" + rest),
       "\"line\" must say where it is drawn"},
      {fileWithSteps(fold + R"("line": {}, )" + rest), "\"line\" needs \"paper\" or \"model\""},
      {fileWithSteps(fold + R"("line": {"paper": [[1, 2]]}, )" + rest),
       "\"line.paper\" has 1 point, at least 2 are needed"},
      {fileWithSteps(fold + R"("line": {"paper": [[1, 2], [3, 4], [5, 6]]}, )" + rest),
       "\"line.paper\" has 3 points, a line has 2"},
      {fileWithSteps(fold + R"("line": {"paper": [[1, 2], [1, 2]]}, )" + rest),
       "\"line.paper\" has its two ends at the same point"},
      {fileWithSteps(fold + R"("line": {"paper": [[1, 2], [1, null]]}, )" + rest),
       "\"line.paper[1][1]\" must be a number, but is null"},
      {fileWithSteps(fold + R"("line": {"paper": [[1, 2], [1, 2e6]]}, )" + rest),
       "\"line.paper[1][1]\" is 2e6, must lie between -1000000 and 1000000"},
      {fileWithSteps(fold + R"("line": {"model": [[1, 2], [3, 4]], "facet": [1, 2]}, )" + rest),
       "\"line.facet\" goes with a line on the paper only"},
      {fileWithSteps(fold + line + R"("layers": "top", )" + rest),
       "\"layers\" must be \"all\", \"through\", {\"top\": count}"},
      {fileWithSteps(fold + line + R"("layers": {"top": 0}, )" + rest),
       "\"layers.top\" is 0, must lie between 1"},
      {fileWithSteps(fold + line + R"("layers": {"top": 1.5}, )" + rest),
       "\"layers.top\" must be a whole number, but is 1.5"},
      {fileWithSteps(fold + line + rest + ",\n" + fold + line + rest),
       "a.kiri:6:1: step 2 (fold \"mid-vein\"): step 1 has a fold named \"mid-vein\" already"},
      {fileWithSteps(R"({"do": "fold", "name": "fold 2", )" + line + rest + R"(, {"do": "fold", )" +
                     line + rest),
       "step 1 has a fold named \"fold 2\" already"},
  });
}

TEST(KiriReader, NamesStepAndFieldOfMistakesInOtherSteps) {
  expectSentences({
      {fileWithSteps(R"({"do": "angle", "angle": 5})"), "step 1 (angle): \"fold\" is missing"},
      {fileWithSteps(R"({"do": "angle", "fold": "a"})"), "step 1 (angle): \"angle\" is missing"},
      {fileWithSteps(R"({"do": "angle", "fold": "a", "angle": 181})"),
       "must lie between -180 and 180"},
      {fileWithSteps(R"({"do": "angle", "fold": "", "angle": 1})"), "\"fold\" is an empty name"},
      {fileWithSteps(R"({"do": "angle", "fold": 3, "angle": 1})"),
       "\"fold\" must be the name of a fold or a place [x, y] on its crease, but is 3"},
      {fileWithSteps(R"({"do": "unfold", "folds": "mid-vein"})"),
       "\"folds\" must be \"all\" or a list with the names of folds, but is \"mid-vein\""},
      {fileWithSteps(R"({"do": "unfold", "folds": []})"), "\"folds\" must be \"all\" or a list"},
      {fileWithSteps(R"({"do": "unfold", "folds": [1, 2]})"),
       "put the point in brackets once more"},
      {fileWithSteps(R"({"do": "refold", "folds": ["a", 5]})"),
       "\"folds[1]\" must be the name of a fold"},
      {fileWithSteps(R"({"do": "refold", "sequence": "togehter"})"), "did you mean \"together\"?"},
      {fileWithSteps(R"({"do": "tear"})"), "step 1 (tear): \"path\" is missing"},
      {fileWithSteps(R"({"do": "tear", "path": [[1, 2], [3, 4]]})"),
       "\"path\" must say where it is drawn"},
      {fileWithSteps(R"({"do": "tear", "path": {"paper": [[1, 2]]}})"),
       "\"path.paper\" has 1 point"},
      {fileWithSteps(R"({"do": "mend", "path": "some"})"), "\"path\" must be \"all\" or a path"},
      {fileWithSteps(R"({"do": "add edge"})"), "\"line\" is missing: the edge to add"},
      {fileWithSteps(R"({"do": "straight cut", "line": {"paper": [[1, 2], [3, 4]]}})"),
       "\"keep\" is missing"},
      {fileWithSteps(R"({"do": "straight cut", "line": {"paper": [[1, 2], [3, 4]]}, "keep": []})"),
       "\"keep\" must be a list of places [[x, y], ...] with at least one, but is an empty list"},
      {fileWithSteps(
           R"({"do": "straight cut", "line": {"paper": [[1, 2], [3, 4]]}, "keep": "left"})"),
       "\"keep\" must be \"all\", but is \"left\""},
      {fileWithSteps(R"({"do": "straight cut", "line": {"paper": [[1, 2], [3, 4]]}, "keep": 4})"),
       "\"keep\" must be \"all\" or a list of places"},
      {fileWithSteps(R"({"do": "curve cut", "keep": "all"})"), "\"curve\" is missing"},
      {fileWithSteps(
           R"({"do": "curve cut", "curve": {"model": [[0, 0], [1, 1], [2, 2]]}, "keep": "all"})"),
       "\"curve.model\" has 3 points, at least 4 are needed"},
      {fileWithSteps(
           R"({"do": "curve cut", "curve": {"model": [[0, 0], [1, 1]], "closed": true}, "keep": "all"})"),
       "\"curve.model\" has 2 points, at least 3 are needed"},
      {fileWithSteps(
           R"({"do": "curve cut", "curve": {"model": [[0, 0]], "closed": "yes"}, "keep": "all"})"),
       "\"curve.closed\" must be true or false, but is \"yes\""},
      {fileWithSteps(R"({"do": "turn over", "axis": "y"})"),
       "\"axis\" must be \"vertical\" or \"horizontal\""},
      {fileWithSteps(R"({"do": "rotate"})"), "\"degrees\" is missing"},
      {fileWithSteps(R"({"do": "rotate", "degrees": 30, "about": 4})"),
       "\"about\" must be a point [x, y], but is 4"},
      {fileWithSteps(R"({"do": "move"})"), "\"by\" is missing: how far to move"},
      {fileWithSteps(R"({"do": "move", "by": [1, 2, 3]})"),
       "\"by\" must be a point [x, y] of two numbers, but has 3"},
  });
}

TEST(KiriReader, ReadsAPatternWithItsLettersAndAngles) {
  const PatternStep step = stepOf<PatternStep>(
      R"({"do": "pattern", "vertices": [[75, 0], [75, 150], [0, 75]], "creases": [[0, 1, "M"], [1, 2, "V", 90], [0, 2, "C"]]})");
  ASSERT_EQ(step.creases.size(), 3u);
  EXPECT_EQ(step.creases[0], (PatternCrease{0, 1, Assignment::Mountain, -180}));
  EXPECT_EQ(step.creases[1], (PatternCrease{1, 2, Assignment::Valley, 90}));
  EXPECT_EQ(step.creases[2], (PatternCrease{0, 2, Assignment::Cut, 0}));
  EXPECT_FALSE(step.isFolded);
  EXPECT_TRUE(step.layers.empty());
}

TEST(KiriReader, NamesThePlaceOfMistakesInPatterns) {
  const auto messageOf = [](const std::string& rest) {
    const Result<LoadedModel> loaded = readKiri(
        fileWithSteps(R"({"do": "pattern", "vertices": [[75, 0], [75, 150]], )" + rest + "}"),
        "f.kiri");
    return loaded.isOk() ? "" : loaded.error().message;
  };
  const auto names = [&](const std::string& rest, const char* part) {
    const std::string message = messageOf(rest);
    return message.find(part) != std::string::npos && message.rfind("f.kiri:5:", 0) == 0
               ? testing::AssertionSuccess()
               : testing::AssertionFailure() << message;
  };
  EXPECT_TRUE(names(R"("creases": [[0, 2, "V"]])", "\"creases[0][1]\" is 2"));
  EXPECT_TRUE(names(R"("creases": [[0, 0.5, "V"]])", "\"creases[0][1]\""));
  EXPECT_TRUE(names(R"("creases": [[0, 1, "B"]])", "\"creases[0][2]\""));
  EXPECT_TRUE(names(R"("creases": [[0, 1]])", "\"creases[0]\""));
  EXPECT_TRUE(names(R"("creases": [[0, 1, "V", 200]])", "\"creases[0][3]\" is 200"));
  EXPECT_TRUE(names(R"("creases": 5)", "\"creases\""));
  EXPECT_TRUE(names(R"("folded": true)", "\"creases\""));
  EXPECT_TRUE(names(R"("creases": [], "exceptions": [[1, 2]])", "\"exceptions[0][0]\""));
}

TEST(KiriReader, RefusesHugeFilesWithASentence) {
  expectSentences({
      {std::string(std::size_t{101} << 20, ' '), "the file has 101 MB, at most 64 MB are read"},
  });
  std::string many = "[0";
  for (int i = 0; i < 2'000'000; ++i) many += ",0";
  many += "]";
  expectSentences({{many, "the file holds more than 2000000 values"}});
}

TEST(KiriReader, AcceptsAByteOrderMark) {
  EXPECT_EQ(modelOf("\xEF\xBB\xBF" + fileWithEverything()).steps.size(), everyStep().size());
}

}  // namespace
}  // namespace kiri
