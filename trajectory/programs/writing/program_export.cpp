// SPDX-License-Identifier: Apache-2.0
#include "trajectory/programs/writing/program_export.h"

#include <algorithm>
#include <cctype>

#include "geometry/system/text_case.h"
#include "trajectory/motion/csv_table.h"
#include "trajectory/motion/number_text.h"
#include "trajectory/programs/writing/program_names.h"
#include "trajectory/programs/writing/program_writers.h"

namespace hapticell::trajectory {

namespace {

constexpr std::size_t kMostInformPositions = 9990;  // A job has at most 9999 lines.

bool isWholeNumber(const std::string& text, int least, int greatest) {
  const auto number = parseNumber(text);
  return number && text.find_first_not_of("0123456789") == std::string::npos && *number >= least && *number <= greatest;
}

/// A word of the language, perhaps with an index or of a library: what cannot end the statement it is put into.
bool isExpression(const std::string& text, ProgramFormat format) {
  const bool has_structures = format == ProgramFormat::kKrl || format == ProgramFormat::kUrScript;
  const std::string_view signs = has_structures ? "_$[]{}.,:+- ()" : "_[]:.";
  const auto isFit = [signs](unsigned char c) {
    return c < 128 && (std::isalnum(c) != 0 || signs.find(static_cast<char>(c)) != std::string_view::npos);
  };
  const auto first = static_cast<unsigned char>(text.front());
  return (std::isalpha(first) != 0 || first == '$' || first == '{') && std::all_of(text.begin(), text.end(), isFit);
}

/// Tool and base as the language takes them.
Expected<void> checkFrames(const ProgramOptions& options, ProgramFormat format) {
  struct Word {
    Text name;
    const std::string& text;
    int least, greatest;
  };
  const bool is_fanuc = format == ProgramFormat::kFanuc;
  for (const Word& word : {Word{Text("tool"), options.tool, is_fanuc ? 1 : 0, is_fanuc ? 29 : 63},
                           Word{Text("base"), options.base, is_fanuc ? 0 : 1, is_fanuc ? 61 : 63}}) {
    if (word.text.empty()) continue;
    if (is_fanuc || format == ProgramFormat::kInform) {
      if (isWholeNumber(word.text, word.least, word.greatest)) continue;
      return makeError({.place = word.name,
                        .found = Text("'%1'", word.text),
                        .expected = Text("the number on the controller, %1 to %2", word.least, word.greatest)});
    }
    if (isExpression(word.text, format)) continue;
    return makeError(
        {.place = word.name, .found = Text("'%1'", word.text), .expected = "a name that exists on the controller"});
  }
  return {};
}

/// A blend must not reach into a neighbour's.
std::vector<double> blendsOf(const Trajectory& trajectory, double wanted, double least) {
  std::vector<double> blends(trajectory.size(), 0.0);
  for (std::size_t i = 1; i + 1 < trajectory.size(); ++i) {
    if (trajectory[i].dwell > 0.0) continue;
    const double before = glm::length(trajectory[i].X_WT.p - trajectory[i - 1].X_WT.p);
    const double after = glm::length(trajectory[i + 1].X_WT.p - trajectory[i].X_WT.p);
    blends[i] = std::min(wanted, 0.45 * std::min(before, after));
    if (blends[i] < least) blends[i] = 0.0;
  }
  return blends;
}

/// What became of the name that was wanted; empty where nothing did.
Text nameNote(const std::string& wanted, const std::string& name, ProgramFormat format) {
  if (wanted.empty() || sameButForCase(wanted, name)) return {};
  const std::string language = programNumbers(format).language;
  if (isReservedName(wanted, format))
    return Text("The program is named '%1', because '%2' is a reserved word of %3.", name, wanted, language);
  return Text(
      "The program is named '%1', because '%2' is not a valid name in %3 (letters, digits and _, a letter first, at "
      "most %4 characters).",
      name, wanted, language, longestProgramName(format));
}

std::vector<ProgramFile> writeProgram(const ProgramInput& input, ProgramFormat format) {
  switch (format) {
    case ProgramFormat::kKrl:
      return writeKrl(input);
    case ProgramFormat::kRapid:
      return writeRapid(input);
    case ProgramFormat::kFanuc:
      return writeFanuc(input);
    case ProgramFormat::kUrScript:
      return writeUrScript(input);
    case ProgramFormat::kVal3:
      return writeVal3(input);
    case ProgramFormat::kInform:
      return writeInform(input);
  }
  return {};
}

}  // namespace

std::string ProgramInput::configurationAt(std::size_t i) const {
  return options.configuration && hasJoints() ? options.configuration(trajectory.joints(i)) : std::string();
}

std::string numberList(std::initializer_list<double> values, int decimals, std::string_view separator) {
  std::string text;
  for (const double value : values) {
    if (!text.empty()) text += separator;
    text += fixedText(value, decimals);
  }
  return text;
}

std::string jointList(std::span<const double> joints, int decimals, double unit, std::string_view separator) {
  std::string text;
  for (const double joint : joints) {
    if (!text.empty()) text += separator;
    text += fixedText(joint * unit, decimals);
  }
  return text;
}

Expected<std::vector<ProgramFile>> exportProgram(const Trajectory& trajectory, ProgramFormat format,
                                                 const ProgramOptions& options, std::vector<Text>* notes) {
  if (trajectory.empty()) return makeError({.place = "frames", .found = "none", .expected = "at least one frame"});
  if (!trajectory.has_poses) {
    return makeError({.place = "poses",
                      .found = "joint values without poses, so the program has no targets",
                      .expected = "poses",
                      .fix = "Set the robot of these joints (--robot), so that the poses can be computed."});
  }
  if (trajectory.hasJoints() && trajectory.joint_names.size() != 6) {
    return makeError({.place = "joints",
                      .found = Text("%1 joints", trajectory.joint_names.size()),
                      .expected = "six joints, or none",
                      .fix = "Export it as csv, json or ros."});
  }
  const bool has_values = options.speed > 0.0 && options.acceleration > 0.0 && options.blend >= 0.0 &&
                          options.joint_speed > 0.0 && options.joint_speed <= 1.0;
  if (!has_values) {
    return makeError({.place = "speed, acceleration, blend",
                      .found = "a value outside its range",
                      .expected = "speeds above 0, a joint speed of at most 1, a blend of 0 or more"});
  }
  HAPTICELL_TRY(checkFrames(options, format));
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    if (!trajectory[i].X_WT.isValid()) {
      return makeError({.place = Text("frame %1", i),
                        .found = "an invalid pose",
                        .expected = "finite numbers and a unit quaternion"});
    }
  }
  if (format == ProgramFormat::kInform && trajectory.size() > kMostInformPositions) {
    return makeError({.place = "frames",
                      .found = std::to_string(trajectory.size()),
                      .expected = Text("at most %1, the limit of an INFORM job", kMostInformPositions),
                      .fix = "Simplify or split the motion."});
  }
  const std::string wanted_name = options.name.empty() ? trajectory.name : options.name;
  const std::string name = programName(wanted_name, format);
  const ProgramNumbers& rules = programNumbers(format);
  NumberWriter numbers(rules);
  if (options.blend > 0.0 && rules.blend.greatest > 0.0) numbers.text(rules.blend, options.blend, Text("blend"));
  const double least_blend = rules.blend.least / rules.blend.scale;
  const ProgramInput input{trajectory, options, name, blendsOf(trajectory, options.blend, least_blend), rules, numbers};
  auto files = writeProgram(input, format);
  if (numbers.error()) return makeError(*numbers.error());
  const auto measured = measureProgram(files, format, options, trajectory);
  HAPTICELL_TRY(measured);
  const PoseDistance& off = measured->largest;
  if (options.must_read_back && kProgramPromise.shareOf(off) > 1.0) {
    return makeError(
        {.place = "check of the written program",
         .found = Text("a deviation of %1 m and %2 rad", shortestText(off.position), shortestText(off.angle)),
         .expected = Text("at most %1 m and %2 rad", shortestText(kProgramPromise.position),
                          shortestText(kProgramPromise.angle)),
         .fix = "Nothing was written. Move the motion nearer to the robot's base."});
  }
  if (notes) {
    if (auto changed = nameNote(wanted_name, name, format); !changed.empty()) notes->push_back(std::move(changed));
    notes->insert(notes->end(), numbers.notes().begin(), numbers.notes().end());
  }
  return files;
}

std::vector<ProgramFile> placedProgram(const std::vector<ProgramFile>& files, ProgramFormat format,
                                       const std::filesystem::path& wanted) {
  std::vector<ProgramFile> placed;
  for (const ProgramFile& file : files) {
    const std::filesystem::path name(file.name);
    std::filesystem::path path = wanted;
    if (format == ProgramFormat::kVal3) {
      path = wanted / name.filename();
    } else if (files.size() > 1 || !path.has_extension()) {
      path.replace_extension(name.extension());
    }
    placed.push_back({path.string(), file.content});
  }
  return placed;
}

}  // namespace hapticell::trajectory
