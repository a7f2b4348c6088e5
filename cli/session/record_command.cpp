// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "cli/session/session_commands.h"
#include "exchange/recordings/demonstration_table.h"
#include "exchange/recordings/recording_reader.h"
#include "exchange/recordings/recording_writer.h"
#include "exchange/recordings/trace_table.h"
#include "geometry/system/regular_file.h"
#include "geometry/system/text_case.h"
#include "haptic/client/server_address.h"
#include "haptic/client/server_watch.h"
#include "haptic/protocol/link_problem.h"
#include "manipulation/session/exercise.h"
#include "trajectory/files/trajectory_io.h"
#include "trajectory/training/training.h"

namespace hapticell::cli {

namespace {

namespace fs = std::filesystem;
using exchange::Recording;
using nlohmann::ordered_json;

struct RecordWords {
  std::vector<std::string> from;
  std::string topic, server, mcap, table, task;
  double seconds = 10.0, rate = 50.0;
};

/// A trainee's scores with the runs that are kept beside them.
Expected<void> addTraining(const fs::path& file, Recording& recording) {
  auto session = trajectory::readTraining(file);
  HAPTICELL_TRY(session);
  for (const trajectory::TrainingAttempt& attempt : session->attempts) {
    if (attempt.recording.empty()) continue;
    auto run = trajectory::readTrajectory(file.parent_path() / attempt.recording);
    HAPTICELL_TRY(run);
    recording.motions.push_back(std::move(*run));
  }
  recording.trainings.push_back(std::move(*session));
  return {};
}

/// An exercise: the expert's motion, and its file as an attachment.
Expected<void> addExercise(const fs::path& file, Recording& recording) {
  const auto exercise = manipulation::readExercise(file);
  HAPTICELL_TRY(exercise);
  auto expert = trajectory::readTrajectory(exercise->recording);
  HAPTICELL_TRY(expert);
  auto text = geometry::readRegularFile(file);
  HAPTICELL_TRY(text);
  recording.motions.push_back(std::move(*expert));
  recording.files.emplace_back(file.filename().string(), std::move(*text));
  return {};
}

Expected<void> addFile(const std::string& name, const std::string& topic, Recording& recording) {
  const fs::path file(name);
  if (lowerExtension(file) == ".htrain") return addTraining(file, recording);
  if (lowerExtension(file) == ".hexercise") return addExercise(file, recording);
  if (exchange::isMcapFile(file)) {
    auto read = exchange::readMcapRecording(file, topic);
    HAPTICELL_TRY(read);
    for (const Text& note : read->notes) warn(note);
    const bool has_two = !recording.stylus.empty() && !read->stylus.empty();
    if (has_two) return makeError({name, "--from", "a second stylus", "one recording of a stylus", ""});
    std::vector<trajectory::Trajectory> motions = std::move(recording.motions);
    motions.insert(motions.end(), read->motions.begin(), read->motions.end());
    if (recording.isEmpty()) recording = std::move(*read);
    recording.motions = std::move(motions);
    return {};
  }
  if (lowerExtension(file) == ".csv" && exchange::isTraceTable(file)) {
    if (!recording.stylus.empty()) return makeError({name, "--from", "a second stylus", "one recording of a stylus", ""});
    auto samples = exchange::readTraceTable(file);
    HAPTICELL_TRY(samples);
    recording.stylus = std::move(*samples);
    recording.has_moved_frame = true;
    return {};
  }
  std::vector<Text> notes;
  auto motion = trajectory::readTrajectory(file, &notes);
  HAPTICELL_TRY(motion);
  for (const Text& note : notes) warn(note);
  if (motion->empty()) return makeError({name, "frames", "none", "a motion", ""});
  recording.motions.push_back(std::move(*motion));
  return {};
}

/// What a watcher hears of a server, by its own clock.
struct WatchedSamples {
  std::vector<exchange::StylusSample> samples;
  std::uint64_t first_tick = 0, last_tick = 0;
  std::int64_t first_stamp_ns = 0;
  bool was_lost = false;

