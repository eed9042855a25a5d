// SPDX-License-Identifier: MIT
#include "editor/motion/player.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"

namespace kiri {
namespace {

bool looksTheSame(const Moment& a, const Moment& b) {
  if (a.step != b.step || a.isResting != b.isResting) return false;
  return a.isResting || (a.movement == b.movement && a.part == b.part);
}

}  // namespace

void Player::load(std::shared_ptr<const Timeline> timeline) {
  timeline_ = std::move(timeline);
  seconds_ = 0;
  isPlaying_ = false;
}

double Player::duration() const { return timeline_ ? timeline_->duration() : 0; }

void Player::play() {
  if (!timeline_) return;
  if (seconds_ >= duration()) seconds_ = 0;
  isPlaying_ = true;
}

void Player::seek(double seconds) { seconds_ = std::clamp(seconds, 0.0, duration()); }

void Player::setSpeed(double factor) { speed_ = std::clamp(factor, kSlowest, kFastest); }

void Player::seekStep(std::size_t done) {
  if (!timeline_) return;
  for (const Phase& phase : timeline_->phases()) {
    if (phase.step < done) continue;
    seconds_ = phase.start;
    return;
  }
  seconds_ = duration();
}

void Player::skip(int steps) {
  if (!timeline_ || steps == 0) return;
  const Moment now = timeline_->momentAt(seconds_);
  const auto first = static_cast<long long>(timeline_->phases().front().step);
  long long done = static_cast<long long>(now.step) + steps;
  if (steps < 0 && !now.isResting) ++done;
  if (done > static_cast<long long>(timeline_->phases().back().step)) {
    seconds_ = duration();
  } else {
    seekStep(static_cast<std::size_t>(std::max(done, first)));
  }
}

bool Player::advance(double realSeconds) {
  if (!timeline_ || !isPlaying_) return false;
  const Moment before = timeline_->momentAt(seconds_);
  seconds_ += realSeconds * speed_;
  if (seconds_ >= duration()) {
    isPlaying_ = loops_ && duration() > 0;
    seconds_ = isPlaying_ ? std::fmod(seconds_, duration()) : duration();
  }
  return !looksTheSame(before, timeline_->momentAt(seconds_));
}

FoldedState Player::state() const {
  KIRI_CHECK(timeline_ != nullptr, "a film is loaded before it is seen");
  return timeline_->stateAt(seconds_);
}

std::size_t Player::step() const { return timeline_ ? timeline_->momentAt(seconds_).step : 0; }

std::size_t Player::stepSeen() const {
  if (!timeline_) return 0;
  const Moment now = timeline_->momentAt(seconds_);
  return now.isResting ? now.step : now.step + 1;
}

}  // namespace kiri
