// Writing .kiri files: nothing is lost on the way out and in again.
// SPDX-License-Identifier: MIT
#include "io/kiri_writer.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "io/json_tree.h"
#include "io/kiri_reader.h"
#include "tests/io/kiri_texts.h"

namespace kiri {
namespace {

using test::everyStep;
using test::fileWithEverything;
using test::fileWithSteps;
using test::joinedSteps;

Model readBack(const std::string& text) {
  const Result<LoadedModel> loaded = readKiri(text, "test.kiri");
  EXPECT_TRUE(loaded.isOk()) << (loaded.isOk() ? "" : loaded.error().message);
  return loaded.isOk() ? loaded->model : Model{};
}

TEST(KiriWriter, KeepsHowAModelOpens) {
  Model model;
  EXPECT_EQ(writeKiri(model).find("opens"), std::string::npos);
  model.opening = Sequence::Together;
  const Result<LoadedModel> again = readKiri(writeKiri(model), "leaf.kiri");
  ASSERT_TRUE(again.isOk()) << again.error().message;
  EXPECT_EQ(again->model.opening, Sequence::Together);
}

TEST(KiriWriter, WritesEveryStepAsItWasRead) {
  const nlohmann::json before = nlohmann::json::parse(fileWithEverything());
  const nlohmann::json after = nlohmann::json::parse(writeKiri(readBack(fileWithEverything())));
  EXPECT_EQ(after["steps"], before["steps"]);
  EXPECT_EQ(after["sheet"], before["sheet"]);
  EXPECT_EQ(after["title"], before["title"]);
}

TEST(KiriWriter, GivesTheSameBytesAfterReadingThemAgain) {
  const std::string once = writeKiri(readBack(fileWithEverything()));
  EXPECT_EQ(writeKiri(readBack(once)), once);
}

TEST(KiriWriter, WritesEverySheetAsItWasRead) {
  for (
      const std::string sheet :
      {R"({"shape":"square","side":12.5})", R"({"shape":"rectangle","width":210,"height":297})",
       R"({"shape":"disc","diameter":80})", R"({"shape":"polygon","outline":[[0,0],[9,0],[0,9]]})",
       R"({"shape":"polygon","outline":[[0,0],[9,0],[0,9]],"holes":[[[1,1],[2,1],[1,2]]],"grain":"long"})"}) {
    const std::string text = writeKiri(readBack(test::fileWithSheet(sheet)));
    EXPECT_EQ(nlohmann::json::parse(text)["sheet"], nlohmann::json::parse(sheet));
    EXPECT_EQ(writeKiri(readBack(text)), text);
  }
}

TEST(KiriWriter, KeepsUnknownFieldsWhereTheyStood) {
  const std::string text = R"({"format":"kiri","version":1,"author":{"name":"x","a/b~c":[1,2]},
    "sheet":{"shape":"square","side":150,"weight":80},
    "paper":{"front":{"color":"#102030","gloss":0.5},"back":{"color":"#d6e2be"},"brand":"z"},
    "steps":[
      {"do":"fold","line":{"paper":[[1,2],[3,4]],"ink":"red","x/y~z":1},"type":"valley","angle":180,
       "layers":{"facets":[[1,2],{"model":[3,4],"why":"seen"}],"all?":false},
       "move":{"point":[3,4],"hint":null},"speed":1.50},
      {"do":"curve cut","curve":{"paper":[[0,0],[1,2],[3,4],[5,6]],"tool":"knife"},"keep":"all"}]})";
  const std::string written = writeKiri(readBack(text));
  EXPECT_EQ(nlohmann::json::parse(written), nlohmann::json::parse(text));
  EXPECT_NE(written.find("1.50"), std::string::npos) << "unknown numbers keep their digits";
  EXPECT_EQ(writeKiri(readBack(written)), written);
}

TEST(KiriWriter, DropsUnknownFieldsOfThingsThatAreGone) {
  Model model = readBack(fileWithSteps(
      R"({"do":"fold","line":{"paper":[[1,2],[3,4]],"ink":"red"},"type":"valley","move":"left","own":1})"));
  model.steps[0].action = MoveStep{{1, 2}};
  const nlohmann::json step = nlohmann::json::parse(writeKiri(model))["steps"][0];
  EXPECT_EQ(step, nlohmann::json::parse(R"({"do":"move","by":[1,2],"own":1})"));
}

TEST(KiriWriter, LaysOutForPeople) {
  const std::string text =
      writeKiri(readBack(fileWithSteps(joinedSteps({everyStep()[19], everyStep()[16]}))));
  EXPECT_EQ(text, R"({
  "format": "kiri",
  "version": 1,
  "title": "A test",
  "sheet": {"shape": "square", "side": 150},
  "paper": {"front": {"color": "#5a8c46"}, "back": {"color": "#d6e2be"}},
  "steps": [
    {"do": "turn over"},
    {
      "do": "curve cut",
      "curve": {"model": [[0, 0], [10, 20], [30, 20], [40, 0]]},
      "keep": [[75, 75]]
    }
  ]
}
)");
}

TEST(KiriWriter, KeepsEveryBitOfANumber) {
  std::mt19937_64 random(20240607);
  std::uniform_real_distribution<double> anywhere(-1000, 1000);
  for (int i = 0; i < 20000; ++i) {
    const double value = i % 2 == 0 ? anywhere(random) : anywhere(random) / 1048576.0;
    const std::string text = numberText(value);
    EXPECT_EQ(std::strtod(text.c_str(), nullptr), value) << text;
  }
  EXPECT_EQ(numberText(150), "150");
  EXPECT_EQ(numberText(-0.0), "0");
  EXPECT_EQ(numberText(0.1), "0.1");
  EXPECT_EQ(numberText(22.5), "22.5");
}

TEST(JsonTree, KnowsWhereEveryValueStands) {
  const Result<JsonValue> json =
      parseJson("{\"a\" : [1,\n  -2.5e3, \"x\\\"]\"],\n\"b\": {\"c\": true}}", "t");
  ASSERT_TRUE(json.isOk());
  const JsonValue& list = *json->find("a");
  EXPECT_EQ(list.line, 1u);
  EXPECT_EQ(list.column, 8u);
  EXPECT_EQ(list.items[1].line, 2u);
  EXPECT_EQ(list.items[1].column, 3u);
  EXPECT_EQ(list.items[1].text, "-2.5e3");
  EXPECT_EQ(list.items[2].column, 11u);
  EXPECT_EQ(json->find("b")->find("c")->line, 3u);
  EXPECT_EQ(json->find("b")->find("c")->column, 12u);
}

}  // namespace
}  // namespace kiri
