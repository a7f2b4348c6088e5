// SPDX-License-Identifier: Apache-2.0
// A driver that notes each time that it is asked for devices (setting "log": a file, a line each), or ends its process
// instead (setting "crash").
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "haptic/devices/driver_support.h"

namespace {

using namespace hapticell::driver;

class CountedDriver final : public Driver {
 public:
  const Information& information() const noexcept override { return information_; }
  void configure(const char* key, const char* value) noexcept override {
    if (std::string_view(key) == "log") log_ = value;
    if (std::string_view(key) == "crash") crash_ = true;
  }
  std::uint32_t find(Found*, std::uint32_t, Problem&) noexcept override {
    if (crash_) std::_Exit(134);
    if (std::FILE* const log = std::fopen(log_.c_str(), "a")) {
      std::fputs("asked\n", log);
      std::fclose(log);
    }
    return 0;
  }
  Device* open(const char*, Problem&) noexcept override { return nullptr; }
  void close(Device*) noexcept override {}
  std::uint64_t presence() noexcept override { return 1; }

 private:
  Information information_{"counted", "Counted", "1", "", ""};
  std::string log_;
  bool crash_ = false;
};

}  // namespace

HAPTICELL_DRIVER(new CountedDriver)
