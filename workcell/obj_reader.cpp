// SPDX-License-Identifier: Apache-2.0
// Wavefront OBJ after the specification of Advanced Visualizer, appendix B1: vertices and polygons, nothing of its
// curves.
#include <array>
#include <map>

#include "workcell/mesh_formats.h"
#include "workcell/polygon_soup.h"
#include "workcell/text_cursor.h"

namespace hapticell::workcell {

namespace {

/// Statements that say nothing about the shape's polygons, or only how they look.
constexpr std::array<std::string_view, 16> kIgnored = {"vn",     "vt",     "vp",     "o",       "g", "s",
                                                       "mg",     "usemtl", "mtllib", "l",       "p", "lod",
                                                       "usemap", "maplib", "bevel",  "c_interp"};

bool isIgnored(std::string_view keyword) {
  for (std::string_view word : kIgnored) {
    if (word == keyword) return true;
  }
  return keyword.starts_with('#');
}

class ObjReader {
 public:
  explicit ObjReader(std::string_view content) : cursor_(content, TextCursor::Continuation::kBackslash) {}

  Expected<PolygonSoup> read(Diagnostics& diagnostics) {
    while (cursor_.nextLine()) {
      const std::string_view keyword = cursor_.nextWord();
      Expected<void> done;
      if (keyword == "v") {
        done = readVertex();
      } else if (keyword == "f" || keyword == "fo") {
        done = readFace();
      } else if (!keyword.empty() && !isIgnored(keyword)) {
        ++unknown_[std::string(keyword.substr(0, 20))];
        if (unknown_.size() > 50) return makeError({"", cursor_.place(), quoted(keyword), "an OBJ statement", ""});
      }
      if (!done) return makeError(done.error());
    }
    if (farthest_ > soup_.vertices.size()) {
      return makeError(outOfRange("line " + std::to_string(farthest_line_), std::to_string(farthest_)));
    }
    for (const auto& [keyword, lines] : unknown_) {
      diagnostics.warn(std::to_string(lines) + " lines beginning with " + quoted(keyword) + " were not understood");
    }
    return std::move(soup_);
  }

 private:
  Expected<void> readVertex() {
    dvec3 point;
    for (int axis = 0; axis < 3; ++axis) {
      const std::string place = cursor_.place();
      const std::string_view word = cursor_.nextWord();
      const std::optional<double> value = parseNumber(word);
      if (!value) {
        return makeError({"", place,
                          word.empty() ? "a vertex with fewer than three coordinates" : "vertex with " + quoted(word),
                          "three numbers with '.' as decimal point", ""});
      }
      point[axis] = *value;
    }
    if (!isUsable(point)) return makeError(unusableCoordinate(cursor_.place(), "vertex", point));
    soup_.vertices.push_back(point);  // A weight or a colour may follow; neither changes the shape.
    return {};
  }

  Expected<void> readFace() {
    const std::string place = cursor_.place();
    for (std::string_view word = cursor_.nextWord(); !word.empty(); word = cursor_.nextWord()) {
      if (word.starts_with('#')) break;
      const std::string_view vertex = word.substr(0, word.find('/'));
      const std::optional<std::int64_t> index = parseInteger(vertex);
      if (!index || *index == 0) {
        return makeError(
            {"", place, "face corner " + quoted(word), "a vertex number (1 is the first, -1 the last so far)", ""});
      }
      const auto known = static_cast<std::int64_t>(soup_.vertices.size());
      const std::int64_t absolute = *index < 0 ? known + *index : *index - 1;
      if (absolute < 0 || absolute > 0xFFFFFFFEll) return makeError(outOfRange(place, std::string(vertex)));
      if (absolute >= known && static_cast<std::uint64_t>(absolute) + 1 > farthest_) {
        farthest_ = static_cast<std::uint64_t>(absolute) + 1;
        farthest_line_ = cursor_.lineNumber();
      }
      soup_.corners.push_back(static_cast<std::uint32_t>(absolute));
    }
    soup_.closePolygon();
    return {};
  }

  Error outOfRange(const std::string& place, const std::string& index) const {
    return {"", place, "vertex number " + quoted(index),
            "one of the " + std::to_string(soup_.vertices.size()) + " vertices",
            "The file is damaged: export it again."};
  }

  TextCursor cursor_;
  PolygonSoup soup_;
  std::map<std::string, std::uint64_t> unknown_;
  std::uint64_t farthest_ = 0;  // Vertex number named before its vertex came, and where.
  std::size_t farthest_line_ = 0;
};

}  // namespace

Expected<geometry::TriangleMesh> readObj(std::string_view content, Diagnostics& diagnostics) {
  Expected<PolygonSoup> soup = ObjReader(content).read(diagnostics);
  if (!soup) return makeError(soup.error());
  return triangulate(std::move(*soup), diagnostics);
}

}  // namespace hapticell::workcell
