// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/openhaptics/hd_library.h"

#include <dlfcn.h>

#include <clocale>

#include "haptic/devices/driver_support.h"

namespace hapticell::driver {

namespace {

constexpr const char* kInstall =
    "Install 3D Systems' Touch driver and OpenHaptics, or set library = \"/path/libHD.so\" in [driver.openhaptics].";

template <typename Function>
void resolve(void* library, const char* name, Function*& function, std::string& missing) {
  void* const symbol = dlsym(library, name);
  if (symbol == nullptr && missing.empty()) missing = name;
  function = reinterpret_cast<Function*>(symbol);
}

}  // namespace

Problem HdLibrary::load(const std::vector<std::string>& names) {
  Problem problem;
  if (isLoaded()) return problem;
  std::setlocale(LC_ALL, "C");
  void* library = nullptr;
  std::string why;
  for (const std::string& name : names) {
    library = dlopen(name.c_str(), RTLD_NOW | RTLD_GLOBAL);
    if (library != nullptr) {
      file = name;
      break;
    }
    // The first name's reason is the one that matters: the others are fall-backs.
    if (const char* const text = dlerror(); why.empty() && text != nullptr) why = text;
  }
  if (library == nullptr) {
    refuse(problem, Status::kMissingLibrary, "the vendor's library cannot be loaded: " + why, kInstall);
    return problem;
  }
  std::string missing;
#define HAPTICELL_RESOLVE(name) resolve(library, #name, name, missing)
  HAPTICELL_RESOLVE(hdDisableDevice);
  HAPTICELL_RESOLVE(hdMakeCurrentDevice);
  HAPTICELL_RESOLVE(hdEnable);
  HAPTICELL_RESOLVE(hdDisable);
  HAPTICELL_RESOLVE(hdStartScheduler);
  HAPTICELL_RESOLVE(hdStopScheduler);
  HAPTICELL_RESOLVE(hdSetSchedulerRate);
  HAPTICELL_RESOLVE(hdScheduleAsynchronous);
  HAPTICELL_RESOLVE(hdUnschedule);
  HAPTICELL_RESOLVE(hdBeginFrame);
  HAPTICELL_RESOLVE(hdEndFrame);
  HAPTICELL_RESOLVE(hdGetDoublev);
  HAPTICELL_RESOLVE(hdGetIntegerv);
  HAPTICELL_RESOLVE(hdGetString);
  HAPTICELL_RESOLVE(hdSetDoublev);
  HAPTICELL_RESOLVE(hdGetError);
  HAPTICELL_RESOLVE(hdGetErrorString);
  HAPTICELL_RESOLVE(hdCheckCalibration);
  HAPTICELL_RESOLVE(hdUpdateCalibration);
  HAPTICELL_RESOLVE(hdInitDevice);
#undef HAPTICELL_RESOLVE
  if (!missing.empty()) {
    hdInitDevice = nullptr;
    refuse(problem, Status::kMissingLibrary, file + " lacks the function " + missing,
           "Install OpenHaptics 3.4 or later.");
  }
  return problem;
}

}  // namespace hapticell::driver
