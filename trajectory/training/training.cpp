// SPDX-License-Identifier: Apache-2.0
#include "trajectory/training/training.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "geometry/system/nesting_limit.h"
#include "geometry/system/regular_file.h"
#include "trajectory/editing/smoothing.h"
#include "trajectory/files/trajectory_io.h"
#include "trajectory/motion/number_text.h"
#include "trajectory/training/path_progress.h"

namespace hapticell::trajectory {

namespace {

using nlohmann::json;

constexpr const char* kTrainingFormat = "hapticell-training";
constexpr int kTrainingVersion = 1;
// Of full help, docs/user/training.md tells them; our choice: five successes free a trainee. Half: ten; twice: three,
// and help falls before the way is known. Failures give half as much back, so that it does not swing.
constexpr double kLessHelp = 0.2, kMoreHelp = 0.1;

/// -ln of the squared jerk's integral times T^5 over the square of the way.
double smoothnessOf(const Trajectory& motion) {
  double way = 0.0;
  for (std::size_t i = 1; i < motion.size(); ++i) way += glm::distance(motion[i].X_WT.p, motion[i - 1].X_WT.p);
  const double time = motion.duration();
  if (motion.size() < 4 || !(way > 1e-6) || !(time > 0.0)) return 0.0;
  // A hand's noise at the recording's rate is no roughness: looked at in 60 steps a second at most.
  Trajectory even;
  const std::size_t steps = static_cast<std::size_t>(std::clamp(60.0 * time, 8.0, 60000.0));
  for (std::size_t i = 0; i <= steps; ++i) {
    const double t = motion[0].t + time * static_cast<double>(i) / static_cast<double>(steps);
    even.addFrame({t, motion.poseAt(t)});
  }
  const double jerk = rmsJerk(even);
  return jerk > 0.0 ? -std::log(jerk * jerk * std::pow(time, 6) / (way * way)) : 0.0;
}

struct Felt {
  double mean = 0.0, most = 0.0;
};

Felt forceOf(const Trajectory& motion) {
  const auto x = motion.findChannel("force_x"), y = motion.findChannel("force_y"), z = motion.findChannel("force_z");
  Felt felt;
  if (!x || !y || !z || motion.empty()) return felt;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const auto c = motion.channels(i);
    const double force = glm::length(dvec3(c[*x], c[*y], c[*z]));
    felt.mean += force / static_cast<double>(motion.size());
    felt.most = std::max(felt.most, force);
  }
  return felt;
}

/// 1 at `good`, falling to 0 at `bad`.
double shareOf(double value, double good, double bad) {
  if (bad > good) return std::clamp(1.0 - (value - good) / (bad - good), 0.0, 1.0);
  return value <= good ? 1.0 : 0.0;
}

double pointsOf(const TrainingScore& score, const TrainingScore& expert, const ScoringRule& rule) {
  const double parts[5] = {shareOf(score.time, score.expert_time, rule.slowness * score.expert_time),
                           shareOf(score.mean_deviation, 0.0, rule.deviation),
                           shareOf(score.max_force, expert.max_force, expert.max_force + rule.force),
                           shareOf(score.expert_smoothness - score.smoothness, 0.0, rule.smoothness),
                           shareOf(score.contacts, expert.contacts, expert.contacts + rule.contacts)};
  const double weights[5] = {rule.weight_time, rule.weight_deviation, rule.weight_force, rule.weight_smoothness,
                             rule.weight_contacts};
  double sum = 0.0, all = 0.0;
  for (int i = 0; i < 5; ++i) {
    sum += weights[i] * parts[i];
    all += weights[i];
  }
  return all > 0.0 ? 100.0 * score.completed * sum / all : 0.0;
}

/// Names and places of the numbers of a score, the same in both file formats.
template <class Score, class Visit>
void visitNumbers(Score& score, Visit visit) {
  visit("points", "", score.points);
  visit("completed", "", score.completed);
  visit("time", "s", score.time);
  visit("expert_time", "s", score.expert_time);
  visit("mean_deviation", "m", score.mean_deviation);
  visit("max_deviation", "m", score.max_deviation);
  visit("mean_turn", "rad", score.mean_turn);
  visit("mean_force", "N", score.mean_force);
  visit("max_force", "N", score.max_force);
  visit("smoothness", "", score.smoothness);
  visit("expert_smoothness", "", score.expert_smoothness);
  visit("contact_time", "s", score.contact_time);
}

Expected<TrainingAttempt> attemptOf(const json& entry, std::size_t index) {
  const Text place("attempt %1", index + 1);
  const auto wrong = [&](const std::string& field) {
    return makeError({.place = Text("%1, field '%2'", place, field),
                      .found = "it is missing or has the wrong type",
                      .expected = "a value"});
  };
  if (!entry.is_object()) return makeError({.place = place, .found = "not a JSON object", .expected = "an attempt"});
  TrainingAttempt attempt;
  if (!entry.contains("date") || !entry["date"].is_string()) return wrong("date");
  if (!entry.contains("help") || !entry["help"].is_number()) return wrong("help");
  if (!entry.contains("success") || !entry["success"].is_boolean()) return wrong("success");
  if (!entry.contains("contacts") || !entry["contacts"].is_number_integer()) return wrong("contacts");
  attempt.date = entry["date"].get<std::string>();
  attempt.help = entry["help"].get<double>();
  attempt.success = entry["success"].get<bool>();
  attempt.score.contacts = entry["contacts"].get<int>();
  std::string missing;
  visitNumbers(attempt.score, [&](const char* name, const char*, double& value) {
    const auto found = entry.find(name);
    if (found == entry.end() || !found->is_number())
      missing = missing.empty() ? name : missing;
    else
      value = found->template get<double>();
  });
  if (!missing.empty()) return wrong(missing);
  if (!(attempt.help >= 0.0 && attempt.help <= 1.0)) return wrong("help");
  // Files of before there were kinds: all runs were practice.
  if (const auto kind = entry.find("kind"); kind != entry.end()) {
    const auto known = kind->is_string() ? parseRunKind(kind->get<std::string>()) : std::nullopt;
    if (!known) return wrong("kind");
    attempt.kind = *known;
  }
  if (const auto file = entry.find("recording"); file != entry.end()) {
    if (!file->is_string()) return wrong("recording");
    attempt.recording = file->get<std::string>();
  }
  return attempt;
}

constexpr std::array<std::pair<RunKind, const char*>, 3> kKinds{
    {{RunKind::kPractice, "practice"}, {RunKind::kRetention, "retention"}, {RunKind::kTransfer, "transfer"}}};

/// Seconds since 1970 of "2026-01-31T12:00:00+01:00"; the zone may be Z or none.
std::optional<double> secondsOf(const std::string& date) {
  int year = 0, month = 0, day = 0, hour = 0, minute = 0, second = 0, read = 0;
  if (std::sscanf(date.c_str(), "%d-%d-%dT%d:%d:%d%n", &year, &month, &day, &hour, &minute, &second, &read) < 6)
    return std::nullopt;
  const std::chrono::year_month_day whole{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                          std::chrono::day(static_cast<unsigned>(day))};
  if (!whole.ok()) return std::nullopt;
  const auto days = std::chrono::sys_days(whole).time_since_epoch().count();
  double seconds = 86400.0 * static_cast<double>(days) + 3600.0 * hour + 60.0 * minute + second;
  char sign = 0;
  int hours = 0, minutes = 0;
  if (std::sscanf(date.c_str() + read, "%c%d:%d", &sign, &hours, &minutes) == 3 && (sign == '+' || sign == '-'))
    seconds -= (sign == '+' ? 1.0 : -1.0) * (3600.0 * hours + 60.0 * minutes);
  return seconds;
}

}  // namespace

