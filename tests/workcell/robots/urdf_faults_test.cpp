// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/test_data.h"
#include "tests/workcell/robots/urdf_text.h"
#include "workcell/robots/urdf_reader.h"

namespace hapticell::workcell {
namespace {

using test::jointText;
using test::linkText;
using test::meshText;
using test::robotText;
using ::testing::HasSubstr;

struct Fault {
  std::string name;
  std::string text;
  std::vector<std::string> told;  ///< What the sentence must name.
};

class UrdfFault : public ::testing::TestWithParam<Fault> {};

TEST_P(UrdfFault, IsOneSentenceThatNamesTheFileAndThePlace) {
  const hapticell::test::TemporaryFolder folder;
  const auto file = folder.write("robot.urdf", GetParam().text);
  Diagnostics diagnostics;
  ::testing::internal::CaptureStderr();
  const auto model = readUrdf(file, diagnostics);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << "no library chatters";
  ASSERT_FALSE(model);
  const std::string message = model.error().message();
  EXPECT_THAT(message, HasSubstr("robot.urdf"));
  for (const std::string& part : GetParam().told) EXPECT_THAT(message, HasSubstr(part));
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

const std::string kTwoLinks = linkText("a") + linkText("b");

INSTANTIATE_TEST_SUITE_P(
    All, UrdfFault,
    ::testing::Values(
        Fault{"NotXml", "this is no XML", {"XML"}}, Fault{"Empty", "", {}},
        Fault{"Cut", robotText(kTwoLinks).substr(0, 60), {"line"}},
        Fault{"NulByte", std::string(1, '\0') + robotText(kTwoLinks), {"NUL"}},
        Fault{"NotARobot", "<sdf version=\"1.5\"/>", {"<sdf>", "<robot"}},
        Fault{"NoLinks", robotText(""), {"no links"}},
        Fault{"Xacro", robotText("<xacro:include filename=\"x\"/>"), {"xacro:include", ".xacro"}},
        Fault{"TwoRoots",
              robotText(kTwoLinks + linkText("c", "<visual/>") + jointText("j", "a", "b")),
              {"line 5", "two root links", "'a'", "'c'"}},
        Fault{"Cycle", robotText(kTwoLinks + jointText("j", "a", "b") + jointText("k", "b", "a")), {"line 5", "cycle"}},
        Fault{"CycleBesideTheTree",
              robotText(linkText("root") + kTwoLinks + jointText("j", "a", "b") + jointText("k", "b", "a")),
              {"cycle", "line"}},
        Fault{"OwnChild",
              robotText(kTwoLinks + jointText("j", "a", "b") + linkText("c") + jointText("k", "c", "c")),
              {"line 7", "cycle"}},
        Fault{"TwoParents",
              robotText(kTwoLinks + linkText("c") + jointText("j", "a", "b") + jointText("k", "a", "c") +
                        jointText("l", "c", "b")),
              {"line 8", "'b'", "'j'", "'l'"}},
        Fault{"FarAway",
              robotText(kTwoLinks + "<joint name=\"j\" type=\"fixed\"><origin xyz=\"1e200 0 0\"/><parent link=\"a\"/>"
                                    "<child link=\"b\"/></joint>"),
              {"line 5", "origin"}},
        Fault{"UnknownParent", robotText(kTwoLinks + jointText("j", "ghost", "b")), {"line 5", "'ghost'"}},
        Fault{"UnknownChild", robotText(kTwoLinks + jointText("j", "a", "ghost")), {"line 5", "'ghost'"}},
        Fault{"TwoLinksOfAName", robotText(kTwoLinks + linkText("a")), {"line 5", "'a'", "line 3"}},
        Fault{"TwoJointsOfAName",
              robotText(kTwoLinks + linkText("c") + jointText("j", "a", "b") + jointText("j", "b", "c")),
              {"line 7", "'j'"}},
        Fault{"ZeroAxis",
              robotText(kTwoLinks + jointText("j", "a", "b", "continuous", "<axis xyz=\"0 0 0\"/>")),
              {"line 5", "'j'", "axis"}},
        Fault{"NotANumber",
              robotText(kTwoLinks + jointText("j", "a", "b", "fixed", "<origin xyz=\"0 nan 0\"/>")),
              {"line 5", "nan"}},
        Fault{"TooFewNumbers",
              robotText(kTwoLinks + jointText("j", "a", "b", "fixed", "<origin rpy=\"0 1\"/>")),
              {"line 5", "3 finite"}},
        Fault{"UnknownType", robotText(kTwoLinks + jointText("j", "a", "b", "screw")), {"line 5", "'screw'"}},
        Fault{"NoParent",
              robotText(kTwoLinks + "<joint name=\"j\" type=\"fixed\"><child link=\"b\"/></joint>"),
              {"'j'", "parent"}},
        Fault{"Nameless", robotText("<link/>"), {"line 3", "name"}},
        Fault{"MimicGhost",
              robotText(kTwoLinks + jointText("j", "a", "b", "continuous", "<mimic joint=\"ghost\"/>")),
              {"'ghost'", "line 5"}},
        Fault{"MimicCircle",
              robotText(kTwoLinks + linkText("c") + jointText("j", "a", "b", "continuous", "<mimic joint=\"k\"/>") +
                        jointText("k", "b", "c", "continuous", "<mimic joint=\"j\"/>")),
              {"mimics itself"}}),
    [](const auto& case_info) { return case_info.param.name; });

TEST(UrdfFaults, DeepNestingIsRefusedBeforeAnyParserRecurses) {
  std::string deep = "<robot name=\"r\">";
  for (int i = 0; i < 200000; ++i) deep += "<a>";
  const hapticell::test::TemporaryFolder folder;
  Diagnostics diagnostics;
  const auto model = readUrdf(folder.write("deep.urdf", deep), diagnostics);
  ASSERT_FALSE(model);
  EXPECT_THAT(model.error().message(), HasSubstr("nested"));
}

TEST(UrdfFaults, TextThatIsNoUtf8IsReadAndTold) {
  const hapticell::test::TemporaryFolder folder;
  Diagnostics diagnostics;
  const std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- pi\xE8"
      "ce -->\n" +
      robotText(linkText("a"));
  const auto model = readUrdf(folder.write("latin.urdf", text), diagnostics);
  ASSERT_TRUE(model) << model.error().message();
  ASSERT_EQ(diagnostics.warnings.size(), 1u);
  EXPECT_THAT(english(diagnostics.warnings[0]), HasSubstr("line 2: text that is not UTF-8"));
}

TEST(UrdfFaults, NamesInLatin1KeepTheirAccents) {
  const hapticell::test::TemporaryFolder folder;
  Diagnostics diagnostics;
  const std::string text = "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n" + robotText(linkText("pi\xE8"
                                                                                                    "ce"));
  const auto model = readUrdf(folder.write("latin.urdf", text), diagnostics);
  ASSERT_TRUE(model) << model.error().message();
  ASSERT_EQ(model->links.size(), 1u);
  EXPECT_EQ(model->links[0].name, "pièce");
}

/// TinyXML 2.6.2 went on behind the end of such a text.
TEST(UrdfFaults, ATextThatEndsWithinACharacterIsRefused) {
  const hapticell::test::TemporaryFolder folder;
  Diagnostics diagnostics;
  const std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?><robot " + std::string(300, '\xF2');
  const auto model = readUrdf(folder.write("cut.urdf", text), diagnostics);
  ASSERT_FALSE(model);
  EXPECT_THAT(model.error().message(), HasSubstr("invalid XML"));
}

TEST(UrdfFaults, MissingFileAndFolder) {
  Diagnostics diagnostics;
  const hapticell::test::TemporaryFolder folder;
  EXPECT_THAT(readUrdf(folder.path() / "none.urdf", diagnostics).error().message(), HasSubstr("none.urdf"));
  EXPECT_FALSE(readUrdf(folder.path(), diagnostics));
}

std::string withByte(std::string text, std::size_t at, char byte) {
  text[at] = byte;
  return text;
}

// Every prefix and every damaged byte of a real-looking file gives a model or a sentence, never a crash.
TEST(UrdfFaults, DamagedFilesNeverCrash) {
  const std::string whole = robotText(
      linkText("a",
               "<visual><geometry><box size=\"1 1 1\"/></geometry><material name=\"m\"><color rgba=\"1 0 0 1\"/>"
               "</material></visual>") +
      linkText("b") + jointText("j", "a", "b"));
  const hapticell::test::TemporaryFolder folder;
  int accepted = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    for (const std::string& damaged : {whole.substr(0, i), withByte(whole, i, '<'), withByte(whole, i, '"')}) {
      Diagnostics diagnostics;
      const auto model = readUrdf(folder.write("r.urdf", damaged), diagnostics);
      if (model)
        ++accepted;
      else
        EXPECT_FALSE(model.error().message().empty());
    }
  }
  EXPECT_GT(accepted, 0);
}

}  // namespace
}  // namespace hapticell::workcell
