// SPDX-License-Identifier: Apache-2.0
#include "studies/document/study_section.h"

namespace hapticell::studies {

namespace fs = std::filesystem;

SectionReader::SectionReader(const StudySection& section)
    : SectionReader(*section.table, section.title(), section.file) {
  std::string known;
  fields_.read("what", known);
  fields_.read("name", known);
}

Expected<void> SectionReader::end() {
  fields_.refuseOthers();
  return check();
}

Expected<void> SectionReader::check() const {
  if (!error_) return {};
  Error error = *error_;
  error.file = file_.string();
  return makeError(std::move(error));
}

fs::path StudySection::fileNamed(const std::string& path) const {
  const fs::path named(path);
  return (named.is_absolute() ? named : folder() / named).lexically_normal();
}

Error StudySection::fault(Text found, Text expected, Text fix) const {
  return {.file = file.string(),
          .place = Text("line %1, %2", table->source().begin.line, title()),
          .found = std::move(found),
          .expected = std::move(expected),
          .fix = std::move(fix)};
}

std::string StudySection::title() const {
  return list + " '" + name + "'";
}

}  // namespace hapticell::studies
