// SPDX-License-Identifier: Apache-2.0
#include <cctype>

#include "geometry/system/text_case.h"
#include "workcell/meshes/byte_source.h"
#include "workcell/meshes/mesh_formats.h"
#include "workcell/meshes/unit_statement.h"
#include "workcell/text/text_cursor.h"

namespace hapticell::workcell {

namespace {

constexpr std::size_t kHeaderBytes = 84;  // 80 of text, 4 of count.
constexpr std::size_t kTriangleBytes = 50;
constexpr char kTruncatedStl[] = HAPTICELL_TRANSLATED("The file is truncated: export it again.");

Text triangleOf(std::size_t triangle, std::size_t count) {
  return Text("triangle %1 of %2", triangle + 1, count);
}

std::uint32_t countInHeader(std::string_view content) {
  return readNumber<std::uint32_t>(content.substr(80), std::endian::little);
}

Error wrongWord(const TextCursor& cursor, std::string_view word, const Text& expected) {
  if (word.empty())
    return {.place = cursor.place(), .found = "the file ends too early", .expected = expected, .fix = kTruncatedStl};
  return {.place = cursor.place(), .found = inQuotes(word), .expected = expected};
}

/// One facet behind its word "facet". The normal is not used (exporters write NaN there for slivers): any words pass.
Expected<void> readFacet(TextCursor& cursor, geometry::TriangleMesh& mesh) {
  cursor.restOfLine();
  for (const char* expected : {"outer", "loop"}) {
    const std::string_view word = cursor.nextWordOfText();
    if (!sameButForCase(word, expected)) return makeError(wrongWord(cursor, word, "'outer loop'"));
  }
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (int corner = 0; corner < 3; ++corner) {
    const std::string_view word = cursor.nextWordOfText();
    if (!sameButForCase(word, "vertex")) return makeError(wrongWord(cursor, word, Text("'vertex' (three per facet)")));
    const Expected<dvec3> point = readPoint(cursor);
    HAPTICELL_TRY(point);
    mesh.vertices.push_back(*point);
  }
  for (const char* expected : {"endloop", "endfacet"}) {
    const std::string_view word = cursor.nextWordOfText();
    if (!sameButForCase(word, expected)) return makeError(wrongWord(cursor, word, inQuotes(expected)));
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
  return {};
}

}  // namespace

bool hasLengthOfBinaryStl(std::string_view content) {
  return content.size() >= kHeaderBytes && content.size() == kHeaderBytes + kTriangleBytes * countInHeader(content);
}

Expected<RawMesh> readStlAscii(std::string_view content, Diagnostics&) {
  RawMesh raw;
  geometry::TriangleMesh& mesh = raw.mesh;
  TextCursor cursor(content);
  bool in_solid = false;
  while (true) {
    const std::string_view word = cursor.nextWordOfText();
    if (word.empty()) break;
    if (!in_solid && sameButForCase(word, "solid")) {
      const std::string_view name = cursor.restOfLine();
      if (mesh.triangles.empty()) raw.metres_per_unit = statedUnit(name);
      in_solid = true;
    } else if (in_solid && sameButForCase(word, "facet")) {
      HAPTICELL_TRY(readFacet(cursor, mesh));
    } else if (in_solid && sameButForCase(word, "endsolid")) {
      cursor.restOfLine();
      in_solid = false;
    } else {
      return makeError(wrongWord(cursor, word, in_solid ? Text("'facet' or 'endsolid'") : Text("'solid'")));
    }
  }
  if (in_solid) return makeError(wrongWord(cursor, {}, Text("'facet' or 'endsolid'")));
  return raw;
}

Expected<RawMesh> readStlBinary(std::string_view content, Diagnostics& diagnostics) {
  if (content.size() < kHeaderBytes) {
    return makeError({.found = Text("%1 bytes", content.size()),
                      .expected = "at least the 84 bytes of a binary STL's header",
                      .fix = kTruncatedStl});
  }
  const std::size_t count = countInHeader(content);
  const std::size_t room = (content.size() - kHeaderBytes) / kTriangleBytes;
  const std::size_t spare = (content.size() - kHeaderBytes) % kTriangleBytes;
  if (count > room) {
    return makeError({.place = triangleOf(room, count),
                      .found = Text("the file ends after %1 bytes", content.size()),
                      .expected = Text("%1 bytes", kHeaderBytes + kTriangleBytes * count),
                      .fix = kTruncatedStl});
  }
  if (count < room) {
    return makeError({.place = "header",
                      .found = Text("a count of %1 triangles", count),
                      .expected = Text("%1, according to the file size", room),
                      .fix = "Export the file again."});
  }
  if (spare > 0) diagnostics.warn(Text("%1 bytes after the last triangle were not read", spare));
  RawMesh raw;
  raw.metres_per_unit = statedUnit(content.substr(0, kHeaderBytes - 4));
  geometry::TriangleMesh& mesh = raw.mesh;
  mesh.vertices.reserve(3 * count);
  mesh.triangles.reserve(count);
  for (std::size_t triangle = 0; triangle < count; ++triangle) {
    const std::string_view bytes = content.substr(kHeaderBytes + kTriangleBytes * triangle + 12);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::size_t corner = 0; corner < 3; ++corner) {
      dvec3 point;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t at = 4 * (3 * corner + axis);
        point[static_cast<int>(axis)] = readNumber<float>(bytes.substr(at), std::endian::little);
      }
      if (!isUsable(point)) return makeError(unusableCoordinate(triangleOf(triangle, count), point));
      mesh.vertices.push_back(point);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return raw;
}

}  // namespace hapticell::workcell
