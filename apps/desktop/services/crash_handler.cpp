// What is left behind when the program itself is wrong.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/crash_handler.h"

#include <fcntl.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMetaObject>
#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>

namespace kiri::desktop {

namespace {

/// All that a handler of signals may touch, made ready before anything happens.
struct Prepared {
  std::array<char, 4096> path{};
  std::array<char, 1024> head{};
  std::array<char, 1024> claim{};  ///< of the exception that ends the program
  std::atomic<bool> isWritten = false;
};
Prepared prepared;

// A stack for the handler: the program's own may be what overflowed.
std::array<char, 65536> handlerStack;

constexpr int kSignals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

const char* nameOf(int signal) {
  switch (signal) {
    case SIGSEGV:
      return "SIGSEGV (memory that is not there)\n";
    case SIGBUS:
      return "SIGBUS\n";
    case SIGFPE:
      return "SIGFPE (a division by zero)\n";
    case SIGILL:
      return "SIGILL\n";
    case SIGABRT:
      return "SIGABRT\n";
    default:
      return "a signal\n";
  }
}

void put(int file, const char* text) {
  std::size_t left = std::strlen(text);
  while (left > 0) {
    const ssize_t count = ::write(file, text, left);
    if (count <= 0) return;
    text += count;
    left -= static_cast<std::size_t>(count);
  }
}

/// Only what is safe in a handler of signals: open, write, close.
void writeReport(const char* what) {
  if (prepared.isWritten.exchange(true)) return;
  const int file = ::open(prepared.path.data(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (file >= 0) {
    put(file, prepared.head.data());
    put(file, "ended by: ");
    put(file, what);
    if (prepared.claim[0] != 0) {
      put(file, "because this did not hold: ");
      put(file, prepared.claim.data());
      put(file, "\n");
    }
    ::close(file);
  }
  put(STDERR_FILENO, "KiriSim has crashed. What you were working on is kept and will be offered ");
  put(STDERR_FILENO, "at the next start. A report is in ");
  put(STDERR_FILENO, prepared.path.data());
  put(STDERR_FILENO, "\n");
}

void onSignal(int signal) {
  writeReport(nameOf(signal));
  // SA_RESETHAND has put the ordinary end back in its place.
  ::raise(signal);
}

template <std::size_t N>
void copyInto(std::array<char, N>& place, const std::string& text) {
  const std::size_t count = std::min(text.size(), N - 1);
  std::copy_n(text.begin(), count, place.begin());
  place[count] = 0;
}

/// What the exception under way says; empty when there is none.
std::string sentenceOfException() {
  if (!std::current_exception()) return {};
  try {
    std::rethrow_exception(std::current_exception());
  } catch (const std::exception& thrown) {
    return thrown.what();
  } catch (...) {
    return "an unknown exception";
  }
}

[[noreturn]] void onTerminate() {
  copyInto(prepared.claim, sentenceOfException());
  std::abort();
}

QString folderOfReports() {
  return QFileInfo(QFile::decodeName(prepared.path.data())).absolutePath();
}

constexpr const char* kPattern = "crash-*.txt";

}  // namespace

void installCrashHandler(const QString& folder, const QString& version) {
  QDir().mkpath(folder);
  const QDateTime now = QDateTime::currentDateTime();
  const QString name = QString("crash-%1-%2.txt")
                           .arg(now.toString("yyyyMMdd-hhmmss"))
                           .arg(static_cast<qlonglong>(::getpid()));
  copyInto(prepared.path, QFile::encodeName(QDir(folder).filePath(name)).toStdString());
  copyInto(prepared.head, QString("KiriSim %1, Qt %2, started %3\n")
                              .arg(version, qVersion(), now.toString(Qt::ISODate))
                              .toStdString());
  stack_t stack{};
  stack.ss_sp = handlerStack.data();
  stack.ss_size = handlerStack.size();
  ::sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = onSignal;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_ONSTACK;
  for (const int signal : kSignals) ::sigaction(signal, &action, nullptr);
  std::set_terminate(onTerminate);
}

QString writeDefectReport(const QString& sentence) {
  if (prepared.path[0] == 0) return {};
  QFile file(QDir(folderOfReports()).filePath("defects.txt"));
  if (!file.open(QIODevice::WriteOnly | QIODevice::Append)) return {};
  file.write(prepared.head.data());
  file.write("this did not hold: " + sentence.toUtf8() + "\n");
  return file.fileName();
}

std::vector<CrashReport> crashReportsIn(const QString& folder) {
  std::vector<CrashReport> reports;
  const QFileInfoList files = QDir(folder).entryInfoList({kPattern}, QDir::Files, QDir::Time);
  for (const QFileInfo& info : files) {
    QFile file(info.absoluteFilePath());
    if (!file.open(QIODevice::ReadOnly)) continue;
    reports.push_back({file.fileName(), QString::fromUtf8(file.readAll()), info.lastModified()});
  }
  return reports;
}

void discardReports(const QString& folder) {
  for (const CrashReport& report : crashReportsIn(folder)) QFile::remove(report.file);
}

bool Application::notify(QObject* receiver, QEvent* event) {
  QString sentence;
  try {
    return QApplication::notify(receiver, event);
  } catch (const std::exception& thrown) {
    sentence = QString::fromUtf8(thrown.what());
  } catch (...) {
    sentence = QStringLiteral("an unknown exception");
  }
  const QString report = writeDefectReport(sentence);
  // Shown from an event of its own: the one that failed is over first.
  QMetaObject::invokeMethod(
      this, [this, sentence, report] { emit defectFound(sentence, report); }, Qt::QueuedConnection);
  return true;
}

}  // namespace kiri::desktop
