// The examples in their groups, with a field to search them.
// SPDX-License-Identifier: MIT
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QList>
#include <QWidget>

#include "apps/desktop/dialogs/card_list.h"

namespace kiri::desktop {

/// The arrow keys go from group to group.
class GalleryPart final : public QWidget {
  Q_OBJECT
 public:
  explicit GalleryPart(ModelCards& cards, QWidget* parent = nullptr);

  void show(const QList<ExampleGroup>& groups);
  /// All models, in order.
  QStringList paths() const;
  QLineEdit& search() { return *search_; }
  QList<CardList*> lists() const;

 signals:
  void chosen(const QString& path);
  void looked(const QString& path);
  /// The keyboard is at this card: the page shall show it.
  void reached(QWidget* list, const QRect& card);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Group {
    ExampleGroup what;
    QWidget* part = nullptr;
    CardList* list = nullptr;
  };
  void add(const ExampleGroup& what);
  void connectList(CardList& list);
  void filter();
  void goOn(const CardList& from, int direction, int x);

  ModelCards& cards_;
  QLineEdit* search_;
  QLabel* nothing_;
  QWidget* groupsPart_;
  QList<Group> groups_;
};

}  // namespace kiri::desktop
