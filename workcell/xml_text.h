// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace hapticell::workcell {

/// Text for TinyXML, ours and urdfdom's.
struct XmlText {
  std::string text;
  std::size_t replaced = 0;  ///< Bytes that were no UTF-8.
  std::size_t line = 0;      ///< Of the first of them, from 1; 0: there was none.
};

/// `text` with a question mark for each byte that is no part of a UTF-8 character (RFC 3629). Files that say they are
/// UTF-8 often have comments in Latin-1; and TinyXML 2.6.2 takes the first byte of a character for all of it and reads
/// past the end of a text that stops within one.
XmlText soundXmlText(std::string text);

}  // namespace hapticell::workcell
