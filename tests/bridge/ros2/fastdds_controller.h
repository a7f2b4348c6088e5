// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <string>

/// Plays a controller with the action FollowJointTrajectory as rmw_fastrtps ("plain") or rmw_cyclonedds ("numbered") put it
/// on the wire, and the robot's joint states. Prints a JSON object for each goal, cancellation and state.
///
/// `joints`: "A1=0.5,A2=-0.25", where the robot is. `behaviour`: "follow"; "noise" (also answers another client's goals
/// and reports on them), "reject", "abort" (after 0.3 s), "deaf" (cancels nothing), "silent" (no joint states after 0.3 s),
/// "stray" (a joint leaves the motion after 0.3 s), "idle" (accepts, never begins). Ends after `seconds`.
int playController(eprosima::fastdds::dds::DomainParticipant* participant, const std::string& action, const std::string& form,
                   double seconds, const std::string& joints, const std::string& behaviour);
