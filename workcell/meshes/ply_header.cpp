// SPDX-License-Identifier: Apache-2.0
#include "workcell/meshes/ply_header.h"

#include <array>
#include <optional>
#include <utility>

#include "workcell/meshes/unit_statement.h"
#include "workcell/text/text_cursor.h"

namespace hapticell::workcell {

namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> kTypes = {{{"char", PlyType::kInt8},
                                                                          {"int8", PlyType::kInt8},
                                                                          {"uchar", PlyType::kUint8},
                                                                          {"uint8", PlyType::kUint8},
                                                                          {"short", PlyType::kInt16},
                                                                          {"int16", PlyType::kInt16},
                                                                          {"ushort", PlyType::kUint16},
                                                                          {"uint16", PlyType::kUint16},
                                                                          {"int", PlyType::kInt32},
                                                                          {"int32", PlyType::kInt32},
                                                                          {"uint", PlyType::kUint32},
                                                                          {"uint32", PlyType::kUint32},
                                                                          {"float", PlyType::kFloat32},
                                                                          {"float32", PlyType::kFloat32},
                                                                          {"double", PlyType::kFloat64},
                                                                          {"float64", PlyType::kFloat64}}};

std::optional<PlyType> findType(std::string_view name) {
  for (const auto& [known, type] : kTypes) {
    if (known == name) return type;
  }
  return std::nullopt;
}

/// Bytes that one element takes at least.
std::uint64_t leastBytes(const PlyElement& element, PlyEncoding encoding) {
  std::uint64_t bytes = 0;
  for (const PlyProperty& property : element.properties) {
    const auto type = property.is_list ? property.count_type : property.type;
    bytes += encoding == PlyEncoding::kAscii ? 2 : sizeOf(type);
  }
  return bytes;
}

class HeaderReader {
 public:
  explicit HeaderReader(std::string_view content) : content_(content) {}

  Expected<PlyHeader> read() {
    HAPTICELL_TRY(readFirstLines());
    while (true) {
      if (!nextLine()) {
        return makeError({.place = place(),
                          .found = "the file ends too early",
                          .expected = "'end_header'",
                          .fix = "The file is truncated: export it again."});
      }
      TextCursor words(line_);
      words.nextLine();
      const std::string_view keyword = words.nextWord();
      if (keyword == "end_header") break;
      if (readComment() || keyword.empty()) continue;
      Expected<void> done;
      if (keyword == "element") {
        done = readElement(words);
      } else if (keyword == "property") {
        done = readProperty(words);
      } else {
        done = makeError({.place = place(),
                          .found = inQuotes(keyword),
                          .expected = "'element', 'property', 'comment' or 'end_header'"});
      }
      HAPTICELL_TRY(done);
    }
    header_.bytes = next_;
    header_.lines = line_number_;
    HAPTICELL_TRY(checkCounts());
    return std::move(header_);
  }

 private:
  /// Lines end as the first one does: a byte of binary data behind "end_header\r" must not be taken for its end.
  bool nextLine() {
    if (next_ >= content_.size()) return false;
    if (line_end_.empty()) {
      const std::size_t end = std::min(content_.find_first_of("\r\n"), content_.size());
      line_end_ = content_.substr(end, content_.substr(end, 2) == "\r\n" ? 2 : 1);
      if (line_end_.empty()) return false;
    }
    const std::size_t end = content_.find(line_end_, next_);
    if (end == std::string_view::npos) return false;
    line_ = content_.substr(next_, end - next_);
    next_ = end + line_end_.size();
    ++line_number_;
    return true;
  }

  Text place() const { return Text("line %1", line_number_); }

  /// True where the line is a comment.
  bool readComment() {
    if (!line_.starts_with("comment") && !line_.starts_with("obj_info")) return false;
    if (!header_.metres_per_unit) header_.metres_per_unit = statedUnit(line_);
    return true;
  }

