// Widgets for fields, and numbers as people type them.
// SPDX-License-Identifier: MIT
#include "apps/desktop/panels/field_editor.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QTest>
#include <QToolButton>

#include "apps/desktop/panels/unit_box.h"

namespace kiri::desktop {
namespace {

Field number(const std::string& id, double value, const std::string& unit = "mm") {
  Field field;
  field.id = id;
  field.label = {id, {}};
  field.value = value;
  field.least = 0;
  field.most = 500;
  field.unit = unit;
  return field;
}

Field choice(const std::string& id, int options) {
  Field field;
  field.id = id;
  field.label = {id, {}};
  field.kind = Field::Kind::Choice;
  for (int i = 0; i < options; ++i) field.options.push_back({"option " + std::to_string(i), {}});
  return field;
}

Field of(Field::Kind kind, const std::string& id) {
  Field field;
  field.id = id;
  field.label = {id, {}};
  field.kind = kind;
  return field;
}

struct Told {
  QString id;
  FieldValue value;
};

struct Editor {
  explicit Editor(FieldEditor::Layout layout) : shown(layout) {
    QObject::connect(&shown, &FieldEditor::edited, &shown,
                     [this](const QString& id, const FieldValue& value) {
                       told.push_back({id, value});
                     });
    shown.resize(600, 60);
    shown.setVisible(true);
  }
  void show(const std::vector<Field>& fields) { shown.show(fields); }
  /// Only an active window has a focus.
  bool activate() {
    for (int i = 0; i < 5; ++i) {  // the window manager may not be there yet
      shown.activateWindow();
      if (QTest::qWaitForWindowActive(&shown, 1000)) return true;
      shown.setVisible(false);
      shown.setVisible(true);
    }
    return false;
  }
  QWidget* widgetOf(const std::string& id) const { return shown.widgetOf(id); }
  template <class W>
  W* find(const std::string& id) const {
    return qobject_cast<W*>(widgetOf(id));
  }
  FieldEditor shown;
  std::vector<Told> told;
};

TEST(TypedNumber, TakesUnitsOfTheSameKindAndRefusesOthers) {
  EXPECT_DOUBLE_EQ(*typedNumber("12.5", "mm"), 12.5);
  EXPECT_DOUBLE_EQ(*typedNumber("12,5 mm", "mm"), 12.5);
  EXPECT_DOUBLE_EQ(*typedNumber("2.5 cm", "mm"), 25);
  EXPECT_DOUBLE_EQ(*typedNumber("1in", "mm"), 25.4);
  EXPECT_DOUBLE_EQ(*typedNumber("150/4", "mm"), 37.5);
  EXPECT_DOUBLE_EQ(*typedNumber("-90 deg", "°"), -90);
  EXPECT_NEAR(*typedNumber("3.14159265 rad", "°"), 180, 1e-5);
  EXPECT_FALSE(typedNumber("90 deg", "mm"));
  EXPECT_FALSE(typedNumber("3 cm", "°"));
  EXPECT_FALSE(typedNumber("", "mm"));
  EXPECT_FALSE(typedNumber("one", "mm"));
  EXPECT_FALSE(typedNumber("1/0", "mm"));
}

TEST(UnitBox, ShowsNoMoreDigitsThanTheNumberHas) {
  UnitBox box;
  box.setRange(-1000, 1000);
  box.setUnit("mm");
  box.setValue(52.1);
  EXPECT_EQ(box.text(), "52.1 mm");
  box.setUnit("°");
  box.setValue(180);
  EXPECT_EQ(box.text(), "180°");
  box.setValue(-0.0001);
  EXPECT_EQ(box.text(), "0°");
}

TEST(FieldEditor, TellsANumberThatIsTypedWithAUnit) {
  Editor editor(FieldEditor::Layout::Row);
  editor.show({number("length", 10)});
  auto* box = editor.find<UnitBox>("length");
  ASSERT_NE(box, nullptr);
  EXPECT_TRUE(editor.told.empty()) << "showing is not editing";
  ASSERT_TRUE(editor.activate());
  box->setFocus();
  box->selectAll();
  QTest::keyClicks(box, "4 cm");
  ASSERT_FALSE(editor.told.empty());
  EXPECT_EQ(editor.told.back().id, "length");
  EXPECT_DOUBLE_EQ(editor.told.back().value.number, 40);
}

TEST(FieldEditor, DoesNotTakeTheTextOutOfTheHandThatTypes) {
  Editor editor(FieldEditor::Layout::Row);
  editor.show({number("length", 10)});
  auto* box = editor.find<UnitBox>("length");
  QObject::connect(&editor.shown, &FieldEditor::edited, &editor.shown,
                   [&](const QString&, const FieldValue& value) {
                     editor.show({number("length", value.number)});
                   });
  ASSERT_TRUE(editor.activate());
  box->setFocus();
  box->selectAll();
  QTest::keyClicks(box, "2.50");
  EXPECT_EQ(box->text(), "2.50 mm") << "not 2.5: the zero was typed";
  QTest::keyClicks(box, "4");
  EXPECT_DOUBLE_EQ(box->value(), 2.504);
}

TEST(FieldEditor, KeepsItsWidgetsWhenOnlyValuesChange) {
  Editor editor(FieldEditor::Layout::Row);
  editor.show({number("a", 1), choice("b", 3)});
  QWidget* a = editor.widgetOf("a");
  editor.show({number("a", 2), choice("b", 3)});
  EXPECT_EQ(editor.widgetOf("a"), a);
  EXPECT_DOUBLE_EQ(editor.find<UnitBox>("a")->value(), 2);
  editor.show({choice("b", 3)});
  EXPECT_EQ(editor.widgetOf("a"), nullptr);
}

TEST(FieldEditor, ShowsFewOptionsAsButtonsAndManyAsAList) {
  Editor editor(FieldEditor::Layout::Row);
  editor.show({choice("few", 2), choice("many", 7)});
  EXPECT_EQ(editor.widgetOf("few")->findChildren<QToolButton*>().size(), 2);
  ASSERT_NE(editor.find<QComboBox>("many"), nullptr);
  editor.widgetOf("few")->findChildren<QToolButton*>()[1]->click();
  ASSERT_EQ(editor.told.size(), 1U);
  EXPECT_DOUBLE_EQ(editor.told[0].value.number, 1);
  editor.find<QComboBox>("many")->setCurrentIndex(5);
  ASSERT_EQ(editor.told.size(), 2U);
  EXPECT_EQ(editor.told[1].id, "many");
  EXPECT_DOUBLE_EQ(editor.told[1].value.number, 5);
}

TEST(FieldEditor, TellsSwitchesButtonsAndText) {
  Editor editor(FieldEditor::Layout::Row);
  editor.show({of(Field::Kind::Switch, "on"), of(Field::Kind::Button, "do"),
               of(Field::Kind::Text, "name")});
  editor.find<QCheckBox>("on")->click();
  editor.find<QAbstractButton>("do")->click();
  QTest::keyClicks(editor.widgetOf("name"), "ab");
  ASSERT_EQ(editor.told.size(), 4U);
  EXPECT_DOUBLE_EQ(editor.told[0].value.number, 1);
  EXPECT_EQ(editor.told[1].id, "do");
  EXPECT_EQ(editor.told[3].value.text, "ab");
}

TEST(FieldEditor, AFormTellsTextOnlyWhenTypingHasEnded) {
  Editor editor(FieldEditor::Layout::Form);
  editor.show({of(Field::Kind::Text, "title"), number("angle", 90, "°")});
  auto* line = editor.find<QLineEdit>("title");
  QTest::keyClicks(line, "leaf");
  EXPECT_TRUE(editor.told.empty());
  QTest::keyClick(line, Qt::Key_Return);
  ASSERT_EQ(editor.told.size(), 1U);
  EXPECT_EQ(editor.told[0].value.text, "leaf");
}

TEST(FieldEditor, NamesItsWidgetsForThoseWhoDoNotSee) {
  Editor editor(FieldEditor::Layout::Form);
  editor.show({number("angle", 90, "°"), of(Field::Kind::Switch, "on"), choice("type", 2)});
  for (const char* id : {"angle", "on", "type"}) {
    EXPECT_FALSE(editor.widgetOf(id)->accessibleName().isEmpty()) << id;
  }
}

}  // namespace
}  // namespace kiri::desktop
