// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/shapes/vector.h"
#include "geometry/system/error.h"

namespace hapticell::workcell {

/// Reads text line by line and word by word without copying. Lines end with LF, CR LF or CR; words are separated by
/// blanks and tabs. The text must outlive the cursor.
class TextCursor {
 public:
  /// kBackslash: a line that ends with '\' continues in the next (OBJ), except for a comment ('#').
  enum class Continuation { kNone, kBackslash };

  explicit TextCursor(std::string_view text, Continuation continuation = Continuation::kNone);

  /// Goes to the next line; false at the end of the text.
  bool nextLine();
  /// The next word of this line; empty at its end.
  std::string_view nextWord();
  /// The next word of this or a later line; empty at the end of the text.
  std::string_view nextWordOfText();
  /// The rest of this line, without blanks at either end; consumes the line.
  std::string_view restOfLine();

  std::size_t lineNumber() const { return line_number_; }
  Text place() const { return Text("line %1", line_number_); }
  /// Bytes of the text after the last word.
  std::size_t bytesLeft() const { return line_.size() + text_.size() - next_; }

 private:
  std::string_view text_;
  Continuation continuation_;
  std::size_t next_ = 0;         // Start of the next line.
  std::size_t line_number_ = 0;  // Counted from 1.
  std::string_view line_;        // The rest of the current line.
};

/// A number with '.' as decimal point whatever the locale; the whole word must be a number. "nan" and "inf" are numbers
/// here.
std::optional<double> parseNumber(std::string_view word);
std::optional<std::int64_t> parseInteger(std::string_view word);

/// The word in quotes, limited to 40 bytes, with unprintable characters replaced: for messages.
std::string inQuotes(std::string_view word);

/// Reads three words as a vertex; an error names the line and the word. Error also if not isUsable().
Expected<dvec3> readPoint(TextCursor& cursor);

/// Finite and not too large for computations (at most 1e12 in any unit).
bool isUsable(double coordinate);
bool isUsable(const dvec3& point);

/// The error for an unusable vertex: "vertex with the coordinate nan".
Error unusableCoordinate(Text place, const dvec3& point);

}  // namespace hapticell::workcell
