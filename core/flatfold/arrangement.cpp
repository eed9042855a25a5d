// Rounds: pieces are divided at points near them, then where they cross, until nothing changes.
// SPDX-License-Identifier: MIT
#include "core/flatfold/arrangement.h"

#include <algorithm>
#include <unordered_map>

#include "core/flatfold/box_tree.h"
#include "core/flatfold/cluster.h"
#include "core/geometry/orientation.h"

namespace kiri {
namespace {

constexpr int kRounds = 48;
constexpr std::uint32_t kNoPiece = 0xFFFFFFFF;

/// A piece, and a point that lies on it.
struct Split {
  std::uint32_t piece = 0;
  double along = 0;
  std::uint32_t point = 0;

  auto operator<=>(const Split&) const = default;
};

struct Meeting {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
};

Box boxAt(Vec2 p) { return {p, p}; }

class Divider {
 public:
  Divider(const std::vector<Vec2>& points, const std::vector<std::array<std::uint32_t, 2>>& lines,
          double within, std::size_t most)
      : within_(within), most_(most) {
    const Clusters clusters = clustersOf(points, within);
    points_ = clusters.middles;
    noteMoves(points, clusters);
    for (const std::array<std::uint32_t, 2>& line : lines) {
      const std::uint32_t code = codeOf(clusters.of[line[0]], clusters.of[line[1]]);
      chains_.push_back(code);
    }
  }

  bool divide() {
    for (int round = 0; round < kRounds; ++round) {
      std::vector<Split> splits = splitsAtPoints();
      if (splits.empty()) {
        if (!splitsAtCrossings(splits)) return false;
        if (splits.empty()) return true;
      }
      if (pieces_.size() + splits.size() > most_) hasTooMany_ = true;
      if (hasTooMany_) return false;
      apply(splits);
    }
    return false;
  }

  std::size_t pieceCount() const { return pieces_.size(); }
  bool hasTooMany() const { return hasTooMany_; }

  std::optional<Arrangement> result() const {
    Arrangement made;
    made.points = points_;
    made.farthest = farthest_;
    std::vector<std::uint32_t> number(pieces_.size(), kNoPiece);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (isDivided(i)) continue;
      number[i] = static_cast<std::uint32_t>(made.pieces.size());
      made.pieces.push_back(pieces_[i].ends);
    }
    made.starts.push_back(0);
    for (const std::uint32_t code : chains_) {
      if (code != kNoPiece && !addLeaves(code, number, 0, made.chain)) return std::nullopt;
      made.starts.push_back(static_cast<std::uint32_t>(made.chain.size()));
    }
    return made;
  }

 private:
  struct Piece {
    std::array<std::uint32_t, 2> ends{};
    std::uint32_t firstPart = 0;
    std::uint32_t parts = 0;  ///< 0: not divided
  };

  void noteMoves(const std::vector<Vec2>& points, const Clusters& clusters) {
    for (std::size_t i = 0; i < points.size(); ++i)
      farthest_ = std::max(farthest_, distance(points[i], clusters.middles[clusters.of[i]]));
  }

  bool isDivided(std::size_t piece) const { return pieces_[piece].parts > 0; }
  Segment2 segmentOf(std::size_t piece) const {
    return {points_[pieces_[piece].ends[0]], points_[pieces_[piece].ends[1]]};
  }

  /// The code of the piece from a to b, which is made when there is none; kNoPiece when a is b.
  std::uint32_t codeOf(std::uint32_t a, std::uint32_t b) {
    if (a == b) return kNoPiece;
    const std::uint32_t isBack = a > b ? 1 : 0;
    if (isBack == 1) std::swap(a, b);
    const auto made = static_cast<std::uint32_t>(pieces_.size());
    const auto [it, isNew] = byEnds_.try_emplace((std::uint64_t{a} << 32) | b, made);
    if (isNew) pieces_.push_back({{a, b}, 0, 0});
    return 2 * it->second + isBack;
  }

