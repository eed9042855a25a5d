// The examples that come with the program, and small pictures of model files.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/gallery.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <iterator>
#include <optional>

#include "apps/desktop/look/convert.h"
#include "editor/document/document.h"
#include "editor/document/gallery.h"
#include "editor/document/pattern_import.h"
#include "editor/document/thumbnails.h"
#include "io/examples_folder.h"
#include "io/file.h"
#include "io/kiri_reader.h"

namespace kiri::desktop {

namespace {

/// What a beginner should see first.
constexpr const char* kFirst[] = {"leaf_three_lobes",   "leaf_palmate",  "ship",
                                  "kirigami_snowflake", "kirigami_star", "kirigami_flower"};

int rankOf(const QString& path) {
  const QString name = QFileInfo(path).completeBaseName();
  const auto found = std::find(std::begin(kFirst), std::end(kFirst), name);
  return static_cast<int>(found - std::begin(kFirst));
}

QString titleFrom(const QString& path) {
  QString title = QFileInfo(path).completeBaseName().replace('_', ' ');
  if (!title.isEmpty()) title[0] = title[0].toUpper();
  return title;
}

/// A crease pattern as it lies flat: folding it may take long.
void showPattern(const std::string& text, const QString& path, int pixels, ModelCard& card,
                 const Progress& progress) {
  const Result<PatternImport> import =
      importPattern(text, path.toStdString(), PatternUse::Flat, progress);
  if (!import) return;
  const Result<Document> document = Document::create(import->model, progress);
  if (!document) return;
  card.steps = static_cast<int>(import->model.steps.size());
  const Result<Image> picture = thumbnailOf(*document->state(), import->model, pixels, progress);
  if (picture) card.picture = toQt(*picture);
}

}  // namespace

QString examplesFolder() {
  return QString::fromStdString(
      kiri::examplesFolder(QCoreApplication::applicationDirPath().toStdString()));
}

QStringList modelsIn(const QString& folder) {
  if (folder.isEmpty()) return {};
  QStringList paths;
  for (const QFileInfo& file : QDir(folder).entryInfoList({"*.kiri"}, QDir::Files, QDir::Name))
    paths.append(file.absoluteFilePath());
  std::stable_sort(paths.begin(), paths.end(),
                   [](const QString& a, const QString& b) { return rankOf(a) < rankOf(b); });
  return paths;
}

ModelCard cardOf(const QString& path, int pixels, const Progress& progress) {
  ModelCard card;
  card.title = titleFrom(path);
  const Result<std::string> text = readFile(path.toStdString());
  if (!text.isOk()) return card;
  if (isPatternName(path.toStdString())) {
    showPattern(*text, path, pixels, card, progress);
    return card;
  }
  const Result<LoadedModel> loaded = readKiri(*text, path.toStdString());
  if (!loaded.isOk()) return card;
  const Model& model = loaded->model;
  if (!model.title.empty()) card.title = QString::fromStdString(model.title);
  card.steps = static_cast<int>(model.steps.size());
  const GalleryEntry entry{path.toStdString(), "", "", model.steps.size(), std::nullopt};
  const Result<Image> picture = galleryPicture(entry, pixels, progress);
  if (picture.isOk()) card.picture = toQt(*picture);
  return card;
}

}  // namespace kiri::desktop
