// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml.h>

#include <functional>
#include <string>
#include <vector>

#include "geometry/system/text.h"

namespace hapticell::workcell {

// The values in an SDF file, made as libsdformat accepts them: it refuses a file for one word too many. What is changed
// or left out is told, a few words each, as of the element around it.

using TellSdf = std::function<void(Text)>;

/// Numbers as they stand in an SDF file, with all digits.
std::string sdfTextOf(const std::vector<double>& numbers);

/// How many numbers stand in an element of that name; 0: it holds no numbers.
std::size_t sdfNumbersOf(const std::string& name);

// Each settles the content of one element and returns whether it stays in the file.

/// <pose>: six numbers, or seven with a quaternion; missing ones are 0.
bool keepSdfPose(TiXmlElement& pose, const TellSdf& tell);
/// An element of sdfNumbersOf() > 0.
bool keepSdfNumbers(TiXmlElement& element, const TellSdf& tell);
/// "true" or "false"; what is neither is taken as its default.
bool keepSdfWord(TiXmlElement& element);
/// <geometry>: a shape whose size is missing would get one that the standard makes up.
bool keepSdfShape(const TiXmlElement& geometry, const TellSdf& tell);

}  // namespace hapticell::workcell
