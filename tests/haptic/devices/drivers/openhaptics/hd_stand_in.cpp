// SPDX-License-Identifier: Apache-2.0
// A stand-in for 3D Systems' libHD.so: the same C interface, faults included, nothing of the vendor.
#include "tests/haptic/devices/drivers/openhaptics/hd_stand_in.h"

#include <algorithm>
#include <clocale>
#include <cstring>

namespace {

struct Scheduled {
  unsigned long id;
  unsigned (*callback)(void*);
  void* data;
};

HdStandIn state;
std::vector<Scheduled> scheduled;
unsigned long next_id = 1;
unsigned next_handle = 0;

void fail(unsigned code, int internal = 0) {
  state.errors.push_back({code, internal, 0});
}

void tickAll() {
  if (!state.running) return;
  for (const Scheduled& entry : std::vector<Scheduled>(scheduled)) {
    if (entry.callback(entry.data) == 0) {
      std::erase_if(scheduled, [&](const Scheduled& other) { return other.id == entry.id; });
    }
    if (state.frame_open) fail(0x401);
  }
}

void resetAll() {
  state = {};
  state.tick = tickAll;
  state.reset = resetAll;
  scheduled.clear();
}

struct AtLoad {
  AtLoad() {
    resetAll();
    state.locale_at_load = std::setlocale(LC_ALL, nullptr);
  }
} at_load;

}  // namespace

extern "C" {

HdStandIn* hdStandIn() {
  return &state;
}

unsigned hdInitDevice(const char* name) {
  state.tried_names.push_back(name != nullptr ? name : "(null)");
  if (state.running) fail(0x301);
  if (state.init_error != 0) {
    fail(state.init_error, -28);
    return 0xFFFFFFFFu;
  }
  const auto& known = state.known_names;
  const bool good = name != nullptr ? std::find(known.begin(), known.end(), name) != known.end() : state.opens_null;
  if (!good) {
    fail(0x302, -14);
    return 0xFFFFFFFFu;
  }
  ++state.opened;
  return next_handle++;
}
void hdDisableDevice(unsigned) {
  ++state.closed;
}
void hdMakeCurrentDevice(unsigned) {}
void hdEnable(unsigned what) {
  if (what == 0x4000) state.force_output = true;
}
void hdDisable(unsigned what) {
  if (what == 0x4000) state.force_output = false;
}
void hdStartScheduler() {
  state.running = true;
}
void hdStopScheduler() {
  state.running = false;
}
void hdSetSchedulerRate(unsigned long rate) {
  if (rate != 500 && rate != 1000 && rate != 2000) fail(0x101);
}
unsigned long hdScheduleAsynchronous(unsigned (*callback)(void*), void* data, unsigned short) {
  scheduled.push_back({next_id, callback, data});
  return next_id++;
}
void hdUnschedule(unsigned long id) {
  std::erase_if(scheduled, [&](const Scheduled& entry) { return entry.id == id; });
}
void hdBeginFrame(unsigned) {
  if (state.frame_open) fail(0x400);
  state.frame_open = true;
  ++state.frames;
}
void hdEndFrame(unsigned) {
  if (!state.frame_open) fail(0x401);
  state.frame_open = false;
}
void hdGetDoublev(unsigned what, double* values) {
  static constexpr double kBox[6] = {-105, -110, -85, 105, 110, 85};
  switch (what) {
    case 0x2050:
      std::copy_n(state.position, 3, values);
      break;
    case 0x2052:
      std::copy_n(state.transform, 16, values);
      break;
    case 0x2551:
      std::copy_n(kBox, 6, values);
      break;
    case 0x2602:
      values[0] = 0.5;
      break;
    case 0x2603:
      values[0] = 3.3;
      break;
    case 0x2604:
      values[0] = 0.88;
      break;
    case 0x2605:
      std::fill_n(values, 6, state.temperature);
      break;
    default:
      fail(0x100);
  }
}
void hdGetIntegerv(unsigned what, int* value) {
  switch (what) {
    case 0x2000:
      *value = state.buttons;
      break;
    case 0x2002:
      *value = state.inkwell;
      break;
    case 0x2554:
      *value = state.output_axes;
      break;
    case 0x2555:
      *value = state.style;
      break;
    default:
      fail(0x100);
  }
}
const char* hdGetString(unsigned what) {
  if (what == 0x2501) return "Stand-in Touch";
  return what == 0x2505 ? "192" : "";
}
void hdSetDoublev(unsigned what, const double* values) {
  if (what == 0x2700)
    std::copy_n(values, 3, state.force);
  else if (what == 0x2701)
    std::copy_n(values, 3, state.torque);
  else
    fail(0x100);
}
HdStandIn::Error hdGetError() {
  if (state.errors.empty()) return {};
  const HdStandIn::Error error = state.errors.front();
  state.errors.pop_front();
  return error;
}
const char* hdGetErrorString(unsigned code) {
  if (code == 0x302) return "Communication error between device and host";
  return code == 0x300 ? "Device fault" : "";
}
unsigned hdCheckCalibration() {
  return state.calibration;
}
void hdUpdateCalibration(unsigned style) {
  state.calibrated_with = style;
  state.calibration = 0x5000;
}
}