const char* wordOf(RunKind kind) {
  return kKinds[static_cast<std::size_t>(kind)].second;
}

std::optional<RunKind> parseRunKind(const std::string& word) {
  for (const auto& [kind, name] : kKinds)
    if (word == name) return kind;
  return std::nullopt;
}

TrainingScore scoreRun(const Trajectory& expert, const Trajectory& run, const ScoringRule& rule) {
  TrainingScore score, best;
  score.expert_time = expert.duration();
  score.expert_smoothness = smoothnessOf(expert);
  best.max_force = forceOf(expert).most;
  best.contacts = static_cast<int>(expert.touches.size());
  if (run.empty()) return score;
  PathProgress progress(expert);
  double farthest = 0.0, reached = run[0].t;
  for (std::size_t i = 0; i < run.size(); ++i) {
    progress.follow(run[i].X_WT);
    const PoseDistance off = progress.deviation(run[i].X_WT);
    score.mean_deviation += off.position / static_cast<double>(run.size());
    score.mean_turn += off.angle / static_cast<double>(run.size());
    score.max_deviation = std::max(score.max_deviation, off.position);
    if (progress.share() <= farthest + 1e-6) continue;
    farthest = progress.share();
    reached = run[i].t;
  }
  score.completed = farthest >= kCompleteShare ? 1.0 : farthest;
  score.time = reached - run[0].t;
  const Felt felt = forceOf(run);
  score.mean_force = felt.mean;
  score.max_force = felt.most;
  score.smoothness = smoothnessOf(run);
  score.contacts = static_cast<int>(run.touches.size());
  for (const auto& touch : run.touches) score.contact_time += touch.t_out - touch.t_in;
  score.points = pointsOf(score, best, rule);
  return score;
}

double nextHelp(double help, bool success, bool failed_before) {
  if (success) return std::max(0.0, help - kLessHelp);
  return failed_before ? std::min(1.0, help + kMoreHelp) : help;
}

