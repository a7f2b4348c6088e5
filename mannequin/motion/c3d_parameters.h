// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/system/error.h"
#include "geometry/system/text_case.h"
#include "mannequin/motion/c3d_numbers.h"

namespace hapticell::mannequin {

/// Header and parameters of a C3D file, unchanged. Parameters end with their section, with a name without letters, or
/// with the first that points outside the section; one of an unknown kind is skipped, with a warning.
class C3dParameters {
 public:
  static constexpr std::size_t kBlock = 512;

  /// Errors: no C3D header, parameters beyond the end of the file, an unknown processor type.
  static Expected<C3dParameters> read(std::string_view bytes, const std::string& name);

  const C3dBytes& bytes() const { return bytes_; }
  /// The position of the first block after the parameters.
  std::size_t end() const { return end_; }
  /// The value of POINT:RATE and the like; empty if there is no such number. 16 bits are read as unsigned.
  std::optional<double> number(const char* name, std::size_t index = 0) const;
  std::vector<std::string> texts(const std::string& name) const;
  std::size_t placeOf(const char* name) const;
  const std::vector<Text>& warnings() const { return warnings_; }

 private:
  /// Position of a parameter in the file.
  struct Parameter {
    int type = 0;  ///< -1 letters, 1 bytes, 2 whole numbers, 4 real ones.
    std::vector<std::size_t> sizes;
    std::size_t at = 0, count = 1;
  };
  explicit C3dParameters(const C3dBytes& bytes) : bytes_(bytes) {}
  void readAll(std::size_t begin);
  std::optional<Parameter> parameterAt(std::size_t at) const;
  const Parameter* find(const std::string& name) const;

  C3dBytes bytes_;
  std::size_t end_ = 0;
  std::map<std::string, Parameter> parameters_;
  std::vector<Text> warnings_;
};

/// Without blanks and zeros at the ends; characters outside ASCII become question marks.
inline std::string printable(std::string_view text);

inline std::string printable(std::string_view text) {
  while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.remove_suffix(1);
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  std::string result(text.substr(0, text.find('\0')));
  while (!result.empty() && result.back() == ' ') result.pop_back();
  for (char& c : result) c = c >= ' ' && c < '\x7f' ? c : '?';
  return result;
}

inline Expected<C3dParameters> C3dParameters::read(std::string_view bytes, const std::string& name) {
  const auto fail = [&](std::size_t at, Text found, Text expected) {
    return makeError(
        {.file = name, .place = Text("byte %1", at), .found = std::move(found), .expected = std::move(expected)});
  };
  constexpr std::uint8_t kMark = 0x50;
  const C3dBytes raw(bytes, C3dProcessor::kIntel);
  if (!raw.holds(0, kBlock) || raw.byte(1) != kMark)
    return fail(1, Text("the C3D header is missing"), Text("a C3D file"));
  const std::size_t begin = (std::max<std::size_t>(*raw.byte(0), 1) - 1) * kBlock;
  const auto processor = raw.byte(begin + 3);
  if (begin == 0 || !processor)
    return fail(0, Text("the parameters are missing"), Text("a parameter block after the header"));
  if (*processor < 84 || *processor > 86) {
    return fail(begin + 3, Text("processor %1", *processor), Text("84 (Intel), 85 (DEC) or 86 (MIPS)"));
  }
  C3dParameters parameters(C3dBytes(bytes, static_cast<C3dProcessor>(*processor)));
  parameters.readAll(begin);
  return parameters;
}

/// Groups (negative number) and parameters in a list; each states the offset of the next.
inline void C3dParameters::readAll(std::size_t begin) {
  const std::size_t blocks = *bytes_.byte(begin + 2);
  end_ = begin + std::max<std::size_t>(blocks, 1) * kBlock;
  // If the section does not state its length, it ends with the file.
  const std::size_t last = std::min(blocks == 0 ? bytes_.size() : end_, bytes_.size());
  std::map<int, std::string> groups;
  std::map<std::pair<int, std::string>, Parameter> found;
  int unknown = 0;
  for (std::size_t at = begin + 4; at + 2 <= last;) {
    const std::size_t letters = static_cast<std::size_t>(std::abs(static_cast<std::int8_t>(*bytes_.byte(at))));
    const int group = static_cast<int>(static_cast<std::int8_t>(*bytes_.byte(at + 1)));
    const std::size_t link = at + 2 + letters;
    if (letters == 0 || link + 2 > last) break;
    const std::string name = upperCase(printable(bytes_.text(at + 2, letters)));
    const std::size_t step = *bytes_.word(link);
    const auto parameter = group > 0 ? parameterAt(link + 2) : std::nullopt;
    if (group < 0) {
      groups[-group] = name;
    } else if (parameter) {
      found[{group, name}] = *parameter;
    } else {
      ++unknown;
    }
    if (step == 0 || link + step >= last) break;
    at = link + step;
  }
  if (unknown > 0)
    warnings_.push_back(Text("%1 parameters are incomplete or of an unknown type; they are left out", unknown));
  for (auto& [key, parameter] : found) {
    if (const auto group = groups.find(key.first); group != groups.end())
      parameters_[group->second + ":" + key.second] = std::move(parameter);
  }
}

inline std::optional<C3dParameters::Parameter> C3dParameters::parameterAt(std::size_t at) const {
  const auto type = bytes_.byte(at), dimensions = bytes_.byte(at + 1);
  if (!type || !dimensions) return std::nullopt;
  Parameter parameter;
  parameter.type = static_cast<int>(static_cast<std::int8_t>(*type));
  if (parameter.type != -1 && parameter.type != 1 && parameter.type != 2 && parameter.type != 4) return std::nullopt;
  // Values of a parameter, 256^3: guards memory. Half, twice: no effect on real files.
  constexpr std::size_t kMostCounted = 1 << 24;
  for (std::size_t k = 0; k < *dimensions; ++k) {
    const auto size = bytes_.byte(at + 2 + k);
    if (!size) return std::nullopt;
    parameter.sizes.push_back(*size);
    parameter.count *= *size;
    if (parameter.count > kMostCounted) return std::nullopt;
  }
  parameter.at = at + 2 + *dimensions;
  const std::size_t each = parameter.type == -1 ? 1 : static_cast<std::size_t>(parameter.type);
  if (!bytes_.holds(parameter.at, parameter.count * each)) return std::nullopt;
  return parameter;
}

inline const C3dParameters::Parameter* C3dParameters::find(const std::string& name) const {
  const auto found = parameters_.find(name);
  return found == parameters_.end() || found->second.count == 0 ? nullptr : &found->second;
}

inline std::optional<double> C3dParameters::number(const char* name, std::size_t index) const {
  const Parameter* p = find(name);
  if (!p || index >= p->count) return std::nullopt;
  if (p->type == 4) return bytes_.real(p->at + 4 * index);
  if (p->type != 2) return std::nullopt;
  const auto word = bytes_.word(p->at + 2 * index);
  return word ? std::optional(static_cast<double>(*word)) : std::nullopt;
}

inline std::vector<std::string> C3dParameters::texts(const std::string& name) const {
  const Parameter* p = find(name);
  std::vector<std::string> found;
  if (!p || p->type != -1 || p->sizes.empty()) return found;
  const std::size_t letters = p->sizes[0];
  for (std::size_t at = 0; letters > 0 && at + letters <= p->count; at += letters)
    found.push_back(printable(bytes_.text(p->at + at, letters)));
  return found;
}

inline std::size_t C3dParameters::placeOf(const char* name) const {
  const Parameter* p = find(name);
  return p ? p->at : 0;
}

}  // namespace hapticell::mannequin
