// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml.h>

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::workcell {

/// The root element <sdf> of a file, in `document`. Errors: not readable, no XML, nested deeper than 200, another root.
Expected<TiXmlElement*> parseSdf(const std::filesystem::path& file, TiXmlDocument& document);

/// Text of the first child of that name, trimmed; empty if there is no such child. `parent` may be null.
std::string textOf(const TiXmlElement* parent, const char* name);
/// The element's own text, trimmed.
std::string textOf(const TiXmlElement& element);
/// Replaces the content of the element.
void setText(TiXmlElement& element, const std::string& text);
std::string attributeOf(const TiXmlElement& element, const char* name);

/// The numbers of a text as far as they go; "inf" and "nan" are numbers here.
std::vector<double> numbersIn(const std::string& text);

/// A joint of the model itself that moves.
bool hasMovingJoint(const TiXmlElement& model);

}  // namespace hapticell::workcell
