// The folded states of the crease pattern in a model: looked for, counted and walked beside the
// window.
// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/base/task.h"
#include "editor/document/document.h"
#include "editor/session/notice.h"
#include "editor/session/pattern_view.h"

namespace kiri {

/// Follows the document: when its pattern is another, faults and states are looked for; when only
/// its layers are, their numbers are. What is chosen becomes one change of the pattern's step. Only
/// one task at a time touches the search.
class PatternDesk {
 public:
  struct Host {
    std::function<void(Change, Phrase)> change;
    std::function<void(Notice::Kind, Phrase, std::string)> say;
    std::function<void()> changed;  ///< view or marks are others
  };
  PatternDesk(TaskRunner& runner, Host host);

  /// The document may have changed.
  void look(const Document& document);
  /// Another model was opened; `report` belongs to it.
  void setReport(PatternReport report);
  const PatternView& view() const { return view_; }

  /// Looks for faults and states once more, where that was stopped.
  void search();
  void count();
  void stopCounting();
  /// The component's next (1) or previous (-1) state; after the last comes the first.
  void walk(std::size_t component, int by);
  /// State `number` of a component, decimal, from 1.
  void choose(std::size_t component, const std::string& number);
  /// The state nearest to the present one that has it so.
  void bringOnTop(const LayerWish& wish);

  /// What the marks point at.
  void point(const PatternEntry& entry);
  const PatternEntry& pointed() const { return entry_; }
  void showFaults(bool isShown);
  std::vector<Vec2> places(const PatternEntry& entry) const;
  Marks marks(const PaneMap& sheet) const;

 private:
  using Values = std::vector<bool>;
  struct Chosen;
  /// A component's state that was asked for and is not found yet.
  struct Wanted {
    StateCount number;
    bool goesRound = false;  ///< after the last comes the first
  };
  /// Finds other values.
  using Find = std::function<Status(const LayerStates&, LayerValues&, const Progress&)>;

  static Status chooseAll(const LayerStates& states, const std::map<std::size_t, Wanted>& all,
                          LayerValues& values, std::map<std::size_t, StateCount>& numbers,
                          const Progress& progress);

  const PatternStep& step() const;
  void begin(const Document& document);
  void analysed(std::shared_ptr<PatternAnalysis> analysis);
  void follow();
  void ask(Find find, Phrase what, Phrase refusal);
  void take(Chosen chosen, const Phrase& what);
  void askCount();
  void counted(const Status& status, const std::map<std::size_t, StateCount>& found);
  void goOnCounting();
  Values partOf(std::size_t component, const LayerValues& values) const;
  void showNumbers();
  const LayerStates* states() const;

  Host host_;
  PatternView view_;
  PatternEntry entry_;
  bool showsFaults_ = true;

  Step step_;
  SheetSpec sheet_;
  std::shared_ptr<const FoldedState> before_;
  std::shared_ptr<const FoldedState> after_;
  std::shared_ptr<PatternAnalysis> analysis_;
  LayerValues present_;
  std::map<std::size_t, Wanted> wanted_;
  std::vector<std::optional<StateCount>> numbers_;
  std::vector<std::map<Values, StateCount>> known_;  ///< states that were shown, by component
  std::deque<std::vector<Vec2>> written_;            ///< layers on their way into the document
  bool isCountWanted_ = false;
  LatestTask searching_;
  LatestTask work_;  ///< on the states that were found
};

}  // namespace kiri
