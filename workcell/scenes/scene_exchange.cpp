// SPDX-License-Identifier: Apache-2.0
#include "workcell/scenes/scene_exchange.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "geometry/system/packed_text.h"
#include "workcell/scenes/packed_bytes.h"

namespace hapticell::workcell {

namespace {

constexpr std::string_view kMagic("HCSCENE\3", 8);

void writeMesh(const geometry::TriangleMesh& mesh, PackedWriter& writer) {
  static_assert(sizeof(dvec3) == 24 && sizeof(geometry::Triangle) == 12);
  writer.number(std::uint64_t{mesh.vertices.size()});
  writer.raw(mesh.vertices.data(), mesh.vertices.size() * sizeof(dvec3));
  writer.number(std::uint64_t{mesh.triangles.size()});
  writer.raw(mesh.triangles.data(), mesh.triangles.size() * sizeof(geometry::Triangle));
}

bool isCoordinate(const dvec3& p) {
  // m, as kFarthest of geometry/shapes/pose.cpp.
  constexpr double kFarthest = 1e12;
  return std::abs(p.x) <= kFarthest && std::abs(p.y) <= kFarthest && std::abs(p.z) <= kFarthest;
}

geometry::TriangleMesh readMesh(PackedReader& reader) {
  geometry::TriangleMesh mesh;
  mesh.vertices.resize(reader.count(sizeof(dvec3)));
  reader.take(mesh.vertices.data(), mesh.vertices.size() * sizeof(dvec3));
  mesh.triangles.resize(reader.count(sizeof(geometry::Triangle)));
  reader.take(mesh.triangles.data(), mesh.triangles.size() * sizeof(geometry::Triangle));
  const std::size_t n = mesh.vertices.size();
  reader.require(std::all_of(mesh.vertices.begin(), mesh.vertices.end(), isCoordinate));
  reader.require(std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
                             [n](const geometry::Triangle& t) { return t[0] < n && t[1] < n && t[2] < n; }));
  return mesh;
}

void writeNode(const SceneNode& node, PackedWriter& writer) {
  writer.text(node.name);
  writer.text(node.instance);
  writer.number(std::int32_t{node.parent});
  writer.pose(node.X_PN);
  writer.number(std::int32_t{node.mesh});
  writer.number(std::uint8_t{node.color.has_value()});
  for (float part : node.color.value_or(std::array<float, 3>{})) writer.number(part);
  writer.number(std::uint8_t{node.origin.has_value()});
  const SceneOrigin origin = node.origin.value_or(SceneOrigin{});
  writer.text(origin.file);
  writer.text(origin.part);
  writer.number(origin.metres_per_unit);
}

UpAxis readAxis(PackedReader& reader) {
  const auto axis = reader.number<std::uint8_t>();
  return reader.require(axis <= 2) ? static_cast<UpAxis>(axis) : UpAxis::kZ;
}

SceneNode readNode(PackedReader& reader, std::size_t index, std::size_t meshes) {
  SceneNode node;
  node.name = reader.text();
  node.instance = reader.text();
  node.parent = reader.number<std::int32_t>();
  reader.require(node.parent >= -1 && node.parent < static_cast<std::int64_t>(index));
  node.X_PN = reader.pose();
  node.mesh = reader.number<std::int32_t>();
  reader.require(node.mesh >= -1 && node.mesh < static_cast<std::int64_t>(meshes));
  const bool colored = reader.number<std::uint8_t>() != 0;
  std::array<float, 3> color{};
  for (float& part : color) {
    part = reader.number<float>();
    reader.require(part >= 0.0f && part <= 1.0f);
  }
  if (colored) node.color = color;
  const bool has_origin = reader.number<std::uint8_t>() != 0;
  SceneOrigin origin;
  origin.file = reader.text();
  origin.part = reader.text();
  origin.metres_per_unit = reader.number<double>();
  if (has_origin) node.origin = std::move(origin);
  return node;
}

}  // namespace

std::string sceneBytes(const ImportedScene& scene) {
  PackedWriter writer;
  writer.bytes = kMagic;
  writer.text(scene.format);
  writer.number(scene.metres_per_unit);
  writer.number(std::uint8_t{scene.unit_is_stated});
  writer.number(static_cast<std::uint8_t>(scene.up_axis));
  writer.number(scene.chord);
  writer.number(std::uint64_t{scene.warnings.size()});
  for (const Text& warning : scene.warnings) writer.text(packed(warning));
  writer.number(std::uint64_t{scene.meshes.size()});
  for (const geometry::TriangleMesh& mesh : scene.meshes) writeMesh(mesh, writer);
  writer.number(std::uint64_t{scene.nodes.size()});
  for (const SceneNode& node : scene.nodes) writeNode(node, writer);
  return std::move(writer.bytes);
}

Expected<ImportedScene> sceneFromBytes(std::string_view bytes) {
  const Error unsound{.found = "the importer sent invalid data",
                      .fix = "Please report this bug, with the file that caused it."};
  if (!bytes.starts_with(kMagic)) return makeError(unsound);
  PackedReader reader(bytes.substr(kMagic.size()));
  ImportedScene scene;
  scene.format = reader.text();
  scene.metres_per_unit = reader.number<double>();
  reader.require(scene.metres_per_unit > 0.0);
  scene.unit_is_stated = reader.number<std::uint8_t>() != 0;
  scene.up_axis = readAxis(reader);
  scene.chord = reader.number<double>();
  reader.require(scene.chord >= 0.0);
  constexpr std::size_t kSmallestNode = 80;
  for (std::size_t k = reader.count(4); k > 0 && !reader.failed; --k) {
    std::optional<Text> warning = unpackedText(reader.text());
    reader.failed = reader.failed || !warning;
    if (warning) scene.warnings.push_back(std::move(*warning));
  }
  for (std::size_t k = reader.count(16); k > 0 && !reader.failed; --k) scene.meshes.push_back(readMesh(reader));
  for (std::size_t k = reader.count(kSmallestNode); k > 0 && !reader.failed; --k) {
    scene.nodes.push_back(readNode(reader, scene.nodes.size(), scene.meshes.size()));
  }
  if (reader.failed || reader.left() != 0) return makeError(unsound);
  return scene;
}

Pose turnedUp(UpAxis up) {
  constexpr double kQuarter = std::numbers::pi / 2.0;
  if (up == UpAxis::kY) return Pose::rotation(glm::angleAxis(kQuarter, dvec3(1.0, 0.0, 0.0)));
  if (up == UpAxis::kX) return Pose::rotation(glm::angleAxis(-kQuarter, dvec3(0.0, 1.0, 0.0)));
  return {};
}

}  // namespace hapticell::workcell
