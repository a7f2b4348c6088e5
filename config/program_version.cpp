// SPDX-License-Identifier: Apache-2.0
#include "config/program_version.h"

#include "hapticell_commit.h"

namespace hapticell::config {

namespace {

#ifdef __clang__
constexpr const char* kCompiler = "clang " __clang_version__;
#else
constexpr const char* kCompiler = "GCC " __VERSION__;
#endif

}  // namespace

std::string_view builtCommit() {
  return HAPTICELL_COMMIT;
}

std::string versionText(std::string_view program, const std::vector<LibraryVersion>& libraries) {
  std::string text(program);
  text += " " HAPTICELL_VERSION "\ncommit: ";
  text += builtCommit();
  text += "\ncompiler: ";
  text += kCompiler;
  if (!libraries.empty()) text += "\nlibraries:";
  const char* gap = " ";
  for (const LibraryVersion& library : libraries) {
    text.append(gap).append(library.name).append(" ").append(library.version);
    gap = ", ";
  }
  return text;
}

}  // namespace hapticell::config
