// SPDX-License-Identifier: Apache-2.0
#include "workcell/format/document_io.h"

#include <algorithm>

#include "geometry/system/nesting_limit.h"
#include "workcell/format/document_format.h"
#include "workcell/format/recordings.h"
#include "workcell/text/file_content.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

Error inFile(Error error, const std::string& name) {
  error.file = name;
  return error;
}

/// "line 12" of a byte in the text.
Text lineOf(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  return Text("line %1", 1 + std::count(before.begin(), before.end(), '\n'));
}

Expected<Json> parseJson(std::string_view text, const std::string& name) {
  try {
    return Json::parse(text.begin(), text.end());
  } catch (const nlohmann::json::parse_error& problem) {
    return makeError({.file = name,
                      .place = lineOf(text, problem.byte),
                      .found = "text that is not JSON",
                      .expected = "a workcell document"});
  } catch (const nlohmann::json::exception&) {
    return makeError({.file = name, .found = "a number that is too large", .expected = "a workcell document"});
  }
}

}  // namespace

Expected<Document> parseDocument(std::string_view text, const fs::path& folder, const std::string& name,
                                 Diagnostics& diagnostics, const LoadOptions& options) {
  auto flat = geometry::checkNesting(text, geometry::NestedText::kOrderedJson, name);
  HAPTICELL_TRY(flat);
  const Expected<Json> json = parseJson(text, name);
  HAPTICELL_TRY(json);
  Expected<DocumentState> state = stateFromJson(*json, folder, diagnostics, options);
  if (!state) return makeError(inFile(state.error(), name));
  return Document(std::move(*state));
}

Expected<Document> loadDocument(const fs::path& path, Diagnostics& diagnostics, const LoadOptions& options) {
  const Expected<std::string> text = readFileContent(path);
  HAPTICELL_TRY(text);
  const fs::path absolute = fs::absolute(path).lexically_normal();
  Expected<Document> document = parseDocument(*text, absolute.parent_path(), path.string(), diagnostics, options);
  if (document) document->setPath(absolute);
  return document;
}

std::string documentText(const DocumentState& state, const fs::path& folder) {
  return prettyText(jsonFromState(state, folder));
}

Expected<void> saveDocument(Document& document, const fs::path& path) {
  const fs::path absolute = fs::absolute(path).lexically_normal();
  GatheredRecordings recordings = gatherRecordings(document.state(), absolute);
  DocumentState state = document.state();
  for (TrajectoryReference& reference : state.trajectories) {
    if (const auto now = recordings.moved.find(reference.path); now != recordings.moved.end())
      reference.path = now->second;
  }
  std::error_code fault;
  const bool made = !recordings.files.empty() && fs::create_directories(recordingsFolder(absolute), fault);
  recordings.files.push_back({absolute, documentText(state, absolute.parent_path())});
  auto written = writeFilesAtomically(recordings.files);
  if (!written) {
    if (made) fs::remove(recordingsFolder(absolute), fault);  // Where it is empty.
    return makeError(inFile(written.error(), path.string()));
  }
  document.moveTrajectories(recordings.moved);
  document.setPath(absolute);
  document.markSaved();
  return {};
}

const char* wordOf(OnContact on_contact) {
  switch (on_contact) {
    case OnContact::kStop:
      return "stop";
    case OnContact::kPass:
      return "pass";
    case OnContact::kSlide:
      break;
  }
  return "slide";
}

const char* wordOf(ForceClass force_class) {
  switch (force_class) {
    case ForceClass::kConstant:
      return "constant";
    case ForceClass::kDynamics:
      return "dynamics";
    case ForceClass::kContact:
      break;
  }
  return "contact";
}

}  // namespace hapticell::workcell
