// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "workcell/document/document.h"

namespace hapticell::test {

/// A box of 0.1 m at x.
workcell::Entity makeSolid(const std::string& name, double x = 0.0);

/// A robot of one turning joint, "shoulder", from `lower` to 1 rad; its links are "base" and "upper".
workcell::Entity makeArm(const std::string& name, double lower = -1.0);

/// Solids "table", "part", "frame" and "leaf" and the robot "robot".
workcell::Document cellOfEverything();

/// Makes a command for the document as it is by then: ids are given as entities come.
using CommandMaker = std::function<workcell::Command(const workcell::Document&)>;

/// One command of each kind for cellOfEverything(), in an order in which all of them are accepted.
std::vector<CommandMaker> oneOfEach(const workcell::Document& document);

/// The document's whole state as text: what is saved, and what only the memory holds.
std::string everything(const workcell::Document& document);

}  // namespace hapticell::test
