// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace hapticell::test {

/// A file of the project itself, by its path from the project's root.
std::filesystem::path sourceFile(const std::string& relative);

/// A file of the shared test data (real robots and CAD, not part of the project): looked for in the folder named by the
/// environment variable HAPTICELL_TEST_DATA, else in ../shared/data beside the project. Empty when it is not there:
/// the test then says GTEST_SKIP() with the file's name.
std::optional<std::filesystem::path> sharedData(const std::string& relative);

/// A fresh empty folder that is removed with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  /// Writes a text or binary file into the folder and returns its path.
  std::filesystem::path write(const std::string& name, const std::string& content) const;

 private:
  std::filesystem::path path_;
};

}  // namespace hapticell::test

/// Skips the running test, saying so, when the shared data file is absent; else defines `variable` as its path.
#define HAPTICELL_SHARED_DATA_OR_SKIP(variable, relative)                                                       \
  const auto variable##_found = ::hapticell::test::sharedData(relative);                                        \
  if (!variable##_found) GTEST_SKIP() << "test data is not here: " << relative << " (set HAPTICELL_TEST_DATA)"; \
  const std::filesystem::path& variable = *variable##_found
