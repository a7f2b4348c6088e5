// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/file_bytes.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>

#include "geometry/system/in_parallel.h"
#include "geometry/system/open_file.h"

namespace hapticell::geometry {

Expected<FileBytes> FileBytes::read(const std::filesystem::path& path, std::uintmax_t most_bytes) {
  // Bytes for a thread to be worth it. Half, twice: no effect.
  constexpr std::size_t kLeast = 4'000'000;
  const auto file = openRegularFile(path, most_bytes);
  HAPTICELL_TRY(file);
  FileBytes content;
  content.size_ = file->size;
  content.bytes_ = std::make_unique_for_overwrite<char[]>(content.size_);
  std::atomic<bool> complete{true};
  inRanges(content.size_, rangesOf(content.size_, kLeast), [&](std::size_t, std::size_t begin, std::size_t end) {
    while (begin < end) {
      const ssize_t got =
          ::pread(file->descriptor, content.bytes_.get() + begin, end - begin, static_cast<off_t>(begin));
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) {
        complete = false;
        return;
      }
      begin += static_cast<std::size_t>(got);
    }
  });
  ::close(file->descriptor);
  if (!complete) return makeError(endedEarly(path));
  return content;
}

}  // namespace hapticell::geometry
