// Pictures of a model folded, half unfolded and unfolded.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/model_moments.h"

#include <string>
#include <utility>

#include "apps/desktop/look/convert.h"
#include "apps/desktop/services/picture_store.h"
#include "core/model/moments.h"
#include "editor/document/thumbnails.h"
#include "io/file.h"
#include "io/kiri_reader.h"
#include "render/scene/view_spec.h"

namespace kiri::desktop {

namespace {

using Kind = ModelMoment::Kind;

/// How a model that is half open is looked at, as in the gallery of the command line.
constexpr double kFromTheSide = 20;
constexpr double kFromAbove = 40;
constexpr double kReplayed = 0.6;  // of the progress

QString keyOf(const std::string& text, Kind kind, int pixels) {
  return pictureKey(text, QString("moment %1 %2").arg(static_cast<int>(kind)).arg(pixels));
}

/// The moments that were kept; none unless the first and the last are there: they are kept in this
/// order, so what is between them then is there too.
QList<ModelMoment> keptMoments(const std::string& text, int pixels) {
  QList<ModelMoment> kept;
  for (const Kind kind : {Kind::Folded, Kind::HalfUnfolded, Kind::HalfFolded, Kind::Unfolded}) {
    const QImage picture = keptPicture(keyOf(text, kind, pixels));
    if (!picture.isNull()) kept.append({kind, picture});
  }
  const bool isWhole =
      kept.size() > 1 && kept.front().kind == Kind::Folded && kept.back().kind == Kind::Unfolded;
  return isWhole ? kept : QList<ModelMoment>();
}

QList<ModelMoment> drawMoments(const Model& model, int pixels, double density,
                               const Progress& progress) {
  const Result<Timeline> timeline =
      Timeline::of(model, {}, [&](double done) { return goesOn(progress, kReplayed * done); });
  if (!timeline) return {};
  const Moments moments = momentsOf(model, *timeline);
  const Appearance appearance = appearanceOf(model);
  QList<ModelMoment> drawn;
  const auto add = [&drawn](Kind kind, const Result<Image>& image) {
    if (image) drawn.append({kind, toQt(*image)});
  };
  add(Kind::Folded,
      thumbnailOf(timeline->stateAfter(moments.folded), appearance, pixels, density, progress));
  if (moments.half) {
    const ViewSpec aslant{kFromTheSide, kFromAbove};
    const bool isUnfolding = moments.halfWay == HalfWay::Unfolding;
    add(isUnfolding ? Kind::HalfUnfolded : Kind::HalfFolded,
        thumbnailOf(*moments.half, appearance, aslant, pixels, density, progress));
  }
  // The pattern shows how its creases were folded, which the paper at rest no longer knows.
  const FoldedState& last = timeline->stateAfter(model.steps.size());
  add(Kind::Unfolded, patternThumbnail(last, appearance, pixels, density));
  return drawn;
}

}  // namespace

QList<ModelMoment> momentsIn(const QString& path, int pixels, double density,
                             const Progress& progress) {
  const Result<std::string> text = readFile(path.toStdString());
  if (!text) return {};
  if (QList<ModelMoment> kept = keptMoments(*text, pixels); !kept.isEmpty()) return kept;
  const Result<LoadedModel> loaded = readKiri(*text, path.toStdString());
  if (!loaded) return {};
  QList<ModelMoment> drawn = drawMoments(loaded->model, pixels, density, progress);
  for (const ModelMoment& moment : std::as_const(drawn))
    keepPicture(keyOf(*text, moment.kind, pixels), moment.picture);
  return drawn;
}

}  // namespace kiri::desktop
