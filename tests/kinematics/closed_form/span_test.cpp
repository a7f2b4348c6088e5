// SPDX-License-Identifier: Apache-2.0
// Each operation against the same one on many numbers of its spans: what those give lies within, and reaches the ends.
#include "kinematics/closed_form/span.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace hapticell::kinematics {
namespace {

constexpr int kSamples = 200;
constexpr double kRounding = 1e-12;

Span randomSpan(std::mt19937_64& random, double low, double high) {
  std::uniform_real_distribution<double> uniform(low, high);
  const double a = uniform(random), b = uniform(random);
  return {std::min(a, b), std::max(a, b)};
}

double sampleOf(const Span& span, int i) {
  return span.low + (span.high - span.low) * i / kSamples;
}

struct OneSpan {
  const char* name;
  double low, high;  ///< Where it is tried.
  double steepest;   ///< Largest slope there; 0: rises or falls throughout, so that its ends are those of the span.
  std::function<Span(const Span&)> of_span;
  std::function<double(double)> of_number;
};

TEST(Span, OfOneGivesJustTheNumbersThatItsNumbersGive) {
  const std::vector<OneSpan> operations{
      {"minus", -3, 3, 0, [](const Span& a) { return -a; }, [](double a) { return -a; }},
      {"squared", -3, 3, 6, [](const Span& a) { return squared(a); }, [](double a) { return a * a; }},
      {"squareRoot", -1, 3, 0, [](const Span& a) { return squareRoot(a); }, [](double a) { return std::sqrt(std::max(a, 0.0)); }},
      {"cosine", -9, 9, 1, [](const Span& a) { return cosine(a); }, [](double a) { return std::cos(a); }},
      {"sine", -9, 9, 1, [](const Span& a) { return sine(a); }, [](double a) { return std::sin(a); }},
      {"arcCosine", -1.5, 1.5, 0, [](const Span& a) { return arcCosine(a); },
       [](double a) { return std::acos(std::clamp(a, -1.0, 1.0)); }},
      {"arcSine", -1.5, 1.5, 0, [](const Span& a) { return arcSine(a); },
       [](double a) { return std::asin(std::clamp(a, -1.0, 1.0)); }}};
  std::mt19937_64 random(5);
  for (const OneSpan& operation : operations) {
    for (int trial = 0; trial < 300; ++trial) {
      const Span a = randomSpan(random, operation.low, operation.high), result = operation.of_span(a);
      double least = 1e9, most = -1e9;
      for (int i = 0; i <= kSamples; ++i) {
        const double value = operation.of_number(sampleOf(a, i));
        least = std::min(least, value);
        most = std::max(most, value);
      }
      const double between = operation.steepest * a.width() / kSamples + kRounding;  // Missed by the samples.
      EXPECT_TRUE(result.wider(kRounding).has(least) && result.wider(kRounding).has(most)) << operation.name;
      EXPECT_NEAR(result.low, least, between) << operation.name << " " << a.low << " " << a.high;
      EXPECT_NEAR(result.high, most, between) << operation.name << " " << a.low << " " << a.high;
    }
  }
}

TEST(Span, OfTwoGivesJustTheNumbersOfTheirCorners) {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 300; ++trial) {
    const Span a = randomSpan(random, -3, 3), b = randomSpan(random, -3, 3);
    const auto expectEnds = [&](const Span& result, const std::function<double(double, double)>& of_numbers) {
      double least = 1e9, most = -1e9;
      for (const double p : {a.low, a.high}) {
        for (const double q : {b.low, b.high}) {
          least = std::min(least, of_numbers(p, q));
          most = std::max(most, of_numbers(p, q));
        }
      }
      EXPECT_NEAR(result.low, least, kRounding * std::max(1.0, std::abs(least)));
      EXPECT_NEAR(result.high, most, kRounding * std::max(1.0, std::abs(most)));
      const double inside = of_numbers(sampleOf(a, kSamples / 3), sampleOf(b, kSamples / 7));
      EXPECT_TRUE(result.wider(kRounding).has(inside));
    };
    expectEnds(a + b, std::plus<>());
    expectEnds(a - b, std::minus<>());
    expectEnds(a * b, std::multiplies<>());
    if (!b.has(0.0)) expectEnds(a / b, std::divides<>());
  }
}

/// The angle of each place in the box, by as many turns as bring it into the span; at the box's corners are the ends.
TEST(Span, AnAngleIsContinuousOverItsBox) {
  std::mt19937_64 random(9);
  int behind = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Span y = randomSpan(random, -2, 2), x = randomSpan(random, -2, 2), result = angleOf(y, x);
    if (y.has(0.0) && x.has(0.0)) {
      EXPECT_EQ(result.low, -std::numbers::pi);
      EXPECT_EQ(result.high, std::numbers::pi);
      continue;
    }
    behind += y.has(0.0) && x.high < 0.0 ? 1 : 0;
    EXPECT_LT(result.width(), std::numbers::pi) << "seen from the origin a box beside it is less than half a turn";
    const double middle = 0.5 * (result.low + result.high);
    double least = 1e9, most = -1e9;
    for (int i = 0; i <= 10; ++i) {
      for (int k = 0; k <= 10; ++k) {
        const double angle = std::atan2(sampleOf(y, i * kSamples / 10), sampleOf(x, k * kSamples / 10));
        const double near = middle + std::remainder(angle - middle, kTurn);
        least = std::min(least, near);
        most = std::max(most, near);
      }
    }
    EXPECT_NEAR(result.low, least, kRounding);
    EXPECT_NEAR(result.high, most, kRounding);
  }
  EXPECT_GT(behind, 50);
}

TEST(Span, KnowsWhatItHas) {
  const Span span(-1.0, 2.0);
  EXPECT_EQ(span.width(), 3.0);
  EXPECT_TRUE(span.has(-1.0) && span.has(2.0) && span.has(0.0));
  EXPECT_FALSE(span.has(-1.001) || span.has(2.001));
  EXPECT_EQ(span.wider(0.5).low, -1.5);
  EXPECT_EQ(span.wider(0.5).high, 2.5);
  const Span number = 0.25;
  EXPECT_EQ(number.low, 0.25);
  EXPECT_EQ(number.high, 0.25);
  // A whole turn has all cosines, two peaks or none.
  EXPECT_EQ(cosine({0.1, 0.1 + kTurn}).low, -1.0);
  EXPECT_EQ(cosine({0.1, 0.1 + kTurn}).high, 1.0);
}

}  // namespace
}  // namespace hapticell::kinematics
