// SPDX-License-Identifier: Apache-2.0
#include "xacro/source_files.h"

#include <fnmatch.h>

#include <algorithm>

namespace hapticell::xacro {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostMatches = 1000;

std::string packageOf(const std::string& reference) {
  const std::size_t begin = std::string("package://").size();
  return reference.substr(begin, reference.find('/', begin) - begin);
}

}  // namespace

Fault notFound(const std::string& reference) {
  if (!reference.starts_with("package://"))
    return Fault{.found = Text("the file %1 does not exist", reference),
                 .expected = "a file",
                 .fix = "Correct the path, or copy the file to this place."};
  return Fault{.found = Text("resource not found: %1 (%2)", packageOf(reference), reference),
               .expected = "the package's folder",
               .fix = "Put the package folder next to the file or above it, or add its path to ROS_PACKAGE_PATH."};
}

XmlPointer SourceFiles::parsed(const fs::path& file, int& index) {
  const auto known = parsed_.find(file.string());
  if (known != parsed_.end()) {
    index = known->second.second;
    return known->second.first;
  }
  index = static_cast<int>(all_.size());
  const auto text = files_.read(file);
  if (!text) throw Fault{.found = text.error().found, .expected = text.error().expected, .fix = text.error().fix};
  all_.push_back(file);
  budget_.take(text->size() * 4);
  XmlPointer root = readXml(*text, file.string(), index);
  parsed_[file.string()] = {root, index};
  return root;
}

std::string SourceFiles::textOf(const std::string& reference, std::string& file) {
  const auto found = find(reference);
  if (!found) throw notFound(reference);
  file = found->string();
  const auto text = files_.read(*found);
  if (!text) throw Fault{.found = text.error().found, .expected = text.error().expected, .fix = text.error().fix};
  budget_.step(1 + text->size() / 64);
  if (std::find(all_.begin(), all_.end(), *found) == all_.end()) all_.push_back(*found);
  return *text;
}

std::vector<fs::path> SourceFiles::matching(const std::string& reference) const {
  const fs::path pattern = absoluteName(reference);
  std::vector<fs::path> found;
  std::error_code problem;
  std::size_t seen = 0;
  for (fs::directory_iterator entry(pattern.parent_path(), fs::directory_options::skip_permission_denied, problem), end;
       !problem && entry != end && ++seen <= kMostMatches; entry.increment(problem)) {
    if (fnmatch(pattern.filename().c_str(), entry->path().filename().c_str(), FNM_PERIOD) == 0)
      found.push_back(entry->path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::string SourceFiles::absoluteName(const std::string& reference) const {
  if (reference.starts_with("package://") || fs::path(reference).is_absolute()) return reference;
  return (folder() / reference).lexically_normal().string();
}

}  // namespace hapticell::xacro
