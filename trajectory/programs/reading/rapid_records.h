// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "geometry/shapes/pose.h"
#include "trajectory/programs/reading/program_value.h"

namespace hapticell::trajectory {

inline constexpr double kRapidDegree = 0.017453292519943295;  // rad
inline constexpr double kRapidMillimetre = 1e-3;              // m

/// Which item of a list of the record `type` the field is (from 0), and the field's own type ("" for numbers and
/// records without poses). Without a type it is the first record that has the field. Nothing for any other field.
std::optional<std::pair<std::size_t, std::string>> rapidField(const std::string& type, const std::string& field);

/// X (m) of a robtarget or pose, [[x,y,z],[q1,q2,q3,q4],...] in mm with q1 real. Nothing for other values, for unknown
/// numbers, and for a quaternion whose length is off 1 by more than 0.01.
std::optional<Pose> rapidPose(const Value& value);

/// `like` with the place X; a robtarget of unknown configuration where `like` is no list of two items or more.
Value rapidTarget(const Pose& X, const Value& like);

}  // namespace hapticell::trajectory
