// The facets of a model as meshes of a glTF document, in the colours of the paper.
// SPDX-License-Identifier: MIT
#include "io/gltf_meshes.h"

#include <cmath>
#include <utility>

namespace kiri {

namespace {

/// glTF wants light, files of models have sRGB (IEC 61966-2-1). Rounded, so that platforms agree.
double linearOf(std::uint8_t value) {
  constexpr double kFull = 255;
  constexpr double kToeEnd = 0.04045;
  constexpr double kToeSlope = 12.92;
  constexpr double kOffset = 0.055;
  constexpr double kGamma = 2.4;
  constexpr double kParts = 100000;
  const double c = value / kFull;
  const double light =
      c <= kToeEnd ? c / kToeSlope : std::pow((c + kOffset) / (1 + kOffset), kGamma);
  return std::round(light * kParts) / kParts;
}

Color between(Color a, Color b) {
  const auto mean = [](int x, int y) { return static_cast<std::uint8_t>((x + y) / 2); };
  return {mean(a.red, b.red), mean(a.green, b.green), mean(a.blue, b.blue)};
}

JsonValue primitive(int positions, int normals, int indices, int material) {
  JsonValue out = JsonValue::object();
  JsonValue& attributes = out.add("attributes", JsonValue::object());
  attributes.add("POSITION", jsonNumber(positions));
  attributes.add("NORMAL", jsonNumber(normals));
  out.add("indices", jsonNumber(indices));
  out.add("material", jsonNumber(material));
  return out;
}

/// What makes two facets the same mesh.
std::vector<double> keyOf(const FacetTriangles& facet) {
  std::vector<double> key = {static_cast<double>(facet.points.size())};
  for (const Vec2 p : facet.points) {
    key.push_back(p.x);
    key.push_back(p.y);
  }
  for (const std::array<std::uint32_t, 3>& triangle : facet.triangles) {
    key.insert(key.end(), triangle.begin(), triangle.end());
  }
  return key;
}

}  // namespace

JsonValue gltfRoot(const std::string& title, const std::vector<int>& children) {
  constexpr double kMetres = 0.001;
  JsonValue root = JsonValue::object();
  root.add("name", JsonValue::ofText(title.empty() ? "model" : title));
  // The table that the model lies on is glTF's ground: x stays, z becomes y.
  const double half = std::sqrt(0.5);
  root.add("rotation", jsonNumbers({-half, 0, 0, half}));
  root.add("scale", jsonNumbers({kMetres, kMetres, kMetres}));
  JsonValue& list = root.add("children", JsonValue::array());
  for (const int child : children) list.items.push_back(jsonNumber(child));
  return root;
}

std::vector<std::string> gltfLosses(bool hadCurves) {
  std::vector<std::string> losses = {
      "glTF holds no creases, layers or fold angles: only shape and colours are written"};
  if (hadCurves) losses.push_back("glTF has no curves: curved edges became polylines");
  return losses;
}

std::array<double, 4> quaternionOf(const Rigid& pose) {
  const double m00 = pose.x.x;
  const double m11 = pose.y.y;
  const double m22 = pose.z.z;
  std::array<double, 4> q = {};
  // By the largest of the four, for accuracy (Shepperd 1978).
  if (m00 + m11 + m22 > 0) {
    q = {pose.y.z - pose.z.y, pose.z.x - pose.x.z, pose.x.y - pose.y.x, 1 + m00 + m11 + m22};
  } else if (m00 >= m11 && m00 >= m22) {
    q = {1 + m00 - m11 - m22, pose.x.y + pose.y.x, pose.z.x + pose.x.z, pose.y.z - pose.z.y};
  } else if (m11 >= m22) {
    q = {pose.x.y + pose.y.x, 1 + m11 - m00 - m22, pose.y.z + pose.z.y, pose.z.x - pose.x.z};
  } else {
    q = {pose.z.x + pose.x.z, pose.y.z + pose.z.y, 1 + m22 - m00 - m11, pose.x.y - pose.y.x};
  }
  const double size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& part : q) part /= q[3] < 0 ? -size : size;
  return q;
}

GltfMeshes::GltfMeshes(GltfDocument& document, const GltfOptions& options)
    : document_(document),
      options_(options),
      front_(addMaterial("front", options.front)),
      back_(addMaterial("back", options.back)) {
  if (options_.thickness > 0) {
    rim_ = addMaterial("rim", {between(options.front.color, options.back.color), ""});
  }
}

