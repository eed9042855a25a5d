// Scenes as SVG.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <utility>

#include "render/canvas/base64.h"
#include "render/canvas/number_text.h"
#include "render/canvas/page_check.h"
#include "render/canvas/png.h"
#include "render/canvas/write.h"

namespace kiri {
namespace {

std::string mm(double value) {
  constexpr int kDecimals = 6;  // a millionth of a millimetre
  return numberText(value, kDecimals);
}

std::string hex(Color color) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text = "#";
  for (const int c : {int{color.red}, int{color.green}, int{color.blue}}) {
    text += kDigits[c >> 4];
    text += kDigits[c & 15];
  }
  return text;
}

/// Text for element content and attribute values; characters that XML forbids are left out.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else if (static_cast<unsigned char>(c) >= ' ' || c == '\n' || c == '\t') {
      out += c;
    }
  }
  return out;
}

bool isOpaque(const Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    if (image.rgba[i] != 0xFF) return false;
  }
  return true;
}

class SvgWriter {
 public:
  explicit SvgWriter(const Scene& scene) : scene_(scene) {}

  std::string run() {
    std::string body;
    if (scene_.background) {
      body += "<rect id=\"background\" width=\"" + mm(scene_.width) + "\" height=\"" +
              mm(scene_.height) + "\" fill=\"" + hex(*scene_.background) + "\"/>\n";
    }
    for (const Group& group : scene_.groups) body += groupText(group);
    std::string out =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"";
    if (!images_.empty()) out += " xmlns:xlink=\"http://www.w3.org/1999/xlink\"";
    out +=
        " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" width=\"" +
        mm(scene_.width) + "mm\" height=\"" + mm(scene_.height) + "mm\" viewBox=\"0 0 " +
        mm(scene_.width) + " " + mm(scene_.height) + "\">\n";
    if (!scene_.title.empty()) out += "<title>" + escaped(scene_.title) + "</title>\n";
    if (!scene_.description.empty()) out += "<desc>" + escaped(scene_.description) + "</desc>\n";
    if (!defs_.empty()) out += "<defs>\n" + defs_ + "</defs>\n";
    return out + body + "</svg>\n";
  }

 private:
  std::string point(Vec2 p) const { return mm(p.x) + "," + mm(scene_.height - p.y); }

