// SPDX-License-Identifier: Apache-2.0
// Wavefront OBJ after the specification of Advanced Visualizer, appendix B1: vertices and polygons, nothing of its
// curves. Colours behind a vertex (x y z r g b) are an extension that scanners and MeshLab write.
#include <array>
#include <map>
#include <tuple>

#include "workcell/meshes/color_channels.h"
#include "workcell/meshes/mesh_formats.h"
#include "workcell/meshes/polygon_soup.h"
#include "workcell/meshes/unit_statement.h"
#include "workcell/text/text_cursor.h"

namespace hapticell::workcell {

namespace {

/// Statements that say nothing about the shape's polygons, or only how they look.
constexpr std::array<std::string_view, 13> kIgnored = {"vn", "vt",  "vp",     "s",      "mg",    "l",       "p",
                                                       "sp", "lod", "usemap", "maplib", "bevel", "c_interp"};

bool isIgnored(std::string_view keyword) {
  for (std::string_view word : kIgnored) {
    if (word == keyword) return true;
  }
  return false;
}

class ObjReader {
 public:
  explicit ObjReader(std::string_view content) : cursor_(content, TextCursor::Continuation::kBackslash) {}

  Expected<RawMesh> read(Diagnostics& diagnostics) {
    while (cursor_.nextLine()) {
      const std::string_view keyword = cursor_.nextWord();
      Expected<void> done;
      if (keyword == "v") {
        done = readVertex();
      } else if (keyword == "f" || keyword == "fo") {
        done = readFace();
      } else if (keyword.starts_with('#')) {
        readComment(keyword);
      } else if (!keyword.empty() && !readName(keyword) && !isIgnored(keyword)) {
        ++unknown_[std::string(keyword.substr(0, 20))];
        if (unknown_.size() > 50)
          return makeError({.place = cursor_.place(), .found = inQuotes(keyword), .expected = "an OBJ statement"});
      }
      HAPTICELL_TRY(done);
    }
    if (farthest_ > soup_.vertices.size()) {
      return makeError(outOfRange(Text("line %1", farthest_line_), std::to_string(farthest_)));
    }
    report(diagnostics);
    soup_.vertex_colors = std::move(vertex_colors_).take(soup_.vertices.size(), std::nullopt);
    if (labels_.size() == 1 && labels_[0] != MeshLabel{}) soup_.labels.assign(soup_.ends.size(), 0);
    Expected<RawMesh> raw = triangulate(std::move(soup_), diagnostics);
    if (!raw) return raw;
    raw->labels = std::move(labels_);
    raw->metres_per_unit = metres_per_unit_;
    raw->material_files = std::move(material_files_);
    return raw;
  }

 private:
  void readComment(std::string_view hash) {
    if (metres_per_unit_ || !soup_.ends.empty()) return;
    const std::string_view rest = cursor_.restOfLine();
    metres_per_unit_ = statedUnit({hash.data(), static_cast<std::size_t>(rest.data() + rest.size() - hash.data())});
  }

  /// Statements that name what follows. A name is all of the line: programs write blanks into it.
  bool readName(std::string_view keyword) {
    if (keyword == "o") {
      now_.object = cursor_.restOfLine();
      now_.object_number = ++objects_;
    } else if (keyword == "g") {
      now_.group = cursor_.restOfLine();
    } else if (keyword == "usemtl") {
      now_.material = cursor_.restOfLine();
    } else if (keyword == "mtllib") {
      // Guards memory: files of materials. Half, twice: no effect on real files.
      constexpr std::size_t kMost = 64;
      const std::string_view name = cursor_.restOfLine();
      if (!name.empty() && material_files_.size() < kMost) material_files_.emplace_back(name);
    } else {
      return false;
    }
    label_is_known_ = false;
    return true;
  }

