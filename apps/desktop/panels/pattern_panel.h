// The crease pattern of the model: repairs, faults, verdict, and its folded states to walk through.
// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QWidget>
#include <cstddef>
#include <string>

#include "apps/desktop/services/session_hub.h"

class QCheckBox;
class QLabel;
class QListWidget;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace kiri::desktop {

/// A long number as people read it: groups of three digits; from 25 digits on its first ones and
/// the power of ten.
QString grouped(const std::string& decimal);

/// Shows what the session's PatternDesk knows. Clicking an entry marks it and moves the sheet
/// there; the buttons of a component show its previous and next state.
class PatternPanel final : public QWidget {
  Q_OBJECT
 public:
  explicit PatternPanel(SessionHub& hub, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {290, 420}; }

  /// The next or previous state of the chosen component, else of the first.
  void walk(int by);

  QTreeWidget& components() { return *components_; }
  QListWidget& faults() { return *faults_; }
  QListWidget& repairs() { return *repairs_; }
  QString verdict() const;
  QString total() const;

 private:
  void makeLists();
  void connectLists();
  void refresh();
  void showVerdict(const PatternView& view);
  void showTotal(const PatternView& view);
  void showComponents(const PatternView& view);
  void showFaults(const PatternView& view);
  void showRepairs(const PatternView& view);
  void fillRow(QTreeWidgetItem& item, std::size_t index, const PatternComponent& component);
  void addButtons(QTreeWidgetItem& item, std::size_t index);
  PatternDesk& desk() { return hub_.session().pattern(); }

  SessionHub& hub_;
  QLabel* empty_;
  QLabel* sign_;
  QLabel* verdict_;
  QLabel* total_;
  QToolButton* count_;
  QTreeWidget* components_;
  QLabel* faultsTitle_;
  QCheckBox* marks_;
  QListWidget* faults_;
  QLabel* repairsTitle_;
  QListWidget* repairs_;
  bool isUpdating_ = false;
};

}  // namespace kiri::desktop
