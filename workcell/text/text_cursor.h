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

/// Walks through text line by line and word by word without copying. Lines end with LF, CR LF or CR; words are
/// separated by blanks and tabs. The text must outlive the cursor.
class TextCursor {
 public:
  /// kBackslash: a line that ends with '\' goes on in the next (OBJ), but for a comment's '#' that ends with one.
  enum class Continuation { kNone, kBackslash };

  explicit TextCursor(std::string_view text, Continuation continuation = Continuation::kNone);

  /// Goes to the next line; false at the end of the text.
  bool nextLine();
  /// The next word of this line; empty at its end.
  std::string_view nextWord();
  /// The next word of this or a later line; empty at the end of the text.
  std::string_view nextWordOfText();
  /// The rest of this line, without blanks at either end; the line is then used up.
  std::string_view restOfLine();

  std::size_t lineNumber() const { return line_number_; }
  Text place() const { return Text("line %1", line_number_); }
  /// Bytes of the text after the last word.
  std::size_t bytesLeft() const { return line_.size() + text_.size() - next_; }

 private:
  std::string_view text_;
  Continuation continuation_;
  std::size_t next_ = 0;         // Where the next line begins.
  std::size_t line_number_ = 0;  // Counted from 1.
  std::string_view line_;        // What is left of the current line.
};

/// A number with '.' as decimal point whatever the locale; the whole word must be one. "nan" and "inf" are numbers
/// here.
std::optional<double> parseNumber(std::string_view word);
std::optional<std::int64_t> parseInteger(std::string_view word);

/// The word in quotes, cut to 40 bytes, with unprintable characters replaced: for messages.
std::string inQuotes(std::string_view word);

/// Three words as a vertex; an error names the line and the word. Refuses what isUsable refuses.
Expected<dvec3> readPoint(TextCursor& cursor);

/// Finite and of a size that arithmetic survives (at most 1e12 in any unit).
bool isUsable(double coordinate);
bool isUsable(const dvec3& point);

/// The error for a vertex that is not: "vertex with the coordinate nan".
Error unusableCoordinate(Text place, const dvec3& point);

}  // namespace hapticell::workcell
