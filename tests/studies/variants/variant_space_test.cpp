// SPDX-License-Identifier: Apache-2.0
#include "studies/variants/variant_space.h"

#include <gtest/gtest.h>

#include <set>

#include "studies/document/study_section.h"
#include "studies/variants/low_discrepancy.h"

namespace hapticell::studies {
namespace {

/// Changes nothing.
class Nothing : public Variation {
 public:
  using Variation::Variation;
  Expected<void> apply(const Value&, VariantCell&) const override { return {}; }
};

struct Made {
  StudyDocument document;
  std::vector<std::unique_ptr<Variation>> variations;
  Expected<VariantSpace> space;
};

/// A study whose variations have these ranges, written as TOML.
Made made(const std::vector<std::string>& ranges, const std::string& more = "") {
  std::string text = "cell = \"a\"\n";
  for (std::size_t i = 0; i < ranges.size(); ++i)
    text += "[[vary]]\nwhat = \"v\"\nname = \"v" + std::to_string(i) + "\"\n" + ranges[i] + "\n";
  text += "[[ask]]\nwhat = \"q\"\n" + more;
  Made result{*StudyDocument::parse(text, "/tmp/s.hstudy"), {}, makeError({.found = "not made"})};
  for (const StudySection& section : result.document.variations) {
    SectionReader reader(section);
    auto range = section.table->contains("words") ? ValueRange::ofWords({"a", "b", "c"}) : *ValueRange::numbers(reader);
    result.variations.push_back(std::make_unique<Nothing>(section.name, std::move(range)));
  }
  result.space = VariantSpace::create(result.document, result.variations);
  return result;
}

TEST(LowDiscrepancy, HaltonHasThePublishedNumbers) {
  // Radical inverses of 1, 2, 3, 4 in bases 2 and 3.
  const double base2[] = {0.5, 0.25, 0.75, 0.125}, base3[] = {1.0 / 3, 2.0 / 3, 1.0 / 9, 4.0 / 9};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto sample = haltonSample(i, 2, 0);
    EXPECT_DOUBLE_EQ(sample[0], base2[i]);
    EXPECT_DOUBLE_EQ(sample[1], base3[i]);
  }
}

TEST(LowDiscrepancy, SamplesFillEveryCellOfAGridOnce) {
  // A Sobol sequence in two dimensions is a (0, 2)-sequence: of 16 samples one lies in each of 4 x 4 cells.
  std::set<std::pair<int, int>> cells;
  for (std::size_t i = 0; i < 15; ++i) {
    const auto sample = sobolSample(i, 2, 0);
    cells.insert({static_cast<int>(4 * sample[0]), static_cast<int>(4 * sample[1])});
  }
  EXPECT_EQ(cells.size(), 15U);
}

TEST(LowDiscrepancy, TheSeedShiftsAndStaysInside) {
  for (std::size_t i = 0; i < 200; ++i) {
    for (const auto& sample : {haltonSample(i, 5, 3), sobolSample(i, 5, 3)})
      for (const double number : sample) EXPECT_TRUE(number >= 0.0 && number < 1.0);
  }
  EXPECT_NE(haltonSample(0, 2, 1), haltonSample(0, 2, 2));
  EXPECT_EQ(sobolSample(9, 3, 7), sobolSample(9, 3, 7));
}

TEST(ValueRange, NormalTolerancesHaveTheQuantilesOfTables) {
  const Made study = made({"middle = 2.0\nsigma = 0.5"}, "[sampling]\nmethod = \"sobol\"\nsamples = 4\n");
  const ValueRange& range = study.variations[0]->range();
  EXPECT_NEAR(std::get<double>(range.atShare(0.5)), 2.0, 1e-12);
  EXPECT_NEAR(std::get<double>(range.atShare(0.9)), 2.0 + 0.5 * 1.2815515655, 1e-9);
  EXPECT_NEAR(std::get<double>(range.atShare(0.025)), 2.0 - 0.5 * 1.9599639845, 1e-9);
}

TEST(VariantSpace, AGridHasEveryCombinationOnce) {
  const Made study = made({"from = 0.0\nto = 1.0\nsteps = 3", "words = true", "values = [5.0, 7.0]"});
  ASSERT_TRUE(study.space) << study.space.error().message();
  EXPECT_EQ(study.space->count(), 18U);
  std::set<std::string> seen;
  for (std::size_t i = 0; i < 18; ++i) {
    std::string words;
    for (const Value& value : study.space->values(i)) words += textOf(value) + " ";
    seen.insert(words);
  }
  EXPECT_EQ(seen.size(), 18U);
  EXPECT_EQ(textOf(study.space->values(17)[0]), "1");
}

TEST(VariantSpace, AListGoesTogether) {
  const Made study = made({"values = [1.0, 2.0]", "values = [3.0, 4.0]"}, "[sampling]\nmethod = \"list\"\n");
  ASSERT_TRUE(study.space);
  EXPECT_EQ(study.space->count(), 2U);
  EXPECT_EQ(textOf(study.space->values(1)[1]), "4");
  EXPECT_FALSE(made({"values = [1.0]", "values = [3.0, 4.0]"}, "[sampling]\nmethod = \"list\"\n").space);
}

TEST(VariantSpace, ASearchHasAUnitForEachStartAndChoice) {
  const Made study = made({"from = 0.0\nto = 2.0", "words = true"},
                          "[search]\nevaluations = 10\nstarts = 4\n[[objective]]\nvalue = \"q.a\"\n");
  ASSERT_TRUE(study.space) << study.space.error().message();
  EXPECT_EQ(study.space->units(), 12U);
  EXPECT_EQ(study.space->count(), 120U);
  EXPECT_EQ(study.space->searchStart(0), std::vector<double>{0.5});
  EXPECT_EQ(textOf(study.space->searchValues(4, {0.25})[0]), "0.5");
  EXPECT_EQ(textOf(study.space->searchValues(4, {0.25})[1]), "b");
}

TEST(VariantSpace, ChunksShareOutEveryUnitOnce) {
  for (const std::size_t units : {0U, 1U, 15U, 16U, 1000U}) {
    for (const std::size_t chunks : {1U, 2U, 16U, 33U}) {
      std::size_t next = 0;
      for (std::size_t chunk = 1; chunk <= chunks; ++chunk) {
        const ChunkUnits part = unitsOfChunk(units, chunk, chunks);
        EXPECT_EQ(part.begin, next);
        next = part.end;
      }
      EXPECT_EQ(next, units);
    }
  }
}

TEST(VariantSpace, RefusesTooMany) {
  const std::string range = "from = 0.0\nto = 1.0\nsteps = 10000";
  EXPECT_FALSE(made({range, range}).space);
  EXPECT_FALSE(made({"from = 0.0\nto = 1.0"}).space);
}

}  // namespace
}  // namespace hapticell::studies
