// What is left behind when the program itself is wrong: a short report, and the journal.
// SPDX-License-Identifier: MIT
#pragma once

#include <QApplication>
#include <QDateTime>
#include <QString>
#include <QStringList>
#include <vector>

namespace kiri::desktop {

/// From now on a crash (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, an exception that nobody catches)
/// writes a report of a few lines into `folder`, says so on standard error, and ends the program as
/// it would have ended without. The model needs nothing more: its journal is on disk already
/// (autosave.h). Call once, in main, before anything else is made.
void installCrashHandler(const QString& folder, const QString& version);

/// Writes the report of a defect that the program survives, such as a failed KIRI_CHECK that was
/// caught on its way out of an event. Returns the file; empty when it cannot be written.
QString writeDefectReport(const QString& sentence);

struct CrashReport {
  QString file;
  QString text;
  QDateTime written;
};
/// Reports in the folder, the newest first; the window shows them once, beside what can be
/// recovered, and then calls discardReports.
std::vector<CrashReport> crashReportsIn(const QString& folder);
void discardReports(const QString& folder);

/// The application object. A defect that surfaces in an event is reported instead of ending the
/// program: what is open are values, which an event that did not end has not changed.
///
///   Application application(argc, argv);
///   connect(&application, &Application::defectFound, window, ...);   // dialogs/defect_dialog.h
class Application final : public QApplication {
  Q_OBJECT
 public:
  Application(int& argc, char** argv) : QApplication(argc, argv) {}
  bool notify(QObject* receiver, QEvent* event) override;

 signals:
  /// `report`: the file that tells more; may be empty.
  void defectFound(const QString& sentence, const QString& report);
};

}  // namespace kiri::desktop
