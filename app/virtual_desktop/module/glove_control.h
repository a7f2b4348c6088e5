// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <vector>

#include "app/virtual_desktop/devices/input_devices.h"
#include "manipulation/engine/grasp_keeper.h"

namespace hapticell::app {

class VirtualDesktopController;
struct GlovedHand;

/// What a glove does: poses the hand of a mannequin or a free hand, grasps with it and vibrates where the fingers
/// touch. GUI thread.
class GloveControl {
 public:
  /// Both must outlive it.
  GloveControl(VirtualDesktopController& owner, InputDevices& inputs) : owner_(owner), inputs_(inputs) {}

  /// Poses the hand as the glove is now; call it at each poll of the inputs.
  void pose();
  /// Keeps the hand's posture until the glove moves it again.
  void rest();
  /// The glove is gone: what its hand held stays where it is.
  void end();

 private:
  void keep(std::vector<double> joints);
  void keepRested();
  void grasp(const GlovedHand& hand);
  bool mayGrasp(workcell::EntityId entity, workcell::EntityId hand) const;
  void vibrate(const GlovedHand& hand);
  std::vector<double> posedJoints(workcell::EntityId id) const;

  VirtualDesktopController& owner_;
  InputDevices& inputs_;
  workcell::EntityId hand_ = 0;  // The mannequin or free hand that the glove controls.
  std::vector<double> joints_;   // As the glove asks; the snapshot says how far they came.
  manipulation::GraspKeeper grasp_;
  QElapsedTimer rests_;
};

}  // namespace hapticell::app
