// How the parts of a session work together.
// SPDX-License-Identifier: MIT
#include "editor/session/session_parts.h"

#include <utility>

#include "core/layers/layer_count.h"
#include "core/paper/boxes.h"
#include "editor/session/fault_marks.h"
#include "editor/session/moved_facets.h"

namespace kiri {

namespace {

Document emptyDocument() {
  Result<Document> document = Document::create(Model{});
  KIRI_CHECK(document.isOk(), "the sheet of an untouched model is a sheet");
  return std::move(*document);
}

/// True when no corner of the paper is beside the pane.
bool isInSight(const FoldedState& state, const PaneMap& map) {
  for (std::size_t i = 0; i < state.pattern.facets.size(); ++i) {
    const FacetId facet(i);
    for (const EdgeUse use : state.pattern[facet].border) {
      const Vec2 p = map.toPixels(state, Spot{facet, state.pattern[startOf(state.pattern, use)]});
      if (p.x < 0 || p.y < 0 || p.x > map.size.x || p.y > map.size.y) return false;
    }
  }
  return true;
}

void tint(std::vector<FacetTint>& tints, const std::vector<FacetId>& facets, FacetTint with) {
  for (const FacetId facet : facets) tints[facet.index] = with;
}

}  // namespace

Session::Parts::Parts(TaskRunner& taskRunner, std::function<void(const Changed&)> told)
    : runner(taskRunner),
      listener(std::move(told)),
      document(emptyDocument()),
      previewer(taskRunner,
                [this] {
                  changed.marks = true;
                  if (commitsWhenKnown) {
                    commitsWhenKnown = false;
                    react({.isHandled = true, .wantsCommit = true});
                  }
                  refreshShown();
                  tell();
                }),
      slides(taskRunner,
             [this] {
               refreshShown();
               changed.marks = true;
               tell();
             }),
      queue(taskRunner, [this]() -> const History& { return document.history(); }),
      pattern(taskRunner, patternHost()),
      playerTask(taskRunner),
      factsTask(taskRunner) {
  documentChanged();
}

PatternDesk::Host Session::Parts::patternHost() {
  return {[this](Change change, const Phrase& what) { ask(std::move(change), what, false); },
          [this](Notice::Kind kind, Phrase text, std::string why) {
            say(kind, std::move(text), std::move(why));
            tell();
          },
          [this] {
            changed.pattern = true;
            changed.marks = true;
            tell();
          }};
}

Tool& Session::Parts::tool() {
  std::unique_ptr<Tool>& known = tools[toolId];
  if (!known) known = makeTool(toolId);
  return *known;
}

Scope Session::Parts::scope() const {
  SnapSettings now = snaps;
  now.isOn = snaps.isOn && !areSnapsSuspended;
  return {.state = document.state(),
          .number = static_cast<int>(document.cursor()) + 1,
          .model = navigation.camera.map(),
          .sheet = navigation.sheet.map(),
          .snaps = now,
          .selection = selection,
          .preview = previewer.current(),
          .isLeaf = document.model().opening == Sequence::Together};
}

std::optional<Proposal> Session::Parts::proposal() { return tool().proposal(scope()); }

void Session::Parts::refreshProposal() {
  changed.marks = true;
  const std::optional<Proposal> now = isPlayerOpen ? std::nullopt : proposal();
  if (now) {
    previewer.ask(document.state(), now->step, static_cast<int>(document.cursor()) + 1);
  } else {
    previewer.clear();
    commitsWhenKnown = false;
  }
  refreshShown();
}

void Session::Parts::react(const Reaction& reaction) {
  if (reaction.selection) {
    selection = *reaction.selection;
    changed.selection = true;
  }
  if (reaction.wish) pattern.bringOnTop(*reaction.wish);
  if (reaction.wantsCommit) {
    const std::optional<Proposal> now = proposal();
    if (!now || !now->isComplete) return refreshProposal();
    const Preview* preview = previewer.current();
    const bool isKnown = preview && !previewer.isBusy() && preview->step == now->step &&
                         preview->before == document.state();
    if (!isKnown) {
      // Enter was faster than the paper: what cannot be done must not lose what was drawn.
      commitsWhenKnown = true;
      return refreshProposal();
    }
    if (preview->error) {
      say(Notice::Kind::Refused, {KIRI_TEXT("editor/session", "This cannot be done"), {}},
          preview->error->message, preview->error->witness);
      return;
    }
    committing = preview->after;
    ask(addStep(now->step), {}, true);
    return;
  }
  refreshProposal();
}

void Session::Parts::ask(Change change, const Phrase& what, bool isCommit) {
  if (isCommit) tool().reset();
  changed.busy = true;
  queue.add(std::move(change), what, [this, what, isCommit](Result<History> next) {
    ended(std::move(next), what, isCommit);
  });
}

void Session::Parts::ended(Result<History> next, const Phrase& what, bool isCommit) {
  changed.busy = true;
  if (isCommit) committing.reset();
  if (!next) {
    if (next.error().code != ErrorCode::Cancelled) {
      say(Notice::Kind::Refused, {KIRI_TEXT("editor/session", "This cannot be done"), {}},
          next.error().message, next.error().witness);
    }
    refreshProposal();
    tell();
    return;
  }
  const std::size_t collisionsBefore = document.state()->collisions.size();
  document.become(std::move(*next), what);
  if (isCommit) useUpSelection();
  documentChanged();
  const std::vector<Collision>& all = document.state()->collisions;
  if (all.size() > collisionsBefore) {
    say(Notice::Kind::Warning, {KIRI_TEXT("editor/session", "Paper meets paper"), {}},
        all.back().message);
  } else {
    say(Notice::Kind::Done, {});
  }
  tell();
}

/// What said which layers fold, and which side, said it for this fold: the next one may be
/// elsewhere, and what is selected under other paper.
void Session::Parts::useUpSelection() {
  const std::size_t count = document.cursor();
  if (count == 0) return;
  const Step& made = document.model().steps[count - 1];
  if (!std::holds_alternative<FoldStep>(made.action)) return;
  const bool hadFacets = selection.drop(SelectedKind::Facet);
  const bool hadPoints = selection.drop(SelectedKind::Point);
  if (hadFacets || hadPoints) changed.selection = true;
}

void Session::Parts::say(Notice::Kind kind, Phrase text, std::string why, Witness where) {
  notice = {kind, std::move(text), std::move(why)};
  witness = std::move(where);
  changed.marks = true;
}

void Session::Parts::dropGesture() {
  tool().reset();
  commitsWhenKnown = false;
  previewer.clear();
}

void Session::Parts::documentChanged() {
  changed.document = true;
  previewer.clear();
  slides.end();
  isPlayerOpen = false;
  playerTask.clear();
  player.load(nullptr);
  film.reset();
  const FoldedState& state = *document.state();
  countFacts();
  keepInSight(state);
  pattern.look(document);
  refreshProposal();
}

void Session::Parts::countFacts() {
  const std::shared_ptr<const FoldedState> state = document.state();
  facts.facets = state->pattern.facets.size();
  facts.collisions = state->collisions.size();
  const auto layers = std::make_shared<std::uint32_t>(0);
  factsTask.ask({{},
                 [state, layers](const Progress&) { *layers = maxLayerCount(*state); },
                 [this, layers] {
                   facts.layers = *layers;
                   changed.busy = true;
                   tell();
                 }});
}

void Session::Parts::keepInSight(const FoldedState& state) {
  const auto hasGone = [&](const PaneMap& map) {
    return shown.base && isInSight(*shown.base, map) && !isInSight(state, map);
  };
  const bool hasModelGone = hasGone(navigation.camera.map());
  const bool hasSheetGone = hasGone(navigation.sheet.map());
  navigation.camera.setBall(sphereOf(state));
  if (hasModelGone) navigation.camera.fit(sphereOf(state));
  if (hasSheetGone) navigation.sheet.fit(paperBoxOf(state.pattern));
  changed.view = true;
}

std::shared_ptr<const FoldedState> Session::Parts::stateToShow() const {
  if (isPlayerOpen && film) return film;
  if (slides.isSliding() && slides.show() && slides.show()->state) return slides.show()->state;
  if (committing) return committing;
  if (const Preview* preview = previewer.current(); preview && preview->after) {
    return preview->after;
  }
  return document.state();
}

std::vector<FacetTint> Session::Parts::tintsToShow(const FoldedState& state) {
  std::vector<FacetTint> tints(state.pattern.facets.size(), FacetTint::None);
  if (isPlayerOpen) return tints;
  const Preview* preview = previewer.current();
  const bool isPreview = preview && preview->after && preview->after.get() == &state;
  if (isPreview && previewer.tints().size() == tints.size()) tints = previewer.tints();
  tint(tints, facetsHolding(state.pattern, selection.placesOf(SelectedKind::Facet)),
       FacetTint::Selected);
  if (&state == document.state().get()) {
    for (const TintedFacet& tinted : tool().tints(scope())) {
      if (tinted.facet.index < tints.size()) tints[tinted.facet.index] = tinted.tint;
    }
  }
  if (isPreview) tint(tints, facetsOf(preview->collisions, state), FacetTint::Colliding);
  if (slides.isSliding() && slides.show()) {
    tint(tints, facetsOf(slides.show()->collisions, state), FacetTint::Colliding);
  }
  return tints;
}

void Session::Parts::showFilm() {
  film = std::make_shared<const FoldedState>(player.state());
  refreshShown();
}

void Session::Parts::refreshShown() {
  std::shared_ptr<const FoldedState> state = stateToShow();
  const bool isOther = state != shown.state;
  if (isOther) ++shown.revision;
  std::vector<FacetTint> tints = tintsToShow(*state);
  changed.shown = changed.shown || isOther || tints != shown.tints;
  shown.tints = std::move(tints);
  shown.base = document.state();
  shown.isPreview = previewer.current() && previewer.current()->after == state;
  shown.state = std::move(state);
}

void Session::Parts::tell() {
  const Changed now = std::exchange(changed, {});
  if (listener) listener(now);
}

}  // namespace kiri
