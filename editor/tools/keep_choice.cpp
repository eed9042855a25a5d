// SPDX-License-Identifier: MIT
#include "editor/tools/keep_choice.h"

#include <algorithm>
#include <cmath>

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
  std::vector<std::uint32_t> from;
  for (const Piece& piece : pieces) {
    const std::optional<FacetId> facet = facetAt(before.pattern, piece.place);
    from.push_back(facet ? oldPiece[facet->index] : FacetId::kNone);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i)
    pieces[i].isParted = std::count(from.begin(), from.end(), from[i]) > 1;
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
  const Result<FoldedState> all = apply(state, withKeep(cut, {}), scope.number);
  if (!all) return;
  const std::vector<Piece> pieces = partsOf(state, *all);
  const Piece* best = bestOf(pieces, habit);
  if (!best) return;
  mark_ = best->place;
  mode_ = Mode::Side;
  if (apply(state, withKeep(cut, keep(state)), scope.number)) return;
  mode_ = Mode::Pieces;  // the sides hang together somewhere, but the cut parts pieces
  for (const Piece& piece : pieces) {
    if (!piece.isParted || &piece == best) pieces_.push_back(piece.place);
  }
}

void KeepChoice::toggle(const Scope& scope, const Step& cut, Vec2 paper) {
  const FoldedState& state = *scope.state;
  const Result<FoldedState> all = apply(state, withKeep(cut, {}), scope.number);
  const Result<FoldedState> now = apply(state, withKeep(cut, keep(state)), scope.number);
  if (!all) return;
  const std::vector<std::uint32_t> pieceOf = piecesOf(all->pattern);
  const auto pieceAt = [&](Vec2 place) {
    const std::optional<FacetId> facet = facetAt(all->pattern, place);
    return facet ? pieceOf[facet->index] : FacetId::kNone;
  };
  const std::uint32_t clicked = pieceAt(paper);
  if (clicked == FacetId::kNone) return;
  std::vector<Vec2> kept;
  std::vector<Vec2> others;
  for (const Piece& piece : piecesWith(*all)) {
    const bool isKept = !now || facetAt(now->pattern, piece.place).has_value();
    const bool isClicked = pieceAt(piece.place) == clicked;
    if (isClicked != isKept) kept.push_back(piece.place);
    if (!isClicked) others.push_back(piece.place);
  }
  if (kept.empty()) kept = others;
  if (kept.empty()) return;
  pieces_ = std::move(kept);
  mode_ = Mode::Pieces;
  isChosen_ = true;
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
  const auto add = [&](Vec2 place, MarkRole role) {
    const std::optional<FacetId> facet = facetAt(state.pattern, place);
    if (!facet) return;
    marks.push_back(PointMark{role, Spot{*facet, place}});
    marks.push_back(TextMark{role, Spot{*facet, place}, {KIRI_TEXT("editor/tools", "stays"), {}}});
  };
  if (mode_ == Mode::Side && mark_)
    add(*mark_, isHeld_ ? MarkRole::ActiveHandle : MarkRole::Handle);
  if (mode_ == Mode::Pieces) {
    for (const Vec2 place : pieces_) add(place, MarkRole::Selected);
  }
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
