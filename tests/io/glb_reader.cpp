// A reader of GLB files of the tests' own, written from the glTF 2.0 specification.
// SPDX-License-Identifier: MIT
#include "tests/io/glb_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace kiri::test {

namespace {

template <class Number>
Number numberAt(const std::string& bytes, std::size_t at) {
  if (at + sizeof(Number) > bytes.size()) throw std::runtime_error("beyond the end");
  Number value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

void require(bool holds, const char* what) {
  if (!holds) throw std::runtime_error(what);
}

Vec3 rotated(const std::vector<double>& q, Vec3 v) {
  const Vec3 u{q[0], q[1], q[2]};
  const Vec3 t = cross(u, v) * 2;
  return v + t * q[3] + cross(u, t);
}

/// Spherical interpolation, the shorter way (glTF 2.0, appendix C).
std::vector<double> slerp(const std::vector<double>& a, const std::vector<double>& b, double t) {
  double d = 0;
  for (std::size_t k = 0; k < 4; ++k) d += a[k] * b[k];
  const double s = d < 0 ? -1 : 1;
  const double angle = std::acos(std::min(1.0, std::fabs(d)));
  std::vector<double> out(4);
  const double sine = std::sin(angle);
  for (std::size_t k = 0; k < 4; ++k) {
    out[k] = sine < 1e-6
                 ? a[k] * (1 - t) + s * b[k] * t
                 : (std::sin((1 - t) * angle) * a[k] + s * std::sin(t * angle) * b[k]) / sine;
  }
  return out;
}

}  // namespace

GlbFile::GlbFile(const std::string& bytes) {
  require(bytes.substr(0, 4) == "glTF" && numberAt<std::uint32_t>(bytes, 4) == 2, "no GLB");
  require(numberAt<std::uint32_t>(bytes, 8) == bytes.size(), "wrong length");
  const std::size_t json = numberAt<std::uint32_t>(bytes, 12);
  require(bytes.substr(16, 4) == "JSON", "no JSON chunk");
  document_ = nlohmann::json::parse(bytes.substr(20, json));
  require(numberAt<std::uint32_t>(bytes, 20 + json) == bytes.size() - 28 - json, "wrong BIN chunk");
  buffer_ = bytes.substr(28 + json);
}

std::vector<std::vector<double>> GlbFile::values(std::size_t index) const {
  const nlohmann::json& accessor = document_.at("accessors").at(index);
  const nlohmann::json& view =
      document_.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
  const std::map<std::string, std::size_t> sizes = {
      {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
  const std::size_t size = sizes.at(accessor.at("type"));
  const int component = accessor.at("componentType");
  const std::size_t width = component == 5123 ? 2 : 4;
  const std::size_t stride = view.value("byteStride", size * width);
  const std::size_t start =
      view.at("byteOffset").get<std::size_t>() + accessor.at("byteOffset").get<std::size_t>();
  std::vector<std::vector<double>> out;
  for (std::size_t i = 0; i < accessor.at("count").get<std::size_t>(); ++i) {
    std::vector<double>& item = out.emplace_back();
    for (std::size_t k = 0; k < size; ++k) {
      const std::size_t at = start + i * stride + k * width;
      if (component == 5126) item.push_back(static_cast<double>(numberAt<float>(buffer_, at)));
      if (component == 5123) item.push_back(numberAt<std::uint16_t>(buffer_, at));
      if (component == 5125) item.push_back(numberAt<std::uint32_t>(buffer_, at));
    }
  }
  return out;
}

double GlbFile::duration() const {
  double end = 0;
  for (const nlohmann::json& animation : document_.value("animations", nlohmann::json::array())) {
    for (const nlohmann::json& sampler : animation.at("samplers")) {
      const double last =
          document_.at("accessors").at(sampler.at("input").get<std::size_t>()).at("max").at(0);
      end = std::max(end, last);
    }
  }
  return end;
}

void GlbFile::animate(std::vector<Place>& places, double seconds) const {
  for (const nlohmann::json& animation : document_.value("animations", nlohmann::json::array())) {
    for (const nlohmann::json& channel : animation.at("channels")) {
      const nlohmann::json& sampler =
          animation.at("samplers").at(channel.at("sampler").get<std::size_t>());
      const std::vector<std::vector<double>> times = values(sampler.at("input"));
      const std::vector<std::vector<double>> keys = values(sampler.at("output"));
      require(times.size() == keys.size() && !times.empty(), "times and keys differ");
      std::size_t next = 0;
      while (next < times.size() && times[next][0] <= seconds) ++next;
      const std::string path = channel.at("target").at("path");
      std::vector<double> value = keys[next == 0 ? 0 : next - 1];
      const bool isStep = sampler.value("interpolation", "LINEAR") == "STEP";
      if (!isStep && next > 0 && next < times.size()) {
        const double t = (seconds - times[next - 1][0]) / (times[next][0] - times[next - 1][0]);
        if (path == "rotation") {
          value = slerp(keys[next - 1], keys[next], t);
        } else {
          for (std::size_t k = 0; k < value.size(); ++k) {
            value[k] = keys[next - 1][k] * (1 - t) + keys[next][k] * t;
          }
        }
      }
      Place& place = places.at(channel.at("target").at("node").get<std::size_t>());
      (path == "rotation" ? place.rotation
       : path == "scale"  ? place.scale
                          : place.translation) = value;
    }
  }
}

std::vector<GlbFile::Place> GlbFile::placesAt(double seconds) const {
  std::vector<Place> places;
  for (const nlohmann::json& node : document_.at("nodes")) {
    Place& place = places.emplace_back();
    if (node.contains("translation"))
      place.translation = node["translation"].get<std::vector<double>>();
    if (node.contains("rotation")) place.rotation = node["rotation"].get<std::vector<double>>();
    if (node.contains("scale")) place.scale = node["scale"].get<std::vector<double>>();
  }
  animate(places, seconds);
  return places;
}

GlbPart GlbFile::partOf(std::size_t node, const std::vector<std::size_t>& chain,
                        const std::vector<Place>& places) const {
  const auto placed = [&](Vec3 p, bool isPoint) {
    for (auto at = chain.rbegin(); at != chain.rend(); ++at) {
      const Place& place = places[*at];
      if (isPoint) p = {p.x * place.scale[0], p.y * place.scale[1], p.z * place.scale[2]};
      p = rotated(place.rotation, p);
      if (isPoint) p = p + Vec3{place.translation[0], place.translation[1], place.translation[2]};
    }
    return p;
  };
  GlbPart part;
  part.name = document_.at("nodes").at(node).value("name", "");
  const std::size_t mesh = document_.at("nodes").at(node).at("mesh");
  for (const nlohmann::json& primitive : document_.at("meshes").at(mesh).at("primitives")) {
    const auto positions = values(primitive.at("attributes").at("POSITION"));
    const auto normals = values(primitive.at("attributes").at("NORMAL"));
    const auto indices = values(primitive.at("indices"));
    const std::size_t material = primitive.at("material");
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      GlbTriangle triangle;
      triangle.material = document_.at("materials").at(material).at("name");
      for (std::size_t k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(indices[i + k][0]);
        triangle.corners[k] =
            placed({positions.at(at)[0], positions.at(at)[1], positions.at(at)[2]}, true);
        triangle.normals[k] =
            placed({normals.at(at)[0], normals.at(at)[1], normals.at(at)[2]}, false);
      }
      part.triangles.push_back(triangle);
    }
  }
  return part;
}

std::vector<GlbPart> GlbFile::at(double seconds) const {
  const std::vector<Place> places = placesAt(seconds);
  std::vector<GlbPart> out;
  std::vector<std::vector<std::size_t>> open;
  for (const nlohmann::json& root : document_.at("scenes").at(0).at("nodes"))
    open.push_back({root.get<std::size_t>()});
  while (!open.empty()) {
    const std::vector<std::size_t> chain = open.back();
    open.pop_back();
    const nlohmann::json& node = document_.at("nodes").at(chain.back());
    if (places[chain.back()].scale[0] < 1e-5) continue;
    if (node.contains("mesh")) out.push_back(partOf(chain.back(), chain, places));
    for (const nlohmann::json& child : node.value("children", nlohmann::json::array())) {
      std::vector<std::size_t> longer = chain;
      longer.push_back(child.get<std::size_t>());
      open.push_back(longer);
    }
  }
  std::sort(out.begin(), out.end(),
            [](const GlbPart& a, const GlbPart& b) { return a.name < b.name; });
  return out;
}

}  // namespace kiri::test
