// Unfolding a folded form by its faces.
// SPDX-License-Identifier: MIT
#include "io/patterns/fold_unroll.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "core/geometry/tolerance.h"
#include "io/json_tree.h"

namespace kiri {

namespace {

/// A face's side: from corner `side` to the next.
struct FaceSide {
  std::uint32_t face = 0;
  std::uint32_t side = 0;
};

/// The faces at one pair of vertices.
struct SharedSide {
  std::vector<FaceSide> faces;
  bool isCrossed = false;  ///< all faces beside it were placed
};

/// A face laid flat: its corners in the plane, and the frame in space that they are measured in.
struct FlatFace {
  std::vector<Vec2> corners;
  Vec3 normal;
};

using VertexPair = std::pair<std::uint32_t, std::uint32_t>;

class Unroller {
 public:
  explicit Unroller(const FoldGraph& form) : form_(form), faces_(form.faces.size()) {}

  void run() {
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      faces_[f] = laidFlat(form_.faces[f]);
      const std::vector<std::uint32_t>& face = form_.faces[f];
      for (std::uint32_t i = 0; i < face.size(); ++i) {
        sideOf(face, i).faces.push_back({f, i});
      }
    }
    isPlaced_.assign(faces_.size(), false);
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      if (!isPlaced_[f]) rollOutFrom(f);
    }
  }

  FoldGraph result(std::vector<std::string>& notes) {
    FoldGraph out;
    out.size = form_.size;
    out.isAssigned = form_.isAssigned;
    out.faces.resize(faces_.size());
    shareVertices(out);
    std::size_t stray = 0;
    for (const FoldGraphEdge& edge : form_.edges) stray += addEdge(edge, out) ? 0u : 1u;
    notes.push_back("the frame is a folded form; its " + std::to_string(faces_.size()) +
                    " faces were rolled out in the plane along their edges");
    if (widest_ > Tolerance(form_.size).pick()) {
      notes.push_back("corners that are one vertex came to lie up to " + numberText(widest_) +
                      " apart when the faces were rolled out: the form is strained");
    }
    if (pieces_ > 1) {
      notes.push_back("the faces form " + std::to_string(pieces_) +
                      " pieces that share no edges; they were laid side by side");
    }
    if (parted_ > 0) {
      notes.push_back(std::to_string(parted_) +
                      " edges came apart when the faces were rolled out: the form is not made of "
                      "paper that lies flat; they were taken as borders");
    }
    if (stray > 0) {
      notes.push_back(std::to_string(stray) + " edges that belong to no face were left out");
    }
    return out;
  }

 private:
  Vec3 place(std::uint32_t vertex) const { return form_.vertices[vertex]; }

  SharedSide& sideOf(const std::vector<std::uint32_t>& face, std::size_t i) {
    return sides_[std::minmax(face[i], face[(i + 1) % face.size()])];
  }

