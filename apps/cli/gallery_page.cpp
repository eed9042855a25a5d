// The gallery as static HTML.
// SPDX-License-Identifier: MIT
#include "apps/cli/gallery_page.h"

namespace kiri::cli {

namespace {

constexpr const char* kStyle =
    "<style>\n"
    "body { font: 16px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 72rem; "
    "padding: 0 1rem; color: #222; background: #fff }\n"
    "h1 { font-weight: 600 } a { color: #2a6f2a }\n"
    ".models, .pictures { display: grid; gap: 1.5rem; "
    "grid-template-columns: repeat(auto-fill, minmax(13rem, 1fr)) }\n"
    "figure { margin: 0 } img { width: 100%; border: 1px solid #ddd; border-radius: 6px }\n"
    "figcaption { margin-top: .3rem } .notes { color: #555; font-size: .9em }\n"
    "</style>\n";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

/// A file's name in a link: what is no letter, digit or mark of file names is written as %XX.
std::string linked(const std::string& name) {
  constexpr const char* kDigits = "0123456789ABCDEF";
  std::string out;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool isPlain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                         (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.' || c == '/';
    if (isPlain) {
      out += c;
    } else {
      out += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
    }
  }
  return out;
}

std::string head(const std::string& title) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         escaped(title) + "</title>\n" + kStyle + "</head>\n<body>\n<h1>" + escaped(title) +
         "</h1>\n";
}

std::string figure(const std::string& image, const std::string& alternative,
                   const std::string& caption) {
  return "<figure><img src=\"" + linked(image) + "\" alt=\"" + escaped(alternative) +
         "\" loading=\"lazy\"><figcaption>" + caption + "</figcaption></figure>\n";
}

}  // namespace

std::string galleryIndex(const std::vector<GalleryEntryFiles>& entries) {
  std::string out = head("KiriSim gallery") + "<div class=\"models\">\n";
  for (const GalleryEntryFiles& entry : entries) {
    const std::string link = linked(entry.folder) + "/index.html";
    const std::string caption = "<a href=\"" + link + "\">" + escaped(entry.title) +
                                "</a><div class=\"notes\">" + escaped(entry.notes) + "</div>";
    out += figure(entry.folder + "/" + entry.pictures.front().name, entry.title, caption);
  }
  return out + "</div>\n</body>\n</html>\n";
}

std::string galleryPage(const GalleryEntryFiles& entry) {
  std::string out = head(entry.title) + "<p class=\"notes\">" + escaped(entry.notes) +
                    "</p>\n<div class=\"pictures\">\n";
  for (const GalleryFile& picture : entry.pictures) {
    out += figure(picture.name, entry.title + ", " + picture.label, escaped(picture.label));
  }
  out += "</div>\n<h2>Steps</h2>\n<ol>\n";
  for (const auto& [title, notes] : entry.steps) {
    out += "<li>" + escaped(title);
    if (!notes.empty()) out += "<div class=\"notes\">" + escaped(notes) + "</div>";
    out += "</li>\n";
  }
  out += "</ol>\n<h2>Files</h2>\n<ul>\n";
  for (const GalleryFile& file : entry.downloads) {
    out += "<li><a href=\"" + linked(file.name) + "\">" + escaped(file.label) + "</a></li>\n";
  }
  return out + "</ul>\n<p><a href=\"../index.html\">All models</a></p>\n</body>\n</html>\n";
}

}  // namespace kiri::cli
