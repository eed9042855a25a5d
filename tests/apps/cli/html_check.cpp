// Looks through pages of HTML for what browsers and readers stumble over.
// SPDX-License-Identifier: MIT
#include "tests/apps/cli/html_check.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <pugixml.hpp>
#include <set>

namespace kiri::cli {

namespace {

namespace fs = std::filesystem;

/// "a%20b" as the file is named.
std::string unescapedLink(const std::string& link) {
  std::string out;
  for (std::size_t i = 0; i < link.size(); ++i) {
    if (link[i] == '%' && i + 2 < link.size()) {
      out += static_cast<char>(std::stoi(link.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      out += link[i];
    }
  }
  return out;
}

class PageCheck {
 public:
  explicit PageCheck(fs::path path) : path_(std::move(path)) {}

  std::vector<std::string> run() {
    std::ifstream in(path_, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    if (text.rfind("<!DOCTYPE html>\n", 0) != 0) say("it does not begin with its type");
    const pugi::xml_parse_result read = page_.load_buffer(text.data(), text.size());
    if (!read) say(std::string("tags: ") + read.description());
    const pugi::xml_node html = page_.child("html");
    if (*html.attribute("lang").value() == 0) say("no language");
    if (*html.child("head").child("title").text().get() == 0) say("no title");
    if (html.select_nodes("head/meta[@name='viewport']").size() != 1) say("no view port");
    if (html.select_nodes("head/meta[@charset='utf-8']").size() != 1) say("no encoding");
    if (html.select_nodes("body/main").size() != 1) say("not one main part");
    checkIds();
    checkHeadings();
    for (const pugi::xpath_node& node : page_.select_nodes("//*")) checkElement(node.node());
    return mistakes_;
  }

 private:
  void say(const std::string& sentence) { mistakes_.push_back(path_.string() + ": " + sentence); }

  void checkIds() {
    for (const pugi::xpath_node& node : page_.select_nodes("//*[@id]")) {
      const std::string id = node.node().attribute("id").value();
      if (!ids_.insert(id).second) say("the id " + id + " twice");
    }
  }

  void checkHeadings() {
    int before = 0;
    int first = 0;
    for (const pugi::xpath_node& node : page_.select_nodes("//h1 | //h2 | //h3 | //h4")) {
      const int level = node.node().name()[1] - '0';
      if (level > before + 1) say("a heading skips a level");
      if (level == 1) ++first;
      if (*node.node().text().get() == 0) say("an empty heading");
      before = level;
    }
    if (first != 1) say("not one first heading");
  }

  void checkElement(const pugi::xml_node& node) {
    const std::string name = node.name();
    if (name == "script") say("a script");
    for (const char* link : {"href", "src", "poster"}) {
      if (node.attribute(link)) checkLink(node.attribute(link).value());
    }
    checkSources(node.attribute("srcset").value());
    if (node.attribute("aria-labelledby") &&
        ids_.count(node.attribute("aria-labelledby").value()) == 0) {
      say("a label that is not there");
    }
    if (name == "img" && !node.attribute("alt")) say("a picture without alt");
    if (name == "video") checkFilm(node);
    const bool isPicture = name == "img" || name == "video";
    if (isPicture &&
        (node.attribute("width").as_int() <= 0 || node.attribute("height").as_int() <= 0)) {
      say("a picture without its size");
    }
    if (name == "a") {
      const bool hasWords = !pugi::xpath_query("string(.)").evaluate_string(node).empty();
      const bool hasAlt = !node.select_nodes(".//img[@alt != '']").empty();
      if (!hasWords && !hasAlt) say("a link that says nothing");
    }
    for (const char* list : {"ul", "ol"}) {
      if (name != list) continue;
      for (const pugi::xml_node& item : node.children()) {
        if (std::string(item.name()) != "li") say("a list holds something else than items");
      }
    }
  }

  void checkFilm(const pugi::xml_node& node) {
    for (const char* needed : {"src", "poster", "controls", "aria-label"}) {
      if (!node.attribute(needed)) say(std::string("a film without ") + needed);
    }
    if (node.attribute("autoplay")) say("a film that nobody asked for");
    if (std::string(node.attribute("preload").value()) != "none") say("a film that loads unasked");
  }

  /// "a.png 240w, b.png 480w".
  void checkSources(const std::string& sources) {
    for (std::size_t at = 0; at < sources.size();) {
      const std::size_t end = std::min(sources.find(", ", at), sources.size());
      const std::string source = sources.substr(at, end - at);
      const std::size_t space = source.find(' ');
      if (space == std::string::npos || source.back() != 'w') say(source + " has no width");
      checkLink(source.substr(0, space));
      at = end + 2;
    }
  }

  void checkLink(const std::string& link) {
    if (link.find("//") != std::string::npos || link.find(':') != std::string::npos) {
      say(link + " lies elsewhere");
      return;
    }
    const std::size_t hash = link.find('#');
    const std::string file = unescapedLink(link.substr(0, hash));
    const fs::path target = file.empty() ? path_ : path_.parent_path() / file;
    if (!fs::is_regular_file(target)) say(link + " leads nowhere");
    if (hash == std::string::npos) return;
    std::ifstream in(target, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    if (text.find(" id=\"" + link.substr(hash + 1) + "\"") == std::string::npos) {
      say(link + " is no place of that page");
    }
  }

  fs::path path_;
  pugi::xml_document page_;
  std::set<std::string> ids_;
  std::vector<std::string> mistakes_;
};

}  // namespace

std::vector<fs::path> pagesBelow(const fs::path& folder) {
  std::vector<fs::path> pages;
  for (const fs::directory_entry& file : fs::recursive_directory_iterator(folder)) {
    if (file.path().extension() == ".html") pages.push_back(file.path());
  }
  std::sort(pages.begin(), pages.end());
  return pages;
}

std::vector<std::string> htmlMistakes(const fs::path& folder) {
  std::vector<std::string> mistakes;
  for (const fs::path& page : pagesBelow(folder)) {
    const std::vector<std::string> found = PageCheck(page).run();
    mistakes.insert(mistakes.end(), found.begin(), found.end());
  }
  return mistakes;
}

}  // namespace kiri::cli
