// SPDX-License-Identifier: Apache-2.0
#include "tests/workcell/meshes/mesh_text.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <sstream>

namespace hapticell::test {

namespace {

template <typename T>
void put(std::string& bytes, T value, bool big_endian = false) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (big_endian != (std::endian::native == std::endian::big)) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

std::ostringstream exactStream() {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(17);
  return text;
}

void line(std::ostringstream& text, const char* word, const dvec3& p) {
  text << word << p.x << ' ' << p.y << ' ' << p.z << '\n';
}

}  // namespace

std::string stlAscii(const geometry::TriangleMesh& mesh) {
  std::ostringstream text = exactStream();
  text << "solid part\n";
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    text << "  facet normal 0 0 0\n    outer loop\n";
    for (int corner = 0; corner < 3; ++corner) line(text, "      vertex ", mesh.corner(t, corner));
    text << "    endloop\n  endfacet\n";
  }
  text << "endsolid part\n";
  return text.str();
}

std::string stlBinary(const geometry::TriangleMesh& mesh, const std::string& header) {
  std::string bytes = header;
  bytes.resize(80, ' ');
  put(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) put(bytes, 0.0f);
    for (int corner = 0; corner < 3; ++corner) {
      for (int axis = 0; axis < 3; ++axis) put(bytes, static_cast<float>(mesh.corner(t, corner)[axis]));
    }
    put(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string objText(const geometry::TriangleMesh& mesh) {
  std::ostringstream text = exactStream();
  text << "# a test\no part\n";
  for (const dvec3& vertex : mesh.vertices) line(text, "v ", vertex);
  for (const auto& t : mesh.triangles) text << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  return text.str();
}

std::string offText(const geometry::TriangleMesh& mesh) {
  std::ostringstream text = exactStream();
  text << "OFF\n" << mesh.vertices.size() << ' ' << mesh.triangles.size() << " 0\n";
  for (const dvec3& vertex : mesh.vertices) line(text, "", vertex);
  for (const auto& t : mesh.triangles) text << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  return text.str();
}

std::string plyAscii(const geometry::TriangleMesh& mesh) {
  std::ostringstream text = exactStream();
  text << "ply\nformat ascii 1.0\ncomment a test\nelement vertex " << mesh.vertices.size()
       << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << mesh.triangles.size()
       << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const dvec3& vertex : mesh.vertices) line(text, "", vertex);
  for (const auto& t : mesh.triangles) text << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  return text.str();
}

std::string plyBinary(const geometry::TriangleMesh& mesh, bool big_endian) {
  std::string bytes = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                      "_endian 1.0\nelement vertex " + std::to_string(mesh.vertices.size()) +
                      "\nproperty uchar red\nproperty list uint8 int16 extra\nproperty double x\nproperty double y\n"
                      "property double z\nelement face " +
                      std::to_string(mesh.triangles.size()) +
                      "\nproperty list uint8 uint32 vertex_index\nproperty float quality\nend_header\n";
  for (const dvec3& vertex : mesh.vertices) {
    put(bytes, std::uint8_t{200});
    put(bytes, std::uint8_t{2});
    put(bytes, std::int16_t{-7}, big_endian);
    put(bytes, std::int16_t{7}, big_endian);
    for (int axis = 0; axis < 3; ++axis) put(bytes, vertex[axis], big_endian);
  }
  for (const auto& t : mesh.triangles) {
    put(bytes, std::uint8_t{3});
    for (std::uint32_t index : t) put(bytes, index, big_endian);
    put(bytes, 0.5f, big_endian);
  }
  return bytes;
}

}  // namespace hapticell::test
