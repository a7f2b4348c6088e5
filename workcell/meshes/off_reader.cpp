// SPDX-License-Identifier: Apache-2.0
// Object File Format (Geomview): OFF with optional texture coordinates, colours and normals on the vertices, as text.
#include "workcell/meshes/color_channels.h"
#include "workcell/meshes/mesh_formats.h"
#include "workcell/meshes/polygon_soup.h"
#include "workcell/meshes/unit_statement.h"
#include "workcell/text/text_cursor.h"

namespace hapticell::workcell {

namespace {

constexpr char kTruncated[] = HAPTICELL_TRANSLATED("The file is truncated: export it again.");

struct Counts {
  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;
};

class OffReader {
 public:
  explicit OffReader(std::string_view content) : cursor_(content) {}

  Expected<RawMesh> read(Diagnostics& diagnostics) {
    Expected<Counts> counts = readHeader();
    HAPTICELL_TRY(counts);
    soup_.vertices.reserve(counts->vertices);
    soup_.ends.reserve(counts->faces);
    for (std::uint64_t k = 0; k < counts->vertices; ++k) {
      if (!nextFilledLine())
        return makeError(ended(Text("vertex %1 of %2", k + 1, counts->vertices), Text("a line for each vertex")));
      HAPTICELL_TRY(readVertex());
    }
    for (std::uint64_t k = 0; k < counts->faces; ++k) {
      if (!nextFilledLine())
        return makeError(ended(Text("face %1 of %2", k + 1, counts->faces), Text("a line for each face")));
      HAPTICELL_TRY(readFace());
    }
    readTail();
    vertex_colors_.report(ColorChannels::Of::kVertices, diagnostics);
    face_colors_.report(ColorChannels::Of::kFaces, diagnostics);
    soup_.vertex_colors = std::move(vertex_colors_).take(soup_.vertices.size(), std::nullopt);
    soup_.face_colors = std::move(face_colors_).take(soup_.ends.size(), std::nullopt);
    if (from_map_ > 0) {
      diagnostics.warn(Text("%1 faces have a colour by index in a colour map; it was left out", from_map_));
    }
    Expected<RawMesh> raw = triangulate(std::move(soup_), diagnostics);
    if (raw) raw->metres_per_unit = metres_per_unit_;
    return raw;
  }

 private:
  /// Goes to the next line with a word in it, which becomes word_. Comments begin with '#'.
  bool nextFilledLine() {
    while (cursor_.nextLine()) {
      word_ = nextWord();
      if (!word_.empty()) return true;
    }
    return false;
  }

  std::string_view nextWord() {
    const std::string_view word = cursor_.nextWord();
    if (!word.starts_with('#')) return word;
    const std::string_view rest = cursor_.restOfLine();
    if (!metres_per_unit_ && (soup_.vertices.empty() || at_tail_)) {
      metres_per_unit_ = statedUnit({word.data(), static_cast<std::size_t>(rest.data() + rest.size() - word.data())});
    }
    return {};
  }

  /// Comments behind the last face: the unit may be stated there, where it disturbs no other reader.
  void readTail() {
    // Lines behind the last face where a unit is looked for. Half, twice: no effect on our files, which have it in the
    // first.
    constexpr int kMostLines = 8;
    at_tail_ = true;
    for (int k = 0; k < kMostLines && cursor_.nextLine(); ++k) nextWord();
  }

  /// A colour of three or four channels at the end of the line; the fourth, how opaque it is, is not used. Gives how
  /// many numbers there were.
  std::size_t readColor(ColorChannels& colors, std::size_t index) {
    std::array<double, 3> channels{};
    std::size_t count = 0;
    for (std::string_view word = nextWord(); !word.empty(); word = nextWord(), ++count) {
      const std::optional<double> value = parseNumber(word);
      if (!value) break;
      if (count < 3) channels[count] = *value;
    }
    if (count >= 3) colors.set(index, channels);
    return count;
  }

