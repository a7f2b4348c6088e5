// SPDX-License-Identifier: Apache-2.0
#include "workcell/text/base64.h"

#include <cstdint>

namespace hapticell::workcell {

std::string base64(const std::string& bytes) {
  constexpr char kLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      group = (group << 8) | (k + j < bytes.size() ? static_cast<unsigned char>(bytes[k + j]) : 0u);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      text += k + j <= bytes.size() ? kLetters[(group >> (18 - 6 * j)) & 63] : '=';
    }
  }
  return text;
}

}  // namespace hapticell::workcell
