// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/device/device_list.h"
#include "config/configuration.h"

namespace hapticell::cli {

enum class Health {
  kGood,
  kNote,     ///< HaptiCell works; worth knowing.
  kProblem,  ///< Something does not work, or not well, until it is fixed.
};

/// Result of one check of `doctor`.
struct HealthCheck {
  std::string what;  ///< In a word or two: "OpenGL".
  Health health = Health::kGood;
  std::string found;  ///< One line.
  std::string fix{};  ///< What to do; empty if nothing.
};

/// The graphics card's device, and OpenGL as available to the window.
std::vector<HealthCheck> graphicsChecks();
/// Real-time priority, locked memory, udev rules, serial ports.
std::vector<HealthCheck> grantChecks();
/// The connected devices, as the drivers report them.
std::vector<HealthCheck> deviceChecks(const std::vector<DriverEntries>& drivers);
/// The other programs of the installation.
std::vector<HealthCheck> programChecks();
/// The haptic server's port on this machine.
HealthCheck portCheck(const config::Configuration& configuration);
/// Free space and permissions in the folders that are written to.
std::vector<HealthCheck> diskChecks();

}  // namespace hapticell::cli
