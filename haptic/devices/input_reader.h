// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "haptic/devices/driver_interface.h"

namespace hapticell::haptic {

/// A glove or a 3-D mouse beside the stylus: its driver's calls run in a thread of their own, and whoever asks gets the
/// newest state. It is looked for again when it vanishes. No call waits:
/// the device is opened by the thread.
class InputReader {
 public:
  struct Snapshot {
    bool open = false;                  ///< It answers now.
    std::uint64_t measurements = 0;     ///< Grows with each one.
    driver::State state;                ///< The last.
    driver::Capabilities capabilities;  ///< Once it was open.
    std::string problem;                ///< Why it does not answer; a sentence.
  };

  /// `id` as the driver tells it; empty: the first that can be used.
  InputReader(driver::Driver& driver, std::string id);
  ~InputReader();  ///< A driver that does not come back is left to itself.
  InputReader(const InputReader&) = delete;
  InputReader& operator=(const InputReader&) = delete;

  Snapshot latest() const;
  /// Buttons that went down since the last call, one bit each: also those that are up again.
  std::uint32_t takePressed();
  /// How strongly the glove's vibrators shake, 0 .. 1 each.
  void vibrate(const double (&strength)[6]);
  /// What happened since the last call, in sentences.
  std::vector<std::string> takeNews();

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
};

}  // namespace hapticell::haptic
