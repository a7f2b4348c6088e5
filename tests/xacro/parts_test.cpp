// SPDX-License-Identifier: Apache-2.0
// The parts of the expansion one by one. Results of operators and methods are those of Python 3.11.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tinyxml.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/xacro/memory_files.h"
#include "xacro/budget.h"
#include "xacro/built_ins.h"
#include "xacro/call_arguments.h"
#include "xacro/evaluator.h"
#include "xacro/expander.h"
#include "xacro/expression.h"
#include "xacro/fault.h"
#include "xacro/interpreter.h"
#include "xacro/macro.h"
#include "xacro/macro_call.h"
#include "xacro/methods.h"
#include "xacro/operators.h"
#include "xacro/pushed.h"
#include "xacro/scope.h"
#include "xacro/source_files.h"
#include "xacro/tokens.h"
#include "xacro/value.h"
#include "xacro/xml_document.h"
#include "xacro/xml_node.h"
#include "xacro/yaml_values.h"

namespace hapticell::xacro {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// What the Fault of `work` says that it found; empty: there was none.
template <typename Work>
std::string faultOf(const Work& work) {
  try {
    work();
  } catch (const Fault& fault) {
    return fault.found.empty() ? "?" : english(fault.found);
  }
  return {};
}

/// A world with one file and nothing else.
class OneFile final : public Surroundings {
 public:
  std::string yaml;
  std::vector<Text> warnings;
  Value substitution(const std::string& words, Scope&) override { return "<" + words + ">"; }
  std::string readText(const std::string& reference, std::string& file) override {
    file = "/" + reference;
    return yaml;
  }
  std::string absoluteName(const std::string& reference) override { return "/" + reference; }
  Value argument(const std::string& name) override { return "argument " + name; }
  void warn(const Text& sentence) override { warnings.push_back(sentence); }
};

class XacroParts : public ::testing::Test {
 protected:
  XacroParts() { addBuiltIns(functions_, scopes_); }
  std::string shown(const Value& value) { return reprOf(value, budget_); }
  std::string evaluated(const std::string& expression) {
    return shown(interpreter_.evaluateExpression(expression, file_));
  }
  Value yamlOf(const std::string& text) {
    world_.yaml = text;
    return loadYaml("a.yaml", interpreter_);
  }
  Budget budget_;
  OneFile world_;
  Interpreter interpreter_{budget_, world_};
  Scopes scopes_;
  Scope& functions_ = scopes_.make(nullptr);
  Scope& file_ = scopes_.make(&functions_);
};

TEST_F(XacroParts, ABudgetEndsWhatTakesTooMuch) {
  Budget budget;
  EXPECT_EQ(faultOf([&] { budget.step(Budget::kMostSteps); }), "");
  EXPECT_THAT(faultOf([&] { budget.step(); }), HasSubstr("3 million"));
  EXPECT_THAT(faultOf([&] { budget.take(Budget::kMostBytes + 1); }), HasSubstr("64 MB"));
  EXPECT_THAT(faultOf([] { Budget::checkText(Budget::kLongestText + 1); }), HasSubstr("1 MB"));
  EXPECT_THAT(faultOf([] { Budget::checkList(Budget::kLongestList + 1); }), HasSubstr("100 000"));
  for (int i = 0; i < 3; ++i) {
    const Budget::Level deep(budget, Budget::kDeepest);
    EXPECT_THAT(faultOf([&] { const Budget::Level deeper(budget); }), HasSubstr("too deeply"));
  }
}

TEST_F(XacroParts, APlaceOnAStackIsGivenBackWhateverIsThrown) {
  std::vector<int> stack;
  const std::string fault = faultOf([&] {
    const Pushed<int> one(stack, 1), two(stack, 2);
    EXPECT_THAT(stack, ElementsAre(1, 2));
    throw Fault{.found = "x"};
  });
  EXPECT_EQ(fault, "x");
  EXPECT_TRUE(stack.empty());
}

TEST_F(XacroParts, ValuesAreWrittenAsPythonWritesThem) {
  EXPECT_EQ(shown(Value()), "None");
  EXPECT_EQ(shown(true), "True");
  EXPECT_EQ(shown("it's"), "\"it's\"");
  EXPECT_EQ(shown(makeList({1, 2.0, "a"}, budget_)), "[1, 2.0, 'a']");
  EXPECT_EQ(shown(makeList({1}, budget_, true)), "(1,)");
  EXPECT_EQ(shown(makeDict({{"b", 1}, {"a", 2}, {"b", 3}}, budget_)), "{'b': 3, 'a': 2}")
      << "the first place, the last value";
  EXPECT_EQ(textOf("text", budget_), "text");
  EXPECT_EQ(numberText(1e16), "1e+16");
  EXPECT_EQ(numberText(0.1), "0.1");
  EXPECT_EQ(numberText(-0.0), "-0.0");
  EXPECT_EQ(numberText(std::numeric_limits<double>::infinity()), "inf");
}

TEST_F(XacroParts, TruthEqualityAndOrderArePythons) {
  for (const Value& nothing : {Value(), Value(false), Value(0), Value(0.0), Value(""), makeList({}, budget_)})
    EXPECT_FALSE(truthOf(nothing));
  for (const Value& something : {Value(true), Value(-1), Value(0.5), Value("0"), makeList({0}, budget_)})
    EXPECT_TRUE(truthOf(something));
  EXPECT_TRUE(equal(1, 1.0, budget_) && equal(true, 1, budget_));
  EXPECT_FALSE(equal(1, "1", budget_) || equal(Value(), false, budget_));
  EXPECT_TRUE(equal(makeList({1, "a"}, budget_), makeList({1.0, "a"}, budget_), budget_));
  EXPECT_LT(compare(makeList({1, 2}, budget_), makeList({1, 3}, budget_), budget_), 0);
  EXPECT_LT(compare("a", "b", budget_), 0);
  EXPECT_GT(compare(2, 1.5, budget_), 0);
  EXPECT_NE(faultOf([&] { (void)compare(1, "a", budget_); }), "");
  EXPECT_EQ(depthOf(makeList({makeList({1}, budget_)}, budget_)), 2);
  EXPECT_EQ(kindOf("x"), Text("a text"));
}

TEST_F(XacroParts, ExpressionsAreSplitIntoWords) {
  std::vector<std::string> kinds;
  for (const Token& token : tokensOf("a1 + 0x1f ** 'it''s' // 2.5e-1 <= b")) {
    std::string text = token.text;
    if (token.kind == Token::Kind::kConstant) text = shown(token.value);
    if (token.kind == Token::Kind::kEnd) text = "end";
    kinds.push_back(text);
  }
  EXPECT_THAT(kinds, ElementsAre("a1", "+", "31", "**", "'it'", "'s'", "//", "0.25", "<=", "b", "end"));
  for (const char* bad : {"'open", "12abc", "a ? b", "1e", "0x", "99999999999999999999"}) {
    EXPECT_NE(faultOf([&] { (void)tokensOf(bad); }), "") << bad;
  }
  EXPECT_EQ(tokensOf("1e999")[0].value.as<double>() == nullptr ? 0.0 : *tokensOf("1e999")[0].value.as<double>(),
            std::numeric_limits<double>::infinity())
      << "as in Python";
  EXPECT_EQ(*tokensOf("1e-999")[0].value.as<double>(), 0.0);
}

TEST_F(XacroParts, ExpressionsHavePythonsGrammar) {
  EXPECT_EQ(parseExpression("1 + 2 * 3")->name, "+");
  EXPECT_EQ(parseExpression("a if b else c")->kind, Expression::Kind::kChoice);
  EXPECT_EQ(parseExpression("f(1, x=2)")->names, (std::vector<std::string>{"x"}));
  EXPECT_EQ(parseExpression("a < b < c")->parts.size(), 3u);
  for (const char* bad :
       {"", "1 +", "a b", "(1", "[1, 2", "lambda", "x = 1", "import os", "a.", "f(x=1, 2)", "{1: }"}) {
    EXPECT_NE(faultOf([&] { (void)parseExpression(bad); }), "") << bad;
  }
  EXPECT_NE(faultOf([] { (void)parseExpression(std::string(5000, '(') + "1" + std::string(5000, ')')); }), "");
  EXPECT_TRUE(isIdentifier("a_1") && isIdentifier("_"));
  EXPECT_FALSE(isIdentifier("") || isIdentifier("1a") || isIdentifier("lambda") || isIdentifier("a-b"));
}

TEST_F(XacroParts, OperatorsAreWorkedOutAsPythonDoes) {
  const auto result = [&](const char* sign, const Value& a, const Value& b) {
    return shown(binaryOperation(sign, a, b, budget_));
  };
  EXPECT_EQ(result("/", 4, 2), "2.0");
  EXPECT_EQ(result("//", -7, 2), "-4");
  EXPECT_EQ(result("%", -7, 3), "2");
  EXPECT_EQ(result("+", "a", "b"), "'ab'");
  EXPECT_EQ(result("*", makeList({1}, budget_), 3), "[1, 1, 1]");
  EXPECT_EQ(result("%", "%d-%s", makeList({1, "x"}, budget_, true)), "'1-x'");
  for (const auto& [sign, a, b] :
       std::vector<std::tuple<const char*, Value, Value>>{{"/", 1, 0},
                                                          {"%", 1, 0},
                                                          {"+", 1, "a"},
                                                          {"-", "a", "b"},
                                                          {"*", "aaaaaaaaaa", 1'000'000},
                                                          {"*", std::numeric_limits<std::int64_t>::max(), 2},
                                                          {"**", 10, 100}}) {
    EXPECT_NE(faultOf([&, s = sign, &left = a, &right = b] { (void)binaryOperation(s, left, right, budget_); }), "")
        << sign;
  }
  const Value list = makeList({0, 1, 2, 3, 4}, budget_);
  EXPECT_EQ(shown(itemAt(list, -1, budget_)), "4");
  EXPECT_EQ(shown(itemAt("h\xC3\xA4ndel", 1, budget_)), "'\xC3\xA4'") << "letters, not bytes";
  EXPECT_NE(faultOf([&] { (void)itemAt(list, 5, budget_); }), "");
  EXPECT_EQ(shown(sliceOf(list, Value(), Value(), -2, budget_)), "[4, 2, 0]");
  EXPECT_EQ(shown(sliceOf("abcdef", 1, -1, Value(), budget_)), "'bcde'");
  EXPECT_NE(faultOf([&] { (void)sliceOf(list, 0, 3, 0, budget_); }), "") << "a step of 0";
  EXPECT_THAT(lettersOf("a\xE2\x82\xAC"), ElementsAre("a", "\xE2\x82\xAC"));
}

TEST_F(XacroParts, MethodsReadTheirValueAndThereAreNoOthers) {
  const auto called = [&](const Value& value, const char* name, std::vector<Value> arguments) {
    const auto method = methodOf(value, name);
    return method ? shown(interpreter_.call(*method, std::move(arguments))) : std::string("none");
  };
  EXPECT_EQ(called("Arm Left", "lower", {}), "'arm left'");
  EXPECT_EQ(called("a,b,c", "split", {","}), "['a', 'b', 'c']");
  EXPECT_EQ(called(makeDict({{"a", 1}}, budget_), "get", {"b", 7}), "7");
  for (const char* closed : {"__class__", "format_map", "append", "update", "__init__"}) {
    EXPECT_FALSE(methodOf("text", closed)) << closed;
    EXPECT_FALSE(methodOf(makeList({}, budget_), closed)) << closed;
  }
}

TEST_F(XacroParts, ArgumentsOfFunctionsAreCounted) {
  Call call{interpreter_, {1, "two"}, {}};
  EXPECT_EQ(faultOf([&] { expectArguments(call, "f", 1, 2); }), "");
  EXPECT_EQ(faultOf([&] { expectArguments(call, "f", 3, 3); }), "f() with 2 arguments");
  call.named["x"] = 1;
  EXPECT_EQ(faultOf([&] { expectArguments(call, "f", 2, 2); }), "f() with 3 arguments");
  EXPECT_EQ(faultOf([&] { expectArguments(call, "f", 2, 2, true); }), "");
  EXPECT_EQ(textArgument(call, "f", 1), "two");
  EXPECT_THAT(faultOf([&] { (void)textArgument(call, "f", 0); }), HasSubstr("f() with "));
}

TEST_F(XacroParts, ScopesFindOutwardsAndEvaluateATextWhenItIsAskedFor) {
  file_.set("a", "${b + 1}", true);
  file_.set("b", "2", true);
  Scope& inner = scopes_.make(&file_);
  EXPECT_EQ(shown(*inner.find("a", interpreter_)), "3");
  EXPECT_EQ(inner.find("nothing", interpreter_), nullptr);
  inner.set("b", 10, false);
  EXPECT_EQ(shown(*inner.find("a", interpreter_)), "3") << "in the scope that holds it";
  EXPECT_TRUE(inner.holds("b"));
  EXPECT_TRUE(inner.holds("a")) << "around counts";
  EXPECT_FALSE(file_.holds("nothing"));
  EXPECT_EQ(&inner.top(), &file_);
  EXPECT_EQ(inner.parent(), &file_);
  file_.set("c", "${d}", true);
  file_.set("d", "${c}", true);
  EXPECT_NE(faultOf([&] { (void)file_.find("c", interpreter_); }), "") << "they need each other";
}

TEST_F(XacroParts, TextsOfPropertiesAreReadAsNumbersWhereTheyAreOne) {
  EXPECT_EQ(shown(literalOf("1")), "1");
  EXPECT_EQ(shown(literalOf("1.50")), "1.5");
  EXPECT_EQ(shown(literalOf("1_000")), "'1_000'");
  EXPECT_EQ(shown(literalOf("'1'")), "'1'");
  EXPECT_EQ(shown(literalOf("true")), "True");
  EXPECT_EQ(shown(literalOf("left")), "'left'");
  EXPECT_TRUE(conditionOf("1", "x") && conditionOf("true", "x") && conditionOf(2.5, "x"));
  EXPECT_FALSE(conditionOf("0", "x") || conditionOf("False", "x") || conditionOf(Value(), "x"));
  EXPECT_NE(faultOf([] { (void)conditionOf("perhaps", "x"); }), "");
  EXPECT_EQ(wholeFromText(" -12 "), -12);
  EXPECT_FALSE(wholeFromText("1.5") || wholeFromText("") || wholeFromText("99999999999999999999"));
  EXPECT_EQ(numberFromText("1e3"), 1000.0);
  EXPECT_EQ(numberFromText("-inf"), -std::numeric_limits<double>::infinity());
  EXPECT_FALSE(numberFromText("1,5") || numberFromText("") || numberFromText("0x10"));
}

TEST_F(XacroParts, TheInterpreterEvaluatesTextsAndBuiltIns) {
  file_.set("length", 0.5, false);
  EXPECT_EQ(shown(interpreter_.evaluateText("${2 * length}", file_)), "1.0") << "one expression keeps its kind";
  EXPECT_EQ(interpreter_.textOfText("link_${1 + 1}_$(arg side)", file_), "link_2_<arg side>");
  EXPECT_EQ(interpreter_.textOfText("$${kept} and $$(kept)", file_), "${kept} and $(kept)");
  EXPECT_EQ(evaluated("[x * 2 for x in range(4) if x != 1]"), "[0, 4, 6]");
  EXPECT_EQ(evaluated("sorted([3, 1, 2])"), "[1, 2, 3]");
  EXPECT_EQ(evaluated("(lambda x: x + length)(1)"), "1.5");
  for (const char* closed :
       {"open('/etc/passwd')", "__import__('os')", "''.__class__", "eval('1')", "print", "missing"}) {
    EXPECT_NE(faultOf([&] { (void)evaluated(closed); }), "") << closed;
  }
  EXPECT_THAT(shown(makeList(interpreter_.itemsOf("ab"), budget_)), "['a', 'b']");
  EXPECT_NE(faultOf([&] { (void)interpreter_.call(3, {}); }), "") << "a number is no function";
}

TEST_F(XacroParts, ParametersOfMacrosAreTakenApart) {
  const auto parameters = parametersOf("name parent:='base link' *origin **blocks side:=^ size:=^|${1 + 2}");
  ASSERT_EQ(parameters.size(), 6u);
  EXPECT_EQ(parameters[0].name, "name");
  EXPECT_FALSE(parameters[0].otherwise);
  EXPECT_EQ(parameters[1].otherwise, "'base link'") << "as it is written";
  EXPECT_TRUE(parameters[2].isBlock() && parameters[3].isBlock());
  EXPECT_TRUE(parameters[4].forwarded && !parameters[4].otherwise);
  EXPECT_TRUE(parameters[5].forwarded);
  EXPECT_EQ(parameters[5].otherwise, "${1 + 2}");
  EXPECT_TRUE(parametersOf("  ").empty());
}

TEST_F(XacroParts, MacrosAreFoundOutwards) {
  MacroScope outer(nullptr), inner(&outer), space(nullptr);
  outer.set({"arm", parametersOf("a"), nullptr});
  outer.setSpace("lib", &space);
  ASSERT_NE(inner.find("arm"), nullptr);
  EXPECT_EQ(inner.find("leg"), nullptr);
  inner.set({"arm", parametersOf("a b"), nullptr});
  EXPECT_EQ(inner.find("arm")->parameters.size(), 2u);
  EXPECT_EQ(outer.find("arm")->parameters.size(), 1u);
  EXPECT_EQ(inner.findSpace("lib"), &space);
}

/// An evaluator over files in memory.
class XacroCalls : public XacroParts {
 protected:
  XacroCalls() {
    files_.read = [](const std::filesystem::path& path) -> Expected<std::string> {
      if (path == "/robots/a.xacro") return "<robot name=\"a\"/>";
      if (path == "/robots/sizes.txt") return "12";
      return makeError({.file = path.string(), .found = "the file does not exist"});
    };
    files_.find = [](const std::string& reference,
                     const std::filesystem::path& folder) -> std::optional<std::filesystem::path> {
      if (reference == "lost.txt") return std::nullopt;
      return folder / reference;
    };
  }
  Files files_;
  SourceFiles sources_{files_, budget_};
  Arguments arguments_;
  std::vector<DeclaredArgument> declared_;
  Diagnostics diagnostics_;
};

TEST_F(XacroCalls, AFileIsReadOnceAndKnowsItsFolder) {
  int index = -1, again = -1;
  const XmlPointer root = sources_.parsed("/robots/a.xacro", index);
  EXPECT_EQ(root->name, "robot");
  EXPECT_EQ(sources_.parsed("/robots/a.xacro", again), root);
  EXPECT_EQ(again, index);
  EXPECT_EQ(sources_.all().size(), 1u);
  const auto entered = sources_.enter(index);
  EXPECT_EQ(sources_.folder(), "/robots");
  EXPECT_EQ(sources_.nameOf(index), "/robots/a.xacro");
  EXPECT_EQ(sources_.absoluteName("x.yaml"), "/robots/x.yaml");
  std::string file;
  EXPECT_EQ(sources_.textOf("sizes.txt", file), "12");
  EXPECT_EQ(file, "/robots/sizes.txt");
  EXPECT_NE(faultOf([&] { (void)sources_.textOf("lost.txt", file); }), "");
  EXPECT_THAT(english(notFound("lost.txt").found), HasSubstr("lost.txt"));
}

TEST_F(XacroCalls, ACallGivesItsParametersValues) {
  int index = 0;
  (void)sources_.parsed("/robots/a.xacro", index);
  const auto entered = sources_.enter(index);
  Evaluator evaluator(arguments_, sources_, declared_, diagnostics_, budget_);
  Scope& caller = evaluator.scopes().make(nullptr);
  Scope& inside = evaluator.scopes().make(&caller);
  caller.set("side", "left", false);
  const Macro macro{"arm", parametersOf("length width:=2 side:=^"), nullptr};
  MacroCall call(macro, caller, inside, evaluator);
  call.bindValues(*readXml("<arm length=\"${1 + 2}\"/>", "a", 0));
  call.bindBlocks({});
  call.bindDefaults();
  EXPECT_EQ(evaluator.text("${length} ${width} ${side}", inside), "3 2 left");
  MacroCall missing(macro, caller, inside, evaluator);
  missing.bindValues(*readXml("<arm/>", "a", 0));
  EXPECT_NE(faultOf([&] { missing.bindDefaults(); }), "") << "length has no value";
  MacroCall unknown(macro, caller, inside, evaluator);
  EXPECT_NE(faultOf([&] { unknown.bindValues(*readXml("<arm height=\"1\"/>", "a", 0)); }), "");
}

TEST_F(XacroCalls, AnArgumentIsWhatWasGivenElseItsDefault) {
  arguments_["speed"] = "5";
  int index = 0;
  (void)sources_.parsed("/robots/a.xacro", index);
  const auto entered = sources_.enter(index);
  Evaluator evaluator(arguments_, sources_, declared_, diagnostics_, budget_);
  Scope& scope = evaluator.scopes().make(nullptr);
  const XmlPointer node = readXml("<arg name=\"speed\" default=\"1\"/>", "a", 0);
  evaluator.declare("speed", *node, scope);
  evaluator.declare("load", *readXml("<arg name=\"load\" default=\"7\"/>", "a", 0), scope);
  EXPECT_EQ(evaluator.text("$(arg speed) $(arg load)", scope), "5 7");
  EXPECT_TRUE(evaluator.truth("${1 < 2}", scope));
  EXPECT_NE(faultOf([&] { (void)evaluator.text("$(arg none)", scope); }), "");
}

TEST_F(XacroCalls, TheExpanderMakesOnePlainTree) {
  files_.read = [](const std::filesystem::path&) -> Expected<std::string> {
    return "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><xacro:property name=\"n\" value=\"2\"/>"
           "<xacro:if value=\"${n > 1}\"><link name=\"l${n}\"/></xacro:if></robot>";
  };
  Expander expander(arguments_, files_, declared_, diagnostics_);
  const XmlPointer root = expander.run("/robots/b.xacro");
  ASSERT_EQ(root->children.size(), 1u);
  EXPECT_EQ(root->children[0]->attribute("name")->value, "l2");
  EXPECT_EQ(expander.files().size(), 1u);
  EXPECT_EQ(expander.nameOf(0), "/robots/b.xacro");
}

TEST_F(XacroParts, XmlKeepsLinesAndRefusesWhatIsDangerous) {
  const XmlPointer root = readXml("<a x='1'>\n<!-- no -->\n<b y='2'/>text</a>", "f.xml", 4);
  EXPECT_EQ(root->attribute("x")->value, "1");
  EXPECT_EQ(root->attribute("z"), nullptr);
  ASSERT_EQ(root->children.size(), 2u);
  EXPECT_EQ(root->children[0]->line, 3);
  EXPECT_EQ(root->children[0]->file, 4);
  EXPECT_TRUE(root->children[0]->isElement() && !root->children[1]->isElement());
  TiXmlDocument document;
  EXPECT_TRUE(parseXml("<a/>", "f.xml", document));
  for (const std::string& bad : {std::string("<a>"), std::string("<a></b>"), std::string("<a/>\0x", 6),
                                 std::string("<!DOCTYPE a [<!ENTITY b \"c\">]><a/>"), [] {
                                   std::string deep;
                                   for (int i = 0; i < 300; ++i) deep += "<a>";
                                   return deep;
                                 }()}) {
    TiXmlDocument other;
    const auto refused = parseXml(bad, "f.xml", other);
    ASSERT_FALSE(refused) << bad.substr(0, 30);
    EXPECT_EQ(refused.error().file, "f.xml");
  }
  EXPECT_NE(faultOf([] { (void)readXml("<!-- only a remark -->", "f.xml", 0); }), "");
}

TEST_F(XacroParts, YamlIsReadAsVersionOnePointOne) {
  EXPECT_EQ(shown(yamlOf("a: 1\nb: [yes, 010, 1e3, ~, 0.5]\nc: {d: text}")),
            "{'a': 1, 'b': [True, 8, '1e3', None, 0.5], 'c': {'d': 'text'}}");
  EXPECT_EQ(shown(yamlOf("a: !degrees 180\nb: !millimeters 250\nc: !inches 2")),
            "{'a': 3.141592653589793, 'b': 0.25, 'c': 0.0508}");
  for (const char* bad : {"a: [1, 2", "? [1, 2]\n: 3", "a: !python/object:os.system x", "a: &x [*x]"}) {
    EXPECT_NE(faultOf([&] { (void)yamlOf(bad); }), "") << bad;
  }
}

}  // namespace
}  // namespace hapticell::xacro
