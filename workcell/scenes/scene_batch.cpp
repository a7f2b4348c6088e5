// SPDX-License-Identifier: Apache-2.0
#include "workcell/scenes/scene_batch.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "geometry/system/packed_text.h"
#include "workcell/scenes/import_process.h"
#include "workcell/scenes/scene_call.h"
#include "workcell/scenes/sdf_cell_reader.h"

namespace hapticell::workcell {

namespace {

constexpr std::size_t kHead = 1 + sizeof(std::uint64_t);

Error errorOf(const BatchEntry& entry, const std::string& file) {
  Error error = unpackedError(entry.content)
                    .value_or(Error{.found = "an invalid answer of the importer", .expected = "an error"});
  error.file = file;
  return error;
}

/// Absolute, each once, in the order given; what the process does not read is left out.
std::vector<std::string> filesToRead(const std::vector<std::filesystem::path>& files) {
  std::vector<std::string> chosen;
  std::error_code fault;
  for (const std::filesystem::path& file : files) {
    const std::string absolute = std::filesystem::absolute(file, fault).string();
    if (fault || !std::filesystem::is_regular_file(file, fault) || !holdsScene(file) || isSdfCell(file)) continue;
    if (absolute.find('\n') != std::string::npos) continue;
    if (std::find(chosen.begin(), chosen.end(), absolute) == chosen.end()) chosen.push_back(absolute);
  }
  return chosen;
}

}  // namespace

std::string batchBytes(const std::vector<BatchEntry>& entries) {
  std::string bytes;
  for (const BatchEntry& entry : entries) {
    const std::uint64_t size = entry.content.size();
    bytes += entry.is_scene ? '\1' : '\0';
    bytes.append(reinterpret_cast<const char*>(&size), sizeof size);
    bytes += entry.content;
  }
  return bytes;
}

Expected<std::vector<BatchEntry>> batchFromBytes(std::string_view bytes, std::size_t count) {
  const Error fault{.found = "an invalid answer of the importer", .expected = "one scene per file"};
  std::vector<BatchEntry> entries;
  while (entries.size() < count && bytes.size() >= kHead) {
    std::uint64_t size = 0;
    std::memcpy(&size, bytes.data() + 1, sizeof size);
    const bool is_scene = bytes[0] == '\1';
    if ((!is_scene && bytes[0] != '\0') || size > bytes.size() - kHead) return makeError(fault);
    entries.push_back({is_scene, std::string(bytes.substr(kHead, static_cast<std::size_t>(size)))});
    bytes.remove_prefix(kHead + static_cast<std::size_t>(size));
  }
  if (entries.size() != count || !bytes.empty()) return makeError(fault);
  return entries;
}

void SceneBatch::readAhead(const std::vector<std::filesystem::path>& files) {
  const std::vector<std::string> chosen = filesToRead(files);
  if (chosen.size() < 2) return;
  ImporterCall call;
  call.file = chosen.front();
  call.arguments = {"read-all", std::to_string(chosen.size())};
  for (std::string& word : importerWords(options_)) call.arguments.push_back(std::move(word));
  for (const std::string& file : chosen) call.scene += file + "\n";
  std::uintmax_t size = 0;
  for (const std::string& file : chosen) size += bytesToRead(file);
  call.limits = options_.limits;
  limitBySize(call, size, isFiner(options_));
  call.monitor = monitor_;
  const Expected<std::string> bytes = callImporter(call);
  if (!bytes) return;
  const auto entries = batchFromBytes(*bytes, chosen.size());
  if (!entries) return;
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    const BatchEntry& entry = (*entries)[k];
    known_.emplace(chosen[k], entry.is_scene ? uprightScene(entry.content, chosen[k], options_)
                                             : Expected<ImportedScene>(makeError(errorOf(entry, chosen[k]))));
  }
}

Expected<ImportedScene> SceneBatch::scene(const std::filesystem::path& file) const {
  std::error_code fault;
  const auto known = known_.find(std::filesystem::absolute(file, fault).string());
  return known != known_.end() ? known->second : readScene(file, options_, monitor_);
}

}  // namespace hapticell::workcell
