// The steps of a model side by side, as in thesis Figures 1.2 and 7.2.
// SPDX-License-Identifier: MIT
#include "render/scene/sheet_scene.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "render/scene/next_line.h"
#include "render/scene/page.h"
#include "render/scene/paper_items.h"
#include "render/visibility/visible_regions.h"

namespace kiri {
namespace {

constexpr double kTextHeight = 3.2;    // mm, titles
constexpr double kNumberHeight = 4.2;  // mm, numbers of panels
constexpr double kTitleHeight = 6;     // mm, heading of the page
constexpr double kLineSpacing = 1.3;
constexpr Color kInk{20, 20, 20};
constexpr double kLetterWidth = 0.55;  // of the height, on average

struct Panel {
  std::size_t state = 0;
  std::shared_ptr<const FoldedState> paper;
  VisibleRegions regions;
  Box box;
  NextLine line;
  std::string number;
  std::vector<std::string> caption;
};

/// How many bytes the next letter of UTF-8 text takes.
bool isLetterStart(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

std::size_t lettersIn(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), isLetterStart));
}

/// Breaks text at spaces into at most `mostLines` lines of about `width` mm; what is left over ends
/// in dots.
std::vector<std::string> wrapped(const std::string& text, double width, std::size_t mostLines) {
  const auto fits = static_cast<std::size_t>(std::max(4.0, width / (kTextHeight * kLetterWidth)));
  std::vector<std::string> lines;
  std::string word;
  const auto place = [&] {
    if (word.empty()) return;
    if (lines.empty() || lettersIn(lines.back()) + 1 + lettersIn(word) > fits) {
      lines.push_back(word);
    } else {
      lines.back() += " " + word;
    }
    word.clear();
  };
  for (const char c : text) {
    if (c == ' ' || c == '\n' || c == '\t') {
      place();
    } else {
      word += c;
    }
  }
  place();
  if (lines.size() > mostLines) {
    lines.resize(mostLines);
    lines.back() += " ...";
  }
  return lines;
}

/// Measures of the page, mm.
struct Layout {
  std::size_t columns = 1;
  double panel = 60;  ///< width of a column
  double scale = 1;   ///< mm on the page for a mm of paper
};

class SheetBuilder {
 public:
  SheetBuilder(const Model& model, const Replay& replay, const Appearance& appearance,
               const SheetSceneOptions& options)
      : model_(model), replay_(replay), appearance_(appearance), options_(options) {}

  Result<Scene> run() {
    const Status collected = collect();
    if (!collected) return collected.error();
    const Status fits = chooseLayout();
    if (!fits) return fits.error();
    return draw();
  }

 private:
  Status collect() {
    std::vector<std::size_t> states = options_.states;
    const std::size_t stepCount = model_.steps.size();
    if (states.empty()) {
      for (std::size_t i = 0; i <= stepCount; ++i) states.push_back(i);
    }
    for (const std::size_t s : states) {
      if (s > stepCount) {
        return Error{ErrorCode::BadValue,
                     "there is no state after step " + std::to_string(s) + ": the model has " +
                         std::to_string(stepCount) + " steps",
                     {}};
      }
      Result<std::shared_ptr<const FoldedState>> state = replay_.after(s);
      if (!state) return state.error();
      panels_.push_back(panelOf(s, *state));
    }
    return std::monostate{};
  }

  Panel panelOf(std::size_t s, std::shared_ptr<const FoldedState> state) const {
    Panel panel;
    panel.state = s;
    panel.paper = std::move(state);
    panel.regions = visibleRegions(*panel.paper, options_.view);
    panel.box = boundsOf(panel.regions);
    const bool isNext = options_.caption == PanelCaption::NextStep;
    panel.number = std::to_string(isNext ? s + 1 : s);
    if (isNext && s < model_.steps.size())
      panel.line = nextLine(*panel.paper, model_.steps[s], options_.view);
    return panel;
  }

