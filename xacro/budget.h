// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "xacro/fault.h"

namespace hapticell::xacro {

/// Limits of one expansion, so that no file can block the program or fill its memory: steps of evaluation and elements,
/// bytes of texts and lists made, and levels of anything nested (macros, files, expressions, properties that name each
/// other). Exceeding a limit throws Fault. The largest public description uses a twentieth of each.
class Budget {
 public:
  static constexpr std::size_t kMostSteps = 3'000'000;
  static constexpr std::size_t kMostBytes = std::size_t{64} << 20;
  static constexpr std::size_t kLongestText = std::size_t{1} << 20;
  static constexpr std::size_t kLongestList = 100'000;
  static constexpr int kDeepest = 1000;

  void step(std::size_t count = 1) {
    steps_ += count;
    if (steps_ > kMostSteps)
      throw Fault{.found = "more than 3 million evaluation steps",
                  .expected = "a robot",
                  .fix = "Check for a macro that calls itself."};
  }
  /// Memory that something made takes; never given back.
  void take(std::size_t bytes) {
    bytes_ += bytes;
    if (bytes_ > kMostBytes)
      throw Fault{.found = "texts and lists with more than 64 MB in total", .expected = "a robot"};
  }
  /// The same of one text.
  const std::string& text(const std::string& made) {
    checkText(made.size());
    take(made.size());
    return made;
  }
  static void checkText(std::size_t size) {
    if (size > kLongestText) throw Fault{.found = "a text longer than 1 MB", .expected = "a shorter one"};
  }
  static void checkList(std::size_t size) {
    if (size > kLongestList) throw Fault{.found = "a list of more than 100 000 values", .expected = "a shorter one"};
  }

  /// One level deeper for as long as it lives.
  class Level {
   public:
    explicit Level(Budget& budget, int levels = 1) : budget_(budget), levels_(levels) {
      if (budget_.depth_ + levels_ > kDeepest)
        throw Fault{.found = "elements, macros or expressions nested too deeply",
                    .expected = "fewer nested levels",
                    .fix = "Check for a macro, a file or a property that contains itself."};
      budget_.depth_ += levels_;
    }
    ~Level() { budget_.depth_ -= levels_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    Budget& budget_;
    int levels_;
  };

 private:
  std::size_t steps_ = 0, bytes_ = 0;
  int depth_ = 0;
};

}  // namespace hapticell::xacro
