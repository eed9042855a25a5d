// From a blank sheet to a leaf by hand alone.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "io/kiri_reader.h"
#include "io/kiri_writer.h"
#include "tests/editor/session/hand.h"
#include "tests/support/example_files.h"
#include "tests/support/expect.h"
#include "tests/support/order_check.h"

namespace kiri {
namespace {

using test::Hand;
using test::Sitter;

FoldedState exampleLeaf() {
  return *Document::create(test::modelOfExample("leaf_palmate")).value().state();
}

TEST(LeafJourney, APalmateLeafIsFoldedCutUnfoldedSavedAndUndoneByHand) {
  DirectRunner runner;
  Hand hand(runner);
  Sitter person(hand);
  hand.open("square 200");
  hand.session.setLeaf(true);
  ASSERT_EQ(test::foldPalmateLeaf(person), "") << hand.session.notice().why;
  EXPECT_EQ(hand.session.document().state()->pattern.facets.size(), 12u);
  test::cutPalmateMargin(person);
  ASSERT_EQ(hand.session.document().count(), 14u) << hand.session.notice().why;
  person.command("unfold-all");
  ASSERT_EQ(hand.session.document().count(), 15u) << hand.session.notice().why;
  const FoldedState& leaf = *hand.session.document().state();
  EXPECT_EQ(leaf.pattern.facets.size(), 12u);
  EXPECT_TRUE(leaf.collisions.empty());
  // Drawn with pixels of about a third of a millimetre, it is the example's leaf all the same.
  EXPECT_NEAR(areaOf(leaf.pattern) / areaOf(exampleLeaf().pattern), 1, 0.01);

  const std::string saved = writeKiri(hand.session.document().modelToSave());
  const Result<LoadedModel> loaded = readKiri(saved, "leaf.kiri");
  ASSERT_TRUE(loaded.isOk());
  const Result<Document> again = Document::create(loaded->model);
  ASSERT_TRUE(again.isOk());
  EXPECT_EQ(areaOf(again->state()->pattern), areaOf(leaf.pattern));

  for (int i = 0; i < 20; ++i) person.command("undo");
  EXPECT_EQ(hand.session.document().count(), 0u);
  EXPECT_EQ(hand.session.document().state()->pattern.facets.size(), 1u);
}

}  // namespace
}  // namespace kiri
