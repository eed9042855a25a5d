// The gallery as static HTML: no scripts, nothing from elsewhere, light and dark.
// SPDX-License-Identifier: MIT
#include "apps/cli/gallery_page.h"

#include <cctype>
#include <utility>

#include "apps/cli/gallery_style.h"
#include "apps/cli/html.h"

namespace kiri::cli {

namespace {

constexpr const char* kNotes = " class=\"notes\"";

std::string capitalised(std::string words) {
  if (!words.empty()) {
    words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  }
  return words;
}

/// Up to the full stop that ends the first sentence.
std::string firstSentence(const std::string& text) {
  for (std::size_t i = 0; i + 2 < text.size(); ++i) {
    const bool isUpper = std::isupper(static_cast<unsigned char>(text[i + 2])) != 0;
    if (text[i] == '.' && text[i + 1] == ' ' && isUpper) return text.substr(0, i + 1);
  }
  return text;
}

std::string sizeText(std::size_t bytes) {
  constexpr std::size_t kKilo = 1000;
  if (bytes < kKilo) return std::to_string(bytes) + " bytes";
  if (bytes < kKilo * kKilo) return std::to_string((bytes + kKilo / 2) / kKilo) + " kB";
  const std::size_t tenths = (bytes + kKilo * kKilo / 20) / (kKilo * kKilo / 10);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " MB";
}

std::string paragraph(const std::string& text) {
  return text.empty() ? "" : htmlTag("p", kNotes, htmlText(text)) + "\n";
}

std::string anchor(const std::string& target, const std::string& words,
                   const std::string& more = "") {
  return htmlTag("a", " href=\"" + target + "\"" + more, words);
}

/// Said before a picture is there, so that nothing jumps when it comes.
std::string sizeOf(const GalleryPicture& picture) {
  return " width=\"" + std::to_string(picture.width) + "\" height=\"" +
         std::to_string(picture.height) + "\"";
}

std::string image(const std::string& folder, const GalleryPicture& picture,
                  const std::string& alternative, const std::string& more = "") {
  return "<img src=\"" + htmlLink(folder + picture.name) + "\"" + more +
         htmlAttribute("alt", alternative) + sizeOf(picture) + " loading=\"lazy\" />";
}

std::string page(const std::string& title, const std::string& body) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\" />\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\" />\n" +
         htmlTag("title", "", htmlText(title)) + "\n" + htmlTag("style", "", kGalleryStyle) +
         "\n</head>\n<body>\n" + body +
         "<footer><p>Made with KiriSim " KIRI_VERSION ".</p></footer>\n</body>\n</html>\n";
}

std::string groupId(std::size_t group) { return "group-" + std::to_string(group + 1); }

/// The small picture, or the large one where the screen has more pixels.
std::string thumbnailOf(const GalleryEntryFiles& entry) {
  const GalleryPicture& small = entry.thumbnail;
  const GalleryPicture& large = entry.pictures[entry.emblem];
  const auto source = [&entry](const GalleryPicture& picture) {
    return htmlLink(entry.folder + "/" + picture.name) + " " + std::to_string(picture.width) + "w";
  };
  return image(entry.folder + "/", small, "",
               " srcset=\"" + source(small) + ", " + source(large) +
                   "\" sizes=\"(min-width: 36rem) 14rem, 45vw\"");
}

std::string indexItem(const GalleryEntryFiles& entry) {
  return htmlTag("li", "",
                 anchor(htmlLink(entry.folder) + "/index.html",
                        thumbnailOf(entry) + htmlText(entry.title)) +
                     paragraph(firstSentence(entry.notes))) +
         "\n";
}

std::string indexGroup(const GalleryPageGroup& group, std::size_t number) {
  const std::string id = groupId(number);
  std::string out;
  if (!group.title.empty()) {
    out += htmlTag("h2", " id=\"" + id + "-title\"", htmlText(group.title)) + "\n";
  }
  out += paragraph(group.notes);
  std::string items;
  for (const GalleryEntryFiles& entry : group.entries) items += indexItem(entry);
  out += htmlTag("ul", " class=\"plain models\"", "\n" + items) + "\n";
  const std::string name =
      group.title.empty() ? "" : htmlAttribute("aria-labelledby", id + "-title");
  return htmlTag("section", " id=\"" + id + "\"" + name, "\n" + out) + "\n";
}

/// Links to the groups; nothing where there is one group.
std::string indexNavigation(const GalleryPages& pages) {
  if (pages.groups.size() < 2) return "";
  std::string items;
  for (std::size_t g = 0; g < pages.groups.size(); ++g) {
    const std::string& title = pages.groups[g].title;
    const std::string words = title.empty() ? "More models" : htmlText(title);
    items += htmlTag("li", "", anchor("#" + groupId(g), words)) + "\n";
  }
  return htmlTag("nav", " aria-label=\"Groups\"",
                 htmlTag("ul", " class=\"plain bar\"", "\n" + items)) +
         "\n";
}

/// The models before and after one in the order of the gallery.
struct Neighbours {
  const GalleryEntryFiles* before = nullptr;
  const GalleryEntryFiles* after = nullptr;
};

Neighbours neighboursOf(const GalleryPages& pages, const GalleryEntryFiles& entry) {
  Neighbours found;
  const GalleryEntryFiles* last = nullptr;
  for (const GalleryPageGroup& group : pages.groups) {
    for (const GalleryEntryFiles& other : group.entries) {
      if (&other == &entry) found.before = last;
      if (last == &entry) found.after = &other;
      last = &other;
    }
  }
  return found;
}

std::string pageNavigation(const GalleryPages& pages, std::size_t group,
                           const GalleryEntryFiles& entry, const std::string& label) {
  const Neighbours neighbours = neighboursOf(pages, entry);
  const auto link = [](const GalleryEntryFiles& to, const std::string& words,
                       const std::string& how) {
    return htmlTag("li", "", anchor("../" + htmlLink(to.folder) + "/index.html", words, how)) +
           "\n";
  };
  std::string items =
      htmlTag("li", "", anchor("../index.html#" + groupId(group), "All models")) + "\n";
  if (neighbours.before != nullptr) {
    items += link(*neighbours.before, "← " + htmlText(neighbours.before->title), " rel=\"prev\"");
  }
  if (neighbours.after != nullptr) {
    items += link(*neighbours.after, htmlText(neighbours.after->title) + " →", " rel=\"next\"");
  }
  return htmlTag("nav", htmlAttribute("aria-label", label),
                 htmlTag("ul", " class=\"plain bar\"", "\n" + items)) +
         "\n";
}

std::string figure(const std::string& content, const std::string& caption,
                   const std::string& attributes = "") {
  return htmlTag("figure", attributes, content + htmlTag("figcaption", "", caption)) + "\n";
}

/// Nothing of it is loaded, and nothing moves, before somebody wants to see it.
std::string filmOf(const GalleryEntryFiles& entry) {
  const std::string words = entry.title + ", " + entry.film.label;
  const std::string attributes =
      " src=\"" + htmlLink(entry.film.name) + "\" poster=\"" +
      htmlLink(entry.pictures[entry.emblem].name) +
      "\" preload=\"none\" controls=\"\" loop=\"\" muted=\"\" playsinline=\"\"" +
      sizeOf(entry.film) + htmlAttribute("aria-label", words);
  const std::string film =
      htmlTag("video", attributes, anchor(htmlLink(entry.film.name), htmlText(words)));
  return figure(film, htmlText(capitalised(entry.film.label)), " class=\"film\"");
}

std::string picturesOf(const GalleryEntryFiles& entry) {
  std::string out;
  for (const GalleryPicture& picture : entry.pictures) {
    out += figure(image("", picture, entry.title + ", " + picture.label),
                  htmlText(capitalised(picture.label)));
  }
  if (!entry.film.name.empty()) out += filmOf(entry);
  return htmlTag("div", " class=\"pictures\"", "\n" + out) + "\n" + paragraph(entry.remark);
}

std::string stepsOf(const GalleryEntryFiles& entry) {
  if (entry.steps.empty()) return "";
  std::string items;
  for (const auto& [title, notes] : entry.steps) {
    items += htmlTag("li", "", htmlTag("p", "", htmlText(title)) + paragraph(notes)) + "\n";
  }
  const std::string sheet =
      image("", entry.stepSheet, "The steps of " + entry.title + " in pictures");
  return htmlTag("h2", "", "Steps") + "\n" + htmlTag("ol", " class=\"steps\"", "\n" + items) +
         "\n" +
         htmlTag("figure", " class=\"sheet\"", anchor(htmlLink(entry.stepSheet.name), sheet)) +
         "\n";
}

std::string tableOf(const std::string& caption, const std::vector<GalleryMeasure>& measures) {
  std::string rows = htmlTag("caption", "", caption);
  for (const GalleryMeasure& measure : measures) {
    rows += "\n" + htmlTag("tr", "",
                           htmlTag("th", " scope=\"row\"", htmlText(measure.words)) +
                               htmlTag("td", "", htmlText(measure.value)));
  }
  return htmlTag("table", "", rows) + "\n";
}

std::string measuresOf(const GalleryEntryFiles& entry) {
  if (entry.measures.empty()) return "";
  const std::string tables =
      tableOf("On the unfolded leaf", entry.measures) +
      tableOf("Lobes and sinuses: degrees from the axis, clockwise; length from the petiole",
              entry.margin);
  const std::string shown =
      figure(anchor(htmlLink(entry.measured.name),
                    image("", entry.measured, entry.title + ", " + entry.measured.label)),
             htmlText(capitalised(entry.measured.label)));
  return htmlTag("h2", "", "Measures") + "\n" +
         htmlTag("div", " class=\"leaf\"", "\n" + shown + tables) + "\n";
}

std::string downloadsOf(const GalleryEntryFiles& entry) {
  std::string items;
  for (const GalleryFile& file : entry.downloads) {
    items += htmlTag("li", "",
                     anchor(htmlLink(file.name), htmlText(capitalised(file.label))) + ", " +
                         sizeText(file.bytes)) +
             "\n";
  }
  return htmlTag("h2", "", "Files") + "\n" + htmlTag("ul", "", "\n" + items) + "\n";
}

}  // namespace

