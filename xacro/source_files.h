// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "xacro/budget.h"
#include "xacro/expand.h"
#include "xacro/fault.h"
#include "xacro/pushed.h"
#include "xacro/xml_node.h"

namespace hapticell::xacro {

/// The files of one expansion: finds and reads them, each description once, and knows which is expanded now. Throws
/// Fault for a file that does not exist or cannot be read.
class SourceFiles {
 public:
  SourceFiles(const Files& files, Budget& budget) : files_(files), budget_(budget) {}

  /// The root element of a description; `index` becomes the file's number.
  XmlPointer parsed(const std::filesystem::path& file, int& index);
  /// The text of another file. It is found as an include is; `file` becomes its path.
  std::string textOf(const std::string& reference, std::string& file);
  /// The file that a reference in the file being expanded refers to; empty if it does not exist.
  std::optional<std::filesystem::path> find(const std::string& reference) const {
    return files_.find(reference, folder());
  }
  /// The files of a folder by a pattern in their name, in order.
  std::vector<std::filesystem::path> matching(const std::string& reference) const;
  /// A path without the folder that it is relative to is relative to the file that is expanded now.
  std::string absoluteName(const std::string& reference) const;

  /// The file of this number is the one that is expanded, for as long as the result lives.
  Pushed<int> enter(int index) { return Pushed<int>(entered_, index); }
  std::filesystem::path folder() const { return all_[static_cast<std::size_t>(entered_.back())].parent_path(); }
  std::filesystem::path firstFolder() const { return all_[0].parent_path(); }

  std::string nameOf(int file) const { return all_[static_cast<std::size_t>(file)].string(); }
  const std::vector<std::filesystem::path>& all() const { return all_; }  ///< All that was read, the first in front.

 private:
  const Files& files_;
  Budget& budget_;
  std::vector<std::filesystem::path> all_;
  std::map<std::string, std::pair<XmlPointer, int>> parsed_;  ///< By path: a file that is included twice is read once.
  std::vector<int> entered_;
};

/// The message about a reference that leads to no file.
Fault notFound(const std::string& reference);

}  // namespace hapticell::xacro
