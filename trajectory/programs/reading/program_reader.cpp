// SPDX-License-Identifier: Apache-2.0
#include "trajectory/programs/reading/program_reader.h"

#include <algorithm>

#include "geometry/system/regular_file.h"
#include "geometry/system/text_case.h"
#include "trajectory/programs/reading/program_readers.h"

namespace hapticell::trajectory {

namespace {

namespace fs = std::filesystem;

// Bytes: guards memory, as other readers do. Half, twice: other files are refused with a message.
constexpr std::uintmax_t kLargestProgram = 256U << 20U;

bool isAmong(const std::string& word, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(), [&](const char* w) { return word == w; });
}

Expected<std::string> textOf(const fs::path& file) {
  auto content = geometry::readRegularFile(file, kLargestProgram);
  HAPTICELL_TRY(content);
  std::string text = std::move(*content);
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  if (text.find('\0') != std::string::npos)
    return makeError({.file = file.string(),
                      .found = "a binary file",
                      .expected = "a program in text format",
                      .fix = "Save it as text on the controller (FANUC: .ls, not .tp)."});
  return text;
}

/// A file of this name in the folder, whatever the case.
fs::path besides(const fs::path& folder, const std::string& name) {
  std::error_code problem;
  for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    if (lowerCase(entry->path().filename().string()) == lowerCase(name)) return entry->path();
  }
  return {};
}

Expected<ReadProgram> readKrlFiles(const fs::path& file, const ProgramReadOptions& options) {
  fs::path source = file;
  const std::string stem = file.stem().string();
  if (lowerExtension(file) == ".dat") source = besides(file.parent_path(), stem + ".src");
  if (source.empty()) {
    return makeError({.file = file.string(),
                      .found = "a file of points without a program",
                      .expected = Text("%1.src in the same folder", stem),
                      .fix = "Open the .src file."});
  }
  ProgramText text;
  auto read = textOf(source);
  HAPTICELL_TRY(read);
  text.source = std::move(*read);
  const fs::path data = besides(file.parent_path(), stem + ".dat");
  const fs::path more = besides(file.parent_path(), "$config.dat");
  for (const auto& [path, into] : {std::pair(data, &text.data), std::pair(more, &text.more_data)}) {
    if (path.empty()) continue;
    auto points = textOf(path);
    HAPTICELL_TRY(points);
    *into = std::move(*points);
  }
  auto program = readKrl(text, options);
  if (program && data.empty())
    program->notes.insert(program->notes.begin(), Text("%1.dat is missing in the same folder.", stem));
  if (!program && data.empty() && program.error().fix.empty())
    program.error().fix = Text("%1.dat, in which KRL stores the points, is missing in the same folder.", stem);
  return program;
}

}  // namespace

bool isProgramFile(const fs::path& file) {
  return isAmong(lowerExtension(file),
                 {".src", ".dat", ".mod", ".modx", ".prg", ".sys", ".ls", ".script", ".urscript", ".jbi"});
}

Expected<ReadProgram> readProgram(const fs::path& file, const ProgramReadOptions& options) {
  const std::string extension = lowerExtension(file);
  Expected<ReadProgram> program =
      makeError({.found = Text("the extension '%1'", extension), .expected = ".src, .mod, .ls or .script"});
  if (extension == ".src" || extension == ".dat") {
    program = readKrlFiles(file, options);
  } else if (isProgramFile(file)) {
    const auto text = textOf(file);
    HAPTICELL_TRY(text);
    if (extension == ".jbi")
      program = readInform(*text, options);
    else if (extension == ".ls")
      program = readFanuc(*text, options);
    else if (isAmong(extension, {".script", ".urscript"}))
      program = readUrScript(*text, options);
    else
      program = readRapid(*text, options);
  }
  if (!program) {
    if (program.error().file.empty()) program.error().file = file.string();
    return program;
  }
  if (program->trajectory.name.empty()) program->trajectory.name = file.stem().string();
  return program;
}

}  // namespace hapticell::trajectory
