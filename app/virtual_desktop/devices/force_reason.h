// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <vector>

#include "app/viewport/widget/touch_meter.h"
#include "haptic/protocol/link_problem.h"
#include "haptic/protocol/messages.h"
#include "manipulation/engine/scene_snapshot.h"

namespace hapticell::app {

/// What the panel knows about the forces.
struct ForceFacts {
  bool started = false;         ///< The loop runs.
  bool connected = false;       ///< The haptic server answers, and this window controls the stylus.
  bool watching = false;        ///< It answers, but another window controls the stylus.
  bool forceless = false;       ///< The device has no motors: a 3D mouse.
  bool device_fault = false;    ///< The device itself does not answer.
  bool stalled = false;         ///< The simulation loop is not responding: the server lets the force fade.
  bool wanted = false;          ///< The user has switched forces on.
  bool on = false;              ///< They are active.
  bool cut = false;             ///< They were switched off without a request, and are not back yet.
  bool lost = false;            ///< They went off because the server is gone, and were not requested since.
  bool at_edge = false;         ///< The device is at the edge of its workspace.
  double ramp = 0.0;            ///< 0 to 1.
  haptic::LinkProblem problem;  ///< Why there is no connection; may be empty.
  bool held = true;             ///< Something is held.
  bool checked = true;          ///< It is checked for collisions.
  bool passes = false;          ///< Its contact mode is Pass: contacts are only shown.
};

/// The state of the forces in two words, one line with the reason, and its remedy.
struct ForceReason {
  enum class Fix { kNone, kConnect, kStartServer, kTakeStylus, kCheck, kSlide };
  QString state;
  QString why;
  Fix fix = Fix::kNone;
  QString button;  ///< Text of the button with the remedy; empty for kNone.
};

ForceReason forceReason(const ForceFacts& facts);

/// "4 mm of hand → 1 mm in the cell" for 0.25.
QString scaleNote(double motion_scale);

/// One line of the device check.
struct DeviceCheck {
  enum class Result { kGood, kWarning, kProblem, kOpen };
  Result result = Result::kOpen;
  QString title, detail;
};

/// Delay of the picture relative to the felt contact.
struct TouchSight {
  TouchMeter::Figures figures;
  bool software = false;  ///< The picture is drawn without a graphics card.
  double frame_s = 0.0;   ///< Duration of a frame.
};

/// Longest unnoticed delay between feeling and seeing a contact, seconds: with a graphics card, a frame and a fixed
/// time; without one, a larger fixed time.
double longestUnnoticed(const TouchSight& sight);

/// What can be said about the device without moving it: server, device, loop, contacts, their picture, range.
std::vector<DeviceCheck> deviceChecks(const QString& server, const ForceFacts& facts,
                                      const haptic::DeviceDescription* device, const manipulation::SceneSnapshot& now,
                                      const TouchSight& sight = {});

}  // namespace hapticell::app
