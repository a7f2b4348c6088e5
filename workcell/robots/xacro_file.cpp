// SPDX-License-Identifier: Apache-2.0
#include "workcell/robots/xacro_file.h"

#include <algorithm>
#include <set>

#include "geometry/system/regular_file.h"
#include "workcell/text/file_content.h"
#include "workcell/text/package_path.h"
#include "workcell/text/read_record.h"
#include "workcell/text/xml_text.h"

namespace hapticell::workcell {

namespace {

// 64 MB, as kLargestUrdf.
constexpr std::uintmax_t kLargestXacro = std::uintmax_t{64} << 20;

Expected<std::string> readXacroText(const std::filesystem::path& path) {
  auto content = geometry::readRegularFile(path, kLargestXacro);
  HAPTICELL_TRY(content);
  ReadRecord::note(path);
  return soundXmlText(*content).text;
}

/// "package://a/../b/rest" leads to the package b beside a, as workspaces are laid out.
std::string withPlainPackage(const std::string& reference) {
  const std::string scheme = "package://";
  const std::size_t begin = reference.rfind(scheme);
  if (begin == std::string::npos) return reference;
  return scheme + std::filesystem::path(reference.substr(begin + scheme.size())).lexically_normal().string();
}

}  // namespace

Expected<xacro::Expanded> expandXacroFile(const std::filesystem::path& file, const xacro::Arguments& arguments,
                                          std::vector<xacro::DeclaredArgument>& declared, Diagnostics& diagnostics) {
  std::error_code ignored;
  const auto whole = std::filesystem::absolute(file, ignored).lexically_normal();
  std::set<std::filesystem::path> taken;  // Reported once a package.
  const auto find = [&](const std::string& reference,
                        const std::filesystem::path& folder) -> std::optional<std::filesystem::path> {
    const auto found = findReference(withPlainPackage(reference), folder);
    if (!found) return std::nullopt;
    if (!found->taken_for_package.empty() && taken.insert(found->taken_for_package).second)
      diagnostics.warn(takenForPackage(reference, *found));
    return found->path;
  };
  auto expanded = xacro::expand(whole, arguments, {readXacroText, find}, declared, diagnostics);
  if (!expanded) return expanded;
  for (const auto& given : arguments) {
    const bool known =
        std::any_of(declared.begin(), declared.end(), [&](const auto& one) { return one.name == given.first; });
    if (!known)
      diagnostics.warn(Text("the file has no argument '%1'; its value %2 was not used", given.first, given.second));
  }
  return expanded;
}

}  // namespace hapticell::workcell
