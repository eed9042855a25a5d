// From a blank sheet to a leaf with mouse and keyboard.
// SPDX-License-Identifier: MIT
#include <QFile>

#include "core/paper/crease_pattern.h"
#include "tests/apps/desktop/journeys/journey.h"

namespace kiri::desktop {
namespace {

TEST_F(Journey, APalmateLeafIsFoldedCutUnfoldedSavedReloadedAndUndoneToTheStart) {
  fresh(200);
  session().setLeaf(true);
  settle();
  ASSERT_EQ(test::foldPalmateLeaf(*this), "") << session().notice().why;
  EXPECT_EQ(session().facts().facets, 12u);
  test::cutPalmateMargin(*this);
  type(Qt::Key_U, Qt::ControlModifier);
  ASSERT_EQ(count(), 15u) << session().notice().why;
  const double area = areaOf(session().document().state()->pattern);
  EXPECT_EQ(session().facts().facets, 12u);
  EXPECT_TRUE(session().document().state()->collisions.empty());
  picture("journey-leaf");
  // What is left are creases that lie flat: the exact picture is drawn without lines.
  EXPECT_LT(differenceFromExactPicture(), 0.02);

  QTemporaryDir folder;
  answers.toSave = folder.filePath("leaf.kiri");
  type(Qt::Key_S, Qt::ControlModifier);
  EXPECT_FALSE(window->isWindowModified());
  ASSERT_TRUE(QFile::exists(answers.toSave));

  window->files().openFile(answers.toSave);
  settle();
  EXPECT_NEAR(areaOf(session().document().state()->pattern), area, 1e-6);
  for (int i = 0; i < 30 && session().document().canUndo(); ++i) {
    type(Qt::Key_Z, Qt::ControlModifier);
  }
  EXPECT_EQ(session().document().cursor(), 0u);
  EXPECT_EQ(session().facts().facets, 1u);
}

}  // namespace
}  // namespace kiri::desktop
