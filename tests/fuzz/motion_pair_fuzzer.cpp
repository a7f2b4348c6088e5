// SPDX-License-Identifier: Apache-2.0
// Any two texts, parted by the first NUL, as an ASF skeleton and its AMC motion: refused in words, or frames as long as
// the skeleton asks for.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "mannequin/motion/motion_clip.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hapticell;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t cut = std::min(bytes.find('\0'), size);
  const auto clip =
      mannequin::readAsfAmc(bytes.substr(0, cut), "fuzzed.asf", bytes.substr(std::min(cut + 1, size)), "fuzzed.amc");
  if (!clip && clip.error().message().empty()) std::abort();
  return 0;
}
