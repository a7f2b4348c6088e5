// SPDX-License-Identifier: Apache-2.0
// Any bytes as a file of one reader: refused in words, or read. Built once a reader: HAPTICELL_FUZZ_HEADER declares it,
// HAPTICELL_FUZZ_CALL reads `file` (a path ending in HAPTICELL_FUZZ_EXTENSION) or `text` and gives an Expected.
#include HAPTICELL_FUZZ_HEADER

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hapticell;
  static const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("hapticell-fuzz-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  [[maybe_unused]] const std::filesystem::path file = folder / ("fuzzed" HAPTICELL_FUZZ_EXTENSION);
  [[maybe_unused]] const std::string_view text(reinterpret_cast<const char*>(data), size);
  std::ofstream(file, std::ios::binary).write(text.data(), static_cast<std::streamsize>(size));
  const auto result = HAPTICELL_FUZZ_CALL;
  if (!result && (result.error().message().empty() || result.error().message().find('\n') != std::string::npos))
    std::abort();
  return 0;
}