  /// False when a piece is a part of itself: points hardly farther apart than `within_` may do
  /// that.
  bool addLeaves(std::uint32_t code, const std::vector<std::uint32_t>& number, int depth,
                 std::vector<std::uint32_t>& chain) const {
    const Piece& piece = pieces_[code / 2];
    if (piece.parts == 0) {
      chain.push_back(2 * number[code / 2] + code % 2);
      return true;
    }
    if (depth > kRounds) return false;
    for (std::uint32_t i = 0; i < piece.parts; ++i) {
      const bool isBack = code % 2 == 1;
      const std::uint32_t part = parts_[piece.firstPart + (isBack ? piece.parts - 1 - i : i)];
      if (!addLeaves(isBack ? part ^ 1U : part, number, depth + 1, chain)) return false;
    }
    return true;
  }

  /// New pieces are compared with all points, old ones with new points.
  std::vector<Split> splitsAtPoints() {
    std::vector<Split> splits;
    if (pointsSeen_ < points_.size()) {
      std::vector<Box> added;
      for (std::size_t p = pointsSeen_; p < points_.size(); ++p) added.push_back(boxAt(points_[p]));
      const BoxTree tree(std::move(added));
      for (std::size_t i = 0; i < piecesSeen_; ++i) {
        if (!isDivided(i)) splitsNear(tree, i, pointsSeen_, splits);
      }
      std::vector<Box> boxes;
      for (const Vec2 p : points_) boxes.push_back(boxAt(p));
      pointTree_.emplace(std::move(boxes));
      pointsSeen_ = points_.size();
    }
    for (std::size_t i = piecesSeen_; i < pieces_.size(); ++i) {
      if (!isDivided(i)) splitsNear(*pointTree_, i, 0, splits);
    }
    piecesSeen_ = pieces_.size();
    return splits;
  }

  void splitsNear(const BoxTree& tree, std::size_t piece, std::size_t firstPoint,
                  std::vector<Split>& splits) {
    const Segment2 segment = segmentOf(piece);
    tree.near(segment, within_, [&](std::uint32_t item) {
      const std::size_t p = firstPoint + item;
      if (p == pieces_[piece].ends[0] || p == pieces_[piece].ends[1]) return;
      const double away = distanceTo(segment, points_[p]);
      if (away > within_) return;
      farthest_ = std::max(farthest_, away);
      addSplit(piece, p, splits);
    });
  }

  void addSplit(std::size_t piece, std::size_t point, std::vector<Split>& splits) const {
    const Segment2 s = segmentOf(piece);
    splits.push_back({static_cast<std::uint32_t>(piece),
                      dot(points_[point] - s.from, s.to - s.from),
                      static_cast<std::uint32_t>(point)});
  }

  std::vector<Meeting> crossings() {
    std::vector<std::uint32_t> alive;
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (isDivided(i)) continue;
      alive.push_back(static_cast<std::uint32_t>(i));
      boxes.push_back(boxOf(segmentOf(i)));
    }
    const BoxTree tree(std::move(boxes));
    std::vector<Meeting> found;
    for (const std::uint32_t i : alive) {
      if (i < piecesCrossed_) continue;
      const Segment2 a = segmentOf(i);
      tree.near(a, 0, [&](std::uint32_t item) {
        const std::uint32_t j = alive[item];
        const bool isOld = j < piecesCrossed_;
        if (found.size() <= most_ && (isOld || j > i) && doCross(i, j)) found.push_back({i, j});
      });
    }
    piecesCrossed_ = pieces_.size();
    return found;
  }

