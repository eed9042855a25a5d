// A glTF 2.0 document under construction: accessors into one buffer, and the GLB file around them.
// SPDX-License-Identifier: MIT
#include "io/gltf_document.h"

#include <algorithm>
#include <utility>

#include "io/bytes.h"

namespace kiri {

namespace {

// The numbers that glTF has taken over from OpenGL.
constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;
constexpr int kVertexBuffer = 34962;
constexpr int kIndexBuffer = 34963;
constexpr int kLinear = 9729;
constexpr int kLinearMipmapLinear = 9987;
constexpr int kClampToEdge = 33071;

/// What the file will hold: bounds must be those of the floats.
double asSingle(double value) {
  return value == 0 ? 0 : static_cast<double>(static_cast<float>(value));
}

void align(std::string& bytes, char filling) {
  while (bytes.size() % 4 != 0) bytes += filling;
}

/// One of the two parts of a GLB file.
void appendChunk(std::string& file, std::uint32_t kind, const std::string& content) {
  appendUint32(file, static_cast<std::uint32_t>(content.size()));
  appendUint32(file, kind);
  file += content;
}

/// The buffer and its views, one for each kind of bytes and each image.
struct Buffer {
  std::string bytes;
  JsonValue views = JsonValue::array();

  /// Appends a view; the pointer to it is good until the next one.
  JsonValue* add(const std::string& content) {
    JsonValue& view = views.items.emplace_back(JsonValue::object());
    view.add("buffer", jsonNumber(0));
    view.add("byteOffset", JsonValue::ofNumber(static_cast<double>(bytes.size())));
    view.add("byteLength", JsonValue::ofNumber(static_cast<double>(content.size())));
    bytes += content;
    align(bytes, '\0');
    return &view;
  }
  int last() const { return static_cast<int>(views.items.size()) - 1; }
};

void describe(JsonValue& view, GltfBytes kind) {
  constexpr int kVectorSize = 12;
  constexpr int kPairSize = 8;
  switch (kind) {
    case GltfBytes::Vectors:
      view.add("byteStride", jsonNumber(kVectorSize));
      view.add("target", jsonNumber(kVertexBuffer));
      break;
    case GltfBytes::Pairs:
      view.add("byteStride", jsonNumber(kPairSize));
      view.add("target", jsonNumber(kVertexBuffer));
      break;
    case GltfBytes::Shorts:
    case GltfBytes::Words:
      view.add("target", jsonNumber(kIndexBuffer));
      break;
    case GltfBytes::Keys:
      break;
  }
}

/// `images` with their textures and the one way in which they are sampled, as members of `out`.
void addImages(JsonValue& out, Buffer& buffer, const std::vector<std::string>& images) {
  if (images.empty()) return;
  JsonValue textures = JsonValue::array();
  JsonValue list = JsonValue::array();
  for (const std::string& png : images) {
    JsonValue& texture = textures.items.emplace_back(JsonValue::object());
    texture.add("sampler", jsonNumber(0));
    texture.add("source", jsonNumber(static_cast<int>(list.items.size())));
    buffer.add(png);
    JsonValue& image = list.items.emplace_back(JsonValue::object());
    image.add("bufferView", jsonNumber(buffer.last()));
    image.add("mimeType", JsonValue::ofText("image/png"));
  }
  out.add("textures", std::move(textures));
  out.add("images", std::move(list));
  JsonValue& samplers = out.add("samplers", JsonValue::array());
  JsonValue& sampler = samplers.items.emplace_back(JsonValue::object());
  sampler.add("magFilter", jsonNumber(kLinear));
  sampler.add("minFilter", jsonNumber(kLinearMipmapLinear));
  sampler.add("wrapS", jsonNumber(kClampToEdge));
  sampler.add("wrapT", jsonNumber(kClampToEdge));
}

/// A GLB file: a header, then the document, then the buffer.
std::string glbOf(std::string json, const std::string& buffer) {
  constexpr std::uint32_t kMagic = 0x46546C67;  // "glTF"
  constexpr std::uint32_t kJson = 0x4E4F534A;
  constexpr std::uint32_t kBin = 0x004E4942;
  constexpr std::size_t kHeaders = 12 + 8 + 8;
  align(json, ' ');
  std::string file;
  appendUint32(file, kMagic);
  appendUint32(file, 2);
  appendUint32(file, static_cast<std::uint32_t>(kHeaders + json.size() + buffer.size()));
  appendChunk(file, kJson, json);
  appendChunk(file, kBin, buffer);
  return file;
}

}  // namespace

JsonValue jsonNumber(int value) { return JsonValue::ofNumber(value); }

JsonValue jsonNumbers(const std::vector<double>& values) {
  JsonValue out = JsonValue::array();
  for (const double value : values) out.items.push_back(JsonValue::ofNumber(value));
  return out;
}

int GltfDocument::append(JsonValue& list, JsonValue item) {
  list.items.push_back(std::move(item));
  return static_cast<int>(list.items.size()) - 1;
}

int GltfDocument::addAccessor(GltfBytes kind, std::size_t count, const char* type,
                              int componentType) {
  accessors_.push_back({kind, bytesOf(kind).size(), count, type, componentType, {}, {}});
  return static_cast<int>(accessors_.size()) - 1;
}

int GltfDocument::addVectors(const std::vector<Vec3>& values, bool hasBounds) {
  const int accessor = addAccessor(GltfBytes::Vectors, values.size(), "VEC3", kFloat);
  for (const Vec3 v : values) {
    for (const double c : {v.x, v.y, v.z}) appendFloat(bytesOf(GltfBytes::Vectors), c);
  }
  if (hasBounds) {
    std::vector<double> low = {asSingle(values[0].x), asSingle(values[0].y), asSingle(values[0].z)};
    std::vector<double> high = low;
    for (const Vec3 v : values) {
      const double c[3] = {asSingle(v.x), asSingle(v.y), asSingle(v.z)};
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], c[k]);
        high[k] = std::max(high[k], c[k]);
      }
    }
    accessors_.back().low = std::move(low);
    accessors_.back().high = std::move(high);
  }
  return accessor;
}

