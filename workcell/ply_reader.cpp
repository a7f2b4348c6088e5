// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <memory>

#include "workcell/byte_source.h"
#include "workcell/mesh_formats.h"
#include "workcell/ply_header.h"
#include "workcell/polygon_soup.h"
#include "workcell/text_cursor.h"

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
  std::string place(std::size_t header_lines) const {
    return encoding_ == PlyEncoding::kAscii ? "line " + std::to_string(header_lines + words_.lineNumber()) : "";
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

class PlyReader {
 public:
  PlyReader(const PlyHeader& header, std::string_view content)
      : header_(header), source_(content.substr(header.bytes), header.encoding) {}

  Expected<PolygonSoup> read(Diagnostics& diagnostics) {
    if (auto complete = checkElements(); !complete) return makeError(complete.error());
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;
      for (std::uint64_t index = 0; index < element.count; ++index) {
        if (auto done = readOne(element, index); !done) return makeError(done.error());
      }
      const bool known = element.name == "vertex" || element.name == "face" || element.name == "tristrips";
      if (!known)
        diagnostics.warn("the " + std::to_string(element.count) + " elements " + quoted(element.name) +
                         " were not used");
    }
    return std::move(soup_);
  }

 private:
  Expected<void> checkElements() const {
    bool vertices = false, faces = false;
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex")
        vertices = element.find("x") >= 0 && element.find("y") >= 0 && element.find("z") >= 0;
      if (element.name == "face" || element.name == "tristrips") faces = true;
    }
    if (!vertices) return makeError({"", "header", "no vertices", "an element 'vertex' with x, y and z", ""});
    if (!faces) {
      return makeError(
          {"", "header", "points without faces", "an element 'face'", "Make a surface of the point cloud first."});
    }
    return {};
  }

  Expected<void> readOne(const PlyElement& element, std::uint64_t index) {
    dvec3 point(0.0);
    for (const PlyProperty& property : element.properties) {
      if (property.is_list) {
        if (auto list = readList(element, property, index); !list) return list;
        continue;
      }
      const std::optional<double> value = source_.next(property.type);
      if (!value) return makeError(ended(element, index));
      if (property.name == "x") point.x = *value;
      if (property.name == "y") point.y = *value;
      if (property.name == "z") point.z = *value;
    }
    if (element.name != "vertex") return {};
    if (!isUsable(point)) return makeError(unusableCoordinate(placeOf(element, index), "vertex", point));
    soup_.vertices.push_back(point);
    return {};
  }

  Expected<void> readList(const PlyElement& element, const PlyProperty& property, std::uint64_t index) {
    const std::optional<double> length = source_.next(property.count_type);
    if (!length) return makeError(ended(element, index));
    const bool believable = *length >= 0.0 && *length == std::floor(*length) && *length <= 4294967295.0;
    const std::size_t least = header_.encoding == PlyEncoding::kAscii ? 1 : sizeOf(property.type);
    if (!believable || static_cast<std::uint64_t>(*length) > source_.bytesLeft() / least) {
      return makeError({"", placeOf(element, index), "a list whose length the file cannot hold", "a shorter list",
                        "The file is damaged: export it again."});
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
        return makeError({"", placeOf(element, index), "a corner that is no vertex number", "0 or more", ""});
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

  std::string placeOf(const PlyElement& element, std::uint64_t index) const {
    const std::string line = source_.place(header_.lines);
    return (line.empty() ? "" : line + ", ") + element.name + " " + std::to_string(index + 1) + " of " +
           std::to_string(element.count);
  }

  Error ended(const PlyElement& element, std::uint64_t index) const {
    return {"", placeOf(element, index), "the file ends",
            std::to_string(element.count) + " elements " + quoted(element.name),
            "The file is truncated: export it again."};
  }

  const PlyHeader& header_;
  NumberSource source_;
  PolygonSoup soup_;
  std::vector<std::uint32_t> strip_;
};

}  // namespace

Expected<geometry::TriangleMesh> readPly(std::string_view content, Diagnostics& diagnostics) {
  const Expected<PlyHeader> header = readPlyHeader(content);
  if (!header) return makeError(header.error());
  Expected<PolygonSoup> soup = PlyReader(*header, content).read(diagnostics);
  if (!soup) return makeError(soup.error());
  return triangulate(std::move(*soup), diagnostics);
}

}  // namespace hapticell::workcell
