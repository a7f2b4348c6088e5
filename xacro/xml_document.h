// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/system/error.h"

class TiXmlDocument;

namespace hapticell::xacro {

/// Parses XML that comes from outside. `file` is used in messages only. Refused, with the line: a NUL byte, elements
/// nested deeper than 200 (the library recurses), a document type with entities of its own (they unfold without end,
/// and name other files), and what does not parse. The text must be UTF-8 (workcell/text/xml_text.h).
Expected<void> parseXml(const std::string& content, const std::string& file, TiXmlDocument& document);

}  // namespace hapticell::xacro
