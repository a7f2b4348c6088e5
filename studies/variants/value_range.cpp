// SPDX-License-Identifier: Apache-2.0
#include "studies/variants/value_range.h"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <charconv>
#include <cmath>
#include <numbers>

#include "studies/document/study_section.h"

namespace hapticell::studies {

namespace {

/// Values of one range: every one of them is a column's entry. Half: some fine ranges must be split; twice: a full grid
/// of two such ranges has 4e8 variants.
constexpr double kMostSteps = 10'000;

}  // namespace

std::string textOf(const Value& value) {
  if (const auto* word = std::get_if<std::string>(&value)) return *word;
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, std::get<double>(value));
  return std::string(text, end.ptr);
}

Expected<ValueRange> ValueRange::numbers(SectionReader& reader, double unit) {
  workcell::TomlFields& fields = reader.fields();
  ValueRange range;
  std::vector<double> values;
  fields.readList("values", values, unit);
  double steps = 0.0;
  fields.read("from", range.from_, unit);
  fields.read("to", range.to_, unit);
  fields.read("steps", steps, 1.0, 2.0, kMostSteps);
  double middle = 0.0, sigma = 0.0;
  fields.read("middle", middle, unit);
  fields.read("sigma", sigma, unit, 1e-12, 1e6);
  const bool listed = fields.has("values"), ranged = fields.has("from") || fields.has("to") || fields.has("steps"),
             normal = fields.has("sigma") || fields.has("middle");
  if (static_cast<int>(listed) + static_cast<int>(ranged) + static_cast<int>(normal) != 1)
    fields.fail(nullptr, Text("no single range of values"),
                Text("either values, or from and to (with steps), or sigma (with middle)"));
  if (listed && values.empty()) fields.failKey("values", Text("an empty list"), Text("at least one number"));
  if (ranged) {
    fields.require("from");
    fields.require("to");
    if (!(range.to_ > range.from_)) fields.failKey("to", Text("to is not above from"), Text("a greater number"));
    if (std::floor(steps) != steps)
      fields.failKey("steps", Text("steps is not a whole number"), Text("a whole number"));
  }
  if (normal) fields.require("sigma");
  HAPTICELL_TRY(reader.check());
  for (const double value : values) range.values_.emplace_back(value);
  const auto count = static_cast<std::size_t>(steps);
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    range.values_.emplace_back(i + 1 == count ? range.to_ : range.from_ + share * (range.to_ - range.from_));
  }
  if (normal) {
    range.is_normal_ = true;
    range.from_ = middle;
    range.to_ = sigma;
  }
  return range;
}

Expected<ValueRange> ValueRange::words(SectionReader& reader) {
  std::vector<std::string> words;
  reader.fields().require("values");
  reader.fields().readList("values", words);
  if (words.empty()) reader.fields().failKey("values", Text("an empty list"), Text("at least one text"));
  HAPTICELL_TRY(reader.check());
  return ofWords(std::move(words));
}

ValueRange ValueRange::ofWords(std::vector<std::string> words) {
  ValueRange range;
  range.is_words_ = true;
  for (std::string& word : words) range.values_.emplace_back(std::move(word));
  return range;
}

Value ValueRange::atShare(double share) const {
  if (!values_.empty()) {
    const auto count = static_cast<double>(values_.size());
    return values_[std::min(values_.size() - 1, static_cast<std::size_t>(share * count))];
  }
  if (!is_normal_) return from_ + share * (to_ - from_);
  // The quantile is infinite at both ends: a sample there counts as 5.2 sigma (1e-7). Half and twice move it by 0.1
  // sigma.
  const double inner = std::clamp(share, 1e-7, 1.0 - 1e-7);
  return from_ + to_ * std::numbers::sqrt2 * boost::math::erf_inv(2.0 * inner - 1.0);
}

}  // namespace hapticell::studies
