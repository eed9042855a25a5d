// The mesh of a state out of that of another one, when nothing but poses differs.
// SPDX-License-Identifier: MIT
#include "render/mesh/moved_mesh.h"

#include <algorithm>
#include <cstddef>

#include "render/mesh/hinge_breaks.h"
#include "render/mesh/mesh_builder.h"

namespace kiri {
namespace {

Rigid inverse(const Rigid& r) {
  Rigid out;
  out.x = {r.x.x, r.y.x, r.z.x};
  out.y = {r.x.y, r.y.y, r.z.y};
  out.z = {r.x.z, r.y.z, r.z.z};
  out.origin = -out.direction(r.origin);
  return out;
}

bool hasSameFolds(const CreasePattern& a, const CreasePattern& b) {
  const auto isSame = [](const Edge& e, const Edge& f) {
    return e.from == f.from && e.to == f.to && e.left == f.left && e.right == f.right &&
           e.kind == f.kind && e.curve == f.curve && isFoldedHinge(e) == isFoldedHinge(f);
  };
  return std::equal(a.edges.begin(), a.edges.end(), b.edges.begin(), b.edges.end(), isSame);
}

bool hasSamePaper(const CreasePattern& a, const CreasePattern& b) {
  const auto isSameFacet = [](const Facet& f, const Facet& g) {
    return f.border == g.border && f.holeStarts == g.holeStarts;
  };
  const auto isSameCurve = [](const CurveControls& c, const CurveControls& d) {
    return c.control1 == d.control1 && c.control2 == d.control2;
  };
  return a.vertices == b.vertices && hasSameFolds(a, b) &&
         std::equal(a.facets.begin(), a.facets.end(), b.facets.begin(), b.facets.end(),
                    isSameFacet) &&
         std::equal(a.curves.begin(), a.curves.end(), b.curves.begin(), b.curves.end(),
                    isSameCurve);
}

/// How each facet went from the one state to the other.
std::vector<Rigid> motions(const FoldedState& from, const FoldedState& to) {
  std::vector<Rigid> out;
  out.reserve(from.poses.size());
  for (std::size_t f = 0; f < from.poses.size(); ++f) {
    out.push_back(compose(to.poses[f], inverse(from.poses[f])));
  }
  return out;
}

/// Each plane went as a whole, and is layered as it was.
bool planesStayed(const FoldedState& from, const FoldedState& to,
                  const std::vector<Rigid>& motions) {
  if (from.layers.sets().size() != to.layers.sets().size()) return false;
  const Tolerance& tolerance = from.tolerance();
  for (const LayerSet& set : from.layers.sets()) {
    if (set.upward.empty()) continue;
    const FacetId first = set.upward.front();
    const LayerSet& now = to.layers.sets()[to.layers.setOf(first)];
    const Rigid& motion = motions[first.index];
    if (now.upward != set.upward || now.exceptions != set.exceptions ||
        dot(motion.direction(set.normal), now.normal) <= 0) {
      return false;
    }
    const Vec3 place = from.poseOf(first).origin;
    for (const FacetId facet : set.upward) {
      const Rigid& own = motions[facet.index];
      const double turned = distance(own.x, motion.x) + distance(own.y, motion.y);
      if (turned * tolerance.sheetSize() > tolerance.match() ||
          distance(own.apply(place), motion.apply(place)) > tolerance.match()) {
        return false;
      }
    }
  }
  return true;
}

class Mover {
 public:
  Mover(PaperMesh& mesh, const Tolerance& tolerance, const std::vector<Rigid>& motions)
      : mesh_(mesh), builder_(mesh, tolerance), motions_(motions) {}

  void run() {
    for (MeshVertex& v : mesh_.vertices) move(v);
    for (MeshSegment& s : mesh_.segments) move(s);
    const auto isValley = [](const MeshShade& s) { return s.isValley; };
    const auto end = std::find_if(mesh_.shades.begin(), mesh_.shades.end(), isValley);
    mesh_.shades.erase(end, mesh_.shades.end());
    for (MeshShade& s : mesh_.shades) {
      s.from = place(s.from, s.facet);
      s.to = place(s.to, s.facet);
      s.normal = direction(s.normal, s.facet);
    }
    builder_.addValleys(mesh_.segments);
  }

 private:
  std::array<float, 3> place(const std::array<float, 3>& p, std::uint32_t facet) const {
    return builder_.rounded(motions_[facet].apply(mesh_.origin + asVec(p)));
  }
  std::array<float, 3> direction(const std::array<float, 3>& d, std::uint32_t facet) const {
    return floats(motions_[facet].direction(asVec(d)));
  }

  void move(MeshVertex& v) const {
    const Rigid& motion = motions_[v.facet];
    const Vec3 normal = asVec(v.normal);
    const Vec3 foot = mesh_.origin + normal * static_cast<double>(v.height);
    v.position = place(v.position, v.facet);
    const Vec3 turned = motion.direction(normal);
    v.normal = floats(turned);
    v.height = static_cast<float>(dot(turned, motion.apply(foot) - mesh_.origin));
  }

  void move(MeshSegment& s) const {
    s.from = place(s.from, s.facet);
    s.to = place(s.to, s.facet);
    s.normal = direction(s.normal, s.facet);
    s.otherNormal = direction(s.otherNormal, s.otherFacet);
  }

  PaperMesh& mesh_;
  MeshBuilder builder_;
  const std::vector<Rigid>& motions_;
};

}  // namespace

std::optional<PaperMesh> movedMesh(const PaperMesh& base, const FoldedState& baseState,
                                   const FoldedState& state) {
  if (!hasSamePaper(baseState.pattern, state.pattern)) return {};
  const std::vector<Rigid> moved = motions(baseState, state);
  if (!planesStayed(baseState, state, moved)) return {};
  PaperMesh mesh = base;
  Mover(mesh, state.tolerance(), moved).run();
  return mesh;
}

}  // namespace kiri
