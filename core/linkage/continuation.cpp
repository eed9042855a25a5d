// Prediction along the tangent or the last step, correction to the nearest closed angles.
// SPDX-License-Identifier: MIT
#include "core/linkage/continuation.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/geometry/tolerance.h"

namespace kiri {
namespace {

constexpr double kTurn = 4;           // degrees that a step aims at for its fastest hinge
constexpr double kGrowth = 2;         // of the step, at most
constexpr double kCorrection = 0.25;  // of a step: a farther solution belongs to another branch
constexpr double kFirstTurns[] = {2, 0.125};    // degrees, tried for the first step
constexpr double kMostHurry = 4;                // times the mean speed of the fastest hinge
constexpr double kFirstScales[] = {1, 0.5, 2};  // of the free hinges, tried for the first step
constexpr double kMostFirstTurn = 45;           // degrees of the fastest hinge in the first step
constexpr double kMostFirstPart = 0.5;
constexpr double kMoves = 1.0 / 256;  // of the first turn: a hinge that turns less is said to rest
constexpr double kLeastDriven = 1.0 / 4096;  // of the fastest hinge: a slower driven one is held
constexpr double kNearlyFull = 1.0 / 16;  // degrees that a full hinge may lack where the path stops
constexpr double kSnap = 1.0 / 1024;      // degrees from the wanted angles that count as arrived

class Follower {
 public:
  Follower(const FoldAngles& start, const PathRequest& request,
           std::shared_ptr<const Closure> closure, const Closure& loose)
      : start_(start),
        request_(request),
        closure_(std::move(closure)),
        loose_(&loose),
        tried_(start) {
    samples_.push_back({0, start});
  }

  RigidPath run(const Progress& progress) {
    bool moves = true;
    while (moves && samples_.back().part < 1) {
      if (!goesOn(progress, samples_.back().part)) {
        stop_ = {PathEnd::Cancelled, {}};
        break;
      }
      moves = samples_.size() == 1 ? begin() : advance();
    }
    if (samples_.back().part == 1) {
      stop_ = {};
    } else if (stop_.end != PathEnd::Cancelled) {
      nameStop();
    }
    return RigidPath(request_, std::move(samples_), std::move(stop_), closure_);
  }

 private:
  /// The largest difference of a hinge that may change.
  double apart(const FoldAngles& a, const FoldAngles& b) const {
    double most = 0;
    for (const EdgeId e : request_.driven) most = std::max(most, std::abs(a[e.index] - b[e.index]));
    for (const EdgeId e : request_.free) most = std::max(most, std::abs(a[e.index] - b[e.index]));
    return most;
  }

  static FoldAngles moved(const FoldAngles& from, const FoldAngles& rates, double time) {
    FoldAngles to = from;
    for (std::size_t e = 0; e < to.size(); ++e) to[e] += time * rates[e];
    return to;
  }

  static FoldAngles halfway(const FoldAngles& a, const FoldAngles& b) {
    FoldAngles middle = a;
    for (std::size_t e = 0; e < a.size(); ++e) middle[e] = (a[e] + b[e]) / 2;
    return middle;
  }

  /// Degrees per unit of the part: driven hinges as they must, free ones as near as they can to
  /// where they head.
  FoldAngles ratesAt(const RigidPath::Sample& at) const {
    FoldAngles rates(start_.size(), 0);
    for (const EdgeId e : request_.driven)
      rates[e.index] = request_.wanted[e.index] - start_[e.index];
    // One that is held back would hurry without limit as the end comes near.
    const double most = kMostHurry * apart(request_.wanted, start_);
    for (const EdgeId e : request_.free) {
      const double rate = (request_.wanted[e.index] - at.angles[e.index]) / (1 - at.part);
      rates[e.index] = std::clamp(rate, -most, most);
    }
    closure_->project(at.angles, rates);
    return rates;
  }

