// SPDX-License-Identifier: Apache-2.0
// A stylus in the hand of a test: where it is (m, D) and what is pressed stand in the file of the setting "hand", as
// "x y z buttons". Without that setting there is none.
#include <fstream>
#include <string>
#include <string_view>

#include "haptic/devices/driver_support.h"

namespace {

using namespace hapticell::driver;

class Handy final : public Device {
 public:
  explicit Handy(const std::string& file) : file_(file) {
    copyText(capabilities_.name, "Handy stylus");
    capabilities_.measured_axes = 3;
    capabilities_.driven_axes = 3;
    capabilities_.peak_force = 3.0;
    capabilities_.continuous_force = 1.0;
    capabilities_.buttons = 2;
    for (int i = 0; i < 3; ++i) capabilities_.workspace_min[i] = -0.08, capabilities_.workspace_max[i] = 0.08;
  }
  const Capabilities& capabilities() const noexcept override { return capabilities_; }
  Status read(State& state) noexcept override {
    State now;
    std::ifstream file(file_);
    if (!(file >> now.position[0] >> now.position[1] >> now.position[2] >> now.buttons)) return Status::kNothingNew;
    now.flags = kCalibrated;
    state = now;
    return Status::kOk;
  }
  Status write(const Command&) noexcept override { return Status::kOk; }
  const Problem& problem() const noexcept override { return problem_; }

 private:
  const std::string& file_;
  Capabilities capabilities_;
  Problem problem_;
};

class HandyDriver final : public Driver {
 public:
  const Information& information() const noexcept override { return information_; }
  void configure(const char* key, const char* value) noexcept override {
    if (std::string_view(key) == "hand") file_ = value;
  }
  std::uint32_t find(Found* found, std::uint32_t room, Problem&) noexcept override {
    if (file_.empty()) return 0;
    if (room > 0) copyText(found[0].id, "first"), copyText(found[0].name, "Handy stylus");
    return 1;
  }
  Device* open(const char*, Problem& problem) noexcept override {
    if (!file_.empty()) return &device_;
    refuse(problem, Status::kNotFound, "nobody holds it", "Set hand in [driver.handy].");
    return nullptr;
  }
  void close(Device*) noexcept override {}

 private:
  Information information_{"handy", "In the hand of a test", "1.0", "", ""};
  std::string file_;
  Handy device_{file_};
};

}  // namespace

HAPTICELL_DRIVER(new HandyDriver)
