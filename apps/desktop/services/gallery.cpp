// The examples that come with the program, and what cards say and show of model files.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/gallery.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include "apps/desktop/look/convert.h"
#include "apps/desktop/services/gallery_words.h"
#include "apps/desktop/services/picture_store.h"
#include "editor/document/document.h"
#include "editor/document/gallery.h"
#include "editor/document/pattern_import.h"
#include "editor/document/thumbnails.h"
#include "io/examples_folder.h"
#include "io/file.h"

namespace kiri::desktop {

namespace {

/// A crease pattern as it lies flat: folding it may take long.
Result<Image> drawPattern(const std::string& text, const std::string& path, int pixels,
                          const Progress& progress) {
  const Result<PatternImport> import = importPattern(text, path, PatternUse::Flat, progress);
  if (!import) return import.error();
  const Result<Document> document = Document::create(import->model, progress);
  if (!document) return document.error();
  return thumbnailOf(*document->state(), import->model, pixels, progress);
}

}  // namespace

QString examplesFolder() {
  return toQt(kiri::examplesFolder(QCoreApplication::applicationDirPath().toStdString()));
}

QList<ExampleGroup> exampleGroups(const QString& folder) {
  QList<ExampleGroup> groups;
  if (folder.isEmpty()) return groups;
  for (const GalleryGroup& group : galleryIn(folder.toStdString()).groups) {
    ExampleGroup shown{inOurWords(group.title), inOurWords(group.notes), {}};
    for (const std::string& model : group.models)
      shown.models.append(QDir(folder).absoluteFilePath(toQt(model)));
    groups.append(shown);
  }
  return groups;
}

ModelCard blankCard(const QString& path) {
  ModelCard card;
  card.title = QFileInfo(path).completeBaseName().replace('_', ' ');
  if (!card.title.isEmpty()) card.title[0] = card.title[0].toUpper();
  return card;
}

ModelCard readCard(const QString& path) {
  ModelCard card = blankCard(path);
  if (isPatternName(path.toStdString())) return card;
  const Result<ModelWords> words = wordsOf(path.toStdString());
  if (!words) return card;
  const QString file = QFileInfo(path).completeBaseName();
  if (const QString title = toQt(words->title); title != file) card.title = title;
  card.figure = toQt(words->figure);
  card.notes = toQt(words->notes);
  card.steps = static_cast<int>(words->steps);
  return card;
}

QImage drawCard(const QString& path, int pixels, const Progress& progress) {
  const std::string file = path.toStdString();
  const Result<std::string> text = readFile(file);
  if (!text) return {};
  const QString key = pictureKey(*text, QString("card %1").arg(pixels));
  if (QImage kept = keptPicture(key); !kept.isNull()) return kept;
  const Result<Image> drawn = isPatternName(file) ? drawPattern(*text, file, pixels, progress)
                                                  : galleryPicture(file, pixels, progress);
  if (!drawn) return {};
  QImage picture = toQt(*drawn);
  keepPicture(key, picture);
  return picture;
}

}  // namespace kiri::desktop
