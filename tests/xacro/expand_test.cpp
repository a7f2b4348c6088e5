// SPDX-License-Identifier: Apache-2.0
// What a file becomes: the results are those of xacro 2.1 (ros/xacro), with which the same texts were tried.
#include <gtest/gtest.h>

#include "tests/xacro/memory_files.h"

namespace hapticell::xacro {
namespace {

using test::MemoryFiles;

struct Sample {
  const char *what, *text, *result;
};

TEST(XacroExpand, PropertiesMacrosAndBlocks) {
  const std::vector<Sample> samples = {
      {"a property", "<xacro:property name=\"p\" value=\"42\"/><b c=\"${p} ${p/2}\"/>", "<b c=\"42 21.0\"/>"},
      {"used before it is written",
       "<xacro:property name=\"q\" value=\"${2*p}\"/><xacro:property name=\"p\" value=\"4\"/><b c=\"${q}\"/>",
       "<b c=\"8\"/>"},
      {"a text stays one",
       "<xacro:property name=\"p\" value=\"1_2\"/><xacro:property name=\"q\" value=\"5 -2\"/><b c=\"${p} ${q}\"/>",
       "<b c=\"1_2 5 -2\"/>"},
      {"a default",
       "<xacro:property name=\"p\" default=\"1\"/><xacro:property name=\"p\" default=\"2\"/><b c=\"${p}\"/>",
       "<b c=\"1\"/>"},
      {"removed",
       "<xacro:property name=\"p\" value=\"1\"/><xacro:property name=\"p\" remove=\"true\"/><xacro:property name=\"p\" "
       "default=\"2\"/><b c=\"${p}\"/>",
       "<b c=\"2\"/>"},
      {"evaluated where it stands",
       "<xacro:property name=\"p\" value=\"Ab\"/><xacro:property name=\"p\" value=\"${p.lower()}\" "
       "lazy_eval=\"false\"/><b c=\"${p}\"/>",
       "<b c=\"ab\"/>"},
      {"a dollar", "<b c=\"$${x}\" d=\"$$${x}\" e=\"$\" f=\"1 $ 2\" g=\"$$(pwd)\"/>",
       "<b c=\"${x}\" d=\"$${x}\" e=\"$\" f=\"1 $ 2\" g=\"$(pwd)\"/>"},
      {"a macro",
       "<xacro:macro name=\"m\" params=\"x y:=7\"><b c=\"${x}${y}\"/></xacro:macro><xacro:m x=\"1\"/><xacro:m "
       "x=\"${2}\" y=\"3\"/>",
       "<b c=\"17\"/><b c=\"23\"/>"},
      {"defaults in quotes",
       "<xacro:macro name=\"m\" params=\"a='1 -2' c=3\"><b a=\"${a}\" c=\"${c}\"/></xacro:macro><xacro:m/>",
       "<b a=\"1 -2\" c=\"3\"/>"},
      {"a default of the place of the call",
       "<xacro:macro name=\"m\" params=\"x:=${2*p}\"><xacro:property name=\"p\" value=\"-\"/><b "
       "c=\"${x}\"/></xacro:macro><xacro:property name=\"p\" value=\"${3*7}\"/><xacro:m/>",
       "<b c=\"42\"/>"},
      {"forwarded",
       "<xacro:property name=\"x\" value=\"42\"/><xacro:macro name=\"m\" params=\"x:=^ y:=^|6\"><b "
       "c=\"${x}${y}\"/></xacro:macro><xacro:m/>",
       "<b c=\"426\"/>"},
      {"a block and its content",
       "<xacro:macro name=\"m\" params=\"*one **many\"><b><xacro:insert_block name=\"one\"/><xacro:insert_block "
       "name=\"many\"/></b></xacro:macro><xacro:m><c/><d><e/><f/></d></xacro:m>",
       "<b><c/><e/><f/></b>"},
      {"a block through two macros",
       "<xacro:macro name=\"i\" params=\"*k\"><i><xacro:insert_block name=\"k\"/></i></xacro:macro><xacro:macro "
       "name=\"o\" params=\"*k\"><o><xacro:i><xacro:insert_block "
       "name=\"k\"/></xacro:i></o></xacro:macro><xacro:o><w/></xacro:o>",
       "<o><i><w/></i></o>"},
      {"elements in a property",
       "<xacro:property name=\"v\" value=\"2\"/><xacro:property name=\"k\"><c "
       "d=\"${v}\"/></xacro:property><xacro:insert_block name=\"k\"/>",
       "<c d=\"2\"/>"},
      {"scopes",
       "<xacro:macro name=\"m\" params=\"f\"><xacro:property name=\"p\" value=\"${21*f}\" "
       "scope=\"parent\"/><xacro:property name=\"g\" value=\"1\" scope=\"global\"/><xacro:property name=\"l\" "
       "value=\"9\"/></xacro:macro><xacro:property name=\"l\" value=\"0\"/><xacro:m f=\"2\"/><b c=\"${p}${g}${l}\"/>",
       "<b c=\"4210\"/>"},
      {"called by name",
       "<xacro:macro name=\"m\" params=\"x\"><b c=\"${x}\"/></xacro:macro><xacro:property name=\"n\" "
       "value=\"m\"/><xacro:call macro=\"${n}\" x=\"1\"/>",
       "<b c=\"1\"/>"},
      {"an element and an attribute",
       "<xacro:element xacro:name=\"b${1}\"><xacro:attribute name=\"c\" value=\"${2}\"/></xacro:element>",
       "<b1 c=\"2\"/>"},
      {"conditions",
       "<xacro:if value=\"${1 == 1}\"><b/></xacro:if><xacro:if value=\"0\"><c/></xacro:if><xacro:unless "
       "value=\"false\"><d/></xacro:unless><xacro:if value=\"${[]}\"><e/></xacro:if>",
       "<b/><d/>"},
      {"nothing twice",
       "<xacro:macro name=\"m\" params=\"a b:=${a} c:=$${a}\"><b b=\"${b}\" c=\"${c}\"/></xacro:macro><xacro:property "
       "name=\"a\" value=\"1\"/><xacro:m a=\"2\"/>",
       "<b b=\"1\" c=\"${a}\"/>"},
      {"what is no xacro stays", "<arg name=\"x\"/><include filename=\"y\"/>",
       "<arg name=\"x\"/><include filename=\"y\"/>"},
  };
  for (const auto& [what, text, result] : samples) {
    MemoryFiles files;
    EXPECT_EQ(files.expanded(text), result) << what;
  }
}

TEST(XacroExpand, ArgumentsAreGivenOrHaveDefaults) {
  MemoryFiles files;
  const std::string text =
      "<xacro:arg name=\"x\" default=\"0.5\"/><xacro:arg name=\"y\" default=\"$(arg x)\"/><xacro:property name=\"p\" "
      "value=\"$(arg y)\"/><b c=\"${p - 0.3}\" d=\"$(arg ${'x'})\" e=\"${xacro.arg('y')}\" f=\"$(eval arg('x') * "
      "2)\"/>";
  EXPECT_EQ(files.expanded(text), "<b c=\"0.2\" d=\"0.5\" e=\"0.5\" f=\"1.0\"/>");
  ASSERT_EQ(files.declared.size(), 2u);
  EXPECT_EQ(files.declared[0].otherwise, "0.5");
  files.arguments["x"] = "4.3";
  EXPECT_EQ(files.expanded(text), "<b c=\"4.0\" d=\"4.3\" e=\"4.3\" f=\"8.6\"/>");
  EXPECT_EQ(files.declared[0].value, "4.3");
  files.arguments.clear();
  const std::string said = files.expanded("\n<b c=\"$(arg ur_type)\"/>");
  EXPECT_NE(said.find("/a.xacro, line 2: undefined substitution argument ur_type"), std::string::npos) << said;
  EXPECT_NE(said.find("ur_type:=VALUE"), std::string::npos) << said;
  ASSERT_EQ(files.declared.size(), 1u);
  EXPECT_FALSE(files.declared[0].otherwise);
}

TEST(XacroExpand, IncludesFindTheirFilesAndNameSpaces) {
  MemoryFiles files;
  files.texts["/sub/one.xacro"] = "<r xmlns:xacro=\"x\"><xacro:include filename=\"two.xacro\"/><one/></r>";
  files.texts["/sub/two.xacro"] =
      "<r xmlns:xacro=\"x\"><xacro:property name=\"p\" value=\"2\"/><xacro:macro name=\"m\"><two "
      "p=\"${p}\"/></xacro:macro></r>";
  files.texts["/pack/urdf/three.xacro"] = "<r><three/></r>";
  EXPECT_EQ(files.expanded("<xacro:include filename=\"sub/one.xacro\"/><xacro:m/>"), "<one/><two p=\"2\"/>");
  EXPECT_EQ(
      files.expanded("<xacro:include filename=\"$(find pack)/urdf/three.xacro\"/><b c=\"$(find pack)/meshes/x.stl\"/>"),
      "<three/><b c=\"package://pack/meshes/x.stl\"/>");
  EXPECT_EQ(files.expanded("<xacro:property name=\"p\" value=\"1\"/><xacro:include filename=\"sub/two.xacro\" "
                           "ns=\"n\"/><xacro:n.m/><b c=\"${p} ${n.p}\"/>"),
            "<two p=\"2\"/><b c=\"1 2\"/>");
  EXPECT_EQ(files.expanded("<xacro:include filename=\"none.xacro\" optional=\"true\"/>"), "");
  EXPECT_NE(files.expanded("<xacro:include filename=\"$(find nowhere)/x.xacro\"/>").find("resource not found: nowhere"),
            std::string::npos);
  const std::string said = files.expanded("<xacro:include filename=\"none.xacro\"/>");
  EXPECT_NE(said.find("line 1: the file none.xacro does not exist"), std::string::npos) << said;
}

TEST(XacroExpand, YamlIsReadAsPyYamlDoes) {
  MemoryFiles files;
  files.texts["/v.yaml"] =
      "arm:\n  length: 0.5\n  joints: [1, yes, 010, 1e3, 1.0e+3, ~, 'x', 0x10, 1_000, 1:30]\n  turn: !degrees 180/2\n  "
      "span: !inches 10\n"
      "base: &base {x: 1, y: 2}\nmore:\n  <<: *base\n  y: 3\n";
  const auto value = [&files](const std::string& expression) {
    const std::string text = files.expanded(
        "<xacro:property name=\"y\" value=\"${xacro.load_yaml('v.yaml')}\"/><v v=\"${" + expression + "}\"/>");
    return text.starts_with("<v v=\"") ? text.substr(6, text.size() - 9) : text;
  };
  EXPECT_EQ(value("y.arm.length * 2"), "1.0");
  EXPECT_EQ(value("y['arm']['joints']"), "[1, True, 8, '1e3', 1000.0, None, 'x', 16, 1000, 90]");
  EXPECT_EQ(value("y.arm.turn"), "1.5707963267948966");
  EXPECT_EQ(value("y.arm.span"), "0.254");
  EXPECT_EQ(value("y.more.x + y.more.y"), "4");
  EXPECT_EQ(value("'arm' in y and 'leg' not in y"), "True");
  EXPECT_NE(value("y.leg").find("has no key 'leg'"), std::string::npos);
  files.texts["/v.yaml"] = "a: [1\nb: 2\n";
  EXPECT_NE(value("y").find("/v.yaml, line "), std::string::npos) << value("y");
}

TEST(XacroExpand, FaultsNameFileLineNameAndTheMacrosOnTheWay) {
  MemoryFiles files;
  files.texts["/m.xacro"] =
      "<r xmlns:xacro=\"x\">\n<xacro:macro name=\"arm\" params=\"length *end\">\n<link\n name=\"l\" "
      "size=\"${lenght}\"/>\n</xacro:macro></r>";
  files.texts["/a.xacro"] =
      "<r xmlns:xacro=\"x\">\n<xacro:include filename=\"m.xacro\"/>\n<xacro:arm length=\"1\"><e/></xacro:arm></r>";
  const auto refused = files.expandFile("/a.xacro");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().file, "/m.xacro");
  EXPECT_EQ(refused.error().place, Text("line %1", 4));
  EXPECT_NE(english(refused.error().found).find("name 'lenght' is not defined"), std::string::npos);
  EXPECT_NE(english(refused.error().found).find("macro 'arm' called in a.xacro line 3"), std::string::npos)
      << english(refused.error().found);
  const std::vector<std::pair<std::string, std::string>> faults = {
      {"<xacro:nothing/>", "<xacro:nothing>"},
      {"<xacro:macro name=\"m\" params=\"x\"/><xacro:m/>", "does not set x"},
      {"<xacro:macro name=\"m\" params=\"x\"/><xacro:m y=\"1\"/>", "no parameter 'y'"},
      {"<xacro:macro name=\"m\" params=\"*x\"/><xacro:m/>", "has no block for"},
      {"<xacro:macro name=\"m\"/><xacro:m><b/></xacro:m>", "<b> inside the call"},
      {"<xacro:if value=\"maybe\"/>", "maybe"},
      {"<xacro:property name=\"in.valid\" value=\"1\"/>", "in.valid"},
      {"<xacro:property name=\"__x\" value=\"1\"/>", "__x"},
      {"<xacro:property value=\"1\"/>", "without name"},
      {"<xacro:property name=\"p\" value=\"1\" default=\"2\"/>", "more than one"},
      {"<xacro:insert_block name=\"k\"/>", "the block 'k'"},
      {"<b c=\"$(dance x)\"/>", "$(dance x)"},
      {"<b c=\"${1\"/>", "without its end"},
      {"<b c=\"$(env HAPTICELL_SURELY_NOT_SET)\"/>", "HAPTICELL_SURELY_NOT_SET"},
      {"${xacro.fatal('no', 1)}", "no 1"},
  };
  for (const auto& [text, found] : faults) {
    const std::string said = files.expanded("\n" + text);
    EXPECT_NE(said.find("/a.xacro, line 2: "), std::string::npos) << said;
    EXPECT_NE(said.find(found), std::string::npos) << said;
  }
}

TEST(XacroExpand, WhatMovesNothingIsLeftOutWithAWarning) {
  MemoryFiles files;
  EXPECT_EQ(files.expanded("<gazebo><plugin p=\"${nothing}\"/></gazebo>\n<link name=\"l\"/>"),
            "<gazebo/><link name=\"l\"/>");
  ASSERT_EQ(files.diagnostics.warnings.size(), 1u);
  EXPECT_NE(english(files.diagnostics.warnings[0]).find("/a.xacro, line 1: <plugin> is left out"), std::string::npos)
      << english(files.diagnostics.warnings[0]);
  EXPECT_NE(english(files.diagnostics.warnings[0]).find("'nothing'"), std::string::npos);
}

TEST(XacroExpand, EachLineKnowsWhereItComesFrom) {
  MemoryFiles files;
  files.texts["/m.xacro"] = "<r xmlns:xacro=\"x\">\n<xacro:macro name=\"m\">\n<link/>\n</xacro:macro></r>";
  files.texts["/a.xacro"] = "<r xmlns:xacro=\"x\">\n<xacro:include filename=\"m.xacro\"/>\n\n<xacro:m/>\n<joint/></r>";
  const auto result = files.expandFile("/a.xacro");
  ASSERT_TRUE(result) << result.error().message();
  EXPECT_EQ(result->text, "<r>\n<link/>\n<joint/>\n</r>\n");
  ASSERT_EQ(result->places.size(), 4u);
  EXPECT_EQ(result->places[1].file, "/m.xacro");
  EXPECT_EQ(result->places[1].line, 3);
  EXPECT_EQ(result->places[2].file, "/a.xacro");
  EXPECT_EQ(result->places[2].line, 5);
}

}  // namespace
}  // namespace hapticell::xacro
