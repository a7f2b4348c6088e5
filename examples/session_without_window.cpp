// SPDX-License-Identifier: Apache-2.0
// A session without a window: a simulated hand takes a box, presses it onto a table, and the force is felt.
// It runs in virtual time: the same figures each time, on every machine.
#include <haptic/devices/hand_path.h>
#include <manipulation/session/session.h>
#include <workcell/import/entity_source.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

using hapticell::Pose;
namespace haptic = hapticell::haptic;
namespace manipulation = hapticell::manipulation;
namespace workcell = hapticell::workcell;

namespace {

/// The button is pressed at the start; then the hand sinks by 30 mm, rests, and rises again.
haptic::HandPath hand() {
  std::vector<haptic::HandSample> samples;
  for (int i = 0; i <= 400; ++i) {
    const double t = 0.01 * i;
    const double down = std::clamp(t - 0.5, 0.0, 1.0) - std::clamp(t - 2.5, 0.0, 1.0);
    samples.push_back({t, Pose::translation({0.0, 0.0, -0.030 * down}), i >= 5 && i < 15 ? 1U : 0U});
  }
  return haptic::HandPath(samples);
}

}  // namespace

int main() {
  // What the document would hold: files (STL, STEP, URDF ...) or built-in parts, by the same call.
  workcell::EntityLoader loader(".");
  hapticell::Diagnostics diagnostics;
  manipulation::SessionOptions options;
  const struct {
    const char *source, *name;
    Pose X_WE;
  } parts[] = {{"box:1,1,0.1", "table", Pose::translation({0.0, 0.0, -0.05})},
               {"box:0.06,0.06,0.06", "box", Pose::translation({0.0, 0.0, 0.05})}};
  for (const auto& part : parts) {
    auto entity = loader.load(part.source, 1.0, diagnostics);
    if (!entity) {
      std::fprintf(stderr, "%s\n", entity.error().message().c_str());
      return 1;
    }
    entity->id = options.entities.size() + 1;
    entity->name = part.name;
    entity->X_WE = part.X_WE;
    options.entities.push_back(*entity);
  }
  options.entity = "box";
  options.hand = hand();
  options.configuration.manipulation.rate_hz = 250.0;

  const auto report = manipulation::runSession(options);
  if (!report) {
    std::fprintf(stderr, "%s\n", report.error().message().c_str());
    return 1;
  }
  std::printf("%.1f s, most force %.1f N, deepest %.4f mm\n", report->duration_s, report->forces.force_max_n,
              1e3 * report->forces.penetration_max_m);
  for (const auto& contact : report->contacts)
    std::printf("touched %s from %.2f to %.2f s\n", options.entities[contact.other - 1].name.c_str(), contact.time_in,
                contact.time_out);
  std::printf("the box ends at %.1f mm\n", 1e3 * report->end.configuration.X_WE.p.z);
  return 0;
}