  bool doCross(std::size_t i, std::size_t j) const {
    const std::array<std::uint32_t, 2>& a = pieces_[i].ends;
    const std::array<std::uint32_t, 2>& b = pieces_[j].ends;
    if (a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1]) return false;
    const Segment2 s = segmentOf(i);
    const Segment2 t = segmentOf(j);
    return orientation(s.from, s.to, t.from) * orientation(s.from, s.to, t.to) < 0 &&
           orientation(t.from, t.to, s.from) * orientation(t.from, t.to, s.to) < 0;
  }

  bool splitsAtCrossings(std::vector<Split>& splits) {
    const std::vector<Meeting> meetings = crossings();
    if (meetings.empty()) return true;
    hasTooMany_ = meetings.size() > most_;
    if (hasTooMany_) return false;
    std::vector<Vec2> places;
    for (const Meeting& m : meetings) {
      const Segment2 a = segmentOf(m.first);
      const Segment2 b = segmentOf(m.second);
      const double left = cross(b.to - b.from, a.from - b.from);
      const double right = cross(b.to - b.from, a.to - b.from);
      places.push_back(lerp(a.from, a.to, left / (left - right)));
    }
    const Clusters clusters = clustersOf(places, within_);
    noteMoves(places, clusters);
    std::vector<std::uint32_t> pointOf;
    for (const Vec2 middle : clusters.middles) pointOf.push_back(pointAt(middle));
    for (std::size_t m = 0; m < meetings.size(); ++m) {
      const std::uint32_t point = pointOf[clusters.of[m]];
      bool divides = false;
      for (const std::uint32_t piece : {meetings[m].first, meetings[m].second}) {
        if (point == pieces_[piece].ends[0] || point == pieces_[piece].ends[1]) continue;
        addSplit(piece, point, splits);
        divides = true;
      }
      if (!divides) return false;
    }
    return true;
  }

  /// A point within reach of the place, which becomes one when there is none.
  std::uint32_t pointAt(Vec2 place) {
    std::uint32_t nearest = kNoPiece;
    double best = within_;
    pointTree_->near({place, place}, within_, [&](std::uint32_t p) {
      const double d = distance(points_[p], place);
      if (d > best || (d == best && nearest < p)) return;
      best = d;
      nearest = p;
    });
    if (nearest != kNoPiece) {
      farthest_ = std::max(farthest_, best);
      return nearest;
    }
    points_.push_back(place);
    return static_cast<std::uint32_t>(points_.size() - 1);
  }

  void apply(std::vector<Split>& splits) {
    std::sort(splits.begin(), splits.end());
    for (std::size_t i = 0; i < splits.size();) {
      const std::uint32_t piece = splits[i].piece;
      const std::array<std::uint32_t, 2> ends = pieces_[piece].ends;
      std::vector<std::uint32_t> codes;
      std::uint32_t at = ends[0];
      for (; i < splits.size() && splits[i].piece == piece; ++i) {
        if (splits[i].point == at) continue;
        codes.push_back(codeOf(at, splits[i].point));
        at = splits[i].point;
      }
      codes.push_back(codeOf(at, ends[1]));
      pieces_[piece].firstPart = static_cast<std::uint32_t>(parts_.size());
      pieces_[piece].parts = static_cast<std::uint32_t>(codes.size());
      parts_.insert(parts_.end(), codes.begin(), codes.end());
    }
  }

  double within_;
  std::size_t most_;  ///< pieces
  bool hasTooMany_ = false;
  double farthest_ = 0;
  std::vector<Vec2> points_;
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> parts_;   ///< codes of the parts of divided pieces
  std::vector<std::uint32_t> chains_;  ///< by line: the code of the piece it was
  std::unordered_map<std::uint64_t, std::uint32_t> byEnds_;
  std::optional<BoxTree> pointTree_;
  std::size_t pointsSeen_ = 0;
  std::size_t piecesSeen_ = 0;
  std::size_t piecesCrossed_ = 0;
};

}  // namespace

std::optional<Arrangement> arrange(const std::vector<Vec2>& points,
                                   const std::vector<std::array<std::uint32_t, 2>>& lines,
                                   double within, std::size_t& piecesLeft) {
  Divider divider(points, lines, within, piecesLeft);
  const bool isDone = divider.divide();
  piecesLeft = divider.hasTooMany() ? 0 : piecesLeft - std::min(piecesLeft, divider.pieceCount());
  if (!isDone) return std::nullopt;
  return divider.result();
}

double clearanceOf(const Arrangement& a, double most) {
  std::vector<Box> boxes;
  for (const Vec2 p : a.points) boxes.push_back(boxAt(p));
  const BoxTree tree(std::move(boxes));
  for (const std::array<std::uint32_t, 2>& piece : a.pieces) {
    const Segment2 segment{a.points[piece[0]], a.points[piece[1]]};
    tree.near(segment, most, [&](std::uint32_t p) {
      if (p != piece[0] && p != piece[1]) most = std::min(most, distanceTo(segment, a.points[p]));
    });
  }
  return most;
}

}  // namespace kiri
