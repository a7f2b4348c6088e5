// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <utility>

#include "workcell/meshes/byte_source.h"
#include "workcell/meshes/color_channels.h"
#include "workcell/meshes/mesh_formats.h"
#include "workcell/meshes/ply_header.h"
#include "workcell/meshes/polygon_soup.h"
#include "workcell/text/text_cursor.h"

namespace hapticell::workcell {

namespace {

/// The data behind the header as a row of numbers, whatever their encoding. Each fits a double exactly.
class NumberSource {
 public:
  NumberSource(std::string_view data, PlyEncoding encoding)
      : data_(data), encoding_(encoding), words_(encoding == PlyEncoding::kAscii ? data : std::string_view{}) {}

  /// Nothing at the end of the data; NaN for a word that is no number.
  std::optional<double> next(PlyType type) {
    if (encoding_ == PlyEncoding::kAscii) {
      const std::string_view word = words_.nextWordOfText();
      if (word.empty()) return std::nullopt;
      return parseNumber(word).value_or(std::nan(""));
    }
    const std::size_t size = sizeOf(type);
    if (data_.size() < size) return std::nullopt;
    const double value = number(type);
    data_.remove_prefix(size);
    return value;
  }

  std::size_t bytesLeft() const { return encoding_ == PlyEncoding::kAscii ? words_.bytesLeft() : data_.size(); }
  /// "line 12" in text; empty in binary data.
  Text place(std::size_t header_lines) const {
    return encoding_ == PlyEncoding::kAscii ? Text("line %1", header_lines + words_.lineNumber()) : Text();
  }

 private:
  double number(PlyType type) const {
    const std::endian order = encoding_ == PlyEncoding::kBigEndian ? std::endian::big : std::endian::little;
    switch (type) {
      case PlyType::kInt8:
        return readNumber<std::int8_t>(data_, order);
      case PlyType::kUint8:
        return readNumber<std::uint8_t>(data_, order);
      case PlyType::kInt16:
        return readNumber<std::int16_t>(data_, order);
      case PlyType::kUint16:
        return readNumber<std::uint16_t>(data_, order);
      case PlyType::kInt32:
        return readNumber<std::int32_t>(data_, order);
      case PlyType::kUint32:
        return readNumber<std::uint32_t>(data_, order);
      case PlyType::kFloat32:
        return readNumber<float>(data_, order);
      case PlyType::kFloat64:
        break;
    }
    return readNumber<double>(data_, order);
  }

  std::string_view data_;
  PlyEncoding encoding_;
  TextCursor words_;
};

/// What a value of an element is used for.
enum class PlyRole { kNone, kX, kY, kZ, kRed, kGreen, kBlue };

PlyRole roleOf(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, PlyRole>, 12> kRoles = {{{"x", PlyRole::kX},
                                                                            {"y", PlyRole::kY},
                                                                            {"z", PlyRole::kZ},
                                                                            {"red", PlyRole::kRed},
                                                                            {"green", PlyRole::kGreen},
                                                                            {"blue", PlyRole::kBlue},
                                                                            {"r", PlyRole::kRed},
                                                                            {"g", PlyRole::kGreen},
                                                                            {"b", PlyRole::kBlue},
                                                                            {"diffuse_red", PlyRole::kRed},
                                                                            {"diffuse_green", PlyRole::kGreen},
                                                                            {"diffuse_blue", PlyRole::kBlue}}};
  for (const auto& [known, role] : kRoles) {
    if (known == name) return role;
  }
  return PlyRole::kNone;
}

/// The number that stands for a full channel: fixed for whole numbers of a byte or two, else as the file's colours
/// show.
std::optional<double> fullChannel(PlyType type) {
  if (type == PlyType::kUint8) return 255.0;
  if (type == PlyType::kUint16) return 65535.0;
  return std::nullopt;
}

/// An element's properties by what they are used for.
struct PlyRoles {
  std::vector<PlyRole> of;
  bool colored = false;  ///< All three channels are there.
  std::optional<double> full;
};

PlyRoles rolesOf(const PlyElement& element) {
  PlyRoles roles;
  int channels = 0;
  for (const PlyProperty& property : element.properties) {
    roles.of.push_back(property.is_list ? PlyRole::kNone : roleOf(property.name));
    if (roles.of.back() < PlyRole::kRed) continue;
    ++channels;
    roles.full = fullChannel(property.type);
  }
  roles.colored = channels >= 3;
  return roles;
}

class PlyReader {
 public:
  PlyReader(const PlyHeader& header, std::string_view content)
      : header_(header), source_(content.substr(header.bytes), header.encoding) {}

  Expected<RawMesh> read(Diagnostics& diagnostics) {
    HAPTICELL_TRY(checkElements());
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;
      roles_ = rolesOf(element);
      ColorChannels colors;
      for (std::uint64_t index = 0; index < element.count; ++index) {
        HAPTICELL_TRY(readOne(element, index, colors));
      }
      keepColors(element, std::move(colors), diagnostics);
      const bool known = element.name == "vertex" || element.name == "face" || element.name == "tristrips";
      if (!known) diagnostics.warn(Text("%1 elements %2 were not used", element.count, inQuotes(element.name)));
    }
    Expected<RawMesh> raw = triangulate(std::move(soup_), diagnostics);
    if (raw) raw->metres_per_unit = header_.metres_per_unit;
    return raw;
  }

