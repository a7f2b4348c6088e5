// SPDX-License-Identifier: Apache-2.0
#include "workcell/files/claimed_content.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "geometry/system/regular_file.h"
#include "geometry/system/text_case.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

namespace {

struct Claim {
  std::string_view extension;
  std::string_view begins;  // Empty: any bytes.
  std::size_t at = 0;
};

constexpr std::array kClaims = {
    Claim{".png", "\x89PNG\r\n\x1A\n"sv},
    Claim{".jpg", "\xFF\xD8\xFF"sv},
    Claim{".jpeg", "\xFF\xD8\xFF"sv},
    Claim{".gif", "GIF8"sv},
    Claim{".bmp", "BM"sv},
    Claim{".webp", "WEBP"sv, 8},
    Claim{".dds", "DDS "sv},
    Claim{".ktx", "\xABKTX"sv},
    Claim{".ktx2", "\xABKTX"sv},
    Claim{".hdr", "#?"sv},
    Claim{".exr", "\x76\x2F\x31\x01"sv},
    Claim{".tif", "II*\0"sv},
    Claim{".tif", "MM\0*"sv},
    Claim{".tiff", "II*\0"sv},
    Claim{".tiff", "MM\0*"sv},
    Claim{".bin", ""sv},
    Claim{".glbin", ""sv},
};

/// The first word that is no comment, of a text; empty if there is no such word.
std::string_view firstWord(std::string_view text) {
  if (text.find('\0') != std::string_view::npos) return {};
  while (true) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return {};
    text.remove_prefix(begin);
    if (text.front() != '#') break;
    text.remove_prefix(std::min(text.find('\n'), text.size()));
  }
  return text.substr(0, text.find_first_of(" \t\r\n"));
}

}  // namespace

bool isWhatItClaims(const fs::path& file) {
  std::error_code fault;
  if (!fs::is_regular_file(file, fault)) return false;
  const std::string extension = lowerExtension(file);
  // Bytes looked at for the first word; comments may be before it. Half: files with long comments are not known; twice:
  // time.
  constexpr std::size_t kHead = 64 * 1024;
  const std::string head = geometry::headOfFile(file, kHead);
  std::string_view text = head;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (extension == ".mtl") return fs::file_size(file, fault) == 0 || firstWord(text) == "newmtl";
  if (extension == ".step" || extension == ".stp" || extension == ".p21")
    return firstWord(text).starts_with("ISO-10303-21");
  if (extension == ".xml" || extension == ".config" || extension == ".dae") return firstWord(text).starts_with('<');
  for (const Claim& claim : kClaims) {
    if (extension == claim.extension && text.substr(std::min(claim.at, text.size())).starts_with(claim.begins))
      return true;
  }
  return false;
}

}  // namespace hapticell::workcell