  std::string chainText(const std::vector<Arc>& chain, bool isClosed) const {
    if (chain.empty()) return "";
    std::string text = "M" + point(chain.front().start);
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const Arc& arc = chain[i];
      if (arc.isCurved) {
        text += "C" + point(arc.control1) + " " + point(arc.control2) + " " + point(arc.end);
      } else if (!isClosed || i + 1 < chain.size()) {
        text += "L" + point(arc.end);  // the last straight side is drawn by Z
      }
    }
    return isClosed ? text + "Z" : text;
  }

  static bool closes(const std::vector<Arc>& chain) {
    return chain.size() > 1 && chain.front().start == chain.back().end;
  }

  std::string groupText(const Group& group) {
    std::string out = "<g id=\"" + escaped(group.id) +
                      "\" inkscape:groupmode=\"layer\" inkscape:label=\"" +
                      escaped(group.label.empty() ? group.id : group.label) + "\"";
    if (!group.clip.empty()) {
      std::string path;
      for (const Loop& loop : group.clip) path += chainText(loop, true);
      const std::string id = "clip-" + group.id;
      defs_ += "<clipPath id=\"" + escaped(id) + "\"><path d=\"" + path + "\"/></clipPath>\n";
      out += " clip-path=\"url(#" + escaped(id) + ")\"";
    }
    out += ">\n";
    for (const Item& item : group.items) {
      out += std::visit([&](const auto& shape) { return shapeText(shape, namesText(item)); },
                        item.shape);
    }
    return out + "</g>\n";
  }

  static std::string namesText(const Item& item) {
    std::string out;
    if (!item.id.empty()) out += " id=\"" + escaped(item.id) + "\"";
    if (!item.kind.empty()) out += " class=\"" + escaped(item.kind) + "\"";
    for (const auto& [name, value] : item.data)
      out += " data-" + name + "=\"" + escaped(value) + "\"";
    return out;
  }

  std::string shapeText(const FillItem& item, const std::string& names) {
    std::string path;
    for (const Loop& loop : item.loops) path += chainText(loop, true);
    const auto element = [&](const std::string& fill, const std::string& attributes) {
      const std::string veil =
          item.fill.opacity < 1 ? " fill-opacity=\"" + mm(item.fill.opacity) + "\"" : "";
      return "<path" + attributes + " fill=\"" + fill + "\"" + veil + " d=\"" + path + "\"/>\n";
    };
    if (!item.fill.image) return element(hex(item.fill.color), names);
    std::string out;
    if (!isOpaqueImage(item.fill.image.get())) out = element(hex(item.fill.color), "");
    return out + element(textureReference(item.fill.image, item.fill.imageToScene), names);
  }

  std::string shapeText(const StrokeItem& item, const std::string& names) {
    std::string path;
    for (const std::vector<Arc>& chain : item.chains) path += chainText(chain, closes(chain));
    const Stroke& stroke = item.stroke;
    std::string out =
        "<path" + names + " fill=\"none\" stroke=\"" +
        (stroke.image ? textureReference(stroke.image, stroke.imageToScene) : hex(stroke.color)) +
        "\" stroke-width=\"" + mm(stroke.width) + "\"";
    if (stroke.cap == LineCap::Round) out += " stroke-linecap=\"round\"";
    out += " stroke-linejoin=\"round\"";
    if (!stroke.dashes.empty()) {
      out += " stroke-dasharray=\"";
      for (std::size_t i = 0; i < stroke.dashes.size(); ++i)
        out += (i > 0 ? " " : "") + mm(stroke.dashes[i]);
      out += "\"";
    }
    return out + " d=\"" + path + "\"/>\n";
  }

  std::string shapeText(const TextItem& item, const std::string& names) const {
    std::string out = "<text" + names + " x=\"" + mm(item.at.x) + "\" y=\"" +
                      mm(scene_.height - item.at.y) + "\" font-family=\"sans-serif\" font-size=\"" +
                      mm(item.height) + "\"";
    if (item.isBold) out += " font-weight=\"bold\"";
    if (item.anchor == TextAnchor::Middle) out += " text-anchor=\"middle\"";
    if (item.anchor == TextAnchor::End) out += " text-anchor=\"end\"";
    return out + " fill=\"" + hex(item.color) + "\">" + escaped(item.text) + "</text>\n";
  }

  bool isOpaqueImage(const Image* image) {
    const auto known = opaque_.find(image);
    if (known != opaque_.end()) return known->second;
    return opaque_[image] = isOpaque(*image);
  }

  /// A pattern that shows the image where it lies in the scene; the pixels stand in the file once.
  std::string textureReference(const std::shared_ptr<const Image>& image,
                               const Affine& imageToScene) {
    auto known = std::find(images_.begin(), images_.end(), image.get());
    const std::string id = "image-" + std::to_string(known - images_.begin() + 1);
    if (known == images_.end()) {
      images_.push_back(image.get());
      defs_ += "<image id=\"" + id + "\" width=\"" + std::to_string(image->width) + "\" height=\"" +
               std::to_string(image->height) +
               "\" preserveAspectRatio=\"none\" xlink:href=\"data:image/png;base64," +
               base64(encodePng(*image, 0).value()) + "\"/>\n";
    }
    // From pixels, y down, over the unit square, y up, to the page, y down.
    const Affine toUnit{1.0 / image->width, 0, 0, -1.0 / image->height, 0, 1};
    const Affine toPage = compose({1, 0, 0, -1, 0, scene_.height}, compose(imageToScene, toUnit));
    std::string matrix;
    for (const double v : {toPage.a, toPage.b, toPage.c, toPage.d, toPage.e, toPage.f}) {
      constexpr int kDecimals = 9;  // multiplied by thousands of pixels
      matrix += (matrix.empty() ? "" : " ") + numberText(v, kDecimals);
    }
    const std::string use = "width=\"" + std::to_string(image->width) + "\" height=\"" +
                            std::to_string(image->height) + "\" patternTransform=\"matrix(" +
                            matrix + ")\"><use xlink:href=\"#" + id + "\"/>";
    const auto [it, isNew] =
        textures_.try_emplace(use, "texture-" + std::to_string(textures_.size() + 1));
    if (isNew)
      defs_ += "<pattern id=\"" + it->second + "\" patternUnits=\"userSpaceOnUse\" " + use +
               "</pattern>\n";
    return "url(#" + it->second + ")";
  }

  const Scene& scene_;
  std::string defs_;
  std::vector<const Image*> images_;
  std::map<const Image*, bool> opaque_;  ///< looked up, never walked
  std::map<std::string, std::string> textures_;
};

}  // namespace

Result<std::string> writeSvg(const Scene& scene) {
  const Status size = checkPage(scene);
  if (!size) return size.error();
  return SvgWriter(scene).run();
}

}  // namespace kiri
