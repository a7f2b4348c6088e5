// SPDX-License-Identifier: Apache-2.0
#include "agents/task/agent_section.h"

#include "agents/task/section_reader.h"

namespace hapticell::agents {

SectionReader::SectionReader(const AgentSection& section)
    : SectionReader(section.table->toml, "agent '" + section.kind + "'", section.file) {
  std::string known;
  double weight = 0.0;
  bool enabled = true;
  fields_.read("what", known);
  fields_.read("weight", weight);
  fields_.read("enabled", enabled);
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

Error AgentSection::fault(Text found, Text expected, Text fix) const {
  return {.file = file.string(),
          .place = Text("line %1, agent '%2'", table->toml.source().begin.line, kind),
          .found = std::move(found),
          .expected = std::move(expected),
          .fix = std::move(fix)};
}

}  // namespace hapticell::agents
