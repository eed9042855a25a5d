// Every sentence of the window has its German one, with the same places for numbers and names.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDirIterator>
#include <QFile>
#include <QLibraryInfo>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <vector>

#include "apps/desktop/look/convert.h"
#include "apps/desktop/services/language.h"
#include "editor/base/phrase.h"
#include "editor/document/gallery.h"

namespace kiri::desktop {
namespace {

struct Sentence {
  QString context;
  QString source;
  QStringList translations;  ///< one, or one for each number
  bool isFinished = true;
};

const QString kGerman = QString(KIRI_SOURCE_DIR) + "/apps/desktop/translations/kirisim_de.ts";

std::vector<Sentence> sentencesIn(const QString& path) {
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
  QXmlStreamReader xml(&file);
  std::vector<Sentence> sentences;
  QString context;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == u"name") context = xml.readElementText();
    if (xml.name() == u"message") sentences.push_back({context, {}, {}, true});
    if (xml.name() == u"source") sentences.back().source = xml.readElementText();
    if (xml.name() == u"translation") {
      sentences.back().isFinished = xml.attributes().value("type") != u"unfinished";
      while (xml.readNext() != QXmlStreamReader::EndElement || xml.name() != u"translation") {
        if (xml.isStartElement()) {
          sentences.back().translations.append(xml.readElementText());
        } else if (xml.isCharacters() && !xml.isWhitespace()) {
          sentences.back().translations.append(xml.text().toString());
        }
      }
    }
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  return sentences;
}

QStringList placesIn(const QString& text) {
  QStringList places;
  static const QRegularExpression kPlace("%[1-9n]");
  for (auto match = kPlace.globalMatch(text); match.hasNext();)
    places.append(match.next().captured());
  places.sort();
  return places;
}

TEST(Translations, NoSentenceIsLeftUntranslated) {
  QString lupdate = QLibraryInfo::path(QLibraryInfo::BinariesPath) + "/lupdate";
  if (!QFile::exists(lupdate))
    lupdate = QLibraryInfo::path(QLibraryInfo::LibraryExecutablesPath) + "/lupdate";
  if (!QFile::exists(lupdate)) GTEST_SKIP() << "no lupdate here";
  // What the sources say now, merged into a copy of the translation.
  QTemporaryDir folder;
  const QString copy = folder.filePath("kirisim_de.ts");
  ASSERT_TRUE(QFile::copy(kGerman, copy));
  const QString root = KIRI_SOURCE_DIR;
  QProcess process;
  process.start(lupdate, {"-silent",
                          "-I",
                          root,
                          "-locations",
                          "none",
                          "-no-obsolete",
                          "-tr-function-alias",
                          "QT_TRANSLATE_NOOP+=KIRI_TEXT",
                          "-tr-function-alias",
                          "QT_TR_NOOP+=KIRI_ACTION",
                          "-disable-heuristic",
                          "similartext",
                          "-disable-heuristic",
                          "sametext",
                          "-disable-heuristic",
                          "number",
                          root + "/apps/desktop",
                          root + "/editor",
                          "-ts",
                          copy});
  ASSERT_TRUE(process.waitForFinished(60000));
  ASSERT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
  const std::vector<Sentence> sentences = sentencesIn(copy);
  EXPECT_GT(sentences.size(), 500U);
  for (const Sentence& sentence : sentences) {
    const bool isTranslated = sentence.isFinished && !sentence.translations.isEmpty();
    EXPECT_TRUE(isTranslated) << sentence.context.toStdString() << ": "
                              << sentence.source.toStdString();
  }
}

TEST(Translations, KeepThePlacesOfNumbersAndNames) {
  for (const Sentence& sentence : sentencesIn(kGerman)) {
    for (const QString& translation : sentence.translations) {
      EXPECT_EQ(placesIn(translation), placesIn(sentence.source)) << sentence.source.toStdString();
      EXPECT_EQ(translation.count("\n"), sentence.source.count("\n"));
      EXPECT_EQ(translation.startsWith(' '), sentence.source.startsWith(' '))
          << sentence.source.toStdString();
    }
  }
}

TEST(Translations, SentencesAreLookedForWhereTheyAreKept) {
  QSet<QString> known{"QPlatformTheme"};
  for (const Sentence& sentence : sentencesIn(kGerman)) known.insert(sentence.context);
  static const QRegularExpression kAsked("translate\\(\\s*\"([^\"]+)\"");
  int asked = 0;
  QDirIterator files(QString(KIRI_SOURCE_DIR) + "/apps/desktop", {"*.cpp"}, QDir::Files,
                     QDirIterator::Subdirectories);
  while (files.hasNext()) {
    QFile file(files.next());
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QString text = QString::fromUtf8(file.readAll());
    for (auto match = kAsked.globalMatch(text); match.hasNext(); ++asked) {
      const QString context = match.next().captured(1);
      EXPECT_TRUE(known.contains(context))
          << file.fileName().toStdString() << ": " << context.toStdString();
    }
  }
  EXPECT_GT(asked, 4);
}

TEST(Translations, TheGalleryOfTheExamplesSpeaksGerman) {
  const Gallery gallery = galleryIn(KIRI_SOURCE_DIR "/examples");
  ASSERT_FALSE(gallery.groups.empty());
  QSet<QString> known;
  for (const Sentence& sentence : sentencesIn(kGerman)) {
    if (sentence.context == "examples/gallery") known.insert(sentence.source);
  }
  for (const GalleryGroup& group : gallery.groups) {
    for (const std::string& text : {group.title, group.notes}) {
      EXPECT_TRUE(text.empty() || known.contains(toQt(text)))
          << "write this sentence of gallery.json into services/gallery_words.cpp too, and "
             "translate it: "
          << text;
    }
  }
}

TEST(Translations, TheProgramSpeaksGermanAndEnglishAgain) {
  const Phrase phrase{KIRI_TEXT("editor/document", "Point %1, x"), {"3"}};
  EXPECT_EQ(speak("de"), "de");
  EXPECT_EQ(said(phrase), "Punkt 3, x");
  EXPECT_EQ(QCoreApplication::translate("kiri::desktop", "&Open..."), "Ö&ffnen...");
  EXPECT_EQ(QCoreApplication::translate("QPlatformTheme", "Cancel"), "Abbrechen")
      << "Qt's own words";
  EXPECT_EQ(speak("en"), "en");
  EXPECT_EQ(said(phrase), "Point 3, x");
  EXPECT_TRUE(languages().contains(speak("xx"))) << "an unknown language is that of the desktop";
  speak("en");
}

}  // namespace
}  // namespace kiri::desktop
