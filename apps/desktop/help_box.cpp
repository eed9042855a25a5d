// The help: tools, keys and how to move about, on one page.
// SPDX-License-Identifier: MIT
#include "apps/desktop/help_box.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "apps/desktop/words.h"

namespace kiri::desktop {
namespace {

/// Every action that says what it does, with its key as it is now.
QString rowsOf(const Actions& actions) {
  QString rows;
  for (const QAction* action : actions.all()) {
    if (action->statusTip().isEmpty()) continue;
    const QString keys = QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText);
    rows += QString("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2&nbsp;&nbsp;</td><td>%3</td></tr>")
                .arg(action->iconText().toHtmlEscaped(), keys.toHtmlEscaped(),
                     action->statusTip().toHtmlEscaped());
  }
  return rows;
}

}  // namespace

void openHelp(QWidget& window, const Actions& actions) {
  auto* dialog = new QDialog(&window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Help"));
  dialog->resize(720, 620);
  auto* page = new QTextBrowser(dialog);
  page->setAccessibleName(tr("Help"));
  page->setHtml(
      tr("<h3>Working with the paper</h3><p>Take up a tool, work in either pane, and press Enter "
         "to do what is shown or Esc to drop it. The line at the foot of the window says what to "
         "do next.</p><p>Drag the background or the right button to turn the model, the middle "
         "button or Space to pan, the wheel to zoom. Ctrl suspends snapping; with the wheel it "
         "walks through the layers. All keys can be changed in the preferences.</p>") +
      "<table>" + rowsOf(actions) + "</table>");
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  auto* column = new QVBoxLayout(dialog);
  column->addWidget(page);
  column->addWidget(buttons);
  dialog->open();
}

}  // namespace kiri::desktop
