// Random walks of changes: undoing gives back every version bit by bit, and a file of it the same.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/model/apply.h"
#include "editor/document/document.h"
#include "io/kiri_reader.h"
#include "io/kiri_writer.h"
#include "tests/support/random_steps.h"
#include "tests/support/sanitized.h"
#include "tests/support/state_text.h"

namespace kiri::test {
namespace {

constexpr std::uint64_t kSeeds = casesOf<std::uint64_t>(8, 2);

struct Version {
  std::string file;
  std::string state;
  bool operator==(const Version&) const = default;
};

Version versionOf(const Document& document) {
  const auto state = document.stateAfter(document.count());
  return {writeKiri(document.modelToSave()), state ? textOf(*state) : "none"};
}

Color randomColor(Random& random) { return {static_cast<std::uint8_t>(random.below(256)), 10, 20}; }

/// An earlier step with other numbers.
Step variant(Random& random, Step step) {
  step.title = "edited";
  if (FoldStep* fold = std::get_if<FoldStep>(&step.action)) {
    fold->angle = random.chance(0.5) ? 180 : random.between(10, 170);
    if (random.chance(0.3)) fold->name += "x";
  }
  if (RotateStep* rotate = std::get_if<RotateStep>(&step.action)) rotate->degrees += 10;
  return step;
}

Change randomChange(Random& random, const Document& document) {
  constexpr std::size_t kAdding = 11;
  const std::size_t count = document.count();
  switch (count == 0 ? kAdding : random.below(12)) {
    case 0: {
      SheetSpec square;
      square.width = 100 + static_cast<double>(random.below(3));
      return setSheet(square);
    }
    case 1:
      return setSides({randomColor(random), ""}, {});
    case 2:
      return setTitle("title " + std::to_string(random.below(5)), "");
    case 3:
      return removeStep(random.below(count));
    case 4: {
      const std::size_t i = random.below(count);
      return editStep(i, variant(random, document.model().steps[i]));
    }
    default:
      return addStep(randomStep(random, *document.state(), {.facetLimit = 16}));
  }
}

/// A document and all versions that undo can reach, kept beside it.
class Walk {
 public:
  Walk(std::uint64_t seed, std::size_t facetsKept)
      : random_(seed), document_(Document::create(randomSheet(random_)).value()) {
    document_.keepFacets(facetsKept);
    versions_ = {versionOf(document_)};
  }

  /// Steps only, so that there is something to walk on.
  void grow() {
    for (int i = 0; i < 40; ++i)
      change(addStep(randomStep(random_, *document_.state(), {.facetLimit = 16})));
  }

  void go() {
    switch (random_.below(8)) {
      case 0:
      case 1:
        return undo();
      case 2:
        return redo();
      case 3:
        return look();
      default:
        return change(randomChange(random_, document_));
    }
  }

  bool hasReplayed() const { return hasReplayed_; }
  std::size_t mostFacets() const { return mostFacets_; }

  void undo() {
    hasReplayed_ |= document_.isUndoLong();
    if (document_.cursor() < document_.count()) {
      EXPECT_TRUE(document_.undo());
      EXPECT_EQ(document_.cursor(), document_.count());
      return check();
    }
    EXPECT_EQ(document_.canUndo(), now_ > 0);
    if (document_.undo()) --now_;
    check();
  }

  void redo() {
    hasReplayed_ |= document_.isRedoLong();
    EXPECT_EQ(document_.canRedo(), now_ + 1 < versions_.size());
    if (document_.redo()) ++now_;
    check();
  }

  void undoAll() {
    while (document_.canUndo()) undo();
    EXPECT_EQ(now_, 0u);
  }
  void redoAll() {
    while (document_.canRedo()) redo();
    EXPECT_EQ(now_ + 1, versions_.size());
  }

  void checkFile() {
    const std::string file = writeKiri(document_.modelToSave());
    const Document again = Document::create(readKiri(file, "saved").value().model).value();
    EXPECT_EQ(firstDifference(versionOf(again).state, versions_[now_].state), "");
    EXPECT_EQ(versionOf(again).file, versions_[now_].file);
  }

 private:
  void check() {
    mostFacets_ = std::max(mostFacets_, document_.state()->pattern.facets.size());
    EXPECT_EQ(versionOf(document_).file, versions_[now_].file);
    EXPECT_EQ(firstDifference(versionOf(document_).state, versions_[now_].state), "");
    EXPECT_EQ(document_.isModified(), versions_[now_].file != versions_[0].file);
  }

  void look() {
    if (document_.count() > 0) document_.jumpTo(random_.below(document_.count()));
    check();
  }

  void change(const Change& change) {
    Result<History> next = change(document_.history(), {});
    if (!next) return check();
    document_.become(std::move(*next), {"change", {}});
    const Version version = versionOf(document_);
    versions_.resize(now_ + 1);
    if (!(version == versions_.back())) versions_.push_back(version);
    now_ = versions_.size() - 1;
    check();
  }

  Random random_;
  Document document_;
  std::vector<Version> versions_;
  std::size_t now_ = 0;
  bool hasReplayed_ = false;
  std::size_t mostFacets_ = 0;
};

class DocumentWalk : public testing::TestWithParam<std::uint64_t> {};

TEST_P(DocumentWalk, UndoAndRedoGiveBackEveryVersionBitByBit) {
  SCOPED_TRACE("seed " + std::to_string(GetParam()));
  Walk walk(GetParam(), SIZE_MAX);
  walk.grow();
  for (int i = 0; i < 100 && !HasFailure(); ++i) walk.go();
  walk.checkFile();
  walk.undoAll();
  walk.redoAll();
  walk.checkFile();
  EXPECT_FALSE(walk.hasReplayed());
  EXPECT_GT(walk.mostFacets(), 4u);
}

TEST_P(DocumentWalk, StatesThatWereForgottenComeBackBitByBit) {
  SCOPED_TRACE("seed " + std::to_string(GetParam()));
  Walk walk(GetParam(), 3);
  walk.grow();
  for (int i = 0; i < 100 && !HasFailure(); ++i) walk.go();
  walk.undoAll();
  walk.redoAll();
  walk.checkFile();
  EXPECT_TRUE(walk.hasReplayed());
}

INSTANTIATE_TEST_SUITE_P(Seeds, DocumentWalk, testing::Range<std::uint64_t>(1, 1 + kSeeds));

}  // namespace
}  // namespace kiri::test
