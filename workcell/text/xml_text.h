// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace hapticell::workcell {

/// Text for TinyXML.
struct XmlText {
  std::string text;
  std::size_t replaced = 0;  ///< Bytes that were not part of a UTF-8 character, and were read as Latin-1.
  std::size_t line = 0;      ///< Line of the first of them, from 1; 0: no such byte.
};

/// `text` as UTF-8: each byte that is not part of a UTF-8 character (RFC 3629) is read as Latin-1 (ISO 8859-1), in
/// which older programs write names and comments whatever the file says; 0x80 to 0x9F, which are control characters
/// there, become question marks. TinyXML 2.6.2 trusts the first byte of a character for its length and would read past
/// the end of a text that stops within one.
XmlText soundXmlText(const std::string& text);

}  // namespace hapticell::workcell
