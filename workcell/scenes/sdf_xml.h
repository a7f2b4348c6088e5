// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml.h>

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::workcell {

/// Reads the root element <sdf> of a file into `document`, in place of what it held. Errors: not readable, no XML, over
/// 200 levels, another root; `document` then holds nothing of use.
Expected<TiXmlElement*> parseSdf(const std::filesystem::path& file, TiXmlDocument& document);

/// Text of the first child of that name, trimmed; empty if there is no such child. `parent` may be null.
std::string textOf(const TiXmlElement* parent, const char* name);
/// The element's own text, trimmed.
std::string textOf(const TiXmlElement& element);
/// Replaces the content of the element.
void setText(TiXmlElement& element, const std::string& text);
std::string attributeOf(const TiXmlElement& element, const char* name);

/// The numbers at the start of a text, up to the first other word; "inf" and "nan" are numbers here.
std::vector<double> numbersIn(const std::string& text);

/// True if the model itself has a joint that moves.
bool hasMovingJoint(const TiXmlElement& model);

}  // namespace hapticell::workcell
