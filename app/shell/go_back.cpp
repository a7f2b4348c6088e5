// SPDX-License-Identifier: Apache-2.0
#include "app/shell/go_back.h"

#include "app/host/document_model.h"
#include "app/host/hold_choice.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {

GoBack::GoBack(Host& host) : host_(host), memory_(host.documentModel(), [this] { return placesNow(); }) {}

MotionMemory::Places GoBack::placesNow() const {
  MotionMemory::Places places;
  const SceneModel& scene = host_.viewport().scene();
  for (const auto& entity : host_.documentModel().document().state().entities)
    places[entity->id] = {scene.placement_W(*entity), scene.joints(*entity)};
  return places;
}

void GoBack::start() {
  // s of motion that one step of going back takes; what one remembers having done. Half, twice: more or fewer presses.
  constexpr double kSeconds = 10.0;
  if (host_.snapshot() && host_.snapshot()->stylus.held != 0) {
    waits_ = true;
    return host_.holdChoice().letGo();
  }
  waits_ = false;
  if (!memory_.goBack(kSeconds))
    host_.messages().tell(Severity::kInformation, QObject::tr("There is no motion to go back over."));
}

void GoBack::snapshotCame() {
  if (waits_ && (!host_.snapshot() || host_.snapshot()->stylus.held == 0)) start();
}

}  // namespace hapticell::app
