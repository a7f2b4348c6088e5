// SPDX-License-Identifier: Apache-2.0
#include "importer/assimp_fault.h"

#include <cctype>
#include <charconv>
#include <cstdint>
#include <optional>

#include "geometry/system/text_case.h"
#include "importer/library_fault.h"

namespace hapticell::importer {

namespace {

namespace fs = std::filesystem;

constexpr char kAgain[] = HAPTICELL_TRANSLATED("Export it again.");
constexpr char kCopyAgain[] = HAPTICELL_TRANSLATED("The file is incomplete: copy or export it again.");

/// A 32-bit little-endian number, nothing beyond the end.
std::optional<std::uint32_t> numberAt(std::string_view bytes, std::size_t at) {
  if (bytes.size() < at + 4) return std::nullopt;
  std::uint32_t value = 0;
  for (std::size_t k = 4; k-- > 0;) value = (value << 8) | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

/// What is wrong with the length of the first chunk of a binary glTF 2.0 file.
std::optional<Error> firstChunkFault(std::string_view head) {
  const auto version = numberAt(head, 4), length = numberAt(head, 8), json = numberAt(head, 12);
  if (!json || *version != 2 || *json <= *length) return std::nullopt;
  return Error{.place = "first chunk",
               .found = Text("a length of %1 bytes", *json),
               .expected = Text("less than the file size of %1 bytes", *length),
               .fix = kAgain};
}

Text formatWord(const fs::path& file) {
  std::string extension = file.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  extension = upperCase(extension);
  if (extension == "GLTF" || extension == "GLB") return Text("a glTF file");
  if (extension == "DAE") return Text("a Collada file");
  if (extension.empty()) return Text("a file");
  return extension == "FBX" ? Text("an FBX file") : Text("a %1 file", extension);
}

/// Takes "(offset 0x1f)" out of a message; gives "byte 31".
Text placeIn(std::string& message) {
  constexpr std::string_view kBegin = "(offset 0x";
  const std::size_t at = message.find(kBegin);
  const std::size_t end = at == std::string::npos ? at : message.find(')', at);
  if (end == std::string::npos) return {};
  std::uint64_t offset = 0;
  const char* digits = message.data() + at + kBegin.size();
  if (std::from_chars(digits, message.data() + end, offset, 16).ptr != message.data() + end) return {};
  message.erase(at, end + 1 - at);
  return Text("byte %1", offset);
}

/// One line without blanks at its ends or two in a row, and without the file's path, which stands before it anyway.
std::string tidied(std::string message, const fs::path& file) {
  for (const std::string& path : {"\"" + file.string() + "\"", file.string()}) {
    for (std::size_t at = message.find(path); at != std::string::npos; at = message.find(path, at))
      message.replace(at, path.size(), "it");
  }
  std::string text;
  for (const char c : message) {
    const bool blank = std::isspace(static_cast<unsigned char>(c)) != 0;
    if (!blank) text += c;
    if (blank && !text.empty() && text.back() != ' ') text += ' ';
  }
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text;
}

}  // namespace

std::optional<Error> binaryGltfFault(const fs::path& file, std::string_view head) {
  std::error_code fault;
  const std::uintmax_t size = fs::file_size(file, fault);
  const auto version = numberAt(head, 4), length = numberAt(head, 8);
  if (fault || !version || !length || !numberAt(head, 12)) {
    return Error{.place = "header",
                 .found = Text("the file ends after %1 bytes", size),
                 .expected = "the 20 bytes of a binary glTF file's header and more",
                 .fix = kCopyAgain};
  }
  if (*version != 2 && *version != 1) {
    return Error{.place = "header", .found = Text("version %1", *version), .expected = "1 or 2", .fix = kAgain};
  }
  if (size < *length) {
    return Error{.place = "header",
                 .found = Text("the file ends after %1 bytes", size),
                 .expected = Text("%1 bytes", *length),
                 .fix = kCopyAgain};
  }
  return std::nullopt;
}

Error assimpFault(const fs::path& file, std::string_view head, std::string message) {
  if (head.starts_with("glTF")) {
    if (auto fault = binaryGltfFault(file, head)) return *fault;
    if (auto fault = firstChunkFault(head)) return *fault;
  }
  const Text expected("the content of %1", formatWord(file));
  if (message.find("No suitable reader") != std::string::npos || message.empty()) {
    return {.place = "beginning", .found = "content that is not of this format", .expected = expected, .fix = kAgain};
  }
  if (message.find("std::") != std::string::npos || message.find("sto") == 0 ||
      message.find("_M_") != std::string::npos || message.find("basic_string") != std::string::npos ||
      message == "map::at") {
    Error fault = libraryFault(message);
    fault.expected = Text("%1 in %2", fault.expected, formatWord(file));
    return fault;
  }
  Text place = placeIn(message);
  return {.place = std::move(place),
          .found = Text("the reader rejected the file (%1)", tidied(std::move(message), file)),
          .expected = expected,
          .fix = kAgain};
}

}  // namespace hapticell::importer
