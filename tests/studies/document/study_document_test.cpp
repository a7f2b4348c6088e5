// SPDX-License-Identifier: Apache-2.0
#include "studies/document/study_document.h"

#include <gtest/gtest.h>

#include "studies/document/study_section.h"

namespace hapticell::studies {
namespace {

const std::string kHead = "cell = \"a.hcell\"\n[[vary]]\nwhat = \"position\"\nname = \"x\"\n[[ask]]\nwhat = \"reach\"\n";

Expected<StudyDocument> parsed(const std::string& text) {
  return StudyDocument::parse(text, "/tmp/folder/s.hstudy");
}

std::string fault(const std::string& text) {
  const auto document = parsed(text);
  return document ? "no error" : document.error().message();
}

TEST(StudyDocument, ReadsEverythingThatItSays) {
  const auto document = parsed(kHead +
                               "[sampling]\nmethod = \"halton\"\nsamples = 7\n[[require]]\nvalue = \"reach.share\"\n"
                               "at_least = 0.5\n[[objective]]\nvalue = \"t.time\"\ngoal = \"greatest\"\nweight = 3.0\n");
  ASSERT_TRUE(document) << document.error().message();
  EXPECT_EQ(document->name, "s");
  EXPECT_EQ(document->cell, "/tmp/folder/a.hcell");
  EXPECT_EQ(document->sampling, Sampling::kHalton);
  EXPECT_EQ(document->samples, 7U);
  ASSERT_EQ(document->variations.size(), 1U);
  EXPECT_EQ(document->variations[0].name, "x");
  EXPECT_EQ(document->questions.at(0).name, "reach");
  EXPECT_EQ(document->requirements.at(0).at_least, 0.5);
  EXPECT_TRUE(document->objectives.at(0).is_greatest);
  EXPECT_EQ(document->objectives.at(0).weight, 3.0);
}

TEST(StudyDocument, NamesLineAndKeyOfAFault) {
  const std::string unknown = fault("cell = \"a\"\nsed = 3\n[[vary]]\nwhat = \"position\"\n[[ask]]\nwhat = \"reach\"\n");
  EXPECT_NE(unknown.find("line 2"), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("'sed'"), std::string::npos) << unknown;
  EXPECT_NE(fault("cell = 3\n").find("line 1"), std::string::npos);
  EXPECT_NE(fault("cell = \"a\"\n[[vary\n").find("TOML"), std::string::npos);
  const std::string method = fault(kHead + "[sampling]\nmethod = \"dice\"\n");
  EXPECT_NE(method.find("halton"), std::string::npos) << method;
  EXPECT_NE(fault(kHead + "[sampling]\nmethod = \"sobol\"\n").find("samples"), std::string::npos);
}

TEST(StudyDocument, RefusesWhatCannotBeRun) {
  EXPECT_NE(fault("cell = \"a\"\n").find("nothing varies"), std::string::npos);
  EXPECT_NE(fault("cell = \"a\"\n[[vary]]\nwhat = \"position\"\n").find("nothing is asked"), std::string::npos);
  EXPECT_NE(fault(kHead + "[search]\n").find("without an objective"), std::string::npos);
  EXPECT_NE(fault(kHead + "[[vary]]\nwhat = \"position\"\nname = \"x\"\n").find("second one called 'x'"),
            std::string::npos);
  EXPECT_NE(fault(kHead + "[[require]]\nvalue = \"a\"\n").find("without a bound"), std::string::npos);
}

TEST(StudyDocument, SectionsLiveAsLongAsACopy) {
  StudyDocument copy;
  {
    const auto document = parsed(kHead);
    ASSERT_TRUE(document);
    copy = *document;
  }
  SectionReader reader(copy.variations.at(0));
  std::string axis = "none";
  reader.fields().read("axis", axis);
  EXPECT_TRUE(reader.end());
  EXPECT_EQ(axis, "none");
}

}  // namespace
}  // namespace hapticell::studies