  Expected<Counts> readHeader() {
    if (!nextFilledLine()) return makeError({.found = "the file is empty", .expected = "'OFF'"});
    if (!word_.ends_with("OFF") || word_.find_first_of("4n") != std::string_view::npos) {
      return makeError({.place = cursor_.place(),
                        .found = inQuotes(word_),
                        .expected = "'OFF', 'COFF' or 'NOFF' in three dimensions"});
    }
    has_colors_ = word_.find('C') != std::string_view::npos;
    has_normals_ = word_.find('N') != std::string_view::npos;
    std::string_view word = nextWord();
    if (word == "BINARY") {
      return makeError({.place = cursor_.place(),
                        .found = "a binary OFF file",
                        .expected = "OFF as text",
                        .fix = "Save it as text or as PLY."});
    }
    if (word.empty()) {
      if (!nextFilledLine())
        return makeError({.place = cursor_.place(),
                          .found = "the file ends too early",
                          .expected = "the numbers of vertices, faces and edges",
                          .fix = kTruncated});
      word = word_;
    }
    const std::optional<std::int64_t> vertices = parseInteger(word), faces = parseInteger(nextWord());
    if (!vertices || !faces || *vertices < 0 || *faces < 0) {
      return makeError({.place = cursor_.place(),
                        .found = "the numbers are missing",
                        .expected = "the numbers of vertices, faces and edges"});
    }
    // The shortest vertex or face line, "0 0 0" or "0", takes 6 and 2 bytes.
    const std::uint64_t room = cursor_.bytesLeft() + 1;
    const Counts counts{static_cast<std::uint64_t>(*vertices), static_cast<std::uint64_t>(*faces)};
    if (counts.vertices > room / 6 || counts.faces > room / 2) {
      return makeError({.place = cursor_.place(),
                        .found = Text("%1 vertices and %2 faces", counts.vertices, counts.faces),
                        .expected = "no more than the file size allows",
                        .fix = kTruncated});
    }
    return counts;
  }

  Expected<void> readVertex() {
    dvec3 point;
    for (int axis = 0; axis < 3; ++axis) {
      const std::optional<double> value = parseNumber(word_);
      if (!value) {
        return makeError({.place = cursor_.place(),
                          .found = word_.empty() ? Text("a vertex with fewer than three coordinates") : inQuotes(word_),
                          .expected = "three numbers with '.' as decimal point"});
      }
      point[axis] = *value;
      if (axis < 2) word_ = nextWord();
    }
    if (!isUsable(point)) return makeError(unusableCoordinate(cursor_.place(), point));
    soup_.vertices.push_back(point);
    for (int k = 0; has_normals_ && k < 3; ++k) nextWord();
    if (has_colors_) readColor(vertex_colors_, soup_.vertices.size() - 1);
    return {};
  }

  Expected<void> readFace() {
    const std::optional<std::int64_t> corners = parseInteger(word_);
    if (!corners || *corners < 0) {
      return makeError(
          {.place = cursor_.place(), .found = inQuotes(word_), .expected = "the number of the face's corners"});
    }
    for (std::int64_t k = 0; k < *corners; ++k) {
      const std::string_view word = nextWord();
      const std::optional<std::int64_t> index = parseInteger(word);
      if (!index || *index < 0 || static_cast<std::uint64_t>(*index) >= soup_.vertices.size()) {
        return makeError({.place = cursor_.place(),
                          .found = word.empty() ? Text("a face with fewer than three vertices")
                                                : Text("face corner %1", inQuotes(word)),
                          .expected = Text("a vertex number below %1", soup_.vertices.size())});
      }
      soup_.corners.push_back(static_cast<std::uint32_t>(*index));
    }
    soup_.closePolygon();
    if (readColor(face_colors_, soup_.ends.size() - 1) == 1) ++from_map_;
    return {};
  }

  static Error ended(Text place, Text expected) {
    return {.place = std::move(place),
            .found = "the file ends too early",
            .expected = std::move(expected),
            .fix = kTruncated};
  }

  TextCursor cursor_;
  std::string_view word_;
  PolygonSoup soup_;
  bool has_colors_ = false, has_normals_ = false;  // On the vertices.
  ColorChannels vertex_colors_, face_colors_;
  std::uint64_t from_map_ = 0;
  bool at_tail_ = false;
  std::optional<double> metres_per_unit_;
};

}  // namespace

Expected<RawMesh> readOff(std::string_view content, Diagnostics& diagnostics) {
  return OffReader(content).read(diagnostics);
}

}  // namespace hapticell::workcell
