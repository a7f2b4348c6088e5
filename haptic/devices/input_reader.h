// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "haptic/devices/driver_interface.h"

namespace hapticell::haptic {

/// A glove or a 3D mouse used in addition to the stylus. A separate thread makes the driver's calls, opens the device
/// and looks for it again if it vanishes. Callers get the newest state and never wait.
class InputReader {
 public:
  struct Snapshot {
    bool open = false;                  ///< The device answers now.
    std::uint64_t measurements = 0;     ///< Increases with each measurement.
    driver::State state;                ///< The last state.
    driver::Capabilities capabilities;  ///< Valid once the device was open.
    std::string problem;                ///< Why it does not answer; a sentence.
  };

  /// `id` as returned by the driver; empty: the first that can be used.
  InputReader(driver::Driver& driver, std::string id);
  ~InputReader();  ///< A driver whose call does not return is abandoned.
  InputReader(const InputReader&) = delete;
  InputReader& operator=(const InputReader&) = delete;

  Snapshot latest() const;
  /// Buttons pressed since the last call, one bit each, including those already released.
  std::uint32_t takePressed();
  /// Sets the strength of the glove's vibrators, 0 .. 1 each.
  void vibrate(const double (&strength)[6]);
  /// Events since the last call, in sentences.
  std::vector<std::string> takeNews();

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
};

}  // namespace hapticell::haptic
