// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "geometry/system/error.h"
#include "studies/variants/variant_cell.h"

namespace hapticell::studies {

/// One result of a variant; empty where the question has no answer there.
using Answer = std::variant<std::monostate, double, std::int64_t, std::string>;

/// A column of results.
struct Column {
  enum class Kind { kNumber, kWhole, kText };
  std::string name;  ///< Of a question: "share"; of a study: "reach.share".
  Kind kind = Kind::kNumber;
  std::string unit;  ///< "m", "s", "deg"; empty: none.
};

/// A question that is answered for every variant: a table [[ask]] of the document. Immutable; any thread. The same cell
/// gives the same bits, whatever was asked before.
class Question {
 public:
  explicit Question(std::string name) : name_(std::move(name)) {}
  virtual ~Question() = default;

  const std::string& name() const { return name_; }
  virtual std::vector<Column> columns() const = 0;
  /// One answer a column. An error says why nothing can be answered for this variant; it becomes the row's note.
  virtual Expected<std::vector<Answer>> answer(VariantCell& cell) const = 0;

 private:
  std::string name_;
};

/// A kind of question. A new one is one class and one line of questionKinds().
struct QuestionKind {
  const char* name;  ///< The value of `what`.
  /// Reads the section and everything that it needs. Errors name file, line and key.
  Expected<std::unique_ptr<Question>> (*make)(const StudySection&, StudyInputs&);
};

/// All kinds, in the order of the documentation.
std::span<const QuestionKind> questionKinds();

/// Makes the question of a section. Errors also: an unknown kind.
Expected<std::unique_ptr<Question>> makeQuestion(const StudySection& section, StudyInputs& inputs);

}  // namespace hapticell::studies
