// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <string>

#include "workcell/scenes/import_process.h"

namespace hapticell::test {

/// The parent's ends of the importer's protocol, as files in memory, for a ParentLink of this process. What stood at
/// their descriptors comes back at the end.
class ParentEnds {
 public:
  ParentEnds() {
    for (std::size_t k = 0; k < 2; ++k) {
      kept_[k] = ::fcntl(kDescriptors[k], F_DUPFD_CLOEXEC, kAbove);
      const int made = ::memfd_create("end", MFD_CLOEXEC);
      files_[k] = ::fcntl(made, F_DUPFD_CLOEXEC, kAbove);
      if (made != kDescriptors[k]) ::close(made);
      EXPECT_EQ(::dup2(files_[k], kDescriptors[k]), kDescriptors[k]);
    }
  }
  ~ParentEnds() {
    for (std::size_t k = 0; k < 2; ++k) {
      ::close(kDescriptors[k]);
      if (kept_[k] >= 0) {
        ::dup2(kept_[k], kDescriptors[k]);
        ::close(kept_[k]);
      }
      ::close(files_[k]);
    }
  }
  ParentEnds(const ParentEnds&) = delete;
  ParentEnds& operator=(const ParentEnds&) = delete;

  /// All lines so far.
  std::string lines() const {
    struct stat state {};
    if (::fstat(files_[1], &state) != 0) return {};
    std::string text(static_cast<std::size_t>(state.st_size), '\0');
    const ssize_t got = ::pread(files_[1], text.data(), text.size(), 0);
    text.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return text;
  }

 private:
  static constexpr int kAbove = 50;
  static constexpr std::array<int, 2> kDescriptors{workcell::kSceneDescriptor, workcell::kLinesDescriptor};
  std::array<int, 2> kept_{}, files_{};
};

}  // namespace hapticell::test
