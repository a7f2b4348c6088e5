// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace hapticell::haptic {

/// Limits a server's messages about its clients: a client that connects and is refused thousands of times a second must
/// not fill the disk. Each kind of event may use some lines at once and one more every few seconds. Further events are
/// counted and summarised in one line at most every kSummaryPeriod. Used by one thread; the caller provides the time,
/// in nanoseconds.
class ReportBudget {
 public:
  enum class Kind : std::uint8_t { kRefused, kWatcher, kController };
  static constexpr std::size_t kKinds = 3;

  /// Lines per kind after a quiet time: a few clients that come and go are reported one by one. Half: they are summed
  /// up sooner; twice: a flood writes twice as much at first.
  static constexpr std::size_t kLinesAtOnce = 10;
  /// s until another line is allowed: at most 17,280 lines a day and kind. Half: twice as many; twice: half, and single
  /// events are reported late.
  static constexpr double kLinePeriod = 5.0;
  /// s between two summaries of what got no line: at most 8640 a day. Half: twice as many; twice: a flood is reported
  /// 20 s late.
  static constexpr double kSummaryPeriod = 10.0;
  /// Bytes; plainText(). Some lines of a log. Half: sentences with a long path are cut; twice: a client can write twice
  /// as much.
  static constexpr std::size_t kLongestSentence = 400;

  /// `say` gets each line; may be null.
  explicit ReportBudget(std::function<void(const std::string&)> say) : say_(std::move(say)) {}

  void tell(Kind kind, const std::string& sentence, std::int64_t now_ns);
  /// Counts an event without its own line (the waiting room was full).
  void count(Kind kind) { ++counted(kind); }
  /// Writes the summary line, if it is due.
  void summarize(std::int64_t now_ns);

 private:
  struct Allowance {
    std::size_t used = 0;
    std::int64_t since_ns = 0;  ///< Time from which `used` decreases.
    std::uint64_t counted = 0;  ///< Events without a line since the last summary.
  };
  std::uint64_t& counted(Kind kind) { return allowances_[static_cast<std::size_t>(kind)].counted; }
  static bool allows(Allowance& allowance, std::int64_t now_ns);

  std::function<void(const std::string&)> say_;
  std::array<Allowance, kKinds> allowances_;
  std::int64_t summarized_ns_ = 0;
};

}  // namespace hapticell::haptic