  std::optional<FoldAngles> solution(FoldAngles guess, double part) {
    drive(guess, start_, request_, part);
    if (closure_->close(guess)) {
      putFullOnes(guess);
      return guess;
    }
    failWith(PathEnd::Locked, std::move(guess));
    return std::nullopt;
  }

  void failWith(PathEnd end, FoldAngles tried) {
    stop_.end = end;
    tried_ = std::move(tried);
  }

  bool isOverfull(const FoldAngles& angles) const {
    return std::any_of(request_.free.begin(), request_.free.end(),
                       [&](EdgeId e) { return std::abs(angles[e.index]) > 180 + kFullFold; });
  }

  /// Whether the paper can go from one closed state to another without a jump: half way it must
  /// pass near the middle.
  std::optional<FoldAngles> middleOf(const RigidPath::Sample& a, const RigidPath::Sample& b) {
    const FoldAngles guess = halfway(a.angles, b.angles);
    std::optional<FoldAngles> middle = solution(guess, (a.part + b.part) / 2);
    if (!middle) return std::nullopt;
    if (apart(*middle, guess) > kCorrection * apart(a.angles, b.angles) / 2 + kFullFold) {
      failWith(PathEnd::Locked, *middle);
      return std::nullopt;
    }
    return middle;
  }

  /// Which hinges end the path. One that comes to 180 degrees may do so as the driven hinge turns
  /// back: then no equation has a solution beyond, and still it is this hinge that is full.
  void nameStop() {
    std::vector<EdgeId> full;
    for (const EdgeId e : request_.free) {
      const double end = std::abs(samples_.back().angles[e.index]);
      const bool arrives = end > 180 - kNearlyFull && end > std::abs(start_[e.index]);
      const bool passes =
          stop_.end == PathEnd::HingeFull && std::abs(tried_[e.index]) > 180 + kFullFold;
      if (arrives || passes) full.push_back(e);
    }
    if (full.empty()) {
      stop_ = {PathEnd::Locked, closure_->worstLoop(tried_)};
    } else {
      stop_ = {PathEnd::HingeFull, std::move(full)};
    }
  }

  bool advance();
  bool stepTo(double part, const FoldAngles& guess);
  bool arrives(const FoldAngles& guess);
  FoldAngles flatNear(const FoldAngles& guess) const;
  bool begin();
  bool beginWith(const RigidPath::Sample& near);
  std::optional<RigidPath::Sample> firstOf(double turn, double scale, bool keepsSigns) const;
  int leaving(const FoldAngles& angles) const;
  double firstPart(double turn) const;