  Expected<void> readFirstLines() {
    if (!nextLine() || line_.substr(0, 3) != "ply")
      return makeError({.place = Text("line %1", 1), .found = "'ply' is missing", .expected = "'ply'"});
    do {
      if (!nextLine())
        return makeError({.place = place(), .found = "the file ends too early", .expected = "a line 'format'"});
    } while (readComment());
    TextCursor words(line_);
    words.nextLine();
    const std::string_view keyword = words.nextWord(), encoding = words.nextWord();
    if (keyword == "format" && encoding == "ascii") {
      header_.encoding = PlyEncoding::kAscii;
    } else if (keyword == "format" && encoding == "binary_little_endian") {
      header_.encoding = PlyEncoding::kLittleEndian;
    } else if (keyword == "format" && encoding == "binary_big_endian") {
      header_.encoding = PlyEncoding::kBigEndian;
    } else {
      return makeError({.place = place(),
                        .found = inQuotes(line_),
                        .expected = "'format' ascii, binary_little_endian or binary_big_endian"});
    }
    return {};
  }

  Expected<void> readElement(TextCursor& words) {
    PlyElement element;
    element.name = words.nextWord();
    element.line = line_number_;
    const std::string_view word = words.nextWord();
    const std::optional<std::int64_t> count = parseInteger(word);
    if (!count || *count < 0) {
      return makeError(
          {.place = place(), .found = inQuotes(word), .expected = Text("how many elements '%1' follow", element.name)});
    }
    for (const PlyElement& other : header_.elements) {
      if (other.name == element.name) {
        return makeError({.place = place(),
                          .found = Text("the element %1 twice", inQuotes(element.name)),
                          .expected = "each element once"});
      }
    }
    element.count = static_cast<std::uint64_t>(*count);
    header_.elements.push_back(std::move(element));
    return {};
  }

  Expected<void> readProperty(TextCursor& words) {
    if (header_.elements.empty())
      return makeError({.place = place(), .found = "a property", .expected = "an 'element' before it"});
    PlyProperty property;
    std::string_view type = words.nextWord();
    if (type == "list") {
      property.is_list = true;
      const std::string_view count = words.nextWord();
      const std::optional<PlyType> found = findType(count);
      if (!found || *found == PlyType::kFloat32 || *found == PlyType::kFloat64) {
        return makeError(
            {.place = place(), .found = inQuotes(count), .expected = "an integer type for the list's length"});
      }
      property.count_type = *found;
      type = words.nextWord();
    }
    const std::optional<PlyType> found = findType(type);
    if (!found)
      return makeError(
          {.place = place(), .found = inQuotes(type), .expected = "a PLY number type such as 'float' or 'uchar'"});
    property.type = *found;
    property.name = words.nextWord();
    header_.elements.back().properties.push_back(std::move(property));
    return {};
  }

  Expected<void> checkCounts() const {
    const std::uint64_t room = content_.size() - header_.bytes + 1;  // Text may end without a line end.
    for (const PlyElement& element : header_.elements) {
      const std::uint64_t least = leastBytes(element, header_.encoding);
      if (least == 0 || element.count <= room / least) continue;
      return makeError({.place = Text("line %1", element.line),
                        .found = Text("%1 elements %2", element.count, inQuotes(element.name)),
                        .expected = Text("at most %1, the number that fits the file size", room / least),
                        .fix = "The file is truncated: export it again."});
    }
    return {};
  }

  std::string_view content_;
  std::string_view line_end_;
  std::string_view line_;
  std::size_t next_ = 0;
  std::size_t line_number_ = 0;
  PlyHeader header_;
};

}  // namespace

std::size_t sizeOf(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
    case PlyType::kUint8:
      return 1;
    case PlyType::kInt16:
    case PlyType::kUint16:
      return 2;
    case PlyType::kInt32:
    case PlyType::kUint32:
    case PlyType::kFloat32:
      return 4;
    case PlyType::kFloat64:
      break;
  }
  return 8;
}

int PlyElement::find(std::string_view property) const {
  for (std::size_t k = 0; k < properties.size(); ++k) {
    if (properties[k].name == property) return static_cast<int>(k);
  }
  return -1;
}

Expected<PlyHeader> readPlyHeader(std::string_view content) {
  return HeaderReader(content).read();
}

}  // namespace hapticell::workcell
