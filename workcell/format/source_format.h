// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "workcell/format/format_context.h"
#include "workcell/text/field_reader.h"

namespace hapticell::workcell {

/// The name of a file as it is written in a document in `folder`.
std::string relativeName(const std::string& path, const std::filesystem::path& folder);

Json jsonFromSource(const SourceFile& source, const std::filesystem::path& folder);
Json jsonFromColor(const std::array<float, 3>& color);

/// Reads the sources of shapes, and asks for files that no longer exist (LoadOptions::locate).
class SourceReader {
 public:
  explicit SourceReader(const FormatContext& context) : context_(context) {}
  /// Messages use `place`.
  void read(const Json& json, const Text& place, SourceFile& source);

 private:
  void locate(std::string& path);

  const FormatContext& context_;
  std::map<std::filesystem::path, std::optional<std::filesystem::path>> located_;
  std::map<std::filesystem::path, std::filesystem::path> moved_folders_;
};

}  // namespace hapticell::workcell
