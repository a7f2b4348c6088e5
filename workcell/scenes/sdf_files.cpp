// SPDX-License-Identifier: Apache-2.0
#include "workcell/scenes/sdf_files.h"

#include <tinyxml.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "geometry/system/nesting_limit.h"
#include "workcell/text/file_content.h"
#include "workcell/text/package_path.h"
#include "workcell/text/xml_text.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

constexpr const char* kModelScheme = "model://";
constexpr double kNewestVersion = 1.9;

/// The folders that may hold models: from the file upwards, each with its "models", then those of the environment.
std::vector<fs::path> modelFolders(const fs::path& file) {
  std::vector<fs::path> folders;
  for (fs::path at = fs::absolute(file).parent_path();; at = at.parent_path()) {
    folders.push_back(at);
    folders.push_back(at / "models");
    if (at == at.parent_path()) break;
  }
  for (const char* variable : {"GZ_SIM_RESOURCE_PATH", "GAZEBO_MODEL_PATH", "SDF_PATH"}) {
    const char* value = std::getenv(variable);
    std::string rest = value ? value : "";
    while (!rest.empty()) {
      const std::size_t colon = rest.find(':');
      folders.emplace_back(rest.substr(0, colon));
      rest = colon == std::string::npos ? "" : rest.substr(colon + 1);
    }
  }
  return folders;
}

/// A file, or the folder of a model.
std::optional<FoundFile> findAsWritten(const std::string& uri, const fs::path& file) {
  std::error_code ignored;
  if (uri.empty() || leavesPackage(uri)) return std::nullopt;
  if (uri.starts_with(kModelScheme)) {
    for (const fs::path& folder : modelFolders(file)) {
      if (fs::path found = folder / uri.substr(std::string(kModelScheme).size()); fs::exists(found, ignored)) {
        return FoundFile{std::move(found), {}};
      }
    }
  }
  if (auto found = findReference(uri, file.parent_path())) return found;
  if (uri.find("://") != std::string::npos && !uri.starts_with("file://")) return std::nullopt;
  const std::string plain = uri.starts_with("file://") ? uri.substr(7) : uri;
  fs::path beside = (fs::absolute(file).parent_path() / plain).lexically_normal();
  return fs::is_directory(beside, ignored) ? std::optional(FoundFile{std::move(beside), {}}) : std::nullopt;
}

/// The file that a model's manifest names for the newest version that is read.
std::string fileNamedIn(const fs::path& manifest) {
  const auto content = readFileContent(manifest);
  if (!content || content->size() > (1u << 20) || content->find('\0') != std::string::npos) return {};
  if (!geometry::checkNesting(*content, geometry::NestedText::kXml, manifest.string())) return {};
  TiXmlDocument document;
  document.Parse(soundXmlText(*content).text.c_str(), nullptr, TIXML_ENCODING_UTF8);
  const TiXmlElement* root = document.Error() ? nullptr : document.RootElement();
  std::string best;
  double best_version = -1.0;
  for (const TiXmlElement* one = root ? root->FirstChildElement("sdf") : nullptr; one;
       one = one->NextSiblingElement("sdf")) {
    const char* const text = one->GetText();
    const char* const stated = one->Attribute("version");
    double version = stated ? std::strtod(stated, nullptr) : 0.0;
    if (stated && std::string(stated).starts_with("1.1") && std::string(stated).size() == 4) version = -0.5;  // 1.10 …
    if (!text || version <= best_version || version > kNewestVersion) continue;
    best = text;
    best_version = version;
  }
  const std::size_t first = best.find_first_not_of(" \t\r\n");
  return first == std::string::npos ? "" : best.substr(first, best.find_last_not_of(" \t\r\n") + 1 - first);
}

}  // namespace

std::optional<FoundFile> findSdfFile(const std::string& uri, const fs::path& file) {
  auto found = findAsWritten(uri, file);
  return found || uri.find('%') == std::string::npos ? found : findAsWritten(percentDecoded(uri), file);
}

fs::path findSdfModel(const std::string& uri, const fs::path& file) {
  std::error_code ignored;
  const auto reference = findSdfFile(uri, file);
  const fs::path found = reference ? reference->path : fs::path();
  if (found.empty() || !fs::is_directory(found, ignored)) return found;
  for (const char* manifest : {"model.config", "manifest.xml"}) {
    const std::string named = fileNamedIn(found / manifest);
    if (named.empty()) continue;
    const fs::path path = (found / named).lexically_normal();
    const fs::path inside = path.lexically_relative(found.lexically_normal());
    if (fs::is_regular_file(path, ignored) && !inside.empty() && *inside.begin() != "..") return path;
  }
  return fs::is_regular_file(found / "model.sdf", ignored) ? found / "model.sdf" : fs::path();
}

}  // namespace hapticell::workcell