  std::string titleOf(const Panel& panel) const {
    const std::size_t step =
        options_.caption == PanelCaption::NextStep ? panel.state + 1 : panel.state;
    if (step == 0 || step > model_.steps.size()) return "";
    const Step& about = model_.steps[step - 1];
    return about.title.empty() ? wordsFor(about) : about.title;
  }

  Status chooseLayout() {
    constexpr double kUsualPanel = 42;  // mm: what a column is given when nobody says
    constexpr double kLargestPanel = 60;
    constexpr double kLeastPanel = 5;
    const double room = options_.pageWidth - options_.gap;
    const double wanted = options_.panel.value_or(kUsualPanel);
    const double fitting =
        options_.columns > 0 ? options_.columns : std::floor(room / (wanted + options_.gap));
    const double count = std::clamp(fitting, 1.0, static_cast<double>(panels_.size()));
    layout_.columns = static_cast<std::size_t>(count);
    layout_.panel = options_.panel.value_or(std::min(kLargestPanel, room / count - options_.gap));
    if (!(layout_.panel >= kLeastPanel) || !(options_.gap >= 0) ||
        layout_.panel + 2 * options_.gap > options_.pageWidth * 1.001) {
      return Error{ErrorCode::BadValue,
                   "the page leaves no room for the panels: choose a wider page, fewer columns or "
                   "smaller panels",
                   {}};
    }
    double largest = 0;
    for (const Panel& panel : panels_) {
      const Vec2 size = panel.box.high - panel.box.low;
      largest = std::max({largest, size.x, size.y});
    }
    layout_.scale = largest > 0 ? layout_.panel / largest : 1;
    if (!options_.showTitles) return std::monostate{};
    constexpr std::size_t kMostLines = 3;
    for (Panel& panel : panels_) panel.caption = wrapped(titleOf(panel), layout_.panel, kMostLines);
    return std::monostate{};
  }

  /// Height of the pictures and of the captions of the row that starts at panel `first`.
  Vec2 rowHeights(std::size_t first) const {
    Vec2 heights;  // x: pictures, y: captions
    for (std::size_t i = first; i < std::min(first + layout_.columns, panels_.size()); ++i) {
      const Box& box = panels_[i].box;
      heights.x = std::max(heights.x, (box.high.y - box.low.y) * layout_.scale);
      const double lines = static_cast<double>(panels_[i].caption.size());
      heights.y = std::max(heights.y, lines * kTextHeight * kLineSpacing);
    }
    if (options_.showNumbers) heights.y += kNumberHeight * kLineSpacing;
    return heights;
  }

  Scene draw() const {
    Scene scene;
    scene.title = options_.title.empty() ? model_.title : options_.title;
    scene.width = options_.pageWidth;
    scene.background = Color{255, 255, 255};
    const double heading = scene.title.empty() ? 0 : kTitleHeight * kLineSpacing;
    scene.height = 2 * options_.gap + heading;
    for (std::size_t first = 0; first < panels_.size(); first += layout_.columns) {
      const Vec2 heights = rowHeights(first);
      scene.height += heights.x + heights.y + (first > 0 ? options_.gap : 0);
    }
    if (heading > 0) scene.groups.push_back(headingGroup(scene));
    double top = scene.height - options_.gap - heading;
    const double used =
        static_cast<double>(layout_.columns) * (layout_.panel + options_.gap) - options_.gap;
    const double left = (scene.width - used) / 2;
    for (std::size_t first = 0; first < panels_.size(); first += layout_.columns) {
      const Vec2 heights = rowHeights(first);
      for (std::size_t i = first; i < std::min(first + layout_.columns, panels_.size()); ++i) {
        const double x = left + static_cast<double>(i - first) * (layout_.panel + options_.gap);
        drawPanel(panels_[i], {{x, top - heights.x}, {x + layout_.panel, top}}, scene);
      }
      top -= heights.x + heights.y + options_.gap;
    }
    return scene;
  }

