// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <string_view>

namespace hapticell::app {

/// The last actions of the user and the shown messages, for the report of a crash. All memory is allocated at the
/// start, so that a signal handler can read it at any time.
class ActionTrail {
 public:
  static constexpr std::size_t kKept = 50;
  static constexpr std::size_t kLongest = 200;  ///< Bytes of an entry; longer ones are cut.

  /// Adds an entry as one line, after the time of day (UTC). One thread at a time.
  void add(std::string_view text);
  /// Calls `use` with each entry as a C string, oldest first. Any thread, also in a signal handler: it neither
  /// allocates nor locks.
  template <typename Use>
  void forEach(Use use) const {
    const std::size_t count = count_.load(std::memory_order_acquire);
    for (std::size_t number = count > kKept ? count - kKept : 0; number < count; ++number) {
      std::array<char, kLongest + 1> text{};
      const Entry& entry = entries_[number % entries_.size()];
      for (std::size_t i = 0; i < kLongest; ++i) text[i] = entry[i].load(std::memory_order_relaxed);
      use(static_cast<const char*>(text.data()));
    }
  }

 private:
  using Entry = std::array<std::atomic<char>, kLongest>;
  static_assert(std::atomic<char>::is_always_lock_free && std::atomic<std::size_t>::is_always_lock_free);

  std::array<Entry, kKept + 1> entries_{};  // One extra: the entry that is being written is not read.
  std::atomic<std::size_t> count_{0};
};

}  // namespace hapticell::app
