// SPDX-License-Identifier: MIT
#include "editor/tools/keep_choice.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "core/model/apply.h"
#include "editor/tools/drawn_line.h"
#include "editor/view/picking.h"

namespace kiri {
namespace {

/// A connected part of the paper after the cut.
struct Piece {
  Vec2 place;             ///< well inside its largest facet, paper frame
  double area = 0;        ///< mm^2
  double rim = 0;         ///< mm of the border of the sheet
  bool isParted = false;  ///< the cut divided it from others
};

std::vector<Piece> piecesWith(const FoldedState& after) {
  const std::vector<std::uint32_t> pieceOf = piecesOf(after.pattern);
  std::vector<Piece> pieces;
  std::vector<double> largest;
  for (std::size_t f = 0; f < pieceOf.size(); ++f) {
    if (pieceOf[f] >= pieces.size()) {
      pieces.resize(pieceOf[f] + 1);
      largest.resize(pieceOf[f] + 1, 0);
    }
    Piece& piece = pieces[pieceOf[f]];
    const double area = areaOf(regionOf(after.pattern, FacetId(f)));
    piece.area += area;
    if (area > largest[pieceOf[f]]) {
      largest[pieceOf[f]] = area;
      piece.place = interiorPointOf(after.pattern, FacetId(f));
    }
    for (const EdgeUse use : after.pattern[FacetId(f)].border) {
      if (after.pattern[use.edge].kind != EdgeKind::Border) continue;
      piece.rim += lengthOf(arcOf(after.pattern, use), after.tolerance().flattening());
    }
  }
  return pieces;
}

/// The pieces after a cut that keeps everything, those marked that were one piece before.
std::vector<Piece> partsOf(const FoldedState& before, const FoldedState& after) {
  std::vector<Piece> pieces = piecesWith(after);
  const std::vector<std::uint32_t> oldPiece = piecesOf(before.pattern);
  const bool wasWhole = std::count(oldPiece.begin(), oldPiece.end(), 0U) ==
                        static_cast<std::ptrdiff_t>(oldPiece.size());
  std::vector<std::uint32_t> from(pieces.size(), 0);
  for (std::size_t i = 0; i < pieces.size() && !wasWhole; ++i) {
    const std::optional<FacetId> facet = facetAt(before.pattern, pieces[i].place);
    from[i] = facet ? oldPiece[facet->index] : FacetId::kNone;
  }
  std::map<std::uint32_t, int> parts;
  for (const std::uint32_t old : from) ++parts[old];
  for (std::size_t i = 0; i < pieces.size(); ++i) pieces[i].isParted = parts[from[i]] > 1;
  return pieces;
}

const Piece* bestOf(const std::vector<Piece>& pieces, CutHabit habit) {
  constexpr double kLittle = 1.0 / 8;
  double all = 0;
  for (const Piece& piece : pieces) all += piece.isParted ? piece.area : 0;
  const Piece* best = nullptr;
  const Piece* largest = nullptr;
  for (const Piece& piece : pieces) {
    if (!piece.isParted) continue;
    if (!largest || piece.area > largest->area) largest = &piece;
    if (piece.area < all * kLittle) continue;
    if (!best || piece.rim < best->rim) best = &piece;
  }
  return habit == CutHabit::Shape && best ? best : largest;
}

/// True when the pieces can be told into two sides such that every cut lies between the two: then
/// the kernel most likely keeps a side. To be certain the cut has to be tried.
bool haveTwoSides(const FoldedState& after) {
  const std::vector<std::uint32_t> pieceOf = piecesOf(after.pattern);
  std::vector<std::vector<std::uint32_t>> beyond(pieceOf.size());
  for (const Edge& edge : after.pattern.edges) {
    if (edge.kind != EdgeKind::Cut) continue;
    const std::uint32_t a = pieceOf[edge.left.index];
    const std::uint32_t b = pieceOf[edge.right.index];
    beyond[a].push_back(b);
    beyond[b].push_back(a);
  }
  std::vector<int> side(pieceOf.size(), 0);
  for (std::uint32_t first = 0; first < beyond.size(); ++first) {
    if (side[first] != 0) continue;
    side[first] = 1;
    std::vector<std::uint32_t> open{first};
    while (!open.empty()) {
      const std::uint32_t piece = open.back();
      open.pop_back();
      for (const std::uint32_t other : beyond[piece]) {
        if (side[other] == side[piece]) return false;
        if (side[other] == 0) open.push_back(other);
        side[other] = -side[piece];
      }
    }
  }
  return true;
}

/// What the step leads to: as the preview has it, or found now. None when it does not apply.
std::shared_ptr<const FoldedState> outcomeOf(const Scope& scope, const Step& step) {
  const Preview* known = scope.preview;
  if (known && known->before == scope.state && known->step == step) return known->after;
  Result<FoldedState> after = apply(*scope.state, step, scope.number);
  return after ? std::make_shared<const FoldedState>(std::move(*after)) : nullptr;
}

bool haveSameBorder(const CreasePattern& p, FacetId a, const CreasePattern& q, FacetId b) {
  const std::vector<EdgeUse>& border = p[a].border;
  const std::vector<EdgeUse>& other = q[b].border;
  if (border.size() != other.size()) return false;
  for (std::size_t i = 0; i < border.size(); ++i) {
    if (p[startOf(p, border[i])] != q[startOf(q, other[i])]) return false;
  }
  return true;
}

/// For each piece whether it is still there in `now`, which is `all` without some of its facets: a
/// cut that drops paper leaves the rest in its order.
std::vector<bool> piecesIn(const FoldedState& now, const FoldedState& all) {
  const std::vector<std::uint32_t> pieceOf = piecesOf(all.pattern);
  std::vector<bool> isThere(pieceOf.size(), false);
  std::size_t next = 0;
  for (std::size_t f = 0; f < pieceOf.size() && next < now.pattern.facets.size(); ++f) {
    if (!haveSameBorder(all.pattern, FacetId(f), now.pattern, FacetId(next))) continue;
    isThere[pieceOf[f]] = true;
    ++next;
  }
  return isThere;
}

/// Beyond so many facets applying a cut once more than needed is felt.
constexpr std::size_t kManyFacets = 300;

/// The rims of the pieces of `all` that are not in `now`, where they lie in the model.
std::vector<PathMark> outlinesOfDropped(const FoldedState& all, const FoldedState& now) {
  constexpr int kPerCurve = 8;
  const std::vector<bool> isThere = piecesIn(now, all);
  const std::vector<std::uint32_t> pieceOf = piecesOf(all.pattern);
  std::vector<PathMark> outlines;
  for (std::size_t f = 0; f < pieceOf.size(); ++f) {
    if (isThere[pieceOf[f]]) continue;
    for (const EdgeUse use : all.pattern[FacetId(f)].border) {
      if (all.pattern[use.edge].kind == EdgeKind::Hinge) continue;
      const Arc arc = arcOf(all.pattern, use);
      const int parts = arc.isCurved ? kPerCurve : 1;
      PathMark path{MarkRole::Ghost, {}, false, false};
      for (int i = 0; i <= parts; ++i)
        path.places.push_back(
            all.poseOf(FacetId(f)).apply(pointAt(arc, static_cast<double>(i) / parts)));
      outlines.push_back(std::move(path));
    }
  }
  return outlines;
}

Step withKeep(const Step& cut, Keep keep) {
  Step step = cut;
  keepOf(step) = std::move(keep);
  return step;
}

}  // namespace

Keep& keepOf(Step& cut) {
  if (auto* straight = std::get_if<StraightCutStep>(&cut.action)) return straight->keep;
  auto* curve = std::get_if<CurveCutStep>(&cut.action);
  KIRI_CHECK(curve != nullptr, "only cuts keep paper");
  return curve->keep;
}

void KeepChoice::suggest(const Scope& scope, const Step& cut, CutHabit habit) {
  if (isChosen_) return;
  reset();
  const FoldedState& state = *scope.state;
  const auto all = outcomeOf(scope, withKeep(cut, {}));
  if (!all) return;
  const std::vector<Piece> pieces = partsOf(state, *all);
  const Piece* best = bestOf(pieces, habit);
  if (!best) return;
  mark_ = best->place;
  mode_ = Mode::Side;
  const bool isLarge = state.pattern.facets.size() > kManyFacets;
  if (isLarge ? haveTwoSides(*all) : outcomeOf(scope, withKeep(cut, keep(state))) != nullptr)
    return;
  mode_ = Mode::Pieces;  // the sides hang together somewhere, but the cut parts pieces
  for (const Piece& piece : pieces) {
    if (!piece.isParted || &piece == best) pieces_.push_back(piece.place);
  }
}

void KeepChoice::toggle(const Scope& scope, const Step& cut, Vec2 paper) {
  const FoldedState& state = *scope.state;
  const auto all = outcomeOf(scope, withKeep(cut, {}));
  if (!all) return;
  const auto now = mode_ == Mode::All ? all : outcomeOf(scope, withKeep(cut, keep(state)));
  const std::vector<Piece> pieces = piecesWith(*all);
  const std::optional<FacetId> clicked = facetAt(all->pattern, paper);
  if (!clicked) return;
  const std::uint32_t which = piecesOf(all->pattern)[clicked->index];
  const std::vector<bool> wasKept =
      now ? piecesIn(*now, *all) : std::vector<bool>(pieces.size(), true);
  std::vector<Vec2> kept;
  std::vector<Vec2> others;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const bool isClicked = i == which;
    if (isClicked != wasKept[i]) kept.push_back(pieces[i].place);
    if (!isClicked) others.push_back(pieces[i].place);
  }
  if (kept.empty()) kept = std::move(others);
  if (kept.empty()) return;
  pieces_ = std::move(kept);
  mode_ = Mode::Pieces;
  isChosen_ = true;
}

