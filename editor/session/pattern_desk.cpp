// Searching, counting and choosing the states of a pattern.
// SPDX-License-Identifier: MIT
#include "editor/session/pattern_desk.h"

#include <utility>
#include <variant>

namespace kiri {

namespace {

/// So many states are tried to find the number of one that was not reached by walking.
constexpr unsigned kMostTried = 200;

Phrase anotherState() {
  return {KIRI_TEXT("editor/session", "choice of another folded state"), {}};
}

/// The number of the component's state in `present`, where it is among the first.
std::optional<StateCount> numberOf(const LayerStates& states, std::size_t component,
                                   const LayerValues& present, const Progress& progress) {
  const StateComponent& one = states.component(component);
  if (!one.count || *one.count > kMostTried) return std::nullopt;
  LayerValues tried = present;
  for (StateCount number = 0; number < *one.count; ++number) {
    if (!states.choose(component, number, tried, progress)) return std::nullopt;
    if (tried == present) return number;
  }
  return std::nullopt;
}

}  // namespace

/// Sets the wanted components; `numbers` becomes what was set.
Status PatternDesk::chooseAll(const LayerStates& states, const std::map<std::size_t, Wanted>& all,
                              LayerValues& values, std::map<std::size_t, StateCount>& numbers,
                              const Progress& progress) {
  for (const auto& [component, wanted] : all) {
    numbers[component] = wanted.number;
    Status chosen = states.choose(component, wanted.number, values, progress);
    const bool isPastTheEnd = !chosen && chosen.error().code == ErrorCode::NotFound;
    if (isPastTheEnd && wanted.goesRound) {
      numbers[component] = 0;
      chosen = states.choose(component, 0, values, progress);
    }
    if (!chosen) return chosen;
  }
  return std::monostate{};
}

/// A state that was found, and the step that leads to it.
struct PatternDesk::Chosen {
  LayerValues values;
  std::map<std::size_t, StateCount> numbers;
  PatternStep step;
};

PatternDesk::PatternDesk(TaskRunner& runner, Host host)
    : host_(std::move(host)), searching_(runner), work_(runner) {}

const PatternStep& PatternDesk::step() const { return std::get<PatternStep>(step_.action); }

const LayerStates* PatternDesk::states() const {
  if (!analysis_ || !analysis_->folding) return nullptr;
  const LayerStates& states = analysis_->folding->states;
  return states.exist() ? &states : nullptr;
}

void PatternDesk::setReport(PatternReport report) {
  searching_.clear();
  work_.clear();
  analysis_.reset();
  written_.clear();
  wanted_.clear();
  entry_ = {};
  view_ = {};
  view_.report = std::move(report);
  host_.changed();
}

void PatternDesk::look(const Document& document) {
  const auto found = patternStepOf(document.model(), document.count());
  if (!found) {
    if (view_.step) setReport(std::move(view_.report));
    return;
  }
  const Step& now = document.model().steps[*found];
  const PatternStep& pattern = std::get<PatternStep>(now.action);
  const bool isSame =
      view_.step == found && sheet_ == document.model().sheet && haveSameCreases(step(), pattern);
  const bool areSameLayers = isSame && step().layers == pattern.layers &&
                             step().exceptions == pattern.exceptions &&
                             step().isFolded == pattern.isFolded;
  step_ = now;
  sheet_ = document.model().sheet;
  before_ = document.stateAfter(*found);
  after_ = document.stateAfter(*found + 1);
  if (!isSame) {
    setReport(std::move(view_.report));
    view_.step = found;
    search();
  } else if (!areSameLayers) {
    follow();
  }
}

void PatternDesk::search() {
  if (!view_.step || !before_ || view_.isSearching) return;
  view_.isSearching = true;
  const auto result = std::make_shared<std::optional<Result<PatternAnalysis>>>();
  searching_.ask({{KIRI_TEXT("editor/session", "Looking for folded states"), {}},
                  [result, before = before_, pattern = step()](const Progress& progress) {
                    Result<AssignedPattern> creases = creasesOf(*before, pattern);
                    if (creases) {
                      *result = analysisOf(std::move(*creases), progress);
                    } else {
                      *result = Result<PatternAnalysis>(creases.error());
                    }
                  },
                  [this, result] {
                    view_.isSearching = false;
                    const bool isThere = result->has_value() && (*result)->isOk();
                    if (isThere)
                      return analysed(std::make_shared<PatternAnalysis>(std::move(***result)));
                    if (result->has_value() && (*result)->error().code != ErrorCode::Cancelled) {
                      view_.verdict = PatternVerdict::FoldsNot;
                      view_.why = (*result)->error().message;
                    }
                    host_.changed();
                  }});
  host_.changed();
}

void PatternDesk::analysed(std::shared_ptr<PatternAnalysis> analysis) {
  analysis_ = std::move(analysis);
  view_.faults = analysis_->faults;
  view_.faultPlaces.clear();
  for (const VertexFault& fault : view_.faults)
    view_.faultPlaces.push_back(analysis_->creases.pattern[fault.vertex]);
  view_.verdict = PatternVerdict::FoldsFlat;
  if (analysis_->problem) {
    view_.verdict = PatternVerdict::FoldsNot;
    view_.why = analysis_->problem->message;
  } else if (!states()) {
    const OrderConflict& conflict = analysis_->folding->states.conflict();
    view_.verdict = PatternVerdict::NoState;
    view_.why = conflict.message;
    view_.conflictFacets = conflict.facets.size();
    entry_ = {PatternEntry::Kind::Conflict, 0};
  }
  numbers_.clear();
  known_.clear();
  if (const LayerStates* found = states()) {
    for (const std::vector<FacetId>& facets : analysis_->componentFacets) {
      known_.push_back({{partOf(known_.size(), found->first()), StateCount(0)}});
      view_.components.push_back({facets.size(), {}, {}});
    }
    follow();
    return count();
  }
  host_.changed();
}

void PatternDesk::follow() {
  if (!states()) return;
  // What was chosen last may not have arrived yet: then it is known better than the document.
  if (!written_.empty() && written_.front() == step().layers) {
    written_.pop_front();
    if (!written_.empty()) return;
  }
  written_.clear();
  std::optional<LayerValues> now;
  if (after_) now = valuesOf(*analysis_->folding, *after_);
  present_ = now ? *now : states()->first();
  numbers_.assign(known_.size(), std::nullopt);
  for (std::size_t i = 0; now && i < known_.size(); ++i) {
    const auto found = known_[i].find(partOf(i, present_));
    if (found != known_[i].end()) numbers_[i] = found->second;
  }
  showNumbers();
}

PatternDesk::Values PatternDesk::partOf(std::size_t component, const LayerValues& values) const {
  Values part;
  for (const std::uint32_t pair : states()->component(component).pairs)
    part.push_back(values[pair]);
  return part;
}

void PatternDesk::showNumbers() {
  for (std::size_t i = 0; i < numbers_.size(); ++i)
    view_.components[i].number = numbers_[i] ? StateCount(*numbers_[i] + 1).str() : std::string();
  host_.changed();
}

void PatternDesk::walk(std::size_t component, int by) {
  if (!states() || component >= known_.size()) return;
  const auto pending = wanted_.find(component);
  std::optional<StateCount> from = numbers_[component];
  if (pending != wanted_.end()) from = pending->second.number;
  const std::string& count = view_.components[component].count;
  StateCount to = from ? StateCount(*from + by) : StateCount(0);
  if (to < 0) to = count.empty() ? StateCount(0) : StateCount(StateCount(count) - 1);
  wanted_[component] = {to, true};
  ask({}, anotherState(), {KIRI_TEXT("editor/session", "This state cannot be shown"), {}});
}

void PatternDesk::choose(std::size_t component, const std::string& number) {
  const bool isNumber =
      !number.empty() && number.find_first_not_of("0123456789") == std::string::npos;
  if (!states() || component >= known_.size() || !isNumber) return;
  // Boost reads a leading zero as the sign of octal digits.
  const std::size_t first = number.find_first_not_of('0');
  if (first == std::string::npos) return;
  wanted_[component] = {StateCount(StateCount(number.substr(first)) - 1), false};
  ask({}, anotherState(), {KIRI_TEXT("editor/session", "This state cannot be shown"), {}});
}

void PatternDesk::bringOnTop(const LayerWish& wish) {
  if (!states()) {
    host_.say(Notice::Kind::Refused,
              {KIRI_TEXT("editor/session", "There are no folded states to choose from"), {}},
              view_.why);
    return;
  }
  const Result<std::vector<Literal>> wanted = wantedBy(*analysis_->folding, wish);
  if (!wanted) {
    host_.say(Notice::Kind::Refused,
              {KIRI_TEXT("editor/session", "It cannot lie on top there"), {}},
              wanted.error().message);
    return;
  }
  ask(
      [literals = *wanted](const LayerStates& states, LayerValues& values,
                           const Progress& progress) -> Status {
        Result<LayerValues> found = states.stateWith(literals, values, progress);
        if (!found) return found.error();
        values = std::move(*found);
        return std::monostate{};
      },
      {KIRI_TEXT("editor/session", "choice of the paper on top"), {}},
      {KIRI_TEXT("editor/session", "It cannot lie on top there"), {}});
}

void PatternDesk::ask(Find find, Phrase what, Phrase refusal) {
  const auto result = std::make_shared<std::optional<Result<Chosen>>>();
  const auto work = [result, find = std::move(find), analysis = analysis_, after = after_,
                     wanted = wanted_, values = present_,
                     pattern = step()](const Progress& progress) mutable {
    Chosen chosen{std::move(values), {}, {}};
    const FlatFolding& folding = *analysis->folding;
    Status found = chooseAll(folding.states, wanted, chosen.values, chosen.numbers, progress);
    if (found && find) {
      chosen.numbers.clear();  // the values become others
      found = find(folding.states, chosen.values, progress);
    }
    if (!found) {
      *result = Result<Chosen>(found.error());
      return;
    }
    chosen.step = withLayers(std::move(pattern), folding, chosen.values, after.get());
    *result = Result<Chosen>(std::move(chosen));
  };
  work_.ask({{KIRI_TEXT("editor/session", "Looking for the state"), {}},
             work,
             [this, result, what = std::move(what), refusal = std::move(refusal)] {
               wanted_.clear();
               if (result->has_value() && (*result)->isOk()) {
                 take(std::move(***result), what);
               } else if (result->has_value() && (*result)->error().code != ErrorCode::Cancelled) {
                 host_.say(Notice::Kind::Refused, refusal, (*result)->error().message);
               }
               goOnCounting();
             }});
}

void PatternDesk::take(Chosen chosen, const Phrase& what) {
  const bool isOther = chosen.values != present_ || !step().isFolded;
  present_ = std::move(chosen.values);
  for (std::size_t i = 0; i < known_.size(); ++i) {
    const Values part = partOf(i, present_);
    if (const auto set = chosen.numbers.find(i); set != chosen.numbers.end())
      known_[i][part] = set->second;
    const auto known = known_[i].find(part);
    numbers_[i] = known == known_[i].end() ? std::nullopt : std::optional(known->second);
  }
  showNumbers();
  if (!isOther) return;
  written_.push_back(chosen.step.layers);
  Step next = step_;
  next.action = std::move(chosen.step);
  host_.change(editStep(*view_.step, std::move(next)), what);
}

void PatternDesk::count() {
  isCountWanted_ = true;
  goOnCounting();
}

void PatternDesk::stopCounting() {
  isCountWanted_ = false;
  view_.isCounting = false;
  wanted_.clear();
  work_.clear();
  host_.changed();
}

void PatternDesk::goOnCounting() {
  if (isCountWanted_ && states() && !work_.isBusy()) askCount();
}

void PatternDesk::askCount() {
  view_.isCounting = true;
  view_.countProblem.clear();
  struct Counted {
    std::optional<Status> status;
    std::map<std::size_t, StateCount> numbers;
  };
  const auto result = std::make_shared<Counted>();
  const auto work = [result, analysis = analysis_, present = present_,
                     numbers = numbers_](const Progress& progress) {
    LayerStates& states = analysis->folding->states;
    result->status = states.count(progress);
    if (!*result->status) return;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (numbers[i]) continue;
      if (const auto number = numberOf(states, i, present, progress)) result->numbers[i] = *number;
    }
  };
  work_.ask({{KIRI_TEXT("editor/session", "Counting folded states"), {}}, work, [this, result] {
               isCountWanted_ = false;
               view_.isCounting = false;
               if (result->status) counted(*result->status, result->numbers);
               host_.changed();
             }});
  host_.changed();
}

void PatternDesk::counted(const Status& status, const std::map<std::size_t, StateCount>& found) {
  if (!status && status.error().code != ErrorCode::Cancelled)
    view_.countProblem = status.error().message;
  for (std::size_t i = 0; i < view_.components.size(); ++i) {
    const std::optional<StateCount>& count = states()->component(i).count;
    if (count) view_.components[i].count = count->str();
  }
  if (status) view_.total = states()->total().str();
  for (const auto& [component, number] : found) {
    known_[component][partOf(component, present_)] = number;
    numbers_[component] = number;
  }
  showNumbers();
}

void PatternDesk::point(const PatternEntry& entry) {
  entry_ = entry;
  host_.changed();
}

void PatternDesk::showFaults(bool isShown) {
  showsFaults_ = isShown;
  host_.changed();
}

std::vector<Vec2> PatternDesk::places(const PatternEntry& entry) const {
  return placesOf(view_, analysis_.get(), entry);
}

Marks PatternDesk::marks(const PaneMap& sheet) const {
  return patternMarks(view_, analysis_.get(), entry_, showsFaults_, sheet);
}

}  // namespace kiri
