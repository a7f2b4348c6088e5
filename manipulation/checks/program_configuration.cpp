// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/program_configuration.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "kinematics/model/configuration_flags.h"

namespace hapticell::manipulation {

namespace {

using trajectory::ProgramFormat;

std::string wordsOf(const kinematics::ArmShape& shape, const std::array<double, 6>& q, ProgramFormat format) {
  char text[64];
  if (format == ProgramFormat::kKrl) {
    const auto flags = kinematics::kukaFlags(shape, q);
    std::snprintf(text, sizeof text, "S %d,T %d", flags.status, flags.turn);
  } else if (format == ProgramFormat::kRapid) {
    const auto flags = kinematics::abbFlags(shape, q);
    std::snprintf(text, sizeof text, "[%d,%d,%d,%d]", flags.cf1, flags.cf4, flags.cf6, flags.cfx);
  } else {
    const auto flags = kinematics::fanucFlags(shape, q);
    std::snprintf(text, sizeof text, "%c %c %c, %d, %d, %d", flags.wrist, flags.elbow, flags.base, flags.turns[0],
                  flags.turns[1], flags.turns[2]);
  }
  return text;
}

}  // namespace

std::function<std::string(std::span<const double>)> programConfiguration(std::shared_ptr<const kinematics::Chain> chain,
                                                                         ProgramFormat format) {
  const bool has_flags =
      format == ProgramFormat::kKrl || format == ProgramFormat::kRapid || format == ProgramFormat::kFanuc;
  if (!has_flags || !chain || chain->size() != 6) return {};
  return [chain = std::move(chain), format](std::span<const double> joints) -> std::string {
    kinematics::ChainPositions x{};
    std::array<double, 6> q{};
    if (joints.size() < q.size()) return {};
    std::copy_n(joints.begin(), q.size(), x.begin());
    std::copy_n(joints.begin(), q.size(), q.begin());
    const auto shape = kinematics::armShape(*chain, x);
    return shape ? wordsOf(*shape, q, format) : std::string();
  };
}

}  // namespace hapticell::manipulation