void KeepChoice::showDropped(const Scope& scope, const Step& cut) {
  dropped_.clear();
  if (mode_ == Mode::All || scope.state->pattern.facets.size() > kManyFacets) return;
  const auto all = outcomeOf(scope, withKeep(cut, {}));
  const auto now = outcomeOf(scope, withKeep(cut, keep(*scope.state)));
  if (all && now) dropped_ = outlinesOfDropped(*all, *now);
}

bool KeepChoice::takeMark(const PointerEvent& press, const Scope& scope) {
  if (mode_ != Mode::Side || !mark_) return false;
  const std::optional<FacetId> facet = facetAt(scope.state->pattern, *mark_);
  if (!facet) return false;
  const Vec2 at = scope.map(press.pane).toPixels(*scope.state, {*facet, *mark_});
  isHeld_ = distance(at, press.at) < handleReach(press);
  return isHeld_;
}

void KeepChoice::follow(const PointerEvent& event, const Scope& scope) {
  if (!isHeld_) return;
  if (event.action == PointerAction::Release) isHeld_ = false;
  const auto pick = pickPaper(*scope.state, scope.map(event.pane), event.at);
  if (!pick) return;
  mark_ = pick->spot.paper;
  isChosen_ = true;
}

Keep KeepChoice::keep(const FoldedState& state) const {
  Keep keep;
  if (mode_ == Mode::Side && mark_) {
    const std::optional<FacetId> facet = facetAt(state.pattern, *mark_);
    if (!facet) return keep;
    const Rigid& pose = state.poseOf(*facet);
    // A place of the model keeps its side in all layers; a plane that stands upright has no such
    // places, so there the piece itself is named.
    if (std::abs(pose.normal().z) > kSamePlane) {
      keep.places.push_back({Frame::Model, flatten(pose.apply(*mark_))});
    } else {
      keep.places.push_back({Frame::Paper, *mark_});
    }
  }
  if (mode_ == Mode::Pieces) {
    for (const Vec2 place : pieces_) keep.places.push_back({Frame::Paper, place});
  }
  return keep;
}

