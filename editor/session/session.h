// One open model with everything that belongs to working on it; what a window shows and drives.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/base/events.h"
#include "editor/base/field.h"
#include "editor/base/task.h"
#include "editor/document/document.h"
#include "editor/motion/fold_sliders.h"
#include "editor/motion/player.h"
#include "editor/session/notice.h"
#include "editor/session/pattern_desk.h"
#include "editor/session/shown.h"
#include "editor/tools/tool.h"
#include "editor/view/camera.h"

namespace kiri {

/// What of the session has changed since the listener was last called.
struct Changed {
  bool document = false;  ///< model, cursor, path, or what is unsaved
  bool shown = false;     ///< paper or tints
  bool marks = false;     ///< what is drawn over it, fields, hint, cursor
  bool view = false;      ///< a camera
  bool tool = false;      ///< another tool
  bool busy = false;      ///< long work began or ended
  bool selection = false;
  bool pattern = false;  ///< what is known of the crease pattern
};

/// The size of what lies there, for the status bar.
struct Facts {
  std::size_t facets = 0;
  std::size_t layers = 0;      ///< the most that lie on each other
  std::size_t collisions = 0;  ///< that the steps so far have met
};

/// Routes events to the tool, the camera, the previews; commits steps; tells one listener what has
/// changed. All work on paper goes through the task runner. Not copied.
class Session {
 public:
  Session(TaskRunner& runner, std::function<void(const Changed&)> listener);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // The document.
  const Document& document() const;
  /// Replaces what is open. `report`: of the import, when it was a pattern of another program.
  void open(Document document, PatternReport report = {});
  void change(Change change, const Phrase& what);  ///< computed beside the window, in order
  void undo();
  void redo();
  void jumpTo(std::size_t steps);
  void noteSaved(const std::string& path);
  bool isBusy() const;  ///< a change is being computed
  void cancelWork();

  // Panes.
  void resize(Pane pane, Vec2 pixels);
  void pointer(const PointerEvent& event);
  void wheel(const WheelEvent& event);
  bool key(const KeyEvent& event);  ///< false: not for us
  void pinch(Pane pane, Vec2 at, double factor, Vec2 pan, double rollDegrees);  ///< two fingers
  Camera& camera();  ///< call viewChanged() after
  SheetCamera& sheetCamera();
  void viewChanged();
  void fitAll();

  // Tools.
  ToolId tool() const;
  void setTool(ToolId tool);
  std::vector<Field> fields() const;
  void setField(const std::string& id, const FieldValue& value);
  bool canCommit() const;
  void commit();
  void cancel();  ///< Esc: drops what is half done, then the selection
  SnapSettings& snaps();
  Phrase hint() const;
  CursorShape cursor() const;
  const Selection& selection() const;
  void setSelection(Selection selection);
  const Notice& notice() const;
  const Facts& facts() const;

  // What to draw.
  Shown shown() const;
  Marks marks() const;
  /// Drawn over all else until it is another: the hand of a guided tour.
  void setGuide(Marks guide);

  // The crease pattern of the model.
  PatternDesk& pattern();
  /// Marks what the entry is about and moves the sheet so that it is seen.
  void lookAt(const PatternEntry& entry);

  // Sliders.
  std::vector<FoldSlider> sliders() const;
  void beginSlide(FoldLineId line);
  void slide(double amount);
  void endSlide(bool keep);
  const std::optional<SlideShow>& slideShow() const;
  void beginSlideAll();
  void slideAll(double openness);  ///< 0: folded, 1: unfolded
  /// Where the slider of all stands, also when nobody drags it.
  double openness() const;
  void endSlideAll(bool keep);
  /// Why all cannot move as asked; none while that is not known or untrue.
  const std::optional<Error>& slideProblem() const;
  bool isLeaf() const;  ///< the model opens all together; otherwise in order
  void setLeaf(bool isLeaf);

  // The film.
  Player& player();  ///< call playerMoved() after seeking or skipping
  void playerMoved();
  void openPlayer();  ///< computes the time line beside the window, then shows it
  void closePlayer();
  bool isPlayerOpen() const;
  void advance(double seconds);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace kiri
