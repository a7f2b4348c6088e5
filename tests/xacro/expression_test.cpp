// SPDX-License-Identifier: Apache-2.0
// The results are those of Python 3.11 (and, for texts as properties, of xacro 2.1).
#include <gtest/gtest.h>

#include "tests/xacro/memory_files.h"

namespace hapticell::xacro {
namespace {

struct Case {
  const char *expression, *result;
};

void expectAll(const std::vector<Case>& cases) {
  test::MemoryFiles files;
  for (const auto& [expression, result] : cases) EXPECT_EQ(files.value(expression), result) << expression;
}

TEST(XacroExpression, ArithmeticIsPythons) {
  expectAll({{"0.9 / 2 - 0.2", "0.25"},
             {"0.1 + 0.2", "0.30000000000000004"},
             {"1. + sin(pi)", "1.0000000000000002"},
             {"7 // 2", "3"},
             {"-7 // 2", "-4"},
             {"-7 % 3", "2"},
             {"-7.5 % 2", "0.5"},
             {"7 / 2", "3.5"},
             {"4 / 2", "2.0"},
             {"2 ** 10", "1024"},
             {"2 ** -1", "0.5"},
             {"-2 ** 2", "-4"},
             {"2 ** 3 ** 2", "512"},
             {"(1 + 2) * 3 - -4", "13"},
             {"1e-5", "1e-05"},
             {"1e16", "1e+16"},
             {"123456789012345.0", "123456789012345.0"},
             {"5 &amp; 6 | 8 ^ 1", "13"},
             {"1 &lt;&lt; 4 &gt;&gt; 1", "8"},
             {"~5", "-6"},
             {"0x1f + 0b11 + 1_000", "1034"},
             {"True + 1", "2"},
             {"-0.0", "-0.0"},
             {"round(2.5)", "2"},
             {"round(2.675, 2)", "2.67"},
             {"int(-3.7)", "-3"},
             {"float('1e-3')", "0.001"},
             {"radians(180) == pi", "True"},
             {"math.degrees(math.pi / 2)", "90.0"},
             {"atan2(1, -1)", "2.356194490192345"},
             {"ceil(2.1) + floor(-2.1)", "0"},
             {"hypot(3, 4)", "5.0"},
             {"python.sum([0.5] * 4)", "2.0"},
             {"max(3, 1, 2) - min([3, 1, 2])", "2"},
             {"python.abs(-3)", "3"},
             {"math.comb(60, 30)", "118264581564861424"},
             {"log(8, 2)", "3.0"},
             {"inf", "inf"}});
}

TEST(XacroExpression, TextsListsAndConditionsArePythons) {
  expectAll({{"'use' in 'reuse'", "True"},
             {"1 &lt; 2 &lt;= 2 != 3", "True"},
             {"not 1 == 2 and 'x' or 'y'", "x"},
             {"'a' if 0 else 'b'", "b"},
             {"[1, 'a', (2,), None]", "[1, 'a', (2,), None]"},
             {"[x * x for x in range(5) if x % 2]", "[1, 9]"},
             {"[i + j for i, j in python.zip([1, 2], [10, 20])]", "[11, 22]"},
             {"[1, 2, 3, 4][1:-1]", "[2, 3]"},
             {"[1, 2, 3][::-1]", "[3, 2, 1]"},
             {"'arm_left'[:3] + '_' + str(1)", "arm_1"},
             {"'%s_%02d' % ('j', 3)", "j_03"},
             {"'%.3f' % 1.0", "1.000"},
             {"'a,b'.split(',')", "['a', 'b']"},
             {"'_'.join(['a', 'b']).upper()", "A_B"},
             {"' x '.strip() * 2", "xx"},
             {"'arm'.replace('a', 'f').startswith('f')", "True"},
             {"dict(a=1, b=[2])['b'][0]", "2"},
             {"dict(a=1).get('c', 7)", "7"},
             {"sorted([3, 1, 2], reverse=True)", "[3, 2, 1]"},
             {"list(map(lambda x: x + 1, [1, 2]))", "[2, 3]"},
             {"len('äöü')", "3"},
             {"'äöü'[1]", "ö"},
             {"&quot;it's&quot;", "it's"},
             {"[&quot;it's&quot;]", "[&quot;it's&quot;]"},
             {"xacro.tokenize('a, b;c')", "['a', 'b', 'c']"},
             {"1 is not None", "True"},
             {"3 not in [1, 2]", "True"}});
}

TEST(XacroExpression, WhatIsWrongIsNamed) {
  test::MemoryFiles files;
  const std::vector<Case> cases = {{"lenght / 2", "name 'lenght' is not defined in ${lenght / 2}"},
                                   {"1 / 0", "division by zero"},
                                   {"'a' + 1", "a text + a whole number"},
                                   {"[1][1]", "the index 1 of 1 items"},
                                   {"dict(a=1)['b']", "has no key 'b'"},
                                   {"(1", "the expression ends"},
                                   {"1 +", "the expression ends"},
                                   {"a b", "'b' in the expression"},
                                   {"", "the expression ends"},
                                   {"sqrt(-1)", "sqrt() of a number outside its domain"},
                                   {"9223372036854775807 + 1", "beyond 64 bits"},
                                   {"len(3)", "len() of a whole number"},
                                   {"import os", "'import' in the expression"},
                                   {"'abc", "without closing quote"}};
  for (const auto& [expression, found] : cases) {
    const std::string said = files.value(expression);
    EXPECT_NE(said.find(found), std::string::npos) << expression << " / " << said;
    EXPECT_NE(said.find("/a.xacro, line 1: "), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace hapticell::xacro
