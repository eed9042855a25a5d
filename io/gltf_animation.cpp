// glTF 2.0 files (binary, GLB) of a model's whole process in motion (docs/formats/gltf.md).
// SPDX-License-Identifier: MIT
#include "io/gltf_animation.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "io/gltf_document.h"
#include "io/gltf_meshes.h"
#include "io/gltf_tracks.h"

namespace kiri {

namespace {

JsonValue asJson(Vec3 v) { return jsonNumbers({v.x, v.y, v.z}); }

/// The one animation of a document, as its channels come.
class AnimationParts {
 public:
  explicit AnimationParts(GltfDocument& document) : document_(document) {}

  void addPlaces(int node, const std::vector<PlaceKey>& keys) {
    std::vector<double> times;
    std::vector<Vec3> positions;
    std::vector<std::array<double, 4>> turns;
    for (const PlaceKey& key : keys) {
      times.push_back(key.seconds);
      positions.push_back(key.position);
      turns.push_back(key.turn);
    }
    addChannel(node, "translation", "LINEAR", timesOf(times), document_.addKeys(positions));
    addChannel(node, "rotation", "LINEAR", timesOf(times), document_.addKeys(turns));
  }

  /// Sizes hold from their time on.
  void addSizes(int node, const std::vector<double>& times, const std::vector<Vec3>& sizes) {
    addChannel(node, "scale", "STEP", timesOf(times), document_.addKeys(sizes));
  }

  bool isEmpty() const { return channels_.items.empty(); }

  JsonValue finish() {
    JsonValue out = JsonValue::object();
    out.add("name", JsonValue::ofText("process"));
    out.add("channels", std::move(channels_));
    out.add("samplers", std::move(samplers_));
    return out;
  }

 private:
  /// Facets that move together share their times.
  int timesOf(const std::vector<double>& times) {
    const auto [at, isNew] = times_.try_emplace(times, 0);
    if (isNew) at->second = document_.addTimes(times);
    return at->second;
  }

  void addChannel(int node, const char* path, const char* interpolation, int input, int output) {
    JsonValue& sampler = samplers_.items.emplace_back(JsonValue::object());
    sampler.add("input", jsonNumber(input));
    sampler.add("output", jsonNumber(output));
    sampler.add("interpolation", JsonValue::ofText(interpolation));
    JsonValue& channel = channels_.items.emplace_back(JsonValue::object());
    channel.add("sampler", jsonNumber(static_cast<int>(samplers_.items.size()) - 1));
    JsonValue& target = channel.add("target", JsonValue::object());
    target.add("node", jsonNumber(node));
    target.add("path", JsonValue::ofText(path));
  }

  GltfDocument& document_;
  JsonValue channels_ = JsonValue::array();
  JsonValue samplers_ = JsonValue::array();
  std::map<std::vector<double>, int> times_;
};

bool isMoving(const FacetTrack& track) {
  for (const PlaceKey& key : track.keys) {
    if (!(key.position == track.keys[0].position) || key.turn != track.keys[0].turn) return true;
  }
  return false;
}

int addNode(GltfDocument& document, const FacetTrack& track, std::size_t number, double end) {
  const PlaceKey& last = track.keys.back();
  JsonValue node = JsonValue::object();
  node.add("name", JsonValue::ofText("facet_" + std::to_string(number)));
  node.add("mesh", jsonNumber(track.mesh));
  node.add("translation", asJson(last.position));
  node.add("rotation", jsonNumbers({last.turn.begin(), last.turn.end()}));
  if (track.shown.back().second < end) node.add("scale", asJson({0, 0, 0}));
  return document.addNode(std::move(node));
}

/// When the facet is there and when not, from the start of the time on.
void addSizes(AnimationParts& parts, int node, const FacetTrack& track, double end) {
  constexpr Vec3 kThere{1, 1, 1};
  constexpr Vec3 kGone{0, 0, 0};
  std::vector<double> times;
  std::vector<Vec3> sizes;
  const auto add = [&](double seconds, Vec3 size) {
    times.push_back(seconds);
    sizes.push_back(size);
  };
  if (track.shown.front().first > 0) add(0, kGone);
  for (const auto& [from, to] : track.shown) {
    add(from, kThere);
    if (to < end) add(to, kGone);
  }
  if (times.size() > 1) parts.addSizes(node, times, sizes);
}

}  // namespace

Result<Exported> writeAnimatedGlb(const Timeline& timeline, const GltfOptions& options,
                                  const Progress& progress) {
  GltfDocument document;
  GltfMeshes meshes(document, options);
  const Vec2 size = options.sheet.high - options.sheet.low;
  const auto meshOf = [&](const FacetTriangles& facet) { return meshes.meshOf(facet); };
  const Result<std::vector<FacetTrack>> tracks =
      tracksOf(timeline,
               {options.thickness + options.layerGap, options.motionError * length(size),
                options.chordError},
               meshOf, progress);
  if (!tracks.isOk()) return tracks.error();
  AnimationParts parts(document);
  std::vector<int> children;
  const double end = timeline.duration();
  for (std::size_t i = 0; i < tracks->size(); ++i) {
    const FacetTrack& track = (*tracks)[i];
    const int node = addNode(document, track, i, end);
    if (isMoving(track)) parts.addPlaces(node, track.keys);
    addSizes(parts, node, track, end);
    children.push_back(node);
  }
  const int root = document.addNode(gltfRoot(options.title, children));
  if (!parts.isEmpty()) document.addAnimation(parts.finish());
  const FoldedState& last = timeline.stateAfter(timeline.phases().back().step);
  return Exported{document.finish(options.generator, root),
                  gltfLosses(!last.pattern.curves.empty())};
}

}  // namespace kiri