  Group headingGroup(const Scene& scene) const {
    const Vec2 at{scene.width / 2, scene.height - options_.gap - kTitleHeight * 0.8};
    return {"title",
            "title",
            {{TextItem{at, scene.title, kTitleHeight, TextAnchor::Middle, true, kInk},
              "title",
              "",
              {}}},
            {}};
  }

  void drawPanel(const Panel& panel, const Box& place, Scene& scene) const {
    const std::string name = "panel-" + std::to_string(panel.state) + "-";
    const Vec2 size = (panel.box.high - panel.box.low) * layout_.scale;
    // In the middle of its column, standing on the line of the row.
    const Vec2 corner{(place.low.x + place.high.x - size.x) / 2,
                      place.low.y + (place.high.y - place.low.y - size.y) / 2};
    const Affine toScene = placed(panel.box, layout_.scale, corner);
    for (Group& group :
         paperGroups(*panel.paper, panel.regions, options_.view, toScene, appearance_, name)) {
      scene.groups.push_back(std::move(group));
    }
    const Box around{corner - Vec2{kOverhang, kOverhang},
                     corner + size + Vec2{kOverhang, kOverhang}};
    Group line = lineGroup(panel.line, toScene, around);
    line.id = name + "line";
    line.label = "next line";
    if (!line.items.empty()) scene.groups.push_back(std::move(line));
    Group text = textGroup(panel, (place.low.x + place.high.x) / 2, place.low.y);
    text.id = name + "text";
    text.label = "text";
    if (!text.items.empty()) scene.groups.push_back(std::move(text));
  }

  /// The next line; a straight one is cut off a little outside the model.
  Group lineGroup(const NextLine& line, const Affine& toScene, const Box& around) const {
    StrokeItem item;
    item.stroke = strokeFor(line.kind, appearance_, appearance_.drawnWidth);
    for (const std::vector<Arc>& chain : line.chains) {
      std::vector<Arc> shown;
      for (const Arc& arc : chain) {
        const Arc moved = transformed(toScene, arc);
        if (arc.isCurved) {
          shown.push_back(moved);
        } else if (const std::optional<Arc> inside = clippedTo(around, moved)) {
          shown.push_back(*inside);
        }
      }
      if (!shown.empty()) item.chains.push_back(std::move(shown));
    }
    Group group;
    if (item.chains.empty()) return group;
    StrokeItem halo = item;  // keeps the line clear of paper of its own colour
    halo.stroke.color = {255, 255, 255};
    halo.stroke.width *= 2.2;
    halo.stroke.dashes.clear();
    group.items.push_back({std::move(halo), "halo", "", {}});
    group.items.push_back({std::move(item), nameOf(line.kind), "", {}});
    return group;
  }

  Group textGroup(const Panel& panel, double middle, double bottom) const {
    Group group;
    double y = bottom;
    if (options_.showNumbers) {
      y -= kNumberHeight * kLineSpacing;
      group.items.push_back(
          {TextItem{{middle, y}, panel.number, kNumberHeight, TextAnchor::Middle, true, kInk},
           "number",
           "",
           {}});
    }
    for (const std::string& line : panel.caption) {
      y -= kTextHeight * kLineSpacing;
      group.items.push_back(
          {TextItem{{middle, y}, line, kTextHeight, TextAnchor::Middle, false, kInk},
           "caption",
           "",
           {}});
    }
    return group;
  }

  static constexpr double kOverhang = 2.5;  // mm that a drawn line may stand out beyond the model

  const Model& model_;
  const Replay& replay_;
  const Appearance& appearance_;
  const SheetSceneOptions& options_;
  std::vector<Panel> panels_;
  Layout layout_;
};

}  // namespace

Result<Scene> sheetScene(const Model& model, const Replay& replay, const Appearance& appearance,
                         const SheetSceneOptions& options) {
  return SheetBuilder(model, replay, appearance, options).run();
}

}  // namespace kiri
