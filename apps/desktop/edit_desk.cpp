// What the actions of editing, folding and playing do to the session.
// SPDX-License-Identifier: MIT
#include "apps/desktop/edit_desk.h"

#include <algorithm>
#include <array>
#include <utility>

#include "apps/desktop/look/convert.h"

namespace kiri::desktop {
namespace {

constexpr std::array<std::pair<const char*, ToolId>, 11> kTools{
    {{"fold", ToolId::Fold},
     {"line", ToolId::Line},
     {"angle", ToolId::Angle},
     {"add-edge", ToolId::AddEdge},
     {"tear", ToolId::Tear},
     {"mend", ToolId::Mend},
     {"straight-cut", ToolId::StraightCut},
     {"curve-cut", ToolId::CurveCut},
     {"select", ToolId::Select},
     {"measure", ToolId::Measure},
     {"top-layer", ToolId::TopLayer}}};

Step stepOf(Action action) {
  Step step;
  step.action = std::move(action);
  return step;
}

}  // namespace

EditDesk::EditDesk(SessionHub& hub, Actions& actions, PlayerBar& player, QObject* parent)
    : QObject(parent), hub_(hub), actions_(actions) {
  connectTools();
  connectHistory();
  connectSteps();
  connectPlayer(player);
  connect(&hub, &SessionHub::changed, this, &EditDesk::refresh);
  connect(&hub, &SessionHub::toolChanged, this, &EditDesk::refreshTool);
  refresh();
}

void EditDesk::on(const QString& id, std::function<void()> what) {
  connect(&actions_[id], &QAction::triggered, this, [this, what = std::move(what)] {
    what();
    // Keys may follow each other faster than the window is idle: what is possible now is known now.
    hub_.flush();
  });
}

void EditDesk::press(Key key, char character) {
  KeyEvent event;
  event.key = key;
  event.character = character;
  hub_.session().key(event);
}

void EditDesk::connectTools() {
  for (const auto& [id, tool] : kTools) {
    on(id, [this, chosen = tool] { hub_.session().setTool(chosen); });
  }
  on("valley", [this] { press(Key::Character, 'v'); });
  on("mountain", [this] { press(Key::Character, 'm'); });
  on("commit", [this] { press(Key::Enter); });
  on("cancel", [this] { press(Key::Escape); });
  on("delete", [this] { press(Key::Delete); });
}

void EditDesk::connectHistory() {
  on("undo", [this] { hub_.session().undo(); });
  on("redo", [this] { hub_.session().redo(); });
  on("previous-step", [this] { jump(-1); });
  on("next-step", [this] { jump(1); });
  on("remove-step", [this] {
    const std::size_t cursor = hub_.session().document().cursor();
    if (cursor > 0) removeStep(static_cast<int>(cursor) - 1);
  });
}

void EditDesk::jump(int by) {
  const Document& document = hub_.session().document();
  const auto steps = static_cast<int>(document.model().steps.size());
  const int to = std::clamp(static_cast<int>(document.cursor()) + by, 0, steps);
  hub_.session().jumpTo(static_cast<std::size_t>(to));
}

void EditDesk::removeStep(int index) {
  hub_.session().change(
      kiri::removeStep(static_cast<std::size_t>(index)),
      {QT_TRANSLATE_NOOP("editor/session", "removal of step %1"), {std::to_string(index + 1)}});
}

void EditDesk::connectSteps() {
  const auto step = [this](const QString& id, Action action, const char* what) {
    on(id, [this, action = std::move(action), what] {
      hub_.session().change(addStep(stepOf(action)), Phrase{what, {}});
    });
  };
  step("turn-over", TurnOverStep{TurnAxis::Vertical},
       QT_TRANSLATE_NOOP("editor/session", "turning over"));
  step("turn-over-down", TurnOverStep{TurnAxis::Horizontal},
       QT_TRANSLATE_NOOP("editor/session", "turning over"));
  step("rotate-left", RotateStep{90, {}}, QT_TRANSLATE_NOOP("editor/session", "rotation"));
  step("rotate-right", RotateStep{-90, {}}, QT_TRANSLATE_NOOP("editor/session", "rotation"));
  step("mend-all", MendStep{}, QT_TRANSLATE_NOOP("editor/session", "mending"));
  const auto sequence = [this] {
    return hub_.session().isLeaf() ? Sequence::Together : Sequence::InOrder;
  };
  on("unfold-all", [this, sequence] {
    hub_.session().change(addStep(stepOf(UnfoldStep{{}, sequence()})),
                          {QT_TRANSLATE_NOOP("editor/session", "unfolding"), {}});
  });
  on("refold-all", [this, sequence] {
    hub_.session().change(addStep(stepOf(RefoldStep{{}, sequence()})),
                          {QT_TRANSLATE_NOOP("editor/session", "folding again"), {}});
  });
}

void EditDesk::connectPlayer(PlayerBar& player) {
  on("play", [&player] { player.togglePlay(); });
  on("stop", [&player] { player.stop(); });
  on("skip-back", [&player] { player.skip(-1); });
  on("skip-forward", [&player] { player.skip(1); });
  on("slower", [&player] { player.changeSpeed(-1); });
  on("faster", [&player] { player.changeSpeed(1); });
  QAction& loop = actions_["loop"];
  connect(&loop, &QAction::toggled, &player, &PlayerBar::setLoops);
  connect(&player, &PlayerBar::loopsChanged, &loop, &QAction::setChecked);
}

void EditDesk::refresh() {
  const Session& session = hub_.session();
  const Document& document = session.document();
  const std::size_t steps = document.model().steps.size();
  QAction& undo = actions_["undo"];
  QAction& redo = actions_["redo"];
  undo.setEnabled(document.canUndo());
  redo.setEnabled(document.canRedo());
  const auto named = [](const Phrase& phrase, const QString& otherwise) {
    return phrase.isEmpty() ? otherwise : said(phrase);
  };
  undo.setText(named(document.undoPhrase(), tr("&Undo")));
  redo.setText(named(document.redoPhrase(), tr("&Redo")));
  actions_["commit"].setEnabled(session.canCommit());
  actions_["previous-step"].setEnabled(document.cursor() > 0);
  actions_["next-step"].setEnabled(document.cursor() < steps);
  actions_["remove-step"].setEnabled(document.cursor() > 0);
  for (const char* id : {"play", "skip-back", "skip-forward"}) actions_[id].setEnabled(steps > 0);
  actions_["stop"].setEnabled(session.isPlayerOpen());
  refreshTool();
}

void EditDesk::refreshTool() {
  const ToolId now = hub_.session().tool();
  for (const auto& [id, tool] : kTools) {
    if (tool != now || actions_[id].isChecked()) continue;
    actions_[id].setChecked(true);
  }
  for (const auto& [id, tool] : kTools) {
    if (tool == now) emit toolChosen(actions_[id]);
  }
}

}  // namespace kiri::desktop