  FlatFace laidFlat(const std::vector<std::uint32_t>& face) const {
    FlatFace out;
    const Vec3 origin = place(face[0]);
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      out.normal = out.normal + cross(place(face[i]) - origin, place(face[i + 1]) - origin);
    }
    const double size = length(out.normal);
    out.normal = size > 0 ? out.normal / size : Vec3{0, 0, 1};
    // In the plane of the paper already, a face stays as it is, to the last bit.
    if (out.normal.x == 0 && out.normal.y == 0 && out.normal.z > 0) {
      for (const std::uint32_t v : face) out.corners.push_back(flatten(place(v)));
      return out;
    }
    Vec3 along;
    for (const std::uint32_t v : face) {
      if (length(place(v) - origin) > length(along)) along = place(v) - origin;
    }
    along = along - out.normal * dot(along, out.normal);
    const double reach = length(along);
    along = reach > 0 ? along / reach : Vec3{1, 0, 0};
    const Vec3 across = cross(out.normal, along);
    for (const std::uint32_t v : face) {
      const Vec3 p = place(v) - origin;
      out.corners.push_back({dot(p, along), dot(p, across)});
    }
    return out;
  }

  void rollOutFrom(std::uint32_t root) {
    ++pieces_;
    const std::size_t firstOfPiece = order_.size();
    isPlaced_[root] = true;
    order_.push_back(root);
    for (std::size_t at = firstOfPiece; at < order_.size(); ++at) {
      const std::uint32_t f = order_[at];
      const std::vector<std::uint32_t>& face = form_.faces[f];
      for (std::uint32_t i = 0; i < face.size(); ++i) {
        SharedSide& shared = sideOf(face, i);
        if (std::exchange(shared.isCrossed, true)) continue;
        for (const FaceSide& other : shared.faces) {
          if (!isPlaced_[other.face]) putBeside({f, i}, other);
        }
      }
    }
    layAside(firstOfPiece);
  }

  /// Moves a face so that the shared side lies on that of its neighbour, on the other side of it.
  void putBeside(const FaceSide& fixed, const FaceSide& moved) {
    const auto endsOf = [&](const FaceSide& s) {
      const std::vector<Vec2>& corners = faces_[s.face].corners;
      return std::pair{corners[s.side], corners[(s.side + 1) % corners.size()]};
    };
    FlatFace& face = faces_[moved.face];
    const bool runsAlike =
        form_.faces[fixed.face][fixed.side] == form_.faces[moved.face][moved.side];
    // Listed the other way round: the face shows its other side, so it is mirrored.
    if (runsAlike == isMirrored(fixed.face)) {
      isMirrored_[moved.face] = false;
    } else {
      isMirrored_[moved.face] = true;
      for (Vec2& corner : face.corners) corner.x = -corner.x;
    }
    auto [to, toEnd] = endsOf(fixed);
    auto [from, fromEnd] = endsOf(moved);
    if (!runsAlike) std::swap(from, fromEnd);
    const double size = length(toEnd - to) * length(fromEnd - from);
    double c = 1;
    double s = 0;
    if (size > 0) {
      c = dot(fromEnd - from, toEnd - to) / size;
      s = cross(fromEnd - from, toEnd - to) / size;
      const double norm = std::hypot(c, s);
      c = norm > 0 ? c / norm : 1;
      s = norm > 0 ? s / norm : 0;
    }
    for (Vec2& corner : face.corners) {
      const Vec2 d = corner - from;
      corner = to + Vec2{c * d.x - s * d.y, s * d.x + c * d.y};
    }
    isPlaced_[moved.face] = true;
    order_.push_back(moved.face);
  }

  bool isMirrored(std::uint32_t face) {
    const auto at = isMirrored_.find(face);
    return at != isMirrored_.end() && at->second;
  }

  /// Moves a piece to the right of those before it.
  void layAside(std::size_t firstOfPiece) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (std::size_t i = firstOfPiece; i < order_.size(); ++i) {
      for (const Vec2 p : faces_[order_[i]].corners) {
        low = std::min(low, p.x);
        high = std::max(high, p.x);
      }
    }
    if (firstOfPiece > 0) {
      constexpr double kGap = 0.05;
      const double shift = right_ + kGap * form_.size - low;
      for (std::size_t i = firstOfPiece; i < order_.size(); ++i) {
        for (Vec2& p : faces_[order_[i]].corners) p.x += shift;
      }
      high += shift;
    }
    right_ = std::max(right_, high);
  }

  /// One vertex for corners of the same old vertex that lie together.
  void shareVertices(FoldGraph& out) {
    constexpr double kTogether = 0.02;  // of the size: what strained models leave
    std::map<std::uint32_t, std::vector<std::uint32_t>> copies;
    for (const std::uint32_t f : order_) {
      const std::vector<std::uint32_t>& face = form_.faces[f];
      for (std::size_t i = 0; i < face.size(); ++i) {
        const Vec2 p = faces_[f].corners[i];
        std::vector<std::uint32_t>& known = copies[face[i]];
        constexpr std::size_t kMostCopies = 64;
        const auto same =
            known.size() > kMostCopies
                ? known.end()
                : std::find_if(known.begin(), known.end(), [&](std::uint32_t v) {
                    return distance(flatten(out.vertices[v]), p) <= kTogether * form_.size;
                  });
        if (same == known.end()) {
          known.push_back(static_cast<std::uint32_t>(out.vertices.size()));
          out.vertices.push_back({p.x, p.y, 0});
          out.faces[f].push_back(known.back());
        } else {
          widest_ = std::max(widest_, distance(flatten(out.vertices[*same]), p));
          out.faces[f].push_back(*same);
        }
      }
    }
  }

  /// Draws an edge where its faces lie. False when it has no face.
  bool addEdge(const FoldGraphEdge& edge, FoldGraph& out) {
    const auto at = sides_.find(std::minmax(edge.from, edge.to));
    if (at == sides_.end()) return false;
    std::vector<VertexPair> places;
    std::vector<FaceSide>& beside = at->second.faces;
    if (beside.size() > kMostFaces) beside.resize(kMostFaces);
    for (const FaceSide& s : beside) {
      const std::vector<std::uint32_t>& face = out.faces[s.face];
      VertexPair ends = {face[s.side], face[(s.side + 1) % face.size()]};
      if (form_.faces[s.face][s.side] != edge.from) std::swap(ends.first, ends.second);
      if (std::find(places.begin(), places.end(), ends) == places.end()) places.push_back(ends);
    }
    FoldGraphEdge drawn = edge;
    if (places.size() > 1 && edge.assignment != Assignment::Cut) ++parted_;
    if (places.size() > 1) {
      drawn.assignment = Assignment::Border;
      drawn.angle.reset();
    } else if (!form_.isAssigned && beside.size() == 2) {
      assignFromForm(beside, drawn);
    }
    for (const VertexPair& ends : places) {
      drawn.from = ends.first;
      drawn.to = ends.second;
      out.edges.push_back(drawn);
    }
    return true;
  }

  /// The fold angle that the form itself shows; none of which sign where it is folded flat.
  void assignFromForm(const std::vector<FaceSide>& beside, FoldGraphEdge& edge) {
    Vec3 n0 = faces_[beside[0].face].normal;
    Vec3 n1 = faces_[beside[1].face].normal;
    if (isMirrored(beside[0].face)) n0 = -n0;
    if (isMirrored(beside[1].face)) n1 = -n1;
    const bool runsForth = form_.faces[beside[0].face][beside[0].side] == edge.from;
    Vec3 along = place(edge.to) - place(edge.from);
    if (runsForth == isMirrored(beside[0].face)) along = -along;
    const double reach = length(along);
    if (!(reach > 0)) return;
    constexpr double kHalfTurn = 180;
    const double angle =
        -std::atan2(dot(cross(n0, n1), along) / reach, dot(n0, n1)) * kHalfTurn / std::numbers::pi;
    constexpr double kSure = 0.01;  // degrees
    if (std::abs(angle) < kSure) {
      edge.assignment = Assignment::Flat;
    } else if (std::abs(angle) < kHalfTurn - kSure) {
      edge.assignment = angle > 0 ? Assignment::Valley : Assignment::Mountain;
      edge.angle = angle;
    }
  }

  /// More faces than this at one edge are no paper.
  static constexpr std::size_t kMostFaces = 4;

  const FoldGraph& form_;
  std::vector<FlatFace> faces_;
  std::map<VertexPair, SharedSide> sides_;
  std::vector<bool> isPlaced_;
  std::map<std::uint32_t, bool> isMirrored_;
  std::vector<std::uint32_t> order_;  // faces as they were placed
  std::size_t pieces_ = 0;
  std::size_t parted_ = 0;
  double widest_ = 0;  // how far corners lie apart that became one
  double right_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

Result<FoldGraph> unrolled(const FoldGraph& form, std::vector<std::string>& notes) {
  if (form.faces.empty()) {
    return Error{ErrorCode::BadFile,
                 "is a folded form without faces_vertices, so it cannot be unfolded; export the "
                 "crease pattern, or the folded form with its faces"};
  }
  Unroller unroller(form);
  unroller.run();
  FoldGraph out = unroller.result(notes);
  if (out.edges.empty()) {
    return Error{ErrorCode::BadFile, "is a folded form whose edges belong to none of its faces"};
  }
  return out;
}

}  // namespace kiri
