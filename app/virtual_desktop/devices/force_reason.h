// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <vector>

#include "app/viewport/widget/touch_meter.h"
#include "haptic/protocol/link_problem.h"
#include "haptic/protocol/messages.h"
#include "manipulation/engine/scene_snapshot.h"

namespace hapticell::app {

/// What the panel knows of the forces.
struct ForceFacts {
  bool started = false;         ///< The loop runs.
  bool connected = false;       ///< A haptic server answers, and this window has the stylus.
  bool watching = false;        ///< It answers, but another window has the stylus.
  bool forceless = false;       ///< The device has no motors: a 3-D mouse.
  bool device_fault = false;    ///< The device itself does not answer.
  bool stalled = false;         ///< The simulation loop is not responding: the server lets the force fade.
  bool wanted = false;          ///< The user has switched forces on.
  bool on = false;              ///< They act.
  bool cut = false;             ///< They went off though nobody asked for it, and are not back yet.
  bool lost = false;            ///< They went off with the server, and were not asked for since.
  bool at_edge = false;         ///< The device is at the end of its range.
  double ramp = 0.0;            ///< 0 .. 1.
  haptic::LinkProblem problem;  ///< Why there is no connection; may be empty.
  bool held = true;             ///< Something is held.
  bool checked = true;          ///< It takes part in collision checks.
  bool passes = false;          ///< On contact it passes: contacts are only shown.
};

/// The state of the forces in two words, one line with the reason, and how to fix it.
struct ForceReason {
  enum class Fix { kNone, kConnect, kStartServer, kTakeStylus, kCheck, kSlide };
  QString state;
  QString why;
  Fix fix = Fix::kNone;
  QString button;  ///< Text of the button that fixes it; empty for kNone.
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

/// How soon the window shows what is felt.
struct TouchSight {
  TouchMeter::Figures figures;
  bool software = false;  ///< The picture is drawn without a graphics card.
  double frame_s = 0.0;   ///< What a frame takes.
};

/// The longest that the picture of a contact may take after it is felt, seconds: touch may lead the picture by that
/// much before it is noticed, beyond the frame, on a graphics card; more without one.
double longestUnnoticed(const TouchSight& sight);

/// What can be said of the device without moving it: server, device, loop, contacts, their picture, range.
std::vector<DeviceCheck> deviceChecks(const QString& server, const ForceFacts& facts,
                                      const haptic::DeviceDescription* device, const manipulation::SceneSnapshot& now,
                                      const TouchSight& sight = {});

}  // namespace hapticell::app
