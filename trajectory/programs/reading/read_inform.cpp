// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <sstream>

#include "trajectory/motion/csv_table.h"
#include "trajectory/programs/reading/program_path.h"
#include "trajectory/programs/reading/program_readers.h"
#include "trajectory/programs/reading/robot_angles.h"

namespace hapticell::trajectory {

namespace {

constexpr double kInformMillimetre = 1e-3;  // m
// Lines run, as kMostSteps of read_fanuc.cpp.
constexpr std::size_t kMostInformSteps = 500'000;

/// A position of //POS: a pose in a frame, or pulses, which only the controller can read.
struct InformPosition {
  std::optional<Pose> X;
  int user = -1;  ///< The user frame; -1: base or robot.
};

struct InformLine {
  std::size_t line = 0;
  std::vector<std::string> words;
};

/// A job's name, positions and instructions.
struct InformJob {
  std::string name;
  std::map<std::string, InformPosition> positions;
  std::vector<InformLine> lines;
};

std::vector<std::string> informWords(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::optional<Pose> rectangular(const std::string& list) {
  std::array<double, 6> n{};
  std::istringstream stream(list);
  std::string item;
  for (double& number : n) {
    if (!std::getline(stream, item, ',')) return std::nullopt;
    const auto read = parseNumber(item);
    if (!read) return std::nullopt;
    number = *read;
  }
  return Pose{kInformMillimetre * dvec3(n[0], n[1], n[2]), fromFanucAngles({n[3], n[4], n[5]})};
}

InformJob parseJob(const std::string& text) {
  InformJob job;
  std::istringstream stream(text);
  bool is_rectangular = false, in_user = false, has_begun = false;
  int user = 1;
  std::size_t number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    const auto words = informWords(line);
    if (words.empty()) continue;
    const std::string& first = words[0];
    if (first == "//NAME" && words.size() > 1) job.name = words[1];
    if (first == "///USER" && words.size() > 1) user = static_cast<int>(parseNumber(words[1]).value_or(1.0));
    if (first == "///POSTYPE" && words.size() > 1) in_user = words[1] == "USER";
    if (first == "///RECTAN") is_rectangular = true;
    if (first == "///PULSE" || first == "///ANGLE") is_rectangular = false;
    if (first == "//INST") has_begun = true;
    if (first.front() == '/' || first.front() == '\'') continue;
    const auto equals = line.find('=');
    if (!has_begun && equals != std::string::npos) {
      InformPosition position;
      if (is_rectangular) position.X = rectangular(line.substr(equals + 1));
      position.user = in_user ? user : -1;
      job.positions[line.substr(0, equals)] = position;
    } else if (has_begun) {
      job.lines.push_back({number, words});
    }
  }
  return job;
}

class InformRun {
 public:
  InformRun(const InformJob& job, ProgramPath& path) : job_(job), path_(path) {
    for (std::size_t i = 0; i < job_.lines.size(); ++i)
      if (job_.lines[i].words[0].front() == '*') labels_[job_.lines[i].words[0]] = i;
  }

  void run() {
    std::size_t steps = 0;
    for (at_ = 0; at_ < job_.lines.size() && !path_.hasFailed();) {
      const InformLine& line = job_.lines[at_++];
      if (++steps > kMostInformSteps) return path_.fail(line.line, Text("endless jumps"), Text("a job that ends"), "");
      step(line);
    }
    endArc();
  }

 private:
  void step(const InformLine& line) {
    const std::string& word = line.words[0];
    if (word == "MOVC") return addArc(line);
    endArc();
    if (word == "END" || word == "RET") {
      at_ = job_.lines.size();
    } else if (word == "MOVJ" || word == "MOVL" || word == "MOVS") {
      move(line);
    } else if (word == "IMOV" || word == "REFP" || word == "SFTON" || word == "MOVE") {
      path_.fail(line.line, Text("'%1', which moves by a variable on the controller", word),
                 Text::plain("MOVJ, MOVL, MOVC"), "");
    } else if (word == "TIMER") {
      if (const auto seconds = tagged(line, "T=")) path_.wait(*seconds);
    } else if (word == "JUMP") {
      jump(line);
    } else if (word == "CALL") {
      path_.noteLine(line.line,
                     Text("'%1' is not in the file; if it moves the robot, these moves are missing.", joined(line)));
    } else if (word != "NOP" && word.front() != '*') {
      path_.skip(line.line);
    }
  }

