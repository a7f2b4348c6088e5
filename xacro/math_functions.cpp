// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>

#include "xacro/built_ins.h"
#include "xacro/call_arguments.h"
#include "xacro/interpreter.h"
#include "xacro/operators.h"

namespace hapticell::xacro {

namespace {

struct OneNumber {
  const char* name;
  double (*run)(double);
};
struct TwoNumbers {
  const char* name;
  double (*run)(double, double);
};

const OneNumber kOne[] = {
    {"acos", std::acos},    {"acosh", std::acosh},
    {"asin", std::asin},    {"asinh", std::asinh},
    {"atan", std::atan},    {"atanh", std::atanh},
    {"cbrt", std::cbrt},    {"cos", std::cos},
    {"cosh", std::cosh},    {"degrees", [](double x) { return x * (180.0 / std::numbers::pi); }},
    {"erf", std::erf},      {"erfc", std::erfc},
    {"exp", std::exp},      {"exp2", std::exp2},
    {"expm1", std::expm1},  {"fabs", std::fabs},
    {"gamma", std::tgamma}, {"lgamma", std::lgamma},
    {"log10", std::log10},  {"log1p", std::log1p},
    {"log2", std::log2},    {"radians", [](double x) { return x * (std::numbers::pi / 180.0); }},
    {"sin", std::sin},      {"sinh", std::sinh},
    {"sqrt", std::sqrt},    {"tan", std::tan},
    {"tanh", std::tanh},
};
const TwoNumbers kTwo[] = {
    {"atan2", std::atan2}, {"copysign", std::copysign},   {"fmod", std::fmod},
    {"pow", std::pow},     {"remainder", std::remainder}, {"nextafter", std::nextafter},
};

/// Python refuses what is no number or too large.
double checked(const char* name, double result, bool finite, bool number) {
  if (std::isnan(result) && number)
    throw Fault{.found = Text("%1() of a number outside its domain", name), .expected = "a number within its domain"};
  if (std::isinf(result) && finite)
    throw Fault{.found = Text("the result of %1() is too large or undefined", name), .expected = "a finite result"};
  return result;
}

/// The whole number next to `value` in a direction.
Value wholeNumber(const char* name, double value) {
  if (!(std::abs(value) < 9.2e18))
    throw Fault{.found = Text("%1() of %2", name, numberText(value)), .expected = "a number within 64 bits"};
  return static_cast<std::int64_t>(value);
}

std::int64_t binomial(std::int64_t n, std::int64_t k, bool ordered) {
  if (n < 0 || k < 0) throw Fault{.found = "comb() or perm() of a negative number", .expected = "0 or more"};
  if (k > n) return 0;
  if (!ordered) k = std::min(k, n - k);
  std::int64_t result = 1;
  for (std::int64_t i = 0; i < k; ++i) {
    const std::int64_t divisor = ordered ? 1 : i + 1, common = std::gcd(result, divisor);
    if (__builtin_mul_overflow(result / common, (n - i) / (divisor / common), &result))
      throw Fault{.found = "a result of comb() or perm() beyond 64 bits", .expected = "smaller numbers"};
  }
  return result;
}

Value logarithm(Call& call) {
  expectArguments(call, "log", 1, 2);
  const auto ln = [](const Value& value) {
    const double x = numberOf(value);
    if (!(x > 0.0)) throw Fault{.found = Text("log() of %1", numberText(x)), .expected = "a number above 0"};
    return std::log(x);
  };
  if (call.arguments.size() == 1) return ln(call.arguments[0]);
  return binaryOperation("/", ln(call.arguments[0]), ln(call.arguments[1]), call.interpreter.budget());
}

Value hypotenuse(Call& call) {
  double sum = 0.0;
  for (const Value& value : call.arguments) sum = std::hypot(sum, numberOf(value));
  return sum;
}

Value product(Call& call) {
  expectArguments(call, "prod", 1, 1);
  Value result = 1;
  for (const Value& item : call.interpreter.itemsOf(call.arguments[0]))
    result = binaryOperation("*", result, item, call.interpreter.budget());
  return result;
}

Value exactSum(Call& call) {
  expectArguments(call, "fsum", 1, 1);
  double sum = 0.0, rest = 0.0;  // Neumaier 1974.
  for (const Value& item : call.interpreter.itemsOf(call.arguments[0])) {
    const double x = numberOf(item), next = sum + x;
    rest += std::abs(sum) >= std::abs(x) ? (sum - next) + x : (x - next) + sum;
    sum = next;
  }
  return sum + rest;
}

Value isClose(Call& call) {
  expectArguments(call, "isclose", 2, 2, true);
  const auto option = [&call](const char* name, double otherwise) {
    const auto found = call.named.find(name);
    return found == call.named.end() ? otherwise : numberOf(found->second);
  };
  const double a = numberOf(call.arguments[0]), b = numberOf(call.arguments[1]);
  if (a == b) return true;
  if (std::isinf(a) || std::isinf(b)) return false;
  return std::abs(a - b) <=
         std::max(option("rel_tol", 1e-9) * std::max(std::abs(a), std::abs(b)), option("abs_tol", 0.0));
}

Value distance(Call& call) {
  expectArguments(call, "dist", 2, 2);
  const auto p = call.interpreter.itemsOf(call.arguments[0]), q = call.interpreter.itemsOf(call.arguments[1]);
  if (p.size() != q.size())
    throw Fault{.found = "dist() of points with different dimensions", .expected = "two points of the same dimension"};
  double sum = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) sum = std::hypot(sum, numberOf(p[i]) - numberOf(q[i]));
  return sum;
}

Value parts(Call& call, bool binary) {
  expectArguments(call, binary ? "frexp" : "modf", 1, 1);
  const double x = numberOf(call.arguments[0]);
  int exponent = 0;
  double whole = 0.0;
  const double first = binary ? std::frexp(x, &exponent) : std::modf(x, &whole);
  std::vector<Value> both;
  both.emplace_back(first);
  both.push_back(binary ? Value(exponent) : Value(whole));
  return makeList(std::move(both), call.interpreter.budget(), true);
}

using Add = std::function<void(const std::string&, std::function<Value(Call&)>)>;

void addNumberFunctions(const Add& add) {
  for (const OneNumber& one : kOne) {
    add(one.name, [one](Call& call) -> Value {
      expectArguments(call, one.name, 1, 1);
      const double x = numberOf(call.arguments[0]);
      return checked(one.name, one.run(x), std::isfinite(x), !std::isnan(x));
    });
  }
  for (const TwoNumbers& two : kTwo) {
    add(two.name, [two](Call& call) -> Value {
      expectArguments(call, two.name, 2, 2);
      const double x = numberOf(call.arguments[0]), y = numberOf(call.arguments[1]);
      return checked(two.name, two.run(x, y), std::isfinite(x) && std::isfinite(y), !std::isnan(x) && !std::isnan(y));
    });
  }
  add("ldexp", [](Call& call) -> Value {
    expectArguments(call, "ldexp", 2, 2);
    const double x = numberOf(call.arguments[0]);
    const auto by = std::clamp<std::int64_t>(wholeOf(call.arguments[1]), -5000, 5000);
    return checked("ldexp", std::ldexp(x, static_cast<int>(by)), std::isfinite(x), true);
  });
}

void addWholeFunctions(const Add& add) {
  const auto rounding = [&add](const char* name, double (*run)(double)) {
    add(name, [name, run](Call& call) -> Value {
      expectArguments(call, name, 1, 1);
      return call.arguments[0].isWhole() ? Value(wholeOf(call.arguments[0]))
                                         : wholeNumber(name, run(numberOf(call.arguments[0])));
    });
  };
  rounding("ceil", std::ceil);
  rounding("floor", std::floor);
  rounding("trunc", std::trunc);
  add("factorial", [](Call& call) -> Value {
    expectArguments(call, "factorial", 1, 1);
    const std::int64_t n = wholeOf(call.arguments[0]);
    return binomial(n, n, true);
  });
  for (const bool ordered : {false, true}) {
    add(ordered ? "perm" : "comb", [ordered](Call& call) -> Value {
      expectArguments(call, "comb", 2, 2);
      return binomial(wholeOf(call.arguments[0]), wholeOf(call.arguments[1]), ordered);
    });
  }
  for (const bool least : {false, true}) {
    add(least ? "lcm" : "gcd", [least](Call& call) -> Value {
      std::int64_t result = least ? 1 : 0;
      for (const Value& value : call.arguments) {
        const std::int64_t x = wholeOf(value), divisor = std::gcd(result, x);
        if (!least)
          result = divisor;
        else
          result = divisor == 0
                       ? 0
                       : std::abs(wholeOf(binaryOperation("*", result / divisor, x, call.interpreter.budget())));
      }
      return result;
    });
  }
  add("isqrt", [](Call& call) -> Value {
    expectArguments(call, "isqrt", 1, 1);
    const std::int64_t n = wholeOf(call.arguments[0]);
    if (n < 0) throw Fault{.found = "isqrt() of a negative number", .expected = "0 or more"};
    auto root = static_cast<std::int64_t>(std::sqrt(static_cast<long double>(n)));
    return root;
  });
}

void addTests(const Add& add) {
  const auto test = [&add](const char* name, bool (*run)(double)) {
    add(name, [name, run](Call& call) -> Value {
      expectArguments(call, name, 1, 1);
      return run(numberOf(call.arguments[0]));
    });
  };
  test("isnan", [](double x) { return std::isnan(x); });
  test("isinf", [](double x) { return std::isinf(x); });
  test("isfinite", [](double x) { return std::isfinite(x); });
}

}  // namespace

void addMathFunctions(Scope& scope, Scope& name_space) {
  const auto set = [&](const std::string& name, const Value& value) {
    scope.set(name, value, false);
    name_space.set(name, value, false);
  };
  const Add add = [&set](const std::string& name, std::function<Value(Call&)> run) {
    set(name, makeFunction(name, std::move(run)));
  };
  set("pi", std::numbers::pi);
  set("tau", 2.0 * std::numbers::pi);
  set("e", 2.718281828459045235);
  set("inf", std::numeric_limits<double>::infinity());
  set("nan", std::numeric_limits<double>::quiet_NaN());
  addNumberFunctions(add);
  addWholeFunctions(add);
  addTests(add);
  add("log", logarithm);
  add("hypot", hypotenuse);
  add("prod", product);
  add("fsum", exactSum);
  add("isclose", isClose);
  add("dist", distance);
  add("frexp", [](Call& call) { return parts(call, true); });
  add("modf", [](Call& call) { return parts(call, false); });
}

}  // namespace hapticell::xacro