int GltfDocument::addPairs(const std::vector<Vec2>& values) {
  const int accessor = addAccessor(GltfBytes::Pairs, values.size(), "VEC2", kFloat);
  for (const Vec2 v : values) {
    appendFloat(bytesOf(GltfBytes::Pairs), v.x);
    appendFloat(bytesOf(GltfBytes::Pairs), v.y);
  }
  return accessor;
}

int GltfDocument::addIndices(const std::vector<std::uint32_t>& values, std::size_t vertices) {
  constexpr std::size_t kMostForShorts = 65535;  // the largest value is not for indices
  if (vertices <= kMostForShorts) {
    const int accessor = addAccessor(GltfBytes::Shorts, values.size(), "SCALAR", kUnsignedShort);
    for (const std::uint32_t v : values) {
      appendUint16(bytesOf(GltfBytes::Shorts), static_cast<std::uint16_t>(v));
    }
    return accessor;
  }
  const int accessor = addAccessor(GltfBytes::Words, values.size(), "SCALAR", kUnsignedInt);
  for (const std::uint32_t v : values) appendUint32(bytesOf(GltfBytes::Words), v);
  return accessor;
}

int GltfDocument::addTimes(const std::vector<double>& seconds) {
  const int accessor = addAccessor(GltfBytes::Keys, seconds.size(), "SCALAR", kFloat);
  for (const double s : seconds) appendFloat(bytesOf(GltfBytes::Keys), s);
  accessors_.back().low = {asSingle(seconds.front())};
  accessors_.back().high = {asSingle(seconds.back())};
  return accessor;
}

int GltfDocument::addKeys(const std::vector<Vec3>& values) {
  const int accessor = addAccessor(GltfBytes::Keys, values.size(), "VEC3", kFloat);
  for (const Vec3 v : values) {
    for (const double c : {v.x, v.y, v.z}) appendFloat(bytesOf(GltfBytes::Keys), c);
  }
  return accessor;
}

int GltfDocument::addKeys(const std::vector<std::array<double, 4>>& values) {
  const int accessor = addAccessor(GltfBytes::Keys, values.size(), "VEC4", kFloat);
  for (const std::array<double, 4>& v : values) {
    for (const double c : v) appendFloat(bytesOf(GltfBytes::Keys), c);
  }
  return accessor;
}

int GltfDocument::addPngTexture(const std::string& png) {
  images_.push_back(png);
  return static_cast<int>(images_.size()) - 1;
}

JsonValue GltfDocument::accessorsJson(const std::array<int, 5>& views) const {
  JsonValue out = JsonValue::array();
  for (const Accessor& accessor : accessors_) {
    JsonValue& item = out.items.emplace_back(JsonValue::object());
    item.add("bufferView", jsonNumber(views[static_cast<std::size_t>(accessor.bytes)]));
    item.add("byteOffset", JsonValue::ofNumber(static_cast<double>(accessor.offset)));
    item.add("componentType", jsonNumber(accessor.componentType));
    item.add("count", JsonValue::ofNumber(static_cast<double>(accessor.count)));
    item.add("type", JsonValue::ofText(accessor.type));
    if (accessor.low.empty()) continue;
    item.add("min", jsonNumbers(accessor.low));
    item.add("max", jsonNumbers(accessor.high));
  }
  return out;
}

std::string GltfDocument::finish(const std::string& generator, int root) const {
  Buffer buffer;
  std::array<int, 5> viewOf = {};
  for (std::size_t kind = 0; kind < bytes_.size(); ++kind) {
    if (bytes_[kind].empty()) continue;
    describe(*buffer.add(bytes_[kind]), static_cast<GltfBytes>(kind));
    viewOf[kind] = buffer.last();
  }
  JsonValue out = JsonValue::object();
  JsonValue& asset = out.add("asset", JsonValue::object());
  asset.add("version", JsonValue::ofText("2.0"));
  asset.add("generator", JsonValue::ofText(generator));
  out.add("scene", jsonNumber(0));
  JsonValue& scenes = out.add("scenes", JsonValue::array());
  JsonValue& roots =
      scenes.items.emplace_back(JsonValue::object()).add("nodes", JsonValue::array());
  roots.items.push_back(jsonNumber(root));
  out.add("nodes", nodes_);
  if (!animations_.items.empty()) out.add("animations", animations_);
  if (!meshes_.items.empty()) out.add("meshes", meshes_);
  out.add("materials", materials_);
  addImages(out, buffer, images_);
  if (!accessors_.empty()) out.add("accessors", accessorsJson(viewOf));
  out.add("bufferViews", std::move(buffer.views));
  JsonValue& whole = out.add("buffers", JsonValue::array()).items.emplace_back(JsonValue::object());
  whole.add("byteLength", JsonValue::ofNumber(static_cast<double>(buffer.bytes.size())));
  return glbOf(compactText(out), buffer.bytes);
}

}  // namespace kiri