  /// The label of what is named at present; as many as are used, and no label at all while nothing is named.
  void labelFace() {
    if (!label_is_known_) {
      label_is_known_ = true;
      const auto key = std::make_tuple(now_.object_number, now_.group, now_.material);
      const auto [known, is_new] = known_labels_.try_emplace(key, static_cast<std::uint32_t>(labels_.size()));
      if (is_new) labels_.push_back(now_);
      label_ = known->second;
    }
    // One label for all needs no list; the first face of another writes down the ones before it.
    if (label_ != 0 && soup_.labels.empty()) soup_.labels.assign(soup_.ends.size() - 1, 0);
    if (labels_.size() > 1) soup_.labels.push_back(label_);
  }

  void report(Diagnostics& diagnostics) const {
    for (const auto& [keyword, lines] : unknown_) {
      diagnostics.warn(Text("%1 lines that begin with %2 are not supported", lines, inQuotes(keyword)));
    }
    vertex_colors_.report(ColorChannels::Of::kVertices, diagnostics);
  }

  /// What stands behind the coordinates: nothing, a weight (1), a colour (3), a colour and how opaque it is (4).
  void readVertexColor() {
    std::array<double, 3> channels{};
    std::size_t count = 0;
    for (std::string_view word = cursor_.nextWord(); !word.empty() && count < 5; word = cursor_.nextWord(), ++count) {
      const std::optional<double> value = parseNumber(word);
      if (!value) break;
      if (count < 3) channels[count] = *value;
    }
    if (count == 3 || count == 4) vertex_colors_.set(soup_.vertices.size() - 1, channels);
  }

  Expected<void> readVertex() {
    dvec3 point;
    for (int axis = 0; axis < 3; ++axis) {
      const Text place = cursor_.place();
      const std::string_view word = cursor_.nextWord();
      const std::optional<double> value = parseNumber(word);
      if (!value) {
        return makeError({.place = place,
                          .found = word.empty() ? Text("a vertex with fewer than three coordinates")
                                                : Text("a vertex with %1", inQuotes(word)),
                          .expected = "three numbers with '.' as decimal point"});
      }
      point[axis] = *value;
    }
    if (!isUsable(point)) return makeError(unusableCoordinate(cursor_.place(), point));
    soup_.vertices.push_back(point);
    readVertexColor();
    return {};
  }

  Expected<void> readFace() {
    const Text place = cursor_.place();
    for (std::string_view word = cursor_.nextWord(); !word.empty(); word = cursor_.nextWord()) {
      if (word.starts_with('#')) break;
      const std::string_view vertex = word.substr(0, word.find('/'));
      const std::optional<std::int64_t> index = parseInteger(vertex);
      if (!index || *index == 0) {
        return makeError({.place = place,
                          .found = Text("face corner %1", inQuotes(word)),
                          .expected = "a vertex number (1: the first, -1: the last one so far)"});
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
    labelFace();
    return {};
  }

  Error outOfRange(const Text& place, const std::string& index) const {
    return {.place = place,
            .found = Text("vertex number %1", inQuotes(index)),
            .expected = Text("one of the %1 vertices", soup_.vertices.size()),
            .fix = "The file is damaged: export it again."};
  }

  TextCursor cursor_;
  PolygonSoup soup_;
  ColorChannels vertex_colors_;
  MeshLabel now_;
  std::size_t objects_ = 0;
  bool label_is_known_ = false;
  std::uint32_t label_ = 0;
  std::vector<MeshLabel> labels_;
  std::map<std::tuple<std::size_t, std::string, std::string>, std::uint32_t> known_labels_;
  std::vector<std::string> material_files_;
  std::optional<double> metres_per_unit_;
  std::map<std::string, std::uint64_t> unknown_;
  std::uint64_t farthest_ = 0;  // Vertex number named before its vertex came, and where.
  std::size_t farthest_line_ = 0;
};

}  // namespace

Expected<RawMesh> readObj(std::string_view content, Diagnostics& diagnostics) {
  return ObjReader(content).read(diagnostics);
}

}  // namespace hapticell::workcell
