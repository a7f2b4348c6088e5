// SPDX-License-Identifier: Apache-2.0
#include "tests/support/test_data.h"

#include <cstdlib>
#include <fstream>
#include <random>

namespace hapticell::test {

namespace fs = std::filesystem;

fs::path sourceFile(const std::string& relative) { return fs::path(HAPTICELL_SOURCE_DIR) / relative; }

std::optional<fs::path> sharedData(const std::string& relative) {
  const char* named = std::getenv("HAPTICELL_TEST_DATA");
  const fs::path root = named ? fs::path(named) : fs::path(HAPTICELL_SOURCE_DIR).parent_path() / "shared" / "data";
  const fs::path file = root / relative;
  std::error_code ignored;
  return fs::exists(file, ignored) ? std::optional(file) : std::nullopt;
}

TemporaryFolder::TemporaryFolder() {
  std::random_device random;
  path_ = fs::temp_directory_path() / ("hapticell-test-" + std::to_string(random()) + std::to_string(random()));
  fs::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

fs::path TemporaryFolder::write(const std::string& name, const std::string& content) const {
  const fs::path file = path_ / name;
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << content;
  return file;
}

}  // namespace hapticell::test
