// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/module/force_state.h"

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/style/library_text.h"
#include "app/virtual_desktop/module/virtual_desktop_controller.h"

namespace hapticell::app {

void ForceState::setWanted(bool on) {
  wanted_ = on;
  cut_ = lost_ = false;
}

void ForceState::connectionChanged() {
  wanted_ = cut_ = false;
}

void ForceState::reset() {
  wanted_ = lost_ = false;
}

void ForceState::snapshotCame(bool cut) {
  since_snapshot_.start();
  if (owner_.snapshot().stylus.forces_on) cut_ = false;
  if (cut) reportCut();
}

ForceFacts ForceState::facts() const {
  ForceFacts facts;
  facts.started = owner_.isStarted();
  facts.connected = owner_.isConnected();
  facts.watching = owner_.isWatching();
  facts.lost = lost_;
  facts.forceless = owner_.device() && owner_.device()->driven_axes == 0;
  facts.wanted = wanted_;
  facts.on = facts.connected && owner_.snapshot().stylus.forces_on;
  facts.ramp = owner_.snapshot().stylus.force_ramp;
  facts.device_fault = facts.connected && owner_.snapshot().stylus.device_fault;
  // ms without a snapshot until the loop counts as dead; by trial. Half: said where a loop is only busy; twice: a dead
  // loop is unsaid for longer.
  constexpr qint64 kStalled = 2000;
  facts.stalled =
      facts.connected && wanted_ &&
      (owner_.snapshot().stylus.loop_stalled || (since_snapshot_.isValid() && since_snapshot_.elapsed() > kStalled));
  facts.cut = cut_;
  // m to the workspace's edge that count as there: the stops give a little. Half: it flickers; twice: said before the
  // stop is felt.
  constexpr double kEdge = 1e-3;
  facts.at_edge = owner_.device() && owner_.snapshot().stylus.device_edge_m < kEdge;
  facts.held = owner_.snapshot().stylus.held != 0;
  if (const workcell::Entity* held = owner_.host().documentModel().document().find(owner_.snapshot().stylus.held)) {
    facts.checked = held->checked;
    facts.passes = owner_.settings().on_contact == workcell::OnContact::kPass;
  }
  if (!facts.connected) facts.problem = owner_.link().problem();
  return facts;
}

void ForceState::reportCut() {
  cut_ = true;
  owner_.sound().strike(SoundEvent::kFault);
  owner_.host().messages().tell(Severity::kWarning, QObject::tr("Forces switched off"), forceReason(facts()).why);
}

void ForceState::reportLoss() {
  owner_.sound().strike(SoundEvent::kFault);
  if (owner_.isWatching() || owner_.link().isRefused()) {
    owner_.host().messages().tell(Severity::kProblem,
                                  QObject::tr("Forces are off: another window took control of the stylus"),
                                  QObject::tr("To take it back, use Take control in the Virtual Desktop panel."));
    return;
  }
  lost_ = true;
  owner_.host().messages().tell(
      Severity::kProblem, QObject::tr("Forces are off: the haptic server stopped responding"),
      shownText(owner_.link().problem()) + QLatin1Char(' ') +
          QObject::tr(
              "The held entity stays in place. When a server responds again, press Ctrl+Space to turn the forces on."));
}

}  // namespace hapticell::app