 private:
  void keepColors(const PlyElement& element, ColorChannels colors, Diagnostics& diagnostics) {
    const bool vertices = element.name == "vertex";
    colors.report(vertices ? ColorChannels::Of::kVertices : ColorChannels::Of::kFaces, diagnostics);
    if (vertices) {
      soup_.vertex_colors = std::move(colors).take(soup_.vertices.size(), roles_.full);
    } else if (element.name == "face") {
      soup_.face_colors = std::move(colors).take(soup_.ends.size(), roles_.full);
    }
  }

  Expected<void> checkElements() const {
    bool vertices = false, faces = false;
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex")
        vertices = element.find("x") >= 0 && element.find("y") >= 0 && element.find("z") >= 0;
      if (element.name == "face" || element.name == "tristrips") faces = true;
    }
    if (!vertices)
      return makeError(
          {.place = "header", .found = "the file has no vertices", .expected = "an element 'vertex' with x, y and z"});
    if (!faces) {
      return makeError({.place = "header",
                        .found = "points without faces",
                        .expected = "an element 'face'",
                        .fix = "First create a surface from the point cloud."});
    }
    return {};
  }

  Expected<void> readOne(const PlyElement& element, std::uint64_t index, ColorChannels& colors) {
    std::array<double, 7> values{};  // By role.
    const std::size_t polygons = soup_.ends.size();
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const PlyProperty& property = element.properties[k];
      if (property.is_list) {
        if (auto list = readList(element, property, index); !list) return list;
        continue;
      }
      const std::optional<double> value = source_.next(property.type);
      if (!value) return makeError(ended(element, index));
      values[static_cast<std::size_t>(roles_.of[k])] = *value;
    }
    const bool vertex = element.name == "vertex";
    if (roles_.colored && vertex) colors.set(index, {values[4], values[5], values[6]});
    // A face of several lists, or of none, is not told apart from others: its colour belongs to the one it made.
    if (roles_.colored && element.name == "face" && soup_.ends.size() > polygons)
      colors.set(polygons, {values[4], values[5], values[6]});
    if (!vertex) return {};
    const dvec3 point(values[1], values[2], values[3]);
    if (!isUsable(point)) return makeError(unusableCoordinate(placeOf(element, index), point));
    soup_.vertices.push_back(point);
    return {};
  }

  Expected<void> readList(const PlyElement& element, const PlyProperty& property, std::uint64_t index) {
    const std::optional<double> length = source_.next(property.count_type);
    if (!length) return makeError(ended(element, index));
    const bool believable = *length >= 0.0 && *length == std::floor(*length) && *length <= 4294967295.0;
    const std::size_t least = header_.encoding == PlyEncoding::kAscii ? 1 : sizeOf(property.type);
    if (!believable || static_cast<std::uint64_t>(*length) > source_.bytesLeft() / least) {
      return makeError({.place = placeOf(element, index),
                        .found = "a list that is longer than the file",
                        .expected = "a shorter list",
                        .fix = "The file is damaged: export it again."});
    }
    const bool corners = property.name == "vertex_indices" || property.name == "vertex_index";
    const bool face = element.name == "face" && corners, strip = element.name == "tristrips" && corners;
    strip_.clear();
    for (std::uint64_t k = 0; k < static_cast<std::uint64_t>(*length); ++k) {
      const std::optional<double> value = source_.next(property.type);
      if (!value) return makeError(ended(element, index));
      if (!face && !strip) continue;
      const bool restart = strip && *value == -1.0;
      if (!restart && !(*value >= 0.0 && *value == std::floor(*value) && *value <= 4294967294.0)) {
        return makeError({.place = placeOf(element, index),
                          .found = "a corner that is not a vertex number",
                          .expected = "0 or more"});
      }
      if (face) soup_.corners.push_back(static_cast<std::uint32_t>(*value));
      if (strip) extendStrip(restart, restart ? 0 : static_cast<std::uint32_t>(*value));
    }
    if (face) soup_.closePolygon();
    return {};
  }

  /// Every vertex of a strip after its second makes a triangle; each other one is turned round.
  void extendStrip(bool restart, std::uint32_t vertex) {
    if (restart) {
      strip_.clear();
      return;
    }
    strip_.push_back(vertex);
    const std::size_t n = strip_.size();
    if (n < 3) return;
    const bool turned = n % 2 == 0;
    soup_.corners.insert(soup_.corners.end(), {strip_[n - (turned ? 2 : 3)], strip_[n - (turned ? 3 : 2)], vertex});
    soup_.closePolygon();
  }

  Text placeOf(const PlyElement& element, std::uint64_t index) const {
    const Text one("%1 %2 of %3", element.name, index + 1, element.count);
    const Text line = source_.place(header_.lines);
    return line.empty() ? one : Text("%1, %2", line, one);
  }

  Error ended(const PlyElement& element, std::uint64_t index) const {
    return {.place = placeOf(element, index),
            .found = "the file ends too early",
            .expected = Text("%1 elements %2", element.count, inQuotes(element.name)),
            .fix = "The file is truncated: export it again."};
  }

  const PlyHeader& header_;
  NumberSource source_;
  PolygonSoup soup_;
  PlyRoles roles_;  // Of the element that is being read.
  std::vector<std::uint32_t> strip_;
};

}  // namespace

Expected<RawMesh> readPly(std::string_view content, Diagnostics& diagnostics) {
  const Expected<PlyHeader> header = readPlyHeader(content);
  HAPTICELL_TRY(header);
  return PlyReader(*header, content).read(diagnostics);
}

}  // namespace hapticell::workcell
