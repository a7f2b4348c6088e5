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
  snapshot.second = own.stylus;
  snapshot.felt_ns = std::max(snapshot.felt_ns, own.felt_ns);
  snapshot.pairs.insert(snapshot.pairs.end(), own.pairs.begin(), own.pairs.end());
  snapshot.limits.insert(snapshot.limits.end(), own.limits.begin(), own.limits.end());
  for (const EntityState& moved : own.entities) {
    if (moved.id != own.stylus.held) continue;
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
