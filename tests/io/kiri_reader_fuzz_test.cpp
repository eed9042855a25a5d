// Thousands of damaged files: the reader gives a model or a sentence, and never anything else.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "io/kiri_reader.h"
#include "io/kiri_writer.h"
#include "tests/io/kiri_texts.h"

namespace kiri {
namespace {

constexpr std::uint64_t kSeed = 20240521;
constexpr int kCases = 20000;

using Random = std::mt19937_64;

std::size_t upTo(Random& random, std::size_t count) {
  return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
}

const std::vector<std::string>& tokens() {
  static const std::vector<std::string> list = {
      "{",        "}",         "[",        "]",      ",",        ":",    "\"",       "null",
      "true",     "-1",        "1e308",    "1e-308", "99999999", "0.5",  "\"all\"",  "\"fold\"",
      "\"do\":",  "[]",        "{}",       "[1,2]",  "\\u00",    "\xff", "\xEF\xBB", "\n",
      "\"line\"", "\"paper\"", "\"top\":", "//",     "-",        "1e"};
  return list;
}

/// One to four small damages: bytes changed, parts dropped, doubled or exchanged for tokens.
std::string damaged(std::string text, Random& random) {
  const std::size_t count = 1 + upTo(random, 4);
  for (std::size_t i = 0; i < count && !text.empty(); ++i) {
    const std::size_t at = upTo(random, text.size());
    const std::size_t length = 1 + upTo(random, 12);
    switch (upTo(random, 5)) {
      case 0:
        text[at] = static_cast<char>(upTo(random, 256));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(at, length));
        break;
      case 3:
        text.replace(at, length, tokens()[upTo(random, tokens().size())]);
        break;
      default:
        text.insert(at, tokens()[upTo(random, tokens().size())]);
        break;
    }
  }
  return text;
}

std::vector<std::string> seeds() {
  std::vector<std::string> out = {test::fileWithSheet(
      R"({"shape":"polygon","outline":[[0,0],[9,0],[0,9]],"holes":[[[1,1],[2,1],[1,2]]]})")};
  for (const std::string& step : test::everyStep()) out.push_back(test::fileWithSteps(step));
  return out;
}

TEST(KiriReaderFuzz, EveryDamagedFileGivesAModelOrASentence) {
  Random random(kSeed);
  const std::vector<std::string> texts = seeds();
  int readable = 0;
  for (int i = 0; i < kCases; ++i) {
    const std::string text = damaged(texts[upTo(random, texts.size())], random);
    const Result<LoadedModel> loaded = readKiri(text, "f.kiri");
    if (!loaded.isOk()) {
      ASSERT_EQ(loaded.error().message.rfind("f.kiri:", 0), 0u) << text;
      continue;
    }
    ++readable;
    const std::string written = writeKiri(loaded->model);
    const Result<LoadedModel> again = readKiri(written, "f.kiri");
    ASSERT_TRUE(again.isOk()) << "seed " << kSeed << " case " << i << "\n"
                              << text << "\n"
                              << written << again.error().message;
    ASSERT_EQ(writeKiri(again->model), written) << text;
  }
  EXPECT_GT(readable, kCases / 100)
      << "the damages are small enough for some files to stay readable";
}

TEST(KiriReaderFuzz, EveryTruncatedFileGivesASentence) {
  const std::string text = test::fileWithEverything();
  const std::size_t end = text.find_last_of('}');
  for (std::size_t length = 0; length <= end; ++length) {
    ASSERT_FALSE(readKiri(text.substr(0, length), "f.kiri").isOk()) << length;
  }
}

}  // namespace
}  // namespace kiri
