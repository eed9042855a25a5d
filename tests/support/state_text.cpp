// A state as text with every bit in it.
// SPDX-License-Identifier: MIT
#include "tests/support/state_text.h"

#include <cstdio>
#include <sstream>

namespace kiri::test {
namespace {

class StateWriter {
 public:
  StateWriter& operator<<(double value) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, " %a", value);
    out_ << buffer;
    return *this;
  }
  StateWriter& operator<<(const char* word) {
    out_ << word;
    return *this;
  }
  StateWriter& operator<<(const std::string& word) {
    out_ << " '" << word << "'";
    return *this;
  }
  StateWriter& operator<<(std::uint32_t value) {
    out_ << ' ' << value;
    return *this;
  }
  StateWriter& operator<<(bool value) { return *this << (value ? 1u : 0u); }
  StateWriter& operator<<(Vec2 v) { return *this << v.x << v.y; }
  StateWriter& operator<<(Vec3 v) { return *this << v.x << v.y << v.z; }
  StateWriter& operator<<(const Rigid& r) { return *this << r.x << r.y << r.z << r.origin; }
  template <class Tag>
  StateWriter& operator<<(Id<Tag> id) {
    return *this << id.index;
  }
  std::string text() const { return out_.str(); }

 private:
  std::ostringstream out_;
};

void write(StateWriter& out, const CreasePattern& pattern) {
  out << "size" << pattern.tolerance.sheetSize() << "\n";
  for (const Vec2& v : pattern.vertices) out << "vertex" << v << "\n";
  for (const Edge& e : pattern.edges) {
    out << "edge" << e.from << e.to << e.left << e.right << static_cast<std::uint32_t>(e.kind)
        << e.leftMoves << static_cast<std::uint32_t>(e.sign + 1) << e.line << e.angle << e.curve
        << "\n";
  }
  for (const Facet& f : pattern.facets) {
    out << "facet";
    for (const EdgeUse use : f.border) out << use.edge << use.isReversed;
    out << " holes";
    for (const std::uint32_t start : f.holeStarts) out << start;
    out << "\n";
  }
  for (const CurveControls& c : pattern.curves) out << "curve" << c.control1 << c.control2 << "\n";
}

void write(StateWriter& out, const LayerOrder& layers) {
  for (const LayerSet& set : layers.sets()) {
    out << "set" << set.normal << " upward";
    for (const FacetId f : set.upward) out << f;
    out << " exceptions";
    for (const auto& [upper, lower] : set.exceptions) out << upper << lower;
    out << "\n";
  }
}

}  // namespace

std::string textOf(const FoldedState& state) {
  StateWriter out;
  write(out, state.pattern);
  for (const FoldLine& line : state.lines)
    out << "line" << line.name << line.foldedAmount << line.isValley << "\n";
  for (const Rest& rest : state.rests) out << "rest" << rest.facet << rest.pose << "\n";
  write(out, state.layers);
  for (const Rigid& pose : state.poses) out << "pose" << pose << "\n";
  for (const Collision& c : state.collisions) {
    out << "collision" << c.step << static_cast<std::uint32_t>(c.moment) << c.moving << c.fixed
        << c.degrees << c.place << c.isCertain << c.message << "\n";
  }
  return out.text();
}

std::string firstDifference(const std::string& a, const std::string& b) {
  std::istringstream left(a);
  std::istringstream right(b);
  std::string p;
  std::string q;
  while (true) {
    const bool hasLeft = static_cast<bool>(std::getline(left, p));
    const bool hasRight = static_cast<bool>(std::getline(right, q));
    if (!hasLeft && !hasRight) return {};
    if (!hasLeft) p = "(end)";
    if (!hasRight) q = "(end)";
    if (p != q) return p + "\n" + q;
  }
}

}  // namespace kiri::test