GltfMeshes::Material GltfMeshes::addMaterial(const std::string& name, const GltfSide& side) {
  constexpr double kMatt = 0.9;
  JsonValue material = JsonValue::object();
  material.add("name", JsonValue::ofText(name));
  JsonValue& looks = material.add("pbrMetallicRoughness", JsonValue::object());
  if (side.png.empty()) {
    const Color c = side.color;
    looks.add("baseColorFactor",
              jsonNumbers({linearOf(c.red), linearOf(c.green), linearOf(c.blue), 1}));
  } else {
    looks.add("baseColorTexture", JsonValue::object())
        .add("index", jsonNumber(document_.addPngTexture(side.png)));
  }
  looks.add("metallicFactor", jsonNumber(0));
  looks.add("roughnessFactor", JsonValue::ofNumber(kMatt));
  return {document_.addMaterial(std::move(material)), !side.png.empty()};
}

int GltfMeshes::meshOf(const FacetTriangles& facet) {
  const auto [at, isNew] = meshes_.try_emplace(keyOf(facet), 0);
  if (!isNew) return at->second;
  sharedPositions_ = -1;
  JsonValue mesh = JsonValue::object();
  JsonValue& primitives = mesh.add("primitives", JsonValue::array());
  primitives.items.push_back(primitiveOf(facet, PlateSide::Front));
  primitives.items.push_back(primitiveOf(facet, PlateSide::Back));
  if (options_.thickness > 0) primitives.items.push_back(rimOf(facet));
  at->second = document_.addMesh(std::move(mesh));
  return at->second;
}

JsonValue GltfMeshes::primitiveOf(const FacetTriangles& facet, PlateSide side) {
  const bool isFront = side == PlateSide::Front;
  std::vector<std::uint32_t> indices;
  for (const PlateTriangle& triangle : plateTriangles(facet, side)) {
    for (const PlateCorner& corner : triangle) indices.push_back(corner.point);
  }
  if (options_.thickness > 0 || sharedPositions_ < 0) {
    sharedPositions_ = positionsOf(facet, options_.thickness / (isFront ? 2 : -2));
  }
  const Material& material = isFront ? front_ : back_;
  JsonValue out = primitive(sharedPositions_, normalsOf(facet.points.size(), isFront),
                            document_.addIndices(indices, facet.points.size()), material.index);
  if (material.hasTexture) {
    out.find("attributes")->add("TEXCOORD_0", jsonNumber(texturePlacesOf(facet, isFront)));
  }
  return out;
}

/// The rim has corners of its own, for each of its sides has a normal of its own.
JsonValue GltfMeshes::rimOf(const FacetTriangles& facet) {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
  std::vector<std::uint32_t> indices;
  const double half = options_.thickness / 2;
  for (const auto& [from, to] : facet.rim) {
    const Vec2 a = facet.points[from];
    const Vec2 b = facet.points[to];
    const Vec2 out = -perpendicular(normalized(b - a));
    const auto first = static_cast<std::uint32_t>(points.size());
    for (const Vec3 corner :
         {Vec3{a.x, a.y, -half}, Vec3{b.x, b.y, -half}, Vec3{b.x, b.y, half}, Vec3{a.x, a.y, half}})
      points.push_back(corner);
    normals.insert(normals.end(), 4, Vec3{out.x, out.y, 0});
    for (const std::uint32_t k : {0U, 1U, 2U, 0U, 2U, 3U}) indices.push_back(first + k);
  }
  return primitive(document_.addVectors(points, true), document_.addVectors(normals, false),
                   document_.addIndices(indices, points.size()), rim_.index);
}

int GltfMeshes::positionsOf(const FacetTriangles& facet, double lift) {
  std::vector<Vec3> points;
  for (const Vec2 p : facet.points) points.push_back({p.x, p.y, lift});
  return document_.addVectors(points, true);
}

/// All facets with as many points share an accessor.
int GltfMeshes::normalsOf(std::size_t count, bool isFront) {
  const auto [at, isNew] = normals_.try_emplace({count, isFront}, 0);
  if (isNew) {
    at->second =
        document_.addVectors(std::vector<Vec3>(count, {0, 0, isFront ? 1.0 : -1.0}), false);
  }
  return at->second;
}

/// Images have their origin at the upper left; that of the back is seen upright from the back.
int GltfMeshes::texturePlacesOf(const FacetTriangles& facet, bool isFront) {
  const Vec2 size = options_.sheet.high - options_.sheet.low;
  std::vector<Vec2> places;
  for (const Vec2 p : facet.points) {
    const Vec2 from = p - options_.sheet.low;
    const double u = size.x > 0 ? from.x / size.x : 0;
    const double v = size.y > 0 ? from.y / size.y : 0;
    places.push_back({isFront ? u : 1 - u, 1 - v});
  }
  return document_.addPairs(places);
}

}  // namespace kiri