std::string galleryIndex(const GalleryPages& pages) {
  std::string sections;
  std::size_t models = 0;
  for (std::size_t g = 0; g < pages.groups.size(); ++g) {
    sections += indexGroup(pages.groups[g], g);
    models += pages.groups[g].entries.size();
  }
  const std::string lead = std::to_string(models) + (models == 1 ? " model" : " models") +
                           ", each with pictures, its steps, and files to take away.";
  return page(pages.title, htmlTag("h1", "", htmlText(pages.title)) + "\n" + paragraph(lead) +
                               indexNavigation(pages) + htmlTag("main", "", "\n" + sections) +
                               "\n");
}

std::string galleryPage(const GalleryPages& pages, std::size_t group, std::size_t number) {
  const GalleryEntryFiles& entry = pages.groups[group].entries[number];
  const std::string content = htmlTag("h1", "", htmlText(entry.title)) + "\n" +
                              paragraph(entry.notes) + picturesOf(entry) + stepsOf(entry) +
                              measuresOf(entry) + downloadsOf(entry);
  // Above for those who leaf through, below for those who have read to the end.
  return page(entry.title + " - " + pages.title,
              pageNavigation(pages, group, entry, "Models") + htmlTag("main", "", "\n" + content) +
                  "\n" + pageNavigation(pages, group, entry, "More models"));
}

}  // namespace kiri::cli
