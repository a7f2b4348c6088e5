// SPDX-License-Identifier: Apache-2.0
// Ways out of an expression evaluator, and ways to keep one busy: each ends in a sentence, soon.
#include <gtest/gtest.h>

#include "tests/support/test_data.h"
#include "tests/xacro/memory_files.h"
#include "workcell/robots/robot_reader.h"

namespace hapticell::xacro {
namespace {

TEST(XacroEscape, NoExpressionReachesTheProgramOrTheMachine) {
  const std::vector<std::string> ways = {
      "__import__('os').system('touch escaped')",
      "().__class__.__base__.__subclasses__()",
      "''.__class__.__mro__[1].__subclasses__()",
      "[c for c in ().__class__.__base__.__subclasses__() if c.__name__ == 'Popen']",
      "(lambda: 0).__globals__",
      "(lambda: 0).__code__.co_consts",
      "load_yaml.__globals__['os'].system('touch escaped')",
      "xacro.load_yaml.func_globals",
      "math.__loader__.load_module('os')",
      "math.__dict__",
      "'{0.__class__}'.format(1)",
      "'%(a)s' % 3",
      "eval('1')",
      "exec('import os')",
      "open('/etc/passwd')",
      "compile('1', '', 'eval')",
      "getattr(math, '__dict__')",
      "globals()",
      "vars()",
      "dir()",
      "type('X', (), dict())",
      "python.type(1)",
      "python.isinstance.__self__",
      "str.mro()",
      "[].append.__self__",
      "dict.fromkeys",
      "os.system('touch escaped')",
      "subprocess.run('touch escaped')",
      "input()",
      "breakpoint()",
      "xacro.load_yaml('/etc/passwd')",
      "xacro.load_yaml('../../../../etc/shadow')",
      "(x := 1)",
      "f'{1}'",
      "b'abc'",
      "print('x')",
      "1 if __import__('os') else 2",
      "\\\\u005f\\\\u005fimport\\\\u005f\\\\u005f",
      "__builtins__",
      "_global_symbols",
      "self",
      "None.__class__",
      "True.__class__",
      "(1).real",
      "(1.5).as_integer_ratio()",
      "'a'.encode('rot13')",
      "'a'.translate(dict())",
      "str.format",
      "map.__self__",
      "(i for i in [1]).gi_frame",
  };
  for (const std::string& way : ways) {
    test::MemoryFiles files;
    files.texts["/a.xacro"] = "<a xmlns:xacro=\"x\"><v v=\"${" + way + "}\"/></a>";
    const auto result = files.expandFile("/a.xacro");
    EXPECT_FALSE(result) << way << " gave " << (result ? result->text : "");
    if (!result) {
      EXPECT_NE(result.error().message().find("line 1"), std::string::npos) << result.error().message();
    }
  }
}

/// By virtual means: steps and bytes are counted, no clock is asked.
TEST(XacroEscape, NoExpressionKeepsTheProgramBusy) {
  const auto repeated = [](const std::string& text, int count) {
    std::string result;
    for (int i = 0; i < count; ++i) result += text;
    return result;
  };
  const std::vector<std::string> ways = {
      "9 ** 9 ** 9",
      "9.0 ** 99999",
      "'a' * 1000000000",
      "[0] * 1000000000",
      "[[0] * 9999] * 99999",
      "range(1000000000)",
      "[i for i in range(99999) for j in range(99999)]",
      "python.sum([i * j for i in range(9999) for j in range(9999)])",
      "factorial(100000)",
      "math.factorial(25)",
      "1 &lt;&lt; 1000000",
      "'%9999999d' % 1",
      "'%.99999999f' % 1",
      "'a'.rjust(1000000000)",
      "'a'.zfill(1000000000)",
      "(lambda f: f(f))(lambda f: f(f))",
      "(lambda f: f(f) + f(f))(lambda f: f(f) + f(f))",
      repeated("(", 5000) + "1" + repeated(")", 5000),
      repeated("[", 5000) + repeated("]", 5000),
      repeated("-", 20000) + "1",
      repeated("not ", 20000) + "1",
      repeated("1+", 20000) + "1",
      repeated("2**", 5000) + "2",
      repeated("1 if 1 else ", 5000) + "1",
      repeated("lambda: ", 5000) + "1",
      "a" + repeated(".a", 5000),
      "int('" + repeated("9", 60000) + "')",
      repeated("9", 60000),
      "len" + repeated("(len", 300) + repeated(")", 300),
  };
  for (const std::string& way : ways) {
    test::MemoryFiles files;
    const std::string said = files.value(way);
    EXPECT_NE(said.find("/a.xacro, line 1: "), std::string::npos) << way.substr(0, 80) << " / " << said.substr(0, 200);
    EXPECT_LT(said.size(), 1000u);
  }
}

TEST(XacroEscape, NoFileKeepsTheProgramBusy) {
  const std::string head = "<a xmlns:xacro=\"x\">";
  std::string laughs = "<xacro:property name=\"p0\" value=\"lol\"/>",
              lists = "<xacro:property name=\"p0\" value=\"${[1]}\"/>", chain;
  for (int i = 1; i < 60; ++i) {
    const std::string now = "p" + std::to_string(i), before = "p" + std::to_string(i - 1);
    laughs += "<xacro:property name=\"" + now + "\" value=\"${" + before + "}${" + before + "}\"/>";
    lists += "<xacro:property name=\"" + now + "\" value=\"${[" + before + ", " + before + "]}\"/>";
  }
  for (int i = 0; i < 20000; ++i)
    chain += "<xacro:property name=\"c" + std::to_string(i) + "\" value=\"${c" + std::to_string(i + 1) + "}\"/>";
  std::string nested,
      closures =
          "<xacro:property name=\"k\" value=\"${lambda x: lambda: x}\"/><xacro:property name=\"f\" value=\"1\"/>";
  for (int i = 0; i < 150; ++i) nested += "<xacro:if value=\"1\">";
  for (int i = 0; i < 150; ++i) nested += "</xacro:if>";
  for (int i = 0; i < 200; ++i) closures += "<xacro:property name=\"f\" value=\"${k(f)}\" lazy_eval=\"false\"/>";
  const std::map<std::string, std::string> ways = {
      {"a macro that calls itself", "<xacro:macro name=\"m\"><xacro:m/></xacro:macro><xacro:m/>"},
      {"one that calls itself twice", "<xacro:macro name=\"m\"><xacro:m/><xacro:m/></xacro:macro><xacro:m/>"},
      {"two that call each other",
       "<xacro:macro name=\"m\"><xacro:n/></xacro:macro><xacro:macro name=\"n\"><xacro:m/></xacro:macro><xacro:m/>"},
      {"one that unfolds",
       "<xacro:macro name=\"m\" params=\"n\"><b/><xacro:if value=\"${n}\"><xacro:m n=\"${n-1}\"/><xacro:m "
       "n=\"${n-1}\"/></xacro:if></xacro:macro><xacro:m n=\"60\"/>"},
      {"a file that includes itself", "<xacro:include filename=\"a.xacro\"/>"},
      {"two files that include each other", "<xacro:include filename=\"b.xacro\"/>"},
      {"laughs", laughs + "<v v=\"${p59}\"/>"},
      {"lists of lists", lists + "<v v=\"${p59}\"/>"},
      {"equal lists of lists", lists + "<v v=\"${p50 == p50}\"/>"},
      {"a chain of properties", chain + "<v v=\"${c0}\"/>"},
      {"a circle of properties",
       "<xacro:property name=\"x\" value=\"${y}\"/><xacro:property name=\"y\" value=\"${x}\"/><v v=\"${x}\"/>"},
      {"a block that inserts itself",
       "<xacro:property name=\"x\"><xacro:insert_block name=\"x\"/></xacro:property><xacro:insert_block name=\"x\"/>"},
      {"an element that is one", "<xacro:element xacro:name=\"xacro:element\"/>"},
      {"functions in functions", closures + "<v v=\"${f}\"/>"},
      {"entities", "</a><!DOCTYPE a [<!ENTITY x \"y\">]><a>"},
      {"laughs of YAML", "<xacro:property name=\"y\" value=\"${xacro.load_yaml('l.yaml')}\"/><v v=\"${y}\"/>"},
      {"a circle of YAML", "<v v=\"${xacro.load_yaml('c.yaml')}\"/>"},
      {"deep YAML", "<v v=\"${xacro.load_yaml('d.yaml')}\"/>"},
      {"YAML with a tag of Python's", "<v v=\"${xacro.load_yaml('p.yaml')}\"/>"},
  };
  for (const auto& [what, text] : ways) {
    test::MemoryFiles files;
    files.texts["/a.xacro"] = head + text + "</a>";
    files.texts["/b.xacro"] = head + "<xacro:include filename=\"a.xacro\"/></a>";
    std::string& yaml = files.texts["/l.yaml"] = "a0: &a0 [1, 1]\n";
    for (int i = 1; i < 40; ++i)
      yaml += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [*a" + std::to_string(i - 1) + ", *a" +
              std::to_string(i - 1) + "]\n";
    files.texts["/c.yaml"] = "&a [*a]\n";
    files.texts["/d.yaml"] = std::string(100000, '[') + std::string(100000, ']');
    files.texts["/p.yaml"] = "x: !!python/object/apply:os.system ['touch escaped']\n";
    const auto result = files.expandFile("/a.xacro");
    EXPECT_FALSE(result) << what;
  }
  test::MemoryFiles files;
  EXPECT_EQ(files.expanded(nested), "") << "150 conditions in each other are odd, and harmless";
}

TEST(XacroEscape, AProgramCalledXacroIsNeverStarted) {
  const hapticell::test::TemporaryFolder folder;
  const auto program = folder.write("xacro", "#!/bin/sh\ntouch " + (folder.path() / "started").string() + "\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const std::string before = std::getenv("PATH");
  ::setenv("PATH", (folder.path().string() + ":" + before).c_str(), 1);
  const auto file =
      folder.write("arm.xacro", "<robot name=\"arm\" xmlns:xacro=\"x\"><link name=\"${'a' + 'b'}\"/></robot>");
  Diagnostics diagnostics;
  const auto robot = workcell::readRobot(file, diagnostics);
  ::setenv("PATH", before.c_str(), 1);
  ASSERT_TRUE(robot) << robot.error().message();
  EXPECT_EQ(robot->model.links[0].name, "ab");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "started"));
}

}  // namespace
}  // namespace hapticell::xacro
