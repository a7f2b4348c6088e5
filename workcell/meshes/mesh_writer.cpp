// SPDX-License-Identifier: Apache-2.0
#include "workcell/meshes/mesh_writer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

namespace hapticell::workcell {

namespace {

template <typename T>
void appendRaw(std::string& bytes, T value) {
  static_assert(std::endian::native == std::endian::little, "STL and PLY are written as the machine has them");
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void appendPoint(std::string& bytes, const dvec3& p) {
  for (int k = 0; k < 3; ++k) appendRaw(bytes, static_cast<float>(p[k]));
}

void appendNumber(std::string& text, double value) {
  char buffer[40];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  text.append(buffer, end);
}

void appendLine(std::string& text, const char* begin, const dvec3& p) {
  text += begin;
  for (int k = 0; k < 3; ++k) {
    if (k > 0 || *begin) text += ' ';
    appendNumber(text, p[k]);
  }
  text += '\n';
}

std::uint8_t byteOf(float part) {
  return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(part, 0.0f, 1.0f)));
}

std::size_t trianglesOf(std::span<const NamedMesh> meshes) {
  std::size_t sum = 0;
  for (const NamedMesh& part : meshes) sum += part.mesh.triangles.size();
  return sum;
}

std::size_t verticesOf(std::span<const NamedMesh> meshes) {
  std::size_t sum = 0;
  for (const NamedMesh& part : meshes) sum += part.mesh.vertices.size();
  return sum;
}

/// A name as one word of an OBJ file.
std::string word(const std::string& name) {
  std::string result = name.empty() ? "part" : name;
  for (char& c : result) {
    if (static_cast<unsigned char>(c) <= 0x20 || c == '#' || c == '\\') c = '_';
  }
  return result;
}

/// "units: mm", as statedUnit() reads it; nothing for a unit without a name.
std::string unitStatement(double metres_per_unit) {
  constexpr std::array<std::pair<double, const char*>, 5> kUnits = {
      {{1.0, "m"}, {0.001, "mm"}, {0.0254, "in"}, {0.01, "cm"}, {0.3048, "ft"}}};
  for (const auto& [metres, word] : kUnits) {
    if (std::abs(metres_per_unit / metres - 1.0) < 1e-12) return std::string("units: ") + word;
  }
  return {};
}

/// The statement behind `begin` as a line of its own.
std::string unitLine(const char* begin, double metres_per_unit) {
  const std::string statement = unitStatement(metres_per_unit);
  return statement.empty() ? "" : begin + statement + "\n";
}

std::string materialName(std::size_t index) {
  return "color_" + std::to_string(index + 1);
}

}  // namespace

std::string stlBytes(std::span<const NamedMesh> meshes, double metres_per_unit) {
  constexpr std::size_t kHeader = 80, kTriangle = 50;
  std::string bytes = "HaptiCell binary STL, " + unitStatement(metres_per_unit);
  bytes.resize(kHeader, ' ');
  const std::size_t triangles = trianglesOf(meshes);
  bytes.reserve(kHeader + 4 + triangles * kTriangle);
  appendRaw(bytes, static_cast<std::uint32_t>(triangles));
  for (const NamedMesh& part : meshes) {
    for (std::uint32_t t = 0; t < part.mesh.triangles.size(); ++t) {
      const dvec3 a = part.mesh.corner(t, 0), b = part.mesh.corner(t, 1), c = part.mesh.corner(t, 2);
      const dvec3 normal = glm::cross(b - a, c - a);
      const double length = glm::length(normal);
      appendPoint(bytes, length > 0.0 ? normal / length : dvec3(0.0));
      for (const dvec3& p : {a, b, c}) appendPoint(bytes, p / metres_per_unit);
      appendRaw(bytes, std::uint16_t{0});
    }
  }
  return bytes;
}

std::string plyBytes(std::span<const NamedMesh> meshes, double metres_per_unit) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment HaptiCell\n" +
                      unitLine("comment ", metres_per_unit) + "element vertex " + std::to_string(verticesOf(meshes)) +
                      "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar "
                      "green\nproperty uchar blue\nelement face " +
                      std::to_string(trianglesOf(meshes)) + "\nproperty list uchar uint vertex_indices\nend_header\n";
  for (const NamedMesh& part : meshes) {
    for (const dvec3& p : part.mesh.vertices) {
      appendPoint(bytes, p / metres_per_unit);
      for (float channel : part.color) appendRaw(bytes, byteOf(channel));
    }
  }
  std::uint32_t first = 0;
  for (const NamedMesh& part : meshes) {
    for (const geometry::Triangle& t : part.mesh.triangles) {
      appendRaw(bytes, std::uint8_t{3});
      for (std::uint32_t index : t) appendRaw(bytes, first + index);
    }
    first += static_cast<std::uint32_t>(part.mesh.vertices.size());
  }
  return bytes;
}

std::string offText(std::span<const NamedMesh> meshes, double metres_per_unit) {
  std::string text = "OFF\n" + std::to_string(verticesOf(meshes)) + " " + std::to_string(trianglesOf(meshes)) + " 0\n";
  for (const NamedMesh& part : meshes) {
    for (const dvec3& p : part.mesh.vertices) appendLine(text, "", p / metres_per_unit);
  }
  std::uint32_t first = 0;
  for (const NamedMesh& part : meshes) {
    std::string color;
    for (float channel : part.color) color.append(" ").append(std::to_string(byteOf(channel)));
    for (const geometry::Triangle& t : part.mesh.triangles) {
      text += '3';
      for (std::uint32_t index : t) text.append(" ").append(std::to_string(first + index));
      text.append(color).append("\n");
    }
    first += static_cast<std::uint32_t>(part.mesh.vertices.size());
  }
  text += unitLine("# ", metres_per_unit);  // At the end: not all readers pass over a comment at the head.
  return text;
}

std::string objText(std::span<const NamedMesh> meshes, double metres_per_unit, const std::string& material_file) {
  std::string text = "# HaptiCell\n" + unitLine("# ", metres_per_unit);
  if (!material_file.empty()) text += "mtllib " + material_file + "\n";
  std::size_t first = 1;
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    const NamedMesh& part = meshes[k];
    text.append("o ").append(word(part.name)).append("\n");
    for (const dvec3& p : part.mesh.vertices) appendLine(text, "v", p / metres_per_unit);
    if (!material_file.empty()) text.append("usemtl ").append(materialName(k)).append("\n");
    for (const geometry::Triangle& t : part.mesh.triangles) {
      text += 'f';
      for (std::uint32_t index : t) text.append(" ").append(std::to_string(first + index));
      text += '\n';
    }
    first += part.mesh.vertices.size();
  }
  return text;
}

std::string objMaterials(std::span<const NamedMesh> meshes) {
  std::string text = "# HaptiCell\n";
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    text.append("newmtl ").append(materialName(k)).append("\n");
    const auto [r, g, b] = meshes[k].color;
    appendLine(text, "Kd", {static_cast<double>(r), static_cast<double>(g), static_cast<double>(b)});
  }
  return text;
}

}  // namespace hapticell::workcell
