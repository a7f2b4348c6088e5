// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <string>
#include <vector>

/// What the stand-in for the vendor's libHD.so does, in the hands of a test. Its functions have the names and the types
/// of the vendor's; what they do is ours. The scheduler ticks only when the test says so.
struct HdStandIn {
  struct Error {
    unsigned code;
    int internal;
    unsigned handle;
  };

  // What the test sets.
  std::vector<std::string> known_names{"Default Device"};  ///< That hdInitDevice opens.
  bool opens_null = false;                                 ///< hdInitDevice(nullptr) works.
  unsigned init_error = 0;                                 ///< Of the next hdInitDevice's.
  double position[3] = {};                                 ///< mm, vendor's axes.
  double transform[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  double temperature = 0.0;
  int buttons = 0, inkwell = 0;
  unsigned calibration = 0x5000;
  int style = 4;
  int output_axes = 3;
  std::deque<Error> errors;  ///< hdGetError takes them from the front.

  // What it saw.
  std::vector<std::string> tried_names;  ///< "(null)" for a null pointer.
  double force[3] = {};
  double torque[3] = {};
  bool force_output = false;
  int opened = 0, closed = 0;
  bool running = false;
  int frames = 0;
  bool frame_open = false;
  unsigned calibrated_with = 0;
  std::string locale_at_load;

  /// A tick of the vendor's scheduler: all callbacks, highest priority first.
  void (*tick)() = nullptr;
  void (*reset)() = nullptr;
};

extern "C" HdStandIn* hdStandIn();
