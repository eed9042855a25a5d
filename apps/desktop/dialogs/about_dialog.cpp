// About: version, licences, and what draws the window.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/about_dialog.h"

#include <QApplication>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSysInfo>
#include <QVBoxLayout>

#include "apps/desktop/dialogs/form.h"
#include "apps/desktop/look/icons.h"

namespace kiri::desktop {

namespace {

// Names and licences of what the program is made with (docs/dependencies.md).
constexpr const char* kMadeWith =
    "Qt (LGPL 3) · cairo (LGPL 2.1) · libepoxy (MIT) · Eigen (MPL 2) · nlohmann-json (MIT) · "
    "libpng (libpng licence)";

}  // namespace

AboutDialog::AboutDialog(const QString& version, const QString& renderer, QWidget* parent)
    : QDialog(parent) {
  setWindowTitle(tr("About KiriSim"));
  facts_ = QString("KiriSim %1\nQt %2\n%3\n%4, %5")
               .arg(version, qVersion(), renderer, QSysInfo::prettyProductName(),
                    QSysInfo::currentCpuArchitecture());
  constexpr int kIcon = 96;
  auto* picture = new QLabel;
  picture->setPixmap(icon("kirisim").pixmap(QSize(kIcon, kIcon), devicePixelRatioF()));
  picture->setAlignment(Qt::AlignTop);
  auto* text = new QVBoxLayout;
  text->setSpacing(8);
  text->addWidget(headline(tr("KiriSim %1").arg(version)));
  auto* what = new QLabel(
      tr("A virtual-paper laboratory: fold, tear and cut a sheet of paper, unfold it, and see "
         "what has become of it."));
  what->setWordWrap(true);
  text->addWidget(what);
  auto* licence = new QLabel(
      tr("Free software under the MIT licence. The program comes without any warranty."));
  licence->setWordWrap(true);
  text->addWidget(licence);
  text->addWidget(remark(tr("Made with %1.").arg(kMadeWith)));
  auto* facts = remark(facts_);
  facts->setTextInteractionFlags(Qt::TextSelectableByMouse);
  text->addWidget(facts);
  text->addStretch();
  auto* upper = new QHBoxLayout;
  upper->setSpacing(20);
  upper->addWidget(picture);
  upper->addLayout(text, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  auto* copy = buttons->addButton(tr("Copy facts"), QDialogButtonBox::ActionRole);
  connect(copy, &QPushButton::clicked, this,
          [this] { QApplication::clipboard()->setText(facts_); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(20, 20, 20, 16);
  layout->setSpacing(16);
  layout->addLayout(upper, 1);
  withoutIcons(*buttons);
  layout->addWidget(buttons);
  setMinimumWidth(520);
}

}  // namespace kiri::desktop
