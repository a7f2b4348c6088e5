// SPDX-License-Identifier: Apache-2.0
#include "config/program_folders.h"

#include <dlfcn.h>

#include <algorithm>

namespace hapticell::config {

namespace fs = std::filesystem;

namespace {

/// The folder of the file that this code was loaded from; empty where the system does not say it by its whole path.
fs::path folderOfLibrary() {
  Dl_info found{};
  if (::dladdr(reinterpret_cast<const void*>(&programFolders), &found) == 0 || found.dli_fname == nullptr) return {};
  std::error_code ignored;
  const fs::path file = found.dli_fname[0] == '/' ? fs::canonical(found.dli_fname, ignored) : fs::path();
  return file.parent_path();
}

}  // namespace

std::vector<fs::path> programFolders() {
  std::error_code ignored;
  std::vector<fs::path> wanted{fs::read_symlink("/proc/self/exe", ignored).parent_path()};
  const fs::path library = folderOfLibrary();
  // The library lies with the programs where it was built, and in lib or lib/ARCHITECTURE once installed.
  if (!library.empty()) {
    wanted.insert(wanted.end(), {library, library.parent_path() / "bin", library.parent_path().parent_path() / "bin"});
  }
  std::vector<fs::path> folders;
  for (const fs::path& folder : wanted) {
    if (fs::is_directory(folder, ignored) && std::find(folders.begin(), folders.end(), folder) == folders.end())
      folders.push_back(folder);
  }
  return folders;
}

}  // namespace hapticell::config