  const FoldAngles& start_;
  const PathRequest& request_;
  std::shared_ptr<const Closure> closure_;
  const Closure* loose_;
  std::vector<RigidPath::Sample> samples_;
  RigidPath::Stop stop_;
  FoldAngles tried_;                        ///< what did not close when the path stopped
  std::vector<RigidPath::Sample> resting_;  ///< a first step in which hinges rest; empty: none
};

/// One step along the tangent or in the direction of the last step, halved until it succeeds.
bool Follower::advance() {
  const RigidPath::Sample now = samples_.back();
  const RigidPath::Sample& before = samples_[samples_.size() - 2];
  const double last = now.part - before.part;
  const FoldAngles tangent = ratesAt(now);
  FoldAngles secant = now.angles;
  for (std::size_t e = 0; e < secant.size(); ++e)
    secant[e] = (now.angles[e] - before.angles[e]) / last;
  const FoldAngles zero(start_.size(), 0);
  const double speed = std::max(apart(tangent, zero), apart(secant, zero));
  double time = std::min({kGrowth * last, kTurn / speed, 1 - now.part});
  for (; time > kSameMoment; time /= 2) {
    // A tiny rest would be a step of its own, too short to tell where it leads.
    const double part = 1 - now.part - time < time / 8 ? 1 : now.part + time;
    for (const FoldAngles* rates : {&tangent, &std::as_const(secant)}) {
      if (stepTo(part, moved(now.angles, *rates, part - now.part))) return true;
    }
  }
  return false;
}

bool Follower::stepTo(double part, const FoldAngles& guess) {
  if (part == 1 && arrives(guess)) return true;
  const RigidPath::Sample& now = samples_.back();
  const std::optional<FoldAngles> found = solution(guess, part);
  if (!found) return false;
  const double step = apart(*found, now.angles);
  if (apart(*found, guess) > kCorrection * step + kFullFold || step > 2 * kTurn) {
    failWith(PathEnd::Locked, guess);
    return false;
  }
  if (isOverfull(*found)) {
    failWith(PathEnd::HingeFull, *found);
    return false;
  }
  RigidPath::Sample next{part, *found};
  if (!middleOf(now, next)) return false;
  if (part == 1) {
    for (const FoldAngles& end : {request_.wanted, flatNear(next.angles)}) {
      if (apart(next.angles, end) < kSnap && closure_->error(end) <= kClosedLoop) next.angles = end;
    }
  }
  samples_.push_back(std::move(next));
  return true;
}

/// The wanted angles, or flat ones, are where the motion leads when they lie where it points to.
/// Flat ends are singular: correction would miss them by what rounding allows.
bool Follower::arrives(const FoldAngles& guess) {
  const RigidPath::Sample& now = samples_.back();
  for (const FoldAngles& end : {request_.wanted, flatNear(guess)}) {
    const double step = apart(end, now.angles);
    if (step > 2 * kTurn || apart(guess, end) > kCorrection * step + kSnap) continue;
    if (closure_->error(end) > kClosedLoop) continue;
    RigidPath::Sample next{1, end};
    if (!middleOf(now, next)) continue;
    samples_.push_back(std::move(next));
    return true;
  }
  return false;
}

/// The wanted angles, but free hinges that come near to flat or fully folded there.
FoldAngles Follower::flatNear(const FoldAngles& guess) const {
  FoldAngles end = request_.wanted;
  for (const EdgeId e : request_.free) {
    const double flat = 180 * std::round(guess[e.index] / 180);
    if (std::abs(flat - guess[e.index]) < kTurn) end[e.index] = flat;
  }
  return end;
}

/// The first step. Where the start is flat, several branches meet in it: the one is sought in which
/// every hinge leaves towards its wanted angle; if there is none, one in which some rest.
bool Follower::begin() {
  const FoldAngles tangent = ratesAt(samples_.front());
  for (const double turn : kFirstTurns) {
    const double part = firstPart(turn);
    if (beginWith({part, moved(start_, tangent, part)})) return true;
    for (const double scale : kFirstScales) {
      for (const bool keepsSigns : {false, true}) {
        const std::optional<RigidPath::Sample> first = firstOf(turn, scale, keepsSigns);
        if (first && beginWith(*first)) return true;
      }
    }
    FoldAngles onlyDriven = start_;
    if (beginWith({part, std::move(onlyDriven)})) return true;
  }
  if (!resting_.empty()) {
    samples_ = resting_;
    return true;
  }
  return false;
}

/// A first step in which all hinges go their way at first alike, then, driven ones included, are
/// corrected to the nearest solution. Next to a flat state solutions may be magnified: so this one
/// is, until its fastest hinge turns as far as asked.
std::optional<RigidPath::Sample> Follower::firstOf(double turn, double scale,
                                                   bool keepsSigns) const {
  const double most = apart(request_.wanted, start_);
  FoldAngles angles = start_;
  for (std::size_t e = 0; e < start_.size(); ++e)
    angles[e] += turn / most * (request_.wanted[e] - start_[e]);
  for (const EdgeId e : request_.free)
    angles[e.index] = start_[e.index] + scale * (angles[e.index] - start_[e.index]);
  const bool closes =
      keepsSigns ? loose_->closeKeepingSigns(angles, start_) : loose_->close(angles);
  const double turned = apart(angles, start_);
  if (!closes || turned == 0) return std::nullopt;
  double part = HUGE_VAL;
  for (const EdgeId e : request_.driven) {
    const double way = request_.wanted[e.index] - start_[e.index];
    if (way != 0) part = std::min(part, (angles[e.index] - start_[e.index]) / way);
  }
  if (part == HUGE_VAL) part = turned / most;
  if (part * most < kLeastDriven * turned) return std::nullopt;
  const double magnified = std::min(turn / turned, kMostFirstPart / part);
  for (std::size_t e = 0; e < start_.size(); ++e)
    angles[e] = start_[e] + magnified * (angles[e] - start_[e]);
  return RigidPath::Sample{magnified * part, std::move(angles)};
}

bool Follower::beginWith(const RigidPath::Sample& near) {
  const double part = near.part;
  std::optional<FoldAngles> found = solution(near.angles, part);
  if (!found) return false;
  FoldAngles guess = *std::move(found);
  if (apart(guess, start_) > kMostFirstTurn) {
    failWith(PathEnd::Locked, std::move(guess));
    return false;
  }
  if (isOverfull(guess)) {
    failWith(PathEnd::HingeFull, std::move(guess));
    return false;
  }
  const int leave = leaving(guess);
  if (leave < 0) {
    failWith(PathEnd::Locked, std::move(guess));
    return false;
  }
  // The branch must come from the start: twice halved, it must shrink to it evenly.
  const RigidPath::Sample first{part, std::move(guess)};
  const std::optional<FoldAngles> half = middleOf(samples_.front(), first);
  if (!half) return false;
  const RigidPath::Sample middle{part / 2, *half};
  if (!middleOf(samples_.front(), middle)) return false;
  std::vector<RigidPath::Sample> path{samples_.front(), middle, first};
  if (leave > 0) {
    samples_ = std::move(path);
    return true;
  }
  if (resting_.empty()) resting_ = std::move(path);
  return false;
}

/// 1: all hinges that start flat or fully folded leave as they are wanted to; 0: some rest; -1: one
/// leaves the other way.
int Follower::leaving(const FoldAngles& angles) const {
  const double least = kMoves * apart(angles, start_);
  int result = 1;
  for (const EdgeId e : request_.free) {
    const double start = start_[e.index];
    const double way = request_.wanted[e.index] - start;
    if ((start != 0 && std::abs(start) != 180) || way == 0) continue;
    const double turned = (angles[e.index] - start) * (way > 0 ? 1 : -1);
    if (turned < -kFullFold) return -1;
    if (turned < least) result = 0;
  }
  return result;
}

/// The part at which the fastest driven hinge, or where none is driven the fastest free one, has
/// turned so many degrees; at most half the way.
double Follower::firstPart(double turn) const {
  double most = 0;
  for (const EdgeId e : request_.driven)
    most = std::max(most, std::abs(request_.wanted[e.index] - start_[e.index]));
  if (most == 0) most = apart(request_.wanted, start_);
  return most > 0 ? std::min(turn / most, kMostFirstPart) : kMostFirstPart;
}

}  // namespace

RigidPath continuedPath(const FoldAngles& start, const PathRequest& request,
                        std::shared_ptr<const Closure> closure, const Closure& loose,
                        const Progress& progress) {
  return Follower(start, request, std::move(closure), loose).run(progress);
}

void drive(FoldAngles& angles, const FoldAngles& start, const PathRequest& request, double part) {
  for (const EdgeId e : request.driven) {
    angles[e.index] = part == 1
                          ? request.wanted[e.index]
                          : start[e.index] + part * (request.wanted[e.index] - start[e.index]);
  }
}

void putFullOnes(FoldAngles& angles) {
  for (double& angle : angles) {
    if (std::abs(angle) > 180 && std::abs(angle) <= 180 + kFullFold) angle = angle > 0 ? 180 : -180;
  }
}

}  // namespace kiri