void KeepChoice::addMarks(const FoldedState& state, Marks& marks) const {
  constexpr std::size_t kMostWords = 8;
  constexpr std::size_t kMostPoints = 64;
  const auto add = [&](Vec2 place, MarkRole role) {
    const std::optional<FacetId> facet = facetAt(state.pattern, place);
    if (!facet) return;
    marks.push_back(PointMark{role, Spot{*facet, place}});
    if (pieces_.size() > kMostWords) return;
    marks.push_back(TextMark{role, Spot{*facet, place}, {KIRI_TEXT("editor/tools", "stays"), {}}});
  };
  marks.insert(marks.end(), dropped_.begin(), dropped_.end());
  if (mode_ == Mode::Side && mark_)
    add(*mark_, isHeld_ ? MarkRole::ActiveHandle : MarkRole::Handle);
  if (mode_ != Mode::Pieces || pieces_.size() > kMostPoints) return;
  for (const Vec2 place : pieces_) add(place, MarkRole::Selected);
}

void KeepChoice::addFields(std::vector<Field>& fields) const {
  Field keep;
  keep.id = "keep";
  keep.label = {KIRI_TEXT("editor/tools", "Stays"), {}};
  keep.kind = Field::Kind::Choice;
  keep.value = static_cast<double>(mode_);
  keep.options = {{KIRI_TEXT("editor/tools", "The marked side"), {}},
                  {KIRI_TEXT("editor/tools", "Everything"), {}}};
  if (!pieces_.empty()) keep.options.push_back({KIRI_TEXT("editor/tools", "Picked pieces"), {}});
  keep.help = {KIRI_TEXT("editor/tools",
                         "Which paper stays after the cut; click a piece to keep or drop it"),
               {}};
  fields.push_back(keep);
}

bool KeepChoice::setField(const std::string& id, const FieldValue& value) {
  if (id != "keep") return false;
  const bool isSide = value.number == static_cast<double>(Mode::Side);
  const bool isPieces = value.number == static_cast<double>(Mode::Pieces);
  if ((isSide && !mark_) || (isPieces && pieces_.empty())) return true;
  mode_ = isSide ? Mode::Side : isPieces ? Mode::Pieces : Mode::All;
  isChosen_ = true;
  return true;
}

}  // namespace kiri
