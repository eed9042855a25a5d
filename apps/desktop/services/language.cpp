// The language of the window.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <memory>
#include <utility>
#include <vector>

// Resources of a static library are left out of the program unless they are asked for, outside of
// any namespace.
// The name of the resource is that of cmake/KiriTranslations.cmake.
static void makeTranslationsKnown() { Q_INIT_RESOURCE(kirisim_translations); }

namespace kiri::desktop {

namespace {

using Translators = std::vector<std::unique_ptr<QTranslator>>;

Translators& spoken() {
  static Translators translators;
  return translators;
}

void add(const QString& file, const QString& folder) {
  auto translator = std::make_unique<QTranslator>();
  if (!translator->load(file, folder)) return;
  QCoreApplication::installTranslator(translator.get());
  spoken().push_back(std::move(translator));
}

QString codeOfDesktop() {
  for (const QString& name : QLocale::system().uiLanguages()) {
    QString code = name.section('-', 0, 0);
    if (languages().contains(code)) return code;
  }
  return languages().first();
}

}  // namespace

QStringList languages() { return {QStringLiteral("en"), QStringLiteral("de")}; }

QString speak(const QString& code) {
  makeTranslationsKnown();
  spoken().clear();
  QString language = languages().contains(code) ? code : codeOfDesktop();
  if (language == languages().first()) return language;
  // Qt's own words first: ours are asked before them.
  add("qtbase_" + language, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  add("kirisim_" + language, ":/translations");
  return language;
}

}  // namespace kiri::desktop
