// Widgets for a list of fields: of the tool at work, or of a step that is done.
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>
#include <functional>
#include <string>
#include <vector>

#include "editor/base/field.h"

class QLayout;

namespace kiri::desktop {

/// Shows any fields and says what a person sets them to. When the same fields come with other
/// values the widgets stay, so that a number can be typed while the hand drags.
class FieldEditor final : public QWidget {
  Q_OBJECT
 public:
  /// Row: side by side, told while typing. Form: one below the other, told when typing has ended.
  enum class Layout { Row, Form };
  explicit FieldEditor(Layout layout, QWidget* parent = nullptr);

  void show(const std::vector<Field>& fields);
  const std::vector<Field>& fields() const { return fields_; }
  /// The widget of a field, for focus and for tests; none where there is no such field.
  QWidget* widgetOf(const std::string& id) const;
  /// Row: shows as many fields as `width` pixels hold, hides the rest, and says how many are shown.
  std::size_t fitInto(int width);
  /// Puts the cursor into the first number.
  bool focusFirst();

 signals:
  void edited(const QString& id, const kiri::FieldValue& value);

 private:
  struct Row {
    std::string id;
    QWidget* widget = nullptr;
    QWidget* label = nullptr;  ///< beside it in a row; none where the widget says itself what it is
    std::function<void(const Field&)> update;
  };
  bool fits(const std::vector<Field>& fields) const;
  void rebuild(const std::vector<Field>& fields);
  void add(const Field& field);
  Row makeNumber(const Field& field);
  Row makeChoice(const Field& field);
  Row makeSegments(const Field& field);
  Row makeSwitch(const Field& field);
  Row makeText(const Field& field);
  Row makeNotes(const Field& field);
  Row makeButton(const Field& field);
  void tell(const std::string& id, double number, const QString& text = {});

  Layout layout_;
  QWidget* inside_ = nullptr;
  std::vector<Field> fields_;
  std::vector<Row> rows_;
  bool isUpdating_ = false;
};

}  // namespace kiri::desktop
