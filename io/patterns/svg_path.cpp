// What SVG's shapes and path data draw, as straight and cubic arcs.
// SPDX-License-Identifier: MIT
#include "io/patterns/svg_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "io/patterns/svg_numbers.h"

namespace kiri {

namespace {

/// Numbers behind a command, for each time it is done; 0: closes the path.
std::optional<std::size_t> argumentsOf(char command) {
  switch (command) {
    case 'Z':
      return 0;
    case 'H':
    case 'V':
      return 1;
    case 'M':
    case 'L':
    case 'T':
      return 2;
    case 'S':
    case 'Q':
      return 4;
    case 'C':
      return 6;
    case 'A':
      return 7;
    default:
      return std::nullopt;
  }
}

bool isCommandLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

Arc fromQuadratic(Vec2 from, Vec2 control, Vec2 to) {
  return Arc::cubic(from, from + (control - from) * (2.0 / 3), to + (control - to) * (2.0 / 3), to);
}

/// Reads path data from left to right; knows where the pen is.
class PathReader {
 public:
  explicit PathReader(std::string_view data) : rest_(data) {}

  SvgOutline read() {
    while (skipSvgSeparators(rest_), !rest_.empty()) {
      if (!step()) {
        outline_.isWhole = false;
        break;
      }
    }
    lift(false);
    return std::move(outline_);
  }

 private:
  using Numbers = std::array<double, 7>;

  /// One command with its numbers; false where the data are damaged.
  bool step() {
    if (isCommandLetter(rest_.front())) {
      letter_ = rest_.front();
      rest_.remove_prefix(1);
    } else if (letter_ == 0 || letter_ == 'Z' || letter_ == 'z') {
      return false;
    }
    const bool isRelative = letter_ >= 'a';
    const char command = isRelative ? static_cast<char>(letter_ - 'a' + 'A') : letter_;
    const std::optional<std::size_t> count = argumentsOf(command);
    if (!count || (!hasStarted_ && command != 'M')) return false;
    Numbers numbers{};
    for (std::size_t i = 0; i < *count; ++i) {
      const bool isFlag = command == 'A' && (i == 3 || i == 4);
      const std::optional<double> number = isFlag ? takeFlag() : takeListed(rest_);
      if (!number) return false;
      numbers[i] = *number;
    }
    obey(command, numbers, isRelative ? pen_ : Vec2{0, 0}, isRelative);
    // Points after those of a move are lines.
    if (command == 'M') letter_ = isRelative ? 'l' : 'L';
    return true;
  }

  /// Flags may stand without anything between them: "a1 1 0 011 1".
  std::optional<double> takeFlag() {
    skipSvgSeparators(rest_);
    if (rest_.empty() || (rest_.front() != '0' && rest_.front() != '1')) return std::nullopt;
    const double flag = rest_.front() == '1' ? 1 : 0;
    rest_.remove_prefix(1);
    return flag;
  }

  void obey(char command, const Numbers& n, Vec2 origin, bool isRelative) {
    const auto point = [&](std::size_t i) { return Vec2{n[i], n[i + 1]} + origin; };
    const Vec2 mirrored = pen_ * 2 - control_;
    switch (command) {
      case 'M':
        lift(false);
        hasStarted_ = true;
        pen_ = start_ = point(0);
        break;
      case 'Z':
        lift(true);
        pen_ = start_;
        break;
      case 'L':
        draw(Arc::line(pen_, point(0)));
        break;
      case 'H':
        draw(Arc::line(pen_, {isRelative ? origin.x + n[0] : n[0], pen_.y}));
        break;
      case 'V':
        draw(Arc::line(pen_, {pen_.x, isRelative ? origin.y + n[0] : n[0]}));
        break;
      case 'C':
        cubic(point(0), point(2), point(4));
        return;
      case 'S':
        cubic(last_ == 'C' ? mirrored : pen_, point(0), point(2));
        return;
      case 'Q':
        quadratic(point(0), point(2));
        return;
      case 'T':
        quadratic(last_ == 'Q' ? mirrored : pen_, point(0));
        return;
      default:
        appendSvgArc(chain_.arcs, pen_, point(5), {n[0], n[1]}, n[2], n[3] != 0, n[4] != 0);
        pen_ = point(5);
    }
    last_ = command;
  }

