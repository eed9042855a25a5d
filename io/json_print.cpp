// JSON text that people can read: short things on one line, points packed into lines.
// SPDX-License-Identifier: MIT
#include <string>

#include "io/json_tree.h"

namespace kiri {

namespace {

using Kind = JsonValue::Kind;

void printCompact(const JsonValue& value, std::string& out) {
  switch (value.kind) {
    case Kind::Null:
      out += "null";
      break;
    case Kind::Bool:
      out += value.boolean ? "true" : "false";
      break;
    case Kind::Number:
      out += value.text;
      break;
    case Kind::String:
      out += jsonString(value.text);
      break;
    case Kind::Array:
      out += '[';
      for (std::size_t i = 0; i < value.items.size(); ++i) {
        if (i > 0) out += ", ";
        printCompact(value.items[i], out);
      }
      out += ']';
      break;
    case Kind::Object:
      out += '{';
      for (std::size_t i = 0; i < value.members.size(); ++i) {
        if (i > 0) out += ", ";
        out += jsonString(value.members[i].name) + ": ";
        printCompact(value.members[i].value, out);
      }
      out += '}';
      break;
  }
}

bool isLeaf(const JsonValue& value) { return !value.is(Kind::Array) && !value.is(Kind::Object); }

/// A number, null, a single letter, or a list of plain values: what is packed many to a line.
bool isPacked(const JsonValue& value) {
  if (value.is(Kind::Number) || value.is(Kind::Null)) return true;
  if (value.is(Kind::String)) return value.text.size() == 1;
  if (!value.is(Kind::Array) || value.items.empty()) return false;
  for (const JsonValue& item : value.items) {
    if (!isLeaf(item)) return false;
  }
  return true;
}

class Layout {
 public:
  Layout(std::size_t alwaysBroken, std::size_t width)
      : alwaysBroken_(alwaysBroken), width_(width) {}

  /// `used` columns of the line are taken already.
  void print(const JsonValue& value, std::size_t depth, std::size_t used, std::string& out) const {
    const bool isEmpty = value.items.empty() && value.members.empty();
    if (isLeaf(value) || isEmpty || (depth >= alwaysBroken_ && fits(value, used))) {
      printCompact(value, out);
    } else if (value.is(Kind::Array)) {
      printItems(value, depth, out);
    } else {
      printMembers(value, depth, out);
    }
  }

 private:
  bool fits(const JsonValue& value, std::size_t used) const {
    std::string line;
    printCompact(value, line);
    return used + line.size() < width_;
  }

  static std::string indent(std::size_t depth) { return "\n" + std::string(2 * depth, ' '); }

  void printMembers(const JsonValue& value, std::size_t depth, std::string& out) const {
    out += '{';
    for (std::size_t i = 0; i < value.members.size(); ++i) {
      const std::string name = jsonString(value.members[i].name) + ": ";
      out += (i > 0 ? "," : "") + indent(depth + 1) + name;
      print(value.members[i].value, depth + 1, 2 * (depth + 1) + name.size(), out);
    }
    out += indent(depth) + '}';
  }

  void printItems(const JsonValue& value, std::size_t depth, std::string& out) const {
    out += '[';
    std::size_t used = width_;
    for (std::size_t i = 0; i < value.items.size(); ++i) {
      const JsonValue& item = value.items[i];
      std::string text;
      print(item, depth + 1, 2 * (depth + 1), text);
      if (i > 0) out += ',';
      if (isPacked(item) && used + text.size() + 2 < width_) {
        out += ' ';
        used += text.size() + 2;
      } else {
        out += indent(depth + 1);
        used = isPacked(item) ? 2 * (depth + 1) + text.size() : width_;
      }
      out += text;
    }
    out += indent(depth) + ']';
  }

  std::size_t alwaysBroken_;
  std::size_t width_;
};

}  // namespace

std::string compactText(const JsonValue& value) {
  std::string out;
  printCompact(value, out);
  return out;
}

std::string layOut(const JsonValue& value, std::size_t alwaysBroken, std::size_t width) {
  std::string out;
  Layout(alwaysBroken, width).print(value, 0, 0, out);
  out += '\n';
  return out;
}

}  // namespace kiri
