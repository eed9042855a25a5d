// The program kirisim: the window of the virtual-paper laboratory.
// SPDX-License-Identifier: MIT
#include <QCommandLineParser>
#include <QSurfaceFormat>
#include <algorithm>

#include "apps/desktop/look/theme.h"
#include "apps/desktop/main_window.h"
#include "apps/desktop/services/crash_handler.h"
#include "apps/desktop/services/language.h"
#include "apps/desktop/views/gl_model_view.h"

namespace {

using namespace kiri::desktop;

struct Wishes {
  QString file;
  MainWindow::Options options;
};

/// Ends the program where that is what was asked for (--help, --version).
Wishes readArguments(const QCoreApplication& application) {
  QCommandLineParser parser;
  parser.setApplicationDescription(
      QCoreApplication::translate("main", "KiriSim: fold, tear, cut and unfold virtual paper."));
  parser.addHelpOption();
  parser.addVersionOption();
  const QCommandLineOption software(
      "software", QCoreApplication::translate("main", "Draw without the graphics card."));
  parser.addOption(software);
  parser.addPositionalArgument(
      "MODEL",
      QCoreApplication::translate(
          "main", "A model (.kiri) or a crease pattern (.fold, .cp, .opx, .svg, .dxf) to open."),
      "[MODEL]");
  parser.process(application);
  Wishes wishes;
  if (!parser.positionalArguments().isEmpty()) wishes.file = parser.positionalArguments().front();
  if (parser.isSet(software)) wishes.options.drawing = ModelView::Drawing::Software;
  return wishes;
}

/// What needs no window needs no screen either.
bool wantsOnlyWords(int argc, char** argv) {
  return std::any_of(argv + 1, argv + argc, [](const char* argument) {
    const QByteArrayView word(argument);
    return word == "--help" || word == "-h" || word == "--help-all" || word == "--version" ||
           word == "-v";
  });
}

void nameProgram() {
  QCoreApplication::setApplicationName("kirisim");
  QCoreApplication::setOrganizationName("KiriSim");
  QCoreApplication::setApplicationVersion(KIRI_VERSION);
}

Shade shadeOf(const Settings& settings, Shade desktop) {
  switch (settings.preferences().theme) {
    case ThemeChoice::Light:
      return Shade::Light;
    case ThemeChoice::Dark:
      return Shade::Dark;
    case ThemeChoice::System:
      break;
  }
  return desktop;
}

}  // namespace

int main(int argc, char** argv) {
  if (wantsOnlyWords(argc, argv)) {
    const QCoreApplication application(argc, argv);
    nameProgram();
    readArguments(application);
    return 0;
  }
  QSurfaceFormat::setDefaultFormat(surfaceFormat());
  Application application(argc, argv);
  nameProgram();
  QGuiApplication::setApplicationDisplayName("KiriSim");
  const Wishes wishes = readArguments(application);
  installCrashHandler(journalFolder(), KIRI_VERSION);

  Settings settings;
  speak(settings.preferences().language);
  const Shade desktop = shadeOfDesktop();
  applyTheme(application, shadeOf(settings, desktop));
  QObject::connect(&settings, &Settings::preferencesChanged, &application, [&] {
    const Shade shade = shadeOf(settings, desktop);
    if (theme().shade != shade) applyTheme(application, shade);
  });
  PoolRunner runner;
  MainWindow window(runner, settings, wishes.options);
  window.show();
  window.dialogs().begin(!wishes.file.isEmpty());
  if (!wishes.file.isEmpty()) window.files().openFile(wishes.file);
  return QApplication::exec();
}