  void draw(const Arc& arc) {
    chain_.arcs.push_back(arc);
    pen_ = arc.end;
  }

  void cubic(Vec2 control1, Vec2 control2, Vec2 end) {
    draw(Arc::cubic(pen_, control1, control2, end));
    control_ = control2;
    last_ = 'C';
  }

  void quadratic(Vec2 control, Vec2 end) {
    draw(fromQuadratic(pen_, control, end));
    control_ = control;
    last_ = 'Q';
  }

  void lift(bool isClosed) {
    if (chain_.arcs.empty()) return;
    if (isClosed && pen_ != start_) chain_.arcs.push_back(Arc::line(pen_, start_));
    chain_.isClosed = isClosed;
    outline_.chains.push_back(std::move(chain_));
    chain_ = {};
  }

  std::string_view rest_;
  SvgOutline outline_;
  SvgChain chain_;
  char letter_ = 0;
  char last_ = 0;  ///< whose control point the next smooth piece mirrors
  bool hasStarted_ = false;
  Vec2 pen_;
  Vec2 start_;
  Vec2 control_;
};

/// Signed angle from u to v.
double angleBetween(Vec2 u, Vec2 v) { return std::atan2(cross(u, v), dot(u, v)); }

/// An ellipse whose axes are turned: place on it, and direction, by the angle of its circle.
struct TurnedEllipse {
  Vec2 centre;
  Vec2 x;  ///< half axes
  Vec2 y;
  Vec2 at(double t) const { return centre + x * std::cos(t) + y * std::sin(t); }
  Vec2 ahead(double t) const { return y * std::cos(t) - x * std::sin(t); }
};

void appendTurned(std::vector<Arc>& arcs, const TurnedEllipse& ellipse, double start, double sweep,
                  Vec2 from, Vec2 to) {
  constexpr double kEighth = std::numbers::pi / 4;
  const int count = std::clamp(static_cast<int>(std::ceil(std::fabs(sweep) / kEighth)), 1, 8);
  const double step = sweep / count;
  const double reach = 4.0 / 3 * std::tan(step / 4);
  Vec2 here = from;
  for (int i = 0; i < count; ++i) {
    const double t0 = start + step * i;
    const double t1 = start + step * (i + 1);
    const Vec2 next = i + 1 == count ? to : ellipse.at(t1);
    arcs.push_back(
        Arc::cubic(here, here + ellipse.ahead(t0) * reach, next - ellipse.ahead(t1) * reach, next));
    here = next;
  }
}

}  // namespace

// Centre and angles from two ends: SVG 1.1, implementation notes F.6.5 and F.6.6.
void appendSvgArc(std::vector<Arc>& arcs, Vec2 from, Vec2 to, Vec2 radii, double turn, bool isLarge,
                  bool isPositive) {
  double rx = std::fabs(radii.x);
  double ry = std::fabs(radii.y);
  if (from == to) return;
  if (!(rx > 0) || !(ry > 0)) {
    arcs.push_back(Arc::line(from, to));
    return;
  }
  const double angle = turn * std::numbers::pi / 180;
  const Vec2 x{std::cos(angle), std::sin(angle)};
  const Vec2 y = perpendicular(x);
  const Vec2 half = (from - to) / 2;
  const Vec2 p{dot(half, x) / rx, dot(half, y) / ry};
  const double size = dot(p, p);
  if (size > 1) {
    rx *= std::sqrt(size);
    ry *= std::sqrt(size);
  }
  // In the frame where the ellipse is the unit circle.
  const Vec2 unit = size > 1 ? p / std::sqrt(size) : p;
  const double square = dot(unit, unit);
  const double away = square > 0 ? std::sqrt(std::max(0.0, 1 / square - 1)) : 0;
  const double sign = isLarge == isPositive ? -1 : 1;
  const Vec2 middle = Vec2{unit.y, -unit.x} * (sign * away);
  const TurnedEllipse ellipse{(from + to) / 2 + x * (middle.x * rx) + y * (middle.y * ry), x * rx,
                              y * ry};
  const Vec2 first = unit - middle;
  const Vec2 second = -unit - middle;
  double sweep = angleBetween(first, second);
  constexpr double kWhole = 2 * std::numbers::pi;
  if (isPositive && sweep < 0) sweep += kWhole;
  if (!isPositive && sweep > 0) sweep -= kWhole;
  const double start = std::atan2(first.y, first.x);
  if (!std::isfinite(start) || !std::isfinite(sweep)) {
    arcs.push_back(Arc::line(from, to));
    return;
  }
  appendTurned(arcs, ellipse, start, sweep, from, to);
}

SvgOutline svgPathOf(std::string_view data) {
  if (data == "none") return {};
  return PathReader(data).read();
}

SvgOutline svgPointsOf(std::string_view points, bool isClosed) {
  SvgOutline outline;
  SvgChain chain;
  std::optional<Vec2> first;
  Vec2 last;
  while (skipSvgSeparators(points), !points.empty()) {
    const std::optional<double> x = takeListed(points);
    const std::optional<double> y = x ? takeListed(points) : std::nullopt;
    if (!y) {
      outline.isWhole = false;
      break;
    }
    const Vec2 next{*x, *y};
    if (first) {
      chain.arcs.push_back(Arc::line(last, next));
    } else {
      first = next;
    }
    last = next;
  }
  if (isClosed && first && last != *first) chain.arcs.push_back(Arc::line(last, *first));
  chain.isClosed = isClosed;
  if (!chain.arcs.empty()) outline.chains.push_back(std::move(chain));
  return outline;
}

SvgChain svgRectangle(Vec2 corner, Vec2 size, Vec2 radii) {
  const double rx = std::clamp(radii.x, 0.0, size.x / 2);
  const double ry = std::clamp(radii.y, 0.0, size.y / 2);
  const Vec2 far = corner + size;
  SvgChain chain;
  chain.isClosed = true;
  std::vector<Arc>& arcs = chain.arcs;
  if (!(rx > 0) || !(ry > 0)) {
    const std::array<Vec2, 4> at{corner, {far.x, corner.y}, far, {corner.x, far.y}};
    for (std::size_t i = 0; i < at.size(); ++i) {
      arcs.push_back(Arc::line(at[i], at[(i + 1) % at.size()]));
    }
    return chain;
  }
  const auto line = [&](Vec2 from, Vec2 to) {
    if (from != to) arcs.push_back(Arc::line(from, to));
  };
  const auto round = [&](Vec2 from, Vec2 to) {
    appendSvgArc(arcs, from, to, {rx, ry}, 0, false, true);
  };
  line({corner.x + rx, corner.y}, {far.x - rx, corner.y});
  round({far.x - rx, corner.y}, {far.x, corner.y + ry});
  line({far.x, corner.y + ry}, {far.x, far.y - ry});
  round({far.x, far.y - ry}, {far.x - rx, far.y});
  line({far.x - rx, far.y}, {corner.x + rx, far.y});
  round({corner.x + rx, far.y}, {corner.x, far.y - ry});
  line({corner.x, far.y - ry}, {corner.x, corner.y + ry});
  round({corner.x, corner.y + ry}, {corner.x + rx, corner.y});
  return chain;
}

SvgChain svgEllipse(Vec2 centre, Vec2 radii) {
  SvgChain chain;
  chain.isClosed = true;
  const std::array<Vec2, 4> at{
      Vec2{centre.x + radii.x, centre.y}, Vec2{centre.x, centre.y + radii.y},
      Vec2{centre.x - radii.x, centre.y}, Vec2{centre.x, centre.y - radii.y}};
  for (std::size_t i = 0; i < at.size(); ++i) {
    appendSvgArc(chain.arcs, at[i], at[(i + 1) % at.size()], radii, 0, false, true);
  }
  return chain;
}

}  // namespace kiri
