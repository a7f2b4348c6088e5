// SPDX-License-Identifier: Apache-2.0
#include "workcell/xacro_file.h"

#include <algorithm>

#include "geometry/regular_file.h"
#include "workcell/file_content.h"
#include "workcell/package_path.h"
#include "workcell/xml_text.h"

namespace hapticell::workcell {

namespace {

constexpr std::uintmax_t kLargestXacro = std::uintmax_t{64} << 20;

Expected<std::string> readXacroText(const std::filesystem::path& path) {
  auto content = geometry::readRegularFile(path, kLargestXacro);
  if (!content) return makeError(content.error());
  return soundXmlText(*content).text;
}

/// "package://a/../b/rest" leads to the package b beside a, as workspaces are laid out.
std::optional<std::filesystem::path> findXacroFile(const std::string& reference, const std::filesystem::path& folder) {
  const std::string scheme = "package://";
  const std::size_t begin = reference.rfind(scheme);
  if (begin == std::string::npos) return resolveMeshPath(reference, folder);
  const std::string tail = std::filesystem::path(reference.substr(begin + scheme.size())).lexically_normal().string();
  return resolveMeshPath(scheme + tail, folder);
}

}  // namespace

Expected<xacro::Expanded> expandXacroFile(const std::filesystem::path& file, const xacro::Arguments& arguments,
                                          std::vector<xacro::DeclaredArgument>& declared, Diagnostics& diagnostics) {
  std::error_code ignored;
  const auto whole = std::filesystem::absolute(file, ignored).lexically_normal();
  auto expanded = xacro::expand(whole, arguments, {readXacroText, findXacroFile}, declared, diagnostics);
  if (!expanded) return expanded;
  for (const auto& [name, value] : arguments) {
    const bool known = std::any_of(declared.begin(), declared.end(), [&](const auto& one) { return one.name == name; });
    if (!known) diagnostics.warn("the file has no argument '" + name + "'; its value " + value + " was not used");
  }
  return expanded;
}

}  // namespace hapticell::workcell
