// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/shapes/pose.h"
#include "geometry/system/text.h"
#include "trajectory/motion/trajectory.h"
#include "trajectory/training/training.h"

namespace hapticell::exchange {

/// The stylus at one tick of the force loop, and what it held.
struct StylusSample {
  double t = 0.0;         ///< s
  Pose X_DS;              ///< Measured stylus in the device's frame.
  Pose X_DP;              ///< Its proxy: where the stylus would be if it obeyed all contacts.
  dvec3 force_D{0.0};     ///< Commanded force on the hand, N.
  dvec3 torque_D{0.0};    ///< N m; zero on a device without torque.
  std::uint32_t buttons = 0;  ///< Bit i set while button i is pressed.
  bool contact = false;
  Pose X_WM;  ///< The moved frame of the held entity in the world; identity while nothing is held.
  bool operator==(const StylusSample&) const;
};

/// Everything of a recording that other programs can use, on one clock. A value.
struct Recording {
  std::vector<trajectory::Trajectory> motions;  ///< The first is the one that was asked for.
  std::vector<StylusSample> stylus;             ///< Times increase strictly; empty if no stylus took part.
  bool has_moved_frame = false;                 ///< Whether X_WM of the samples means anything.
  std::vector<trajectory::Trajectory::Touch> contacts;  ///< Of the session, by time of coming.
  std::vector<trajectory::TrainingSession> trainings;   ///< Scores of trainees.
  /// The result of the session or whatever else belongs to it: name and JSON text.
  std::vector<std::pair<std::string, std::string>> files;
  std::vector<Text> notes;  ///< What a reader assumed or left out.

  bool isEmpty() const {
    return motions.empty() && stylus.empty() && contacts.empty() && trainings.empty() && files.empty();
  }
};

}  // namespace hapticell::exchange
