// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/system/error.h"
#include "haptic/client/tcp_link.h"
#include "manipulation/checks/motion_replay.h"
#include "workcell/document/document.h"

namespace hapticell::bridge {

/// The robot with the name `entity`; if that is empty, the only robot of the cell. `cell` names the cell in errors.
/// Errors: no robot, several.
Expected<std::shared_ptr<const workcell::Entity>> robotToPublish(const workcell::Document& document,
                                                                 const std::string& entity, const std::string& cell);

/// A motion of the robot from a file of any format that is read; `notes` gets what was assumed. Errors: the file, joints
/// that the robot does not have.
Expected<manipulation::MotionReplay> replayOfFile(const workcell::Document& document, const workcell::Entity& robot,
                                                  const std::string& file, std::vector<Text>& notes);

/// A connection that watches the haptic server at HOST:PORT; null if `server` is empty. Errors: no such address (it names
/// `option`); no server answers within 5 s.
Expected<std::unique_ptr<haptic::TcpLink>> watchedServer(const std::string& server, std::string_view option);

}  // namespace hapticell::bridge
