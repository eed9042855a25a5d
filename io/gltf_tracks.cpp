// Where each facet of a time line is when: the key frames of an animation.
// SPDX-License-Identifier: MIT
#include "io/gltf_tracks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <map>

#include "core/layers/layer_levels.h"
#include "io/facet_mesh.h"
#include "io/gltf_meshes.h"

namespace kiri {

namespace {

using Turn = std::array<double, 4>;

double dotOf(const Turn& a, const Turn& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

Vec3 rotated(const Turn& q, Vec2 p) {
  const Vec3 u{q[0], q[1], q[2]};
  const Vec3 v{p.x, p.y, 0};
  const Vec3 t = cross(u, v) * 2;
  return v + t * q[3] + cross(u, t);
}

/// The state at one time, with all that a key needs.
struct Sample {
  double seconds = 0;
  std::vector<Rigid> poses;   ///< where the facets are
  std::vector<Rigid> lifted;  ///< and where they are shown
};

class Tracker {
 public:
  Tracker(const Timeline& timeline, const TrackOptions& options,
          const std::function<int(const FacetTriangles&)>& meshOf)
      : timeline_(timeline), options_(options), error_(kAim * options.error), meshOf_(meshOf) {}

  void addPhase(const Phase& phase) {
    samples_.clear();
    levels_.clear();
    const Moment start{phase.step, phase.movement, 0, phase.isResting};
    const FoldedState state = timeline_.stateAt(start);
    facets_ = trianglesOf(state.pattern, meshOf(state.pattern, options_.chordError));
    findTracks();
    for (const std::size_t track : trackOf_) show(tracks_[track], phase.start, phase.end);
    addKeys(sampleOf(phase, 0));
    if (phase.isResting) return;
    // Few keys to begin with; more where they are needed.
    constexpr int kParts = 3;
    for (int i = 1; i <= kParts; ++i) {
      const double from = static_cast<double>(i - 1) / kParts;
      const double to = static_cast<double>(i) / kParts;
      refine(phase, from, to, 0);
      addKeys(sampleOf(phase, to));
    }
  }

  std::vector<FacetTrack> finish() { return std::move(tracks_); }

 private:
  /// Interpolation is looked at in three places of a stretch; elsewhere it is a little worse.
  static constexpr double kAim = 0.6;

  /// The track of each of the facets; new ones for shapes that are met for the first time.
  void findTracks() {
    trackOf_.clear();
    for (const FacetTriangles& facet : facets_) {
      const int mesh = meshOf_(facet);
      const auto [at, isNew] = byMesh_.try_emplace(mesh, tracks_.size());
      if (isNew) tracks_.push_back({mesh, {}, {}});
      trackOf_.push_back(at->second);
    }
  }

  /// The state when `part` of the phase's time is over.
  const Sample& sampleOf(const Phase& phase, double part) {
    const auto [at, isNew] = samples_.try_emplace(part);
    Sample& sample = at->second;
    if (!isNew) return sample;
    sample.seconds = phase.start + (phase.end - phase.start) * part;
    Moment moment{phase.step, phase.movement, part, phase.isResting};
    if (!phase.isResting && part > 0 && part < 1) {
      moment.part = timeline_.momentAt(sample.seconds).part;
    }
    const FoldedState state = timeline_.stateAt(moment);
    sample.poses = state.poses;
    sample.lifted =
        options_.gap == 0 ? state.poses : spreadPoses(state, options_.gap, levelsOf(state));
    return sample;
  }

  /// Levels follow from the layer order as long as the pattern is the same, and cost more than all
  /// else.
  const std::vector<std::uint32_t>& levelsOf(const FoldedState& state) {
    const auto isSame = [](const LayerSet& a, const LayerSet& b) {
      return a.upward == b.upward && a.exceptions == b.exceptions;
    };
    const std::vector<LayerSet>& sets = state.layers.sets();
    for (const auto& [known, levels] : levels_) {
      if (std::equal(known.begin(), known.end(), sets.begin(), sets.end(), isSame)) return levels;
    }
    return levels_.emplace_back(sets, layerLevels(state)).second;
  }

  /// Adds keys between two parts of the phase until interpolation is good enough.
  void refine(const Phase& phase, double from, double to, int depth) {
    constexpr int kDeepest = 7;
    if (depth >= kDeepest) return;
    // An eased motion may be right half way and wrong before and after.
    bool isGood = true;
    for (const double part : {0.5, 0.25, 0.75}) {
      isGood = isGood && missOf(sampleOf(phase, from), sampleOf(phase, to),
                                sampleOf(phase, from + (to - from) * part), part) <= error_;
    }
    if (isGood) return;
    const double middle = from + (to - from) * 0.5;
    refine(phase, from, middle, depth + 1);
    addKeys(sampleOf(phase, middle));
    refine(phase, middle, to, depth + 1);
  }

  /// The largest distance, mm, of a facet's corner from where interpolation has it.
  double missOf(const Sample& a, const Sample& b, const Sample& between, double part) const {
    double most = 0;
    for (const FacetTriangles& facet : facets_) {
      const std::uint32_t f = facet.facet.index;
      const Turn turn = slerp(quaternionOf(a.poses[f]), quaternionOf(b.poses[f]), part);
      const Vec3 position = a.poses[f].origin * (1 - part) + b.poses[f].origin * part;
      for (const Vec2 p : facet.points) {
        most = std::max(most, distance(rotated(turn, p) + position, between.poses[f].apply(p)));
      }
    }
    return most;
  }

  void addKeys(const Sample& sample) {
    for (std::size_t i = 0; i < facets_.size(); ++i) {
      const Rigid& pose = sample.lifted[facets_[i].facet.index];
      addKey(tracks_[trackOf_[i]], {sample.seconds, pose.origin, quaternionOf(pose)});
    }
  }

  /// A stretch in which nothing changes needs its two ends only.
  void addKey(FacetTrack& track, PlaceKey key) const {
    std::vector<PlaceKey>& keys = track.keys;
    if (!keys.empty()) {
      if (dotOf(keys.back().turn, key.turn) < 0) {
        for (double& part : key.turn) part = -part;
      }
      if (static_cast<float>(key.seconds) <= static_cast<float>(keys.back().seconds)) {
        key.seconds = keys.back().seconds;
        keys.pop_back();
      }
    }
    const auto isSame = [](const PlaceKey& a, const PlaceKey& b) {
      return a.position == b.position && a.turn == b.turn;
    };
    const std::size_t n = keys.size();
    if (n >= 2 && isSame(keys[n - 1], key) && isSame(keys[n - 2], key)) {
      keys.back().seconds = key.seconds;
    } else {
      keys.push_back(key);
    }
  }

  static void show(FacetTrack& track, double from, double to) {
    if (!track.shown.empty() && track.shown.back().second == from) {
      track.shown.back().second = to;
    } else {
      track.shown.emplace_back(from, to);
    }
  }

  const Timeline& timeline_;
  TrackOptions options_;
  double error_;
  const std::function<int(const FacetTriangles&)>& meshOf_;
  std::vector<FacetTriangles> facets_;  ///< of the phase under way
  std::vector<std::size_t> trackOf_;    ///< of those facets
  std::map<double, Sample> samples_;    ///< of the phase under way, by part
  std::deque<std::pair<std::vector<LayerSet>, std::vector<std::uint32_t>>> levels_;  ///< of it
  std::map<int, std::size_t> byMesh_;
  std::vector<FacetTrack> tracks_;
};

}  // namespace

std::array<double, 4> slerp(const std::array<double, 4>& a, const std::array<double, 4>& b,
                            double part) {
  const double sign = dotOf(a, b) < 0 ? -1 : 1;
  const double cosine = std::min(1.0, std::fabs(dotOf(a, b)));
  const double angle = std::acos(cosine);
  const double sine = std::sin(angle);
  Turn out = {};
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k] =
        sine < kSamePlane
            ? a[k]
            : (std::sin((1 - part) * angle) * a[k] + sign * std::sin(part * angle) * b[k]) / sine;
  }
  return out;
}

Result<std::vector<FacetTrack>> tracksOf(const Timeline& timeline, const TrackOptions& options,
                                         const std::function<int(const FacetTriangles&)>& meshOf,
                                         const Progress& progress) {
  Tracker tracker(timeline, options, meshOf);
  for (const Phase& phase : timeline.phases()) {
    const double whole = std::max(timeline.duration(), phase.end);
    if (!goesOn(progress, whole > 0 ? phase.start / whole : 0)) {
      return Error{ErrorCode::Cancelled, "stopped", {}};
    }
    const bool isOnly = timeline.phases().size() == 1;
    if (phase.end > phase.start || isOnly) tracker.addPhase(phase);
  }
  return tracker.finish();
}

}  // namespace kiri
