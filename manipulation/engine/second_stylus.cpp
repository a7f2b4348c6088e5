// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/second_stylus.h"

#include <algorithm>

namespace hapticell::manipulation {

SecondStylus::SecondStylus(std::unique_ptr<haptic::HapticLink> link, ManipulationEngine& engine)
    : link_(std::move(link)), engine_(engine), holder_(*link_, engine.cell()) {
  engine_.setSecond(&holder_);
}

SecondStylus::~SecondStylus() {
  engine_.setSecond(nullptr);
}

void SecondStylus::addTo(SceneSnapshot& snapshot) {
  SceneSnapshot own;
  holder_.addTo(own);
  holder_.describe(own);
  SecondStylusState& second = snapshot.second.emplace();
  second.connected = own.connected;
  second.forces_on = own.forces_on;
  second.device_fault = own.device_fault;
  second.held = own.held;
  second.X_WStylus = own.X_WStylus;
  second.X_DS = own.X_DS;
  second.force_W = own.force_W;
  second.force_n = own.force_n;
  second.motion_scale = own.motion_scale;
  snapshot.felt_ns = std::max(snapshot.felt_ns, own.felt_ns);
  snapshot.pairs.insert(snapshot.pairs.end(), own.pairs.begin(), own.pairs.end());
  snapshot.limits.insert(snapshot.limits.end(), own.limits.begin(), own.limits.end());
  for (const EntityState& moved : own.entities) {
    if (moved.id != own.held) continue;
    const auto known = std::find_if(snapshot.entities.begin(), snapshot.entities.end(),
                                    [&](const EntityState& entity) { return entity.id == moved.id; });
    if (known == snapshot.entities.end()) {
      snapshot.entities.push_back(moved);
    } else {
      known->in_contact = known->in_contact || moved.in_contact;
      known->near_miss = known->near_miss || moved.near_miss;
    }
  }
}

}  // namespace hapticell::manipulation
