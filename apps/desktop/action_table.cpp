// The table of all actions (guide: docs of the window; keys that people of this field know).
// SPDX-License-Identifier: MIT
#include "apps/desktop/actions.h"

namespace kiri::desktop {
namespace {

/// Marks a text for the translators; Actions translates it.
constexpr const char* say(const char* text) { return text; }
#define KIRI_ACTION(text) say(QT_TRANSLATE_NOOP("kiri::desktop::Actions", text))

constexpr bool kCheckable = true;

std::vector<ActionSpec> fileActions() {
  return {
      {"new", KIRI_ACTION("Ne&w..."), "new", "Ctrl+N", KIRI_ACTION("Take a new sheet of paper")},
      {"open", KIRI_ACTION("&Open..."), "open", "Ctrl+O", KIRI_ACTION("Open a model")},
      {"start-page", KIRI_ACTION("S&tart page"), "", "",
       KIRI_ACTION("New sheets, recent files and examples")},
      {"save", KIRI_ACTION("&Save"), "save", "Ctrl+S", ""},
      {"save-as", KIRI_ACTION("Save &as..."), "save-as", "Ctrl+Shift+S", ""},
      {"export", KIRI_ACTION("&Export..."), "export", "Ctrl+E",
       KIRI_ACTION("Pictures, crease patterns, meshes")},
      {"film", KIRI_ACTION("&Film..."), "film", "",
       KIRI_ACTION("The whole process as a film or an animated picture")},
      {"print", KIRI_ACTION("&Print..."), "print", "Ctrl+P",
       KIRI_ACTION("The crease pattern or the model, in true size")},
      {"appearance", KIRI_ACTION("Paper and &colours..."), "texture", "",
       KIRI_ACTION("Colours and textures of both sides of the paper")},
      {"properties", KIRI_ACTION("Title and &notes..."), "info", "", ""},
      {"quit", KIRI_ACTION("&Quit"), "", "Ctrl+Q", ""},
  };
}

std::vector<ActionSpec> editActions() {
  return {
      {"undo", KIRI_ACTION("&Undo"), "undo", "Ctrl+Z", ""},
      {"redo", KIRI_ACTION("&Redo"), "redo", "Ctrl+Y; Ctrl+Shift+Z", ""},
      {"commit", KIRI_ACTION("&Do it"), "commit", "Return; Enter",
       KIRI_ACTION("Make the step that is shown"), false, KeyScope::Panes},
      {"cancel", KIRI_ACTION("&Cancel"), "cancel", "Esc",
       KIRI_ACTION("Drop what is half done, then the selection"), false, KeyScope::Panes},
      {"paste", KIRI_ACTION("P&aste a pattern"), "", "Ctrl+V",
       KIRI_ACTION("A new model from the crease pattern on the clipboard")},
      {"delete", KIRI_ACTION("D&elete"), "delete", "Del", KIRI_ACTION("Take away the chosen point"),
       false, KeyScope::Panes},
      {"remove-step", KIRI_ACTION("Remo&ve the step"), "", "Ctrl+Del",
       KIRI_ACTION("Take the shown step out of the history and replay what follows")},
      {"previous-step", KIRI_ACTION("&Previous step"), "", "Alt+Left",
       KIRI_ACTION("Show the model one step earlier")},
      {"next-step", KIRI_ACTION("Ne&xt step"), "", "Alt+Right",
       KIRI_ACTION("Show the model one step later")},
      {"snap", KIRI_ACTION("&Snap"), "snap", "N",
       KIRI_ACTION("Points catch corners, edges and angles"), kCheckable},
      {"preferences", KIRI_ACTION("Pre&ferences..."), "preferences", "Ctrl+,", ""},
      {"shortcuts", KIRI_ACTION("&Keyboard shortcuts..."), "keyboard", "", ""},
  };
}

std::vector<ActionSpec> foldActions() {
  return {
      {"fold", KIRI_ACTION("&Fold"), "fold", "F",
       KIRI_ACTION("Drag paper, or draw a line across it"), kCheckable},
      {"line", KIRI_ACTION("Fold &line"), "line", "L",
       KIRI_ACTION("Draw or construct the line of a fold"), kCheckable},
      {"angle", KIRI_ACTION("Fold an&gle"), "angle", "W",
       KIRI_ACTION("Open and close a crease that is there"), kCheckable},
      {"add-edge", KIRI_ACTION("&Add edge"), "add-edge", "A",
       KIRI_ACTION("Crease the paper without folding it"), kCheckable},
      {"tear", KIRI_ACTION("&Tear"), "tear", "T", KIRI_ACTION("Tear along edges from the border"),
       kCheckable},
      {"mend", KIRI_ACTION("M&end"), "mend", "E", KIRI_ACTION("Join torn edges again"), kCheckable},
      {"straight-cut", KIRI_ACTION("Straight &cut"), "straight-cut", "C",
       KIRI_ACTION("Cut along a straight line"), kCheckable},
      {"curve-cut", KIRI_ACTION("Curve c&ut"), "curve-cut", "B",
       KIRI_ACTION("Cut along a smooth curve"), kCheckable},
      {"select", KIRI_ACTION("&Select"), "select", "S",
       KIRI_ACTION("Pick facets, points, vertices and lines"), kCheckable},
      {"measure", KIRI_ACTION("Measure"), "measure", "R",
       KIRI_ACTION("Lengths and angles on the paper"), kCheckable},
      {"top-layer", KIRI_ACTION("On to&p"), "top-layer", "O",
       KIRI_ACTION("Choose what lies on top, among the folded states of a crease pattern"),
       kCheckable},
      {"next-state", KIRI_ACTION("Ne&xt folded state"), "", "PgDown",
       KIRI_ACTION("The next state of the chosen component of the crease pattern")},
      {"previous-state", KIRI_ACTION("P&revious folded state"), "", "PgUp",
       KIRI_ACTION("The previous state of the chosen component of the crease pattern")},
      {"valley", KIRI_ACTION("&Valley"), "valley", "V", KIRI_ACTION("The fold comes towards you")},
      {"mountain", KIRI_ACTION("&Mountain"), "mountain", "M",
       KIRI_ACTION("The fold goes away from you")},
      {"turn-over", KIRI_ACTION("Turn &over"), "turn-over", "X",
       KIRI_ACTION("Turn the paper over about a vertical line; a step of the model")},
      {"turn-over-down", KIRI_ACTION("Turn over top to &bottom"), "", "Shift+X",
       KIRI_ACTION("Turn the paper over about a horizontal line; a step of the model")},
      {"rotate-left", KIRI_ACTION("Rotate the paper to the left"), "", "Ctrl+Left",
       KIRI_ACTION("Turn the paper in its plane by 90 degrees; a step of the model")},
      {"rotate-right", KIRI_ACTION("Rotate the paper to the right"), "", "Ctrl+Right",
       KIRI_ACTION("Turn the paper in its plane by 90 degrees; a step of the model")},
      {"unfold-all", KIRI_ACTION("U&nfold all"), "unfold", "Ctrl+U",
       KIRI_ACTION("Open all folds; a step of the model")},
      {"refold-all", KIRI_ACTION("Refol&d all"), "refold", "Ctrl+Shift+U",
       KIRI_ACTION("Fold again all that was unfolded; a step of the model")},
      {"mend-all", KIRI_ACTION("Mend everyt&hing"), "", "",
       KIRI_ACTION("Join all torn edges whose sides lie together; a step of the model")},
  };
}

std::vector<ActionSpec> viewActions() {
  return {
      {"fit", KIRI_ACTION("&Fit"), "fit", "0", KIRI_ACTION("Show all of the model and the sheet")},
      {"view-front", KIRI_ACTION("Fro&nt"), "view-front", "1", KIRI_ACTION("Look at the front")},
      {"view-back", KIRI_ACTION("&Back"), "view-back", "2", KIRI_ACTION("Look at the back")},
      {"view-angled", KIRI_ACTION("&Angled"), "view-angled", "4",
       KIRI_ACTION("Look from one side and above")},
      {"perspective", KIRI_ACTION("&Perspective"), "", "P",
       KIRI_ACTION("What is nearer seems larger"), kCheckable},
      {"zoom-in", KIRI_ACTION("Zoom &in"), "", "+; =; Ctrl++; Ctrl+=", ""},
      {"zoom-out", KIRI_ACTION("&Zoom out"), "", "-; Ctrl+-", ""},
      {"sheet-only", KIRI_ACTION("Sheet onl&y"), "sheet", "3",
       KIRI_ACTION("Only the flat sheet; again: both panes"), kCheckable},
      {"show-model", KIRI_ACTION("&Model pane"), "", "", "", kCheckable},
      {"show-sheet", KIRI_ACTION("&Sheet pane"), "sheet-pane", "F9",
       KIRI_ACTION("Show the flat sheet beside the model"), kCheckable},
      {"sheet-back", KIRI_ACTION("Back of the s&heet"), "", "",
       KIRI_ACTION("The flat sheet from behind"), kCheckable},
      {"creases", KIRI_ACTION("&Creases"), "creases", "Shift+C",
       KIRI_ACTION("Show creases that lie flat"), kCheckable},
      {"edges", KIRI_ACTION("&Edges"), "edges", "Shift+E", KIRI_ACTION("Show folded edges"),
       kCheckable},
      {"borders", KIRI_ACTION("Bor&ders"), "borders", "Shift+B",
       KIRI_ACTION("Show the rim of the paper"), kCheckable},
      {"grid", KIRI_ACTION("&Grid"), "grid", "G", KIRI_ACTION("Show a grid on the paper"),
       kCheckable},
      {"grid-finer", KIRI_ACTION("Finer g&rid"), "", "Ctrl+G", ""},
      {"grid-coarser", KIRI_ACTION("Coarser grid"), "", "Ctrl+Shift+G", ""},
      {"shading", KIRI_ACTION("Soft ligh&t"), "", "",
       KIRI_ACTION("Facets are darker the more they are turned away"), kCheckable},
      {"step-notes", KIRI_ACTION("Step n&otes"), "info", "",
       KIRI_ACTION("What is done in the step that is shown, below the panes"), kCheckable},
      {"full-screen", KIRI_ACTION("F&ull screen"), "", "F11", "", kCheckable},
  };
}

std::vector<ActionSpec> playActions() {
  return {
      {"play", KIRI_ACTION("&Play"), "play", "Space",
       KIRI_ACTION("Show the whole process in motion, or hold it")},
      {"stop", KIRI_ACTION("&Stop"), "cancel", "Shift+Space",
       KIRI_ACTION("Leave the film and go on working")},
      {"skip-back", KIRI_ACTION("Step &back"), "skip-back", "Shift+Left",
       KIRI_ACTION("To the start of the step before")},
      {"skip-forward", KIRI_ACTION("Step &forward"), "skip-forward", "Shift+Right",
       KIRI_ACTION("To the start of the next step")},
      {"slower", KIRI_ACTION("Slo&wer"), "", "[", ""},
      {"faster", KIRI_ACTION("F&aster"), "", "]", ""},
      {"loop", KIRI_ACTION("&Loop"), "loop", "", KIRI_ACTION("Begin again at the end"), kCheckable},
  };
}

std::vector<ActionSpec> helpActions() {
  return {
      {"help", KIRI_ACTION("&Help"), "help", "F1", ""},
      {"tour", KIRI_ACTION("Fold your first &leaf"), "tour", "",
       KIRI_ACTION("Five steps, each waits for your hand")},
      {"about", KIRI_ACTION("&About KiriSim"), "info", "", ""},
  };
}

#undef KIRI_ACTION

}  // namespace

const std::vector<ActionSpec>& actionTable() {
  static const std::vector<ActionSpec> table = [] {
    std::vector<ActionSpec> all;
    for (const std::vector<ActionSpec>& part : {fileActions(), editActions(), foldActions(),
                                                viewActions(), playActions(), helpActions()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }();
  return table;
}

QStringList toolActionIds() {
  return {"fold",         "line",      "angle",  "add-edge", "tear",     "mend",
          "straight-cut", "curve-cut", "select", "measure",  "top-layer"};
}

}  // namespace kiri::desktop