double TrainingSession::nextHelp() const {
  const TrainingAttempt *last = nullptr, *before = nullptr;
  for (const TrainingAttempt& attempt : attempts)
    if (attempt.kind == RunKind::kPractice) before = std::exchange(last, &attempt);
  if (!last) return 1.0;
  const double help = trajectory::nextHelp(last->help, last->success, before && !before->success);
  return std::round(help * 100.0) / 100.0;
}

std::size_t TrainingSession::count(RunKind kind) const {
  return static_cast<std::size_t>(
      std::count_if(attempts.begin(), attempts.end(), [kind](const auto& attempt) { return attempt.kind == kind; }));
}

std::optional<double> TrainingSession::restBefore(const std::string& date) const {
  const auto then = secondsOf(date);
  std::optional<double> rest;
  for (const TrainingAttempt& attempt : attempts) {
    if (attempt.kind != RunKind::kPractice) continue;
    const auto practised = secondsOf(attempt.date);
    if (!then || !practised || *practised > *then) continue;
    rest = std::min(rest.value_or(*then - *practised), *then - *practised);
  }
  return rest;
}

Expected<TrainingSession> readTraining(const std::filesystem::path& file) {
  const auto content = geometry::readRegularFile(file);
  HAPTICELL_TRY(content);
  return parseTraining(*content, file.string());
}

Expected<TrainingSession> parseTraining(std::string_view text, const std::string& name) {
  auto flat = geometry::checkNesting(text, geometry::NestedText::kJson, name);
  HAPTICELL_TRY(flat);
  const json document = json::parse(text, nullptr, false);
  const auto version = document.is_object() ? document.value("version", json()) : json();
  if (!document.is_object() || document.value("format", json()) != kTrainingFormat || !version.is_number_integer()) {
    return makeError({.file = name,
                      .place = Text("field '%1'", "format"),
                      .found = "not a training session",
                      .expected = Text("\"%1\"", kTrainingFormat)});
  }
  if (version.get<std::int64_t>() > kTrainingVersion || version.get<std::int64_t>() < 1) {
    return makeError({.file = name,
                      .place = Text("field '%1'", "version"),
                      .found = version.dump(),
                      .expected = Text("at most %1", kTrainingVersion)});
  }
  TrainingSession session;
  for (const auto& [field, into] : {std::pair("trainee", &session.trainee), std::pair("exercise", &session.exercise)}) {
    if (!document.contains(field) || !document[field].is_string()) {
      return makeError(
          {.file = name, .place = Text("field '%1'", field), .found = "none", .expected = "a text"});
    }
    *into = document[field].get<std::string>();
  }
  const json attempts = document.value("attempts", json::array());
  if (!attempts.is_array())
    return makeError(
        {.file = name, .place = Text("field '%1'", "attempts"), .found = "not a list", .expected = "a list"});
  for (std::size_t i = 0; i < attempts.size(); ++i) {
    auto attempt = attemptOf(attempts[i], i);
    if (!attempt) {
      Error error = attempt.error();
      error.file = name;
      return makeError(std::move(error));
    }
    session.attempts.push_back(std::move(*attempt));
  }
  return session;
}

std::string toJsonText(const TrainingSession& session) {
  nlohmann::ordered_json document{{"format", kTrainingFormat},
                                  {"version", kTrainingVersion},
                                  {"trainee", session.trainee},
                                  {"exercise", session.exercise}};
  document["attempts"] = nlohmann::ordered_json::array();
  for (const TrainingAttempt& attempt : session.attempts) {
    nlohmann::ordered_json entry{
        {"kind", wordOf(attempt.kind)}, {"date", attempt.date}, {"help", attempt.help}, {"success", attempt.success}};
    visitNumbers(attempt.score, [&](const char* name, const char*, const double& value) { entry[name] = value; });
    entry["contacts"] = attempt.score.contacts;
    if (!attempt.recording.empty()) entry["recording"] = attempt.recording;
    document["attempts"].push_back(std::move(entry));
  }
  return document.dump(1) + "\n";
}

std::string toCsvText(const TrainingSession& session) {
  std::string text = "attempt,date,help,success";
  const TrainingScore none;
  visitNumbers(none, [&](const char* name, const char* unit, const double&) {
    text += std::string(",") + name + (*unit ? std::string("_") + unit : std::string());
  });
  text += ",contacts,kind,rest_s\n";
  for (std::size_t i = 0; i < session.attempts.size(); ++i) {
    const TrainingAttempt& attempt = session.attempts[i];
    text +=
        std::to_string(i + 1) + "," + attempt.date + "," + shortestText(attempt.help) + (attempt.success ? ",1" : ",0");
    visitNumbers(attempt.score,
                 [&](const char*, const char*, const double& value) { text += "," + shortestText(value); });
    text += "," + std::to_string(attempt.score.contacts) + "," + wordOf(attempt.kind) + ",";
    if (const auto rest = attempt.kind == RunKind::kPractice ? std::nullopt : session.restBefore(attempt.date))
      text += shortestText(*rest);
    text += "\n";
  }
  return text;
}

}  // namespace hapticell::trajectory
