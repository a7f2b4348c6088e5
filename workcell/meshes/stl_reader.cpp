// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geometry/system/in_parallel.h"
#include "geometry/system/text_case.h"
#include "workcell/meshes/byte_source.h"
#include "workcell/meshes/mesh_formats.h"
#include "workcell/meshes/shared_corners.h"
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
Expected<geometry::Triangle> readFacet(TextCursor& cursor, SharedCorners& corners) {
  cursor.restOfLine();
  for (const char* expected : {"outer", "loop"}) {
    const std::string_view word = cursor.nextWordOfText();
    if (!sameButForCase(word, expected)) return makeError(wrongWord(cursor, word, "'outer loop'"));
  }
  geometry::Triangle triangle{};
  for (std::uint32_t& corner : triangle) {
    const std::string_view word = cursor.nextWordOfText();
    if (!sameButForCase(word, "vertex")) return makeError(wrongWord(cursor, word, Text("'vertex' (three per facet)")));
    const Expected<dvec3> point = readPoint(cursor);
    HAPTICELL_TRY(point);
    corner = corners.add(*point);
  }
  for (const char* expected : {"endloop", "endfacet"}) {
    const std::string_view word = cursor.nextWordOfText();
    if (!sameButForCase(word, expected)) return makeError(wrongWord(cursor, word, inQuotes(expected)));
  }
  return triangle;
}

/// Triangles [begin, end) of a binary STL, or the first of them with an unusable coordinate.
struct BinaryRange {
  std::span<geometry::Triangle> triangles;  ///< Where they go.
  SharedCorners corners;
  std::optional<std::pair<std::size_t, dvec3>> unusable;

  void read(std::string_view content, std::size_t begin, std::size_t end) {
    // Triangles in one go. Half, twice: no effect.
    constexpr std::size_t kBatch = 64;
    std::array<dvec3, 3 * kBatch> points;
    corners.reserve((end - begin) / 2 + 16);  // As many vertices has a closed surface.
    for (std::size_t first = begin; first < end; first += kBatch) {
      const std::size_t count = std::min(kBatch, end - first);
      for (std::size_t k = 0; k < 3 * count; ++k) {
        const std::size_t triangle = first + k / 3;
        points[k] = pointAt(content.substr(kHeaderBytes + kTriangleBytes * triangle + 12 * (1 + k % 3)));
        if (isUsable(points[k])) continue;
        unusable = {triangle, points[k]};
        return;
      }
      corners.add(std::span(points).first(3 * count), triangles[first - begin].data());
    }
  }

  static dvec3 pointAt(std::string_view bytes) {
    return {readNumber<float>(bytes, std::endian::little), readNumber<float>(bytes.substr(4), std::endian::little),
            readNumber<float>(bytes.substr(8), std::endian::little)};
  }
};

/// Appends the vertices of what stands behind it in the file, and gives its triangles their numbers. `last`: of all.
void append(SharedCorners& whole, BinaryRange& next, std::size_t least, bool last) {
  std::vector<std::uint32_t> numbers;
  {
    const std::vector<dvec3> vertices = next.corners.take();
    next.corners = {};
    numbers.resize(vertices.size());
    geometry::inRanges(vertices.size(), geometry::rangesOf(vertices.size(), least),
                       [&](std::size_t, std::size_t begin, std::size_t end) {
                         whole.find(std::span(vertices).subspan(begin, end - begin), numbers.data() + begin);
                       });
    whole.addMissing(vertices, numbers.data(), last);
  }
  const std::span<geometry::Triangle> triangles = next.triangles;
  geometry::inRanges(triangles.size(), geometry::rangesOf(triangles.size(), least),
                     [&](std::size_t, std::size_t begin, std::size_t end) {
                       for (geometry::Triangle& t : triangles.subspan(begin, end - begin)) {
                         t = {numbers[t[0]], numbers[t[1]], numbers[t[2]]};
                       }
                     });
}

}  // namespace

bool hasLengthOfBinaryStl(std::string_view content) {
  return content.size() >= kHeaderBytes && content.size() == kHeaderBytes + kTriangleBytes * countInHeader(content);
}

Expected<RawMesh> readStlAscii(std::string_view content, Diagnostics&) {
  RawMesh raw;
  raw.shared_corners = true;
  SharedCorners corners;
  TextCursor cursor(content);
  bool in_solid = false;
  while (true) {
    const std::string_view word = cursor.nextWordOfText();
    if (word.empty()) break;
    if (!in_solid && sameButForCase(word, "solid")) {
      const std::string_view name = cursor.restOfLine();
      if (raw.mesh.triangles.empty()) raw.metres_per_unit = statedUnit(name);
      in_solid = true;
    } else if (in_solid && sameButForCase(word, "facet")) {
      const auto triangle = readFacet(cursor, corners);
      HAPTICELL_TRY(triangle);
      raw.mesh.triangles.push_back(*triangle);
    } else if (in_solid && sameButForCase(word, "endsolid")) {
      cursor.restOfLine();
      in_solid = false;
    } else {
      return makeError(wrongWord(cursor, word, in_solid ? Text("'facet' or 'endsolid'") : Text("'solid'")));
    }
  }
  if (in_solid) return makeError(wrongWord(cursor, {}, Text("'facet' or 'endsolid'")));
  raw.mesh.vertices = corners.take();
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
  raw.shared_corners = true;
  // Triangles for a thread to be worth it. Half, twice: no effect.
  constexpr std::size_t kLeast = 50'000;
  std::vector<BinaryRange> ranges(geometry::rangesOf(count, kLeast));
  raw.mesh.triangles.resize(count);
  geometry::inRanges(count, ranges.size(), [&](std::size_t range, std::size_t begin, std::size_t end) {
    ranges[range].triangles = std::span(raw.mesh.triangles).subspan(begin, end - begin);
    ranges[range].read(content, begin, end);
  });
  for (BinaryRange& range : ranges) {
    if (range.unusable) {
      return makeError(unusableCoordinate(triangleOf(range.unusable->first, count), range.unusable->second));
    }
    if (&range != &ranges.front()) append(ranges.front().corners, range, kLeast, &range == &ranges.back());
  }
  raw.mesh.vertices = ranges.front().corners.take();
  return raw;
}

}  // namespace hapticell::workcell
