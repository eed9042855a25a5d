// What a session is made of; seen by the sources of Session only.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "editor/session/change_queue.h"
#include "editor/session/navigation.h"
#include "editor/session/pattern_desk.h"
#include "editor/session/previewer.h"
#include "editor/session/session.h"
#include "editor/session/slide_desk.h"

namespace kiri {

struct Session::Parts {
  Parts(TaskRunner& taskRunner, std::function<void(const Changed&)> told);

  TaskRunner& runner;
  std::function<void(const Changed&)> listener;
  Changed changed;

  Document document;
  Navigation navigation;
  ToolId toolId = ToolId::Fold;
  std::map<ToolId, std::unique_ptr<Tool>> tools;  ///< they keep what was set in their fields
  Selection selection;
  SnapSettings snaps;
  bool areSnapsSuspended = false;
  Notice notice;
  Witness witness;  ///< of the notice
  Facts facts;

  Previewer previewer;
  SlideDesk slides;
  ChangeQueue queue;
  PatternDesk pattern;
  bool commitsWhenKnown = false;                  ///< Enter came before the preview
  std::shared_ptr<const FoldedState> committing;  ///< shown until the change has ended

  Player player;
  bool isPlayerOpen = false;
  std::shared_ptr<const FoldedState> film;  ///< the picture of the film that is shown
  LatestTask playerTask;
  LatestTask factsTask;  ///< counting the layers of a deep stack takes longer than a frame

  Shown shown;
  Marks guide;

  PatternDesk::Host patternHost();
  Tool& tool();
  Scope scope() const;
  std::optional<Proposal> proposal();

  /// After the tool has changed: its proposal is previewed.
  void refreshProposal();
  void react(const Reaction& reaction);
  /// Finds what is to be drawn now, and notes whether it is another picture.
  void refreshShown();
  /// The film's picture of this moment.
  void showFilm();
  /// Everything that hangs on the document.
  void documentChanged();
  void countFacts();
  /// The eyes step back when paper that was wholly in sight no longer is.
  void keepInSight(const FoldedState& state);
  void ask(Change change, const Phrase& what, bool isCommit);
  void useUpSelection();
  void ended(Result<History> next, const Phrase& what, bool isCommit);
  void say(Notice::Kind kind, Phrase text, std::string why = {}, Witness where = {});
  void dropGesture();
  /// Tells the listener what has changed since the last time.
  void tell();

 private:
  std::shared_ptr<const FoldedState> stateToShow() const;
  std::vector<FacetTint> tintsToShow(const FoldedState& state);
};

}  // namespace kiri
