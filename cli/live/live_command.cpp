// SPDX-License-Identifier: Apache-2.0
#include "cli/live/live_command.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "cli/kit/result_writer.h"
#include "cli/kit/stop_signal.h"
#include "cli/live/live_options.h"
#include "exchange/recordings/recording_reader.h"
#include "haptic/client/server_address.h"
#include "haptic/client/server_watch.h"
#include "manipulation/checks/motion_replay.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/format/document_io.h"

namespace hapticell::cli {

namespace {

using manipulation::MotionReplay;
using nlohmann::ordered_json;

struct LiveWords {
  LiveOptions where;
  std::string workcell, entity, motion, server;
  double rate = 30.0, seconds = 0.0;
  bool repeat = false;
};

Expected<std::optional<MotionReplay>> replayOf(const workcell::Document& document, const LiveWords& words) {
  if (words.motion.empty()) return std::nullopt;
  if (words.entity.empty())
    return makeError({.place = "--entity", .found = "it is missing", .expected = "what the motion moves"});
  std::vector<Text> notes;
  auto motion = exchange::isMcapFile(words.motion) ? exchange::readMcapMotion(words.motion, {}, &notes)
                                                   : trajectory::readTrajectory(words.motion, &notes);
  HAPTICELL_TRY(motion);
  for (const Text& note : notes) warn(note);
  auto replay = MotionReplay::create(document.state().entities, words.entity,
                                     std::make_shared<const trajectory::Trajectory>(std::move(*motion)));
  HAPTICELL_TRY(replay);
  return std::optional(std::move(*replay));
}

Expected<std::unique_ptr<haptic::TcpLink>> watchedServer(const std::string& server) {
  if (server.empty()) return std::unique_ptr<haptic::TcpLink>();
  const auto address = haptic::parseServerAddress(server, "--server");
  HAPTICELL_TRY(address);
  return haptic::openWatcher(address->host, address->port, "hapticell-cli live");
}

/// The cell `t` seconds after the beginning.
manipulation::SceneSnapshot pictureAt(double t, const std::optional<MotionReplay>& replay, haptic::TcpLink* link,
                                      const LiveWords& words) {
  manipulation::SceneSnapshot picture;
  picture.time_s = t;
  if (replay) {
    const double begin = replay->motion()[0].t, duration = replay->motion().duration();
    const double at = words.repeat && duration > 0.0 ? std::fmod(t, duration) : std::min(t, duration);
    const manipulation::EntityConfiguration now = replay->at(begin + at);
    picture.entities.push_back({replay->entity(), now.X_WE, now.joints});
  }
  if (!link) return picture;
  if (const auto state = link->latestState()) {
    picture.stylus.connected = true;
    // Without a session nobody has placed the device in the cell: its frame is shown as the world's.
    picture.stylus.X_WStylus = state->X_DS;
    picture.stylus.force_W = state->force_D;
    picture.stylus.force_n = glm::length(state->force_D);
  }
  return picture;
}

Expected<ordered_json> showLive(const LiveWords& words) {
  Diagnostics notes;
  const auto document = workcell::loadDocument(words.workcell, notes);
  HAPTICELL_TRY(document);
  for (const Text& note : notes.warnings) warn(note);
  const auto replay = replayOf(*document, words);
  HAPTICELL_TRY(replay);
  const auto link = watchedServer(words.server);
  HAPTICELL_TRY(link);
  const StopSignal stop;  // Before the address is told: who has read it may stop it.
  auto live = LiveView::open(words.where);
  HAPTICELL_TRY(live);
  live->show(document->state());
  double end = -1.0;  // s; below 0: until Ctrl+C.
  if (*replay && !words.repeat) end = (*replay)->motion().duration();
  if (words.seconds > 0.0) end = words.seconds;
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  std::uint64_t pictures = 0;
  std::size_t most_viewers = 0;
  for (; !stop.asked(); ++pictures) {
    const double t = static_cast<double>(pictures) / words.rate;
    if (end >= 0.0 && t > end) break;
    std::this_thread::sleep_until(begin + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(t)));
    live->update(pictureAt(t, *replay, link->get(), words));
    most_viewers = std::max(most_viewers, live->server().viewers());
  }
  return ordered_json{{"address", live->address()},       {"pictures", pictures},
                      {"viewers", most_viewers},          {"messages", live->server().sent()},
                      {"messages_left_out", live->server().dropped()}};
}

}  // namespace

void addLiveCommand(Subcommand app, Action& chosen) {
  Subcommand command = app.add("live", "Show a cell live in a browser, with Foxglove or Lichtblick");
  const auto words = std::make_shared<LiveWords>();
  command.option("--workcell", words->workcell, "Workcell document, *.hcell").takes(ValueKind::kWorkcell).required();
  command.option("--entity", words->entity, "What the motion moves");
  command.option("--motion", words->motion, "Motion to play, in any format that is read").takes(ValueKind::kMotion);
  command.flag("--repeat", words->repeat, "Play the motion again and again");
  command.option("--server", words->server, "HOST:PORT of a haptic server; its stylus and force are shown");
  command.option("--port", words->where.port, "Port for viewers (8765; 0: any that is free)").withinWhole(0, 65535);
  command.option("--listen", words->where.listen,
                 "Address to listen at (127.0.0.1, this machine only); another one gets a code that viewers need");
  command.option("--rate", words->rate, "Pictures a second, Hz (30)").within(1.0, 1000.0);
  command.option("--seconds", words->seconds, "How long, s (0: until the motion ends, or Ctrl+C)").within(0.0, 86400.0);
  command.onChosen([words, &chosen] {
    chosen = [words](ResultWriter& writer) {
      const auto answer = showLive(*words);
      const auto written = answer ? writer.write(*answer) : Expected<void>(tl::unexpected<Error>(answer.error()));
      if (written) return ExitStatus::kDone;
      report(written.error());
      return ExitStatus::kBadInput;
    };
  });
}

}  // namespace hapticell::cli