  static std::string joined(const InformLine& line) {
    std::string text;
    for (const std::string& word : line.words) text += (text.empty() ? "" : " ") + word;
    return text.substr(0, 60);
  }

  static std::optional<double> tagged(const InformLine& line, const std::string& tag) {
    for (const std::string& word : line.words)
      if (word.starts_with(tag)) return parseNumber(word.substr(tag.size()));
    return std::nullopt;
  }

  /// Its pose, once the frame and speed are set; else the target is missed.
  std::optional<Pose> target(const InformLine& line) {
    if (const auto speed = tagged(line, "V=")) path_.setLinearSpeed(kInformMillimetre * *speed);
    if (const auto share = tagged(line, "VJ=")) path_.setJointShare(0.01 * *share);
    const std::string name = line.words.size() > 1 ? line.words[1] : "";
    const auto found = job_.positions.find(name);
    if (found == job_.positions.end() || !found->second.X) {
      path_.missTarget(line.line, found == job_.positions.end()
                                      ? Text("'%1', which the file does not define", name)
                                      : Text("'%1' in pulses, which only the controller can convert", name));
      return std::nullopt;
    }
    const int user = found->second.user;
    if (user < 0)
      path_.setFrame(Pose::identity(), "");
    else
      path_.setFrame(std::nullopt, Text("the user frame %1", user));
    return found->second.X;
  }

  void move(const InformLine& line) {
    if (line.words[0] == "MOVS")
      path_.noteLine(line.line, Text("a spline; it is read as straight lines between its points."));
    if (const auto X = target(line)) path_.moveTo(line.line, *X, line.words[0] == "MOVJ");
  }

  /// The first MOVC goes to the arc's begin, then two each are an arc.
  void addArc(const InformLine& line) {
    const auto X = target(line);
    if (!X) return;
    arc_line_ = line.line;
    arc_.push_back(*X);
    if (arc_.size() == 1) {
      const auto here = path_.current();
      if (!here || distanceBetween(*here, *X).position > 1e-6) path_.moveTo(line.line, *X, false);
    } else if (arc_.size() % 2 == 1) {
      path_.moveArc(line.line, arc_[arc_.size() - 2], *X);
    }
  }

  void endArc() {
    if (arc_.size() > 1 && arc_.size() % 2 == 0)
      path_.fail(arc_line_, Text("MOVC to %1 points", arc_.size()), Text("3, 5, ... points for arcs"), "");
    arc_.clear();
  }

  void jump(const InformLine& line) {
    const bool is_conditional = std::find(line.words.begin(), line.words.end(), "IF") != line.words.end();
    const auto label = line.words.size() > 1 ? labels_.find(line.words[1]) : labels_.end();
    if (is_conditional) {
      path_.noteLine(
          line.line,
          Text("'%1' depends on values that the file does not define; the condition is read as false.", joined(line)));
    } else if (label == labels_.end()) {
      path_.fail(line.line, Text("'%1', a jump out of the job", joined(line)), Text("a label in the job"), "");
    } else if (label->second < at_) {
      path_.noteLine(line.line, Text("a jump back; the repeated lines are read once."));
    } else {
      at_ = label->second;
    }
  }

  const InformJob& job_;
  ProgramPath& path_;
  std::map<std::string, std::size_t> labels_;
  std::vector<Pose> arc_;
  std::size_t arc_line_ = 0;
  std::size_t at_ = 0;
};

}  // namespace

Expected<ReadProgram> readInform(const std::string& text, const ProgramReadOptions& options) {
  const InformJob job = parseJob(text);
  if (job.lines.empty())
    return makeError({.place = Text::plain("//INST"),
                      .found = "the job has no instructions",
                      .expected = "a job: /JOB, //POS, //INST"});
  ProgramPath path(options);
  InformRun(job, path).run();
  return path.finish(job.name);
}

}  // namespace hapticell::trajectory
