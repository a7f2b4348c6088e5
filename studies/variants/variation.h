// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>

#include "studies/variants/value_range.h"
#include "studies/variants/variant_cell.h"

namespace hapticell::studies {

/// One thing that varies: a table [[vary]] of the document. Immutable; any thread.
class Variation {
 public:
  Variation(std::string name, ValueRange range) : name_(std::move(name)), range_(std::move(range)) {}
  virtual ~Variation() = default;

  const std::string& name() const { return name_; }
  const ValueRange& range() const { return range_; }
  /// Unit of its numbers: "m", "deg"; empty for words.
  virtual std::string unit() const { return {}; }
  /// True if it replaces a shape of the cell. Such variations are applied first, so that the others move the new shape.
  virtual bool changesShape() const { return false; }
  /// Changes the cell of a variant. Errors say why the cell cannot be so.
  virtual Expected<void> apply(const Value& value, VariantCell& cell) const = 0;

 private:
  std::string name_;
  ValueRange range_;
};

/// A kind of variation. A new one is one class and one line of variationKinds().
struct VariationKind {
  const char* name;  ///< The value of `what`.
  /// Reads the section and everything that it needs. Errors name file, line and key.
  Expected<std::unique_ptr<Variation>> (*make)(const StudySection&, StudyInputs&);
};

/// All kinds, in the order of the documentation.
std::span<const VariationKind> variationKinds();

/// Makes the variation of a section. Errors also: an unknown kind.
Expected<std::unique_ptr<Variation>> makeVariation(const StudySection& section, StudyInputs& inputs);

}  // namespace hapticell::studies
