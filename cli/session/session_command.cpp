// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/kit/command_listener.h"
#include "cli/live/live_options.h"
#include "cli/session/session_commands.h"
#include "cli/session/session_plan.h"
#include "cli/session/session_recording.h"
#include "cli/session/session_report.h"
#include "cli/session/session_settings.h"
#include "exchange/recordings/recording_writer.h"
#include "geometry/system/plain_number.h"
#include "haptic/client/server_address.h"
#include "manipulation/session/local_server.h"
#include "manipulation/session/server_session.h"
#include "manipulation/session/session.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/document/assembly_solid.h"
#include "workcell/format/document_io.h"
#include "workcell/text/file_content.h"

namespace hapticell::cli {

namespace {

using manipulation::SessionOptions;
using manipulation::SessionReport;
using nlohmann::ordered_json;

struct SessionWords {
  std::string workcell, entity, hand;
  std::optional<double> rate_manipulation, rate_gui;
  double latency_ms = 0.0;
  std::optional<std::string> device;
  std::vector<std::string> set;
  bool realtime = false, fail_on_contact = false, fail_on_limit = false;
  std::string server;
  std::optional<int> live;
  std::string trace, mcap;
  std::string configuration;
  std::string record;
  bool record_by_button = false, record_all = false;
  std::optional<double> record_interval, record_distance;
};

Expected<void> readRates(const SessionWords& words, SessionOptions& options) {
  const auto within = [](const char* name, double value, double low, double high) -> Expected<void> {
    if (std::isfinite(value) && value >= low && value <= high) return {};
    return makeError({.place = Text(name),
                      .found = shortNumber(value),
                      .expected = Text("%1 to %2", shortNumber(low), shortNumber(high))});
  };
  options.rate_gui_hz = words.rate_gui.value_or(options.configuration.gui.rate_hz);
  options.latency_s = 1e-3 * words.latency_ms;
  double& rate = options.configuration.manipulation.rate_hz;
  rate = words.rate_manipulation.value_or(rate);
  if (const auto fine = within("--rate-manipulation", rate, 10.0, 1000.0); !fine) return fine;
  if (const auto fine = within("--rate-gui", options.rate_gui_hz, 1.0, 1000.0); !fine) return fine;
  return within("--latency", words.latency_ms, 0.0, 1000.0);
}

/// By time (10 ms where nothing is said) or by distance.
Expected<void> readRecording(const SessionWords& words, SessionOptions& options) {
  if (words.record.empty() && words.mcap.empty()) {
    if (!words.record_interval && !words.record_distance) return {};
    return makeError({.place = "--record-interval, --record-distance",
                      .found = "--record is missing",
                      .expected = "--record or --mcap together with this option"});
  }
  if (words.record_interval && words.record_distance) {
    return makeError(
        {.place = "--record-interval, --record-distance", .found = "both are given", .expected = "one of the two"});
  }
  trajectory::RecordingOptions recording;
  const bool every_step = words.record.empty() && !words.record_interval;  // --mcap alone.
  if (words.record_all || every_step) recording.mode = trajectory::RecordingMode::kEveryStep;
  if (words.record_by_button) recording.mode = trajectory::RecordingMode::kByHand;
  options.mark_by_button = words.record_by_button;
  recording.interval_s = words.record_interval.value_or(recording.interval_s);
  if (words.record_distance) {
    recording.mode = trajectory::RecordingMode::kByDistance;
    // 5 mm go with 5 degrees; other distances in proportion.
    recording.spacing.angle *= *words.record_distance / recording.spacing.position;
    recording.spacing.position = *words.record_distance;
  }
  if (!(recording.interval_s > 0.0) || !(recording.spacing.position > 0.0)) {
    return makeError({.place = "--record-interval, --record-distance",
                      .found = "a value that is not above 0",
                      .expected = "seconds or metres above 0"});
  }
  options.recording = recording;
  return {};
}

Expected<void> saveRecording(const SessionWords& words, const SessionReport& session) {
  if (words.record.empty() && words.mcap.empty()) return {};
  if (session.recording.empty()) warn("No entity was held and moved, so the recording has no frames.");
  if (words.record.empty()) return {};
  const bool is_csv = words.record.ends_with(".csv");
  // What moved beside it, on the same clock, stands beside its file.
  const std::filesystem::path place(words.record);
  std::vector<workcell::FileToWrite> files;
  for (const trajectory::Trajectory& other : session.other_recordings) {
    const auto beside = place.parent_path() / (place.stem().string() + "-" + other.entity + place.extension().string());
    files.push_back({beside, is_csv ? toCsvText(other) : toJsonText(other)});
  }
  files.push_back({place, is_csv ? toCsvText(session.recording) : toJsonText(session.recording)});
  return workcell::writeFilesAtomically(files);
}

/// What was assumed of the hand path, and what of it no stylus of this kind can follow.
void warnAboutHand(const SessionWords& words, const SessionOptions& options) {
  // m that a hand goes beyond the stops before it is reported: stops give a little. Half: messages on every push;
  // twice: 20 mm are lost in silence.
  constexpr double kStopsGive = 0.01;
  for (const auto& sentence : options.hand.assumptions()) warn(Text("%1: %2.", words.hand, sentence));
  double outside = 0.0;
  for (const haptic::HandSample& sample : options.hand.samples()) {
    const dvec3 over = glm::abs(sample.X_DH.p) - 0.5 * options.device.workspace;
    outside = std::max({outside, over.x, over.y, over.z});
  }
  if (outside < kStopsGive) return;
  warn(Text("%1: the path leaves the workspace of the %2 by %3 mm; the stylus stops at its mechanical limits.",
            words.hand, options.device.name.substr(0, 60), plainNumber(1e3 * outside, std::chars_format::fixed, 0)));
}

Expected<SessionOptions> readOptions(const SessionWords& words) {
  SessionOptions options;
  const auto configuration = config::loadConfiguration(words.configuration);
  HAPTICELL_TRY(configuration);
  options.configuration = *configuration;

  Diagnostics diagnostics;
  const auto document = workcell::loadDocument(words.workcell, diagnostics);
  for (const Text& sentence : diagnostics.warnings) warn(sentence);
  HAPTICELL_TRY(document);
  const workcell::Document held(workcell::withAssemblyAsSolid(document->state(), words.entity));
  options.entities = held.snapshotEntities();
  options.pairs = held.state().pairPolicy();
  options.guides = held.state().guides;
  options.entity = words.entity;

  const auto hand = haptic::readHandPath(words.hand);
  HAPTICELL_TRY(hand);
  options.hand = *hand;
  std::set<std::string> seen;
  SessionPlanWords plan;
  for (const std::string& setting : words.set) {
    const std::string key = setting.substr(0, setting.find('='));
    if (!seen.insert(key).second)
      return makeError({.place = "--set", .found = Text("'%1' twice", key), .expected = "each key at most once"});
    HAPTICELL_TRY(applySessionSetting(setting, options, plan));
  }
  HAPTICELL_TRY(readRates(words, options));
  HAPTICELL_TRY(readRecording(words, options));
  const std::string device = words.device.value_or(options.configuration.haptic.device);
  const auto profile = simulatedDevice(device);
  HAPTICELL_TRY(profile);
  options.device = *profile;
  HAPTICELL_TRY(addPlanner(plan, words.realtime, options));
  warnAboutHand(words, options);
  return options;
}

const char* const kTraceHeader =
    "t,x,y,z,qw,qx,qy,qz,proxy_x,proxy_y,proxy_z,fx,fy,fz,button,contact,"
    "moved_x,moved_y,moved_z,moved_qw,moved_qx,moved_qy,moved_qz,tx,ty,tz\n";

void appendRow(std::string& text, const manipulation::TraceRow& row) {
  char line[640];
  const Pose &S = row.X_DS, &P = row.X_DP, &M = row.X_WM;
  std::snprintf(line, sizeof line,
                "%.6f,%.9f,%.9f,%.9f,%.9f,%.9f,%.9f,%.9f,%.9f,%.9f,%.9f,%.6f,%.6f,%.6f,%u,%d,"
                "%.9f,%.9f,%.9f,%.9f,%.9f,%.9f,%.9f,%.6f,%.6f,%.6f\n",
                row.t, S.p.x, S.p.y, S.p.z, S.q.w, S.q.x, S.q.y, S.q.z, P.p.x, P.p.y, P.p.z, row.force_D.x,
                row.force_D.y, row.force_D.z, row.buttons, row.contact ? 1 : 0, M.p.x, M.p.y, M.p.z, M.q.w, M.q.x,
                M.q.y, M.q.z, row.torque_D.x, row.torque_D.y, row.torque_D.z);
  text += line;
}

Expected<SessionReport> runAsAsked(const SessionWords& words, const SessionOptions& options,
                                   const manipulation::TraceSink& trace) {
  if (!words.realtime) return manipulation::runSession(options, trace);
  if (words.server.empty()) {
    const auto own = manipulation::LocalServer::start(options.device, options.configuration);
    HAPTICELL_TRY(own);
    return manipulation::runSessionOnServer(options, "127.0.0.1", (*own)->port(), trace);
  }
  const auto address = haptic::parseServerAddress(words.server, "--server");
  HAPTICELL_TRY(address);
  return manipulation::runSessionOnServer(options, address->host, address->port, trace);
}

ExitStatus runSessionCommand(const SessionWords& words, const ResultWriter& writer) {
  const auto failed = [](const Error& error) {
    report(error);
    return ExitStatus::kBadInput;
  };
  if (!words.server.empty() && !words.realtime) {
    return failed({"", "--server", "it has no effect in virtual time", "--realtime with it", ""});
  }
  if (words.live && !words.realtime)
    return failed({"", "--live", "a session in virtual time is over before anybody can watch it", "--realtime with it", ""});
  auto options = readOptions(words);
  if (!options) return failed(options.error());
  std::string rows = kTraceHeader;
  manipulation::TraceSink trace;
  exchange::Recording recording;
  if (commandListener() != nullptr || !words.trace.empty() || !words.mcap.empty()) {
    trace = [&](const manipulation::TraceRow& row) {
      stopWhereAsked();
      if (!words.trace.empty()) appendRow(rows, row);
      if (!words.mcap.empty()) recording.stylus.push_back(stylusSampleOf(row));
    };
  }
  std::optional<LiveView> live;
  if (words.live) {
    auto opened = LiveView::open({.port = *words.live});
    if (!opened) return failed(opened.error());
    live = std::move(*opened);
    live->show(*options);
    options->picture = [&](const manipulation::SceneSnapshot& picture) { live->update(picture); };
  }
  const auto session = runAsAsked(words, *options, trace);
  if (!session) return failed(session.error());
  for (const auto& sentence : session->notices) warn(sentence);
  if (!words.trace.empty()) {
    if (const auto written = writeFileAtomically(words.trace, rows); !written) return failed(written.error());
  }
  if (const auto saved = saveRecording(words, *session); !saved) return failed(saved.error());
  const ordered_json result = sessionJson(*session, *options);
  if (!words.mcap.empty()) {
    addSession(recording, *session, *options, result);
    if (const auto written = exchange::writeMcapRecording(recording, words.mcap); !written)
      return failed(written.error());
  }
  if (const auto written = writer.write(result); !written) return failed(written.error());
  const bool found =
      (words.fail_on_contact && !session->contacts.empty()) || (words.fail_on_limit && !session->limits.empty());
  return found ? ExitStatus::kCheckFound : ExitStatus::kDone;
}

}  // namespace

void addSessionCommand(Subcommand app, Action& chosen) {
  Subcommand command = app.add(
      "session", "Move an entity of a workcell with a scripted hand on a simulated stylus, and measure the feel");
  const auto words = std::make_shared<SessionWords>();
  command.option("--workcell", words->workcell, "Workcell document, *.hcell").takes(ValueKind::kWorkcell).required();
  command.option("--entity", words->entity, "Entity that the stylus button holds").required();
  command.option("--hand", words->hand, "CSV with t,x,y,z,qw,qx,qy,qz,button in the device frame")
      .takes(ValueKind::kTable)
      .required();
  command.option("--rate-manipulation", words->rate_manipulation, "Rate of the manipulation loop, Hz, 10 to 1000");
  command.option("--rate-gui", words->rate_gui, "Rate of the pictures, Hz");
  command.option("--latency", words->latency_ms, "One-way latency of the simulated network, ms (virtual time only)");
  command.option("--device", words->device, "phantom_desktop, touch, touch_x, premium or premium_6dof");
  command.option("--set", words->set, "KEY=VALUE; can be repeated").oneAtATime();
  command.flag("--realtime", words->realtime, "Run in real time over TCP, with an own server or that of --server");
  command.option("--server", words->server, "HOST:PORT of a running haptic server with a simulated device");
  command.option("--live", words->live, "Port for viewers that watch live, 0 for any that is free (--realtime only)")
      .withinWhole(0, 65535);
  command.option("--config", words->configuration, "hapticell.toml whose values override the shipped ones")
      .takes(ValueKind::kToml);
  command.option("--trace,-o,--output", words->trace, "CSV to write, one row per tick").takes(ValueKind::kTable);
  command.option("--mcap", words->mcap, "Everything as MCAP to write: stylus, forces, motion, joints, contacts")
      .takes(ValueKind::kMcap);
  command.option("--record", words->record, "Trajectory of the held entity to write: .htraj or .csv")
      .takes(ValueKind::kMotion);
  command.option("--record-interval", words->record_interval, "Time between its frames, s (0.01)");
  command.flag("--record-all", words->record_all, "Record every step of the manipulation loop");
  command.flag("--record-by-button", words->record_by_button,
               "Record only frames added by the second stylus button (which is then not the clutch)");
  command.flag("--fail-on-contact", words->fail_on_contact, "Exit 1 if anything was touched");
  command.flag("--fail-on-limit", words->fail_on_limit, "Exit 1 if a limit stopped the motion");
  command.option("--record-distance", words->record_distance, "Distance between its frames, m, instead of a time");
  command.onChosen(
      [words, &chosen] { chosen = [words](ResultWriter& writer) { return runSessionCommand(*words, writer); }; });
}

}  // namespace hapticell::cli