  void add(const haptic::HapticState& state) {
    if (!samples.empty() && state.tick <= last_tick) return;
    if (samples.empty()) {
      first_tick = state.tick;
      first_stamp_ns = state.server_stamp_ns;
    }
    last_tick = state.tick;
    exchange::StylusSample sample;
    sample.t = 1e-9 * static_cast<double>(state.server_stamp_ns - first_stamp_ns);
    if (!samples.empty() && !(sample.t > samples.back().t)) return;
    sample.X_DS = state.X_DS;
    sample.X_DP = state.X_DP;
    sample.force_D = state.force_D;
    sample.torque_D = state.torque_D;
    sample.buttons = state.buttons;
    sample.contact = state.force_D != dvec3(0.0);
    samples.push_back(sample);
  }
};

Expected<WatchedSamples> watchServer(const std::string& server, double seconds) {
  using Clock = std::chrono::steady_clock;
  // Four looks a tick: none of the server's states is missed on a machine that is not overloaded. Half as often: a few
  // in a thousand are; twice: more of a processor.
  constexpr auto kLook = std::chrono::microseconds(250);
  const auto address = haptic::parseServerAddress(server, "--server");
  HAPTICELL_TRY(address);
  const auto link = haptic::watchServer(address->host, address->port, "hapticell-cli record");
  HAPTICELL_TRY(link);
  WatchedSamples watched;
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  while (Clock::now() < end) {
    if (const auto state = (*link)->latestState()) watched.add(*state);
    if ((*link)->connections() != 1 || (*link)->linkState() != haptic::LinkState::kConnected) {
      watched.was_lost = true;
      break;
    }
    std::this_thread::sleep_for(kLook);
  }
  if (watched.samples.empty())
    return makeError({server, "", "the connection was lost before the first state", "states of the stylus", ""});
  return watched;
}

Expected<void> writeTable(const RecordWords& words, const Recording& recording) {
  std::error_code ignored;
  if (fs::exists(words.table, ignored) && !fs::is_empty(words.table, ignored))
    return makeError({words.table, "--lerobot", "a folder that is not empty", "a new folder", ""});
  exchange::DemonstrationOptions options;
  options.rate_hz = words.rate;
  options.task = words.task;
  auto files = exchange::demonstrationFiles(recording.motions, options);
  HAPTICELL_TRY(files);
  for (FileToWrite& file : *files) {
    file.path = fs::path(words.table) / file.path;
    fs::create_directories(file.path.parent_path(), ignored);
    if (ignored) return makeError({file.path.string(), "", systemText(ignored.value()), "a folder to write", ""});
  }
  return writeFilesAtomically(*files);
}

Expected<ordered_json> record(const RecordWords& words) {
  if (words.from.empty() == words.server.empty())
    return makeError({"", "--from, --server", words.from.empty() ? Text("neither is given") : Text("both are given"), "one of the two", ""});
  if (words.mcap.empty() && words.table.empty())
    return makeError({"", "--mcap, --lerobot", "neither is given", "a file or a folder to write", ""});
  Recording recording;
  ordered_json result;
  if (!words.server.empty()) {
    if (!words.table.empty())
      return makeError({"", "--lerobot", "--server, which has no motion of an entity", "--from with it",
                        "Record with 'hapticell-cli session --mcap', then use 'record --from'."});
    auto watched = watchServer(words.server, words.seconds);
    HAPTICELL_TRY(watched);
    if (watched->was_lost) warn("The connection was lost before the end; what was received is written.");
    recording.stylus = std::move(watched->samples);
    const std::uint64_t ticks = watched->last_tick - watched->first_tick + 1;
    result["complete"] = !watched->was_lost;
    result["ticks"] = ticks;
    result["ticks_without_state"] = ticks - recording.stylus.size();
  }
  for (const std::string& file : words.from) HAPTICELL_TRY(addFile(file, words.topic, recording));
  if (!words.mcap.empty()) HAPTICELL_TRY(exchange::writeMcapRecording(recording, words.mcap));
  if (!words.table.empty()) HAPTICELL_TRY(writeTable(words, recording));
  std::size_t frames = 0, attempts = 0;
  for (const auto& motion : recording.motions) frames += motion.size();
  for (const auto& training : recording.trainings) attempts += training.attempts.size();
  result["motions"] = recording.motions.size();
  result["frames"] = frames;
  result["samples"] = recording.stylus.size();
  result["contacts"] = recording.contacts.size();
  result["attempts"] = attempts;
  if (!words.mcap.empty()) result["mcap"] = words.mcap;
  if (!words.table.empty()) result["lerobot"] = words.table;
  return result;
}

ExitStatus runRecord(const RecordWords& words, const ResultWriter& writer) {
  const auto result = record(words);
  const auto written = result ? writer.write(*result) : tl::unexpected(result.error());
  if (written) return ExitStatus::kDone;
  report(written.error());
  return ExitStatus::kBadInput;
}

}  // namespace

void addRecordCommand(Subcommand app, Action& chosen) {
  Subcommand command =
      app.add("record", "Write recordings as MCAP or as a table for learning, from files or a running server");
  const auto words = std::make_shared<RecordWords>();
  command
      .option("--from", words->from,
              "File to write: a motion, a trace of a session, an exercise, results of a trainee, or MCAP; can be repeated")
      .takes(ValueKind::kFile)
      .oneAtATime();
  command.option("--topic", words->topic, "Topic of an MCAP file of another program");
  command.option("--server", words->server, "HOST:PORT of a running haptic server; its stylus is recorded");
  command.option("--seconds", words->seconds, "How long to record a server, s (10)").within(0.01, 3600.0);
  command.option("--mcap,-o,--output", words->mcap, "MCAP file to write").takes(ValueKind::kMcap);
  command.option("--lerobot", words->table, "Folder to write in the layout of LeRobot, with tables as CSV")
      .takes(ValueKind::kFolder);
  command.option("--rate", words->rate, "Frames per second of that table (50)").within(1.0, 1000.0);
  command.option("--task", words->task, "What was done, in words, for that table");
  command.onChosen([words, &chosen] { chosen = [words](ResultWriter& writer) { return runRecord(*words, writer); }; });
}

}  // namespace hapticell::cli
