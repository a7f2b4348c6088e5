// SPDX-License-Identifier: Apache-2.0
#include "bench/endurance/shift.h"

#include <cmath>
#include <fstream>
#include <iterator>

#include "bench/endurance/kept_session.h"
#include "bench/endurance/random_hand.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/files/scene_export.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"
#include "manipulation/session/server_session.h"
#include "workcell/import/imported_entities.h"
#include "workcell/text/file_content.h"

namespace hapticell::endurance {

namespace {

using manipulation::MovedBy;
namespace by = manipulation::by;
using manipulation::SessionOptions;
using manipulation::SessionReport;
using workcell::Document;

constexpr double kRounding = 1e-9;
constexpr double kSlew = 1.0;             // N a millisecond, the safety chain's.
constexpr double kEntered = 1e-4;         // m: fitted surfaces may be left by so much (docs/dev/contacts.md).
constexpr std::size_t kLongHistory = 12;  // Steps; then the cell is opened afresh: what is kept of them is no leak.

std::string textOf(const Document& document) {
  return workcell::documentText(document.state(), document.path().parent_path());
}

std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

Expected<Day> Day::begin(std::uint64_t seed, const std::filesystem::path& folder, int server_port) {
  Day day;
  day.random_.seed(seed);
  day.folder_ = folder;
  day.server_port_ = server_port;
  const auto configuration = config::loadConfiguration();
  HAPTICELL_TRY(configuration);
  day.configuration_ = *configuration;
  const auto profile_file = config::findShippedFile("devices/touch.toml");
  HAPTICELL_TRY(profile_file);
  const auto profile = config::readDeviceProfile(*profile_file);
  HAPTICELL_TRY(profile);
  day.device_ = *profile;

  const std::vector<std::pair<const char*, std::vector<std::string>>> cells = {
      {"demo", {"robot", "Housing 4712", "Housing 4713", "Housing 4714"}},
      {"workbench", {"operator", "housing", "cover", "screwdriver"}},
      {"car_door", {"door"}}};
  for (const auto& [name, movable] : cells) {
    const auto file = config::findShippedFile(std::string("workcells/") + name + ".hcell");
    HAPTICELL_TRY(file);
    Diagnostics diagnostics;
    auto document = workcell::loadDocument(*file, diagnostics);
    HAPTICELL_TRY(document);
    day.cells_.push_back({name, std::move(*document), movable});
  }
  return day;
}

ShiftReport Day::work(double hand_seconds) {
  ShiftReport report;
  Cell& cell = cells_[draw(cells_.size())];
  const SessionOptions options = drawOptions(cell, hand_seconds);
  const std::size_t steps_back = 1 + draw(10);
  if (!only_.empty() && cell.name != only_) {
    ++shifts_;
    report.left_out = true;
    report.hand_s = options.hand.duration();
    return report;
  }
  runOneSession(cell, options, report);
  goThroughHistory(cell, steps_back, report);
  if (++shifts_ % 4 == 0) saveAndRead(cell, report);
  if (shifts_ % 16 == 0) importAndRemove(cell, report);
  return report;
}

SessionOptions Day::drawOptions(Cell& cell, double hand_seconds) {
  SessionOptions options;
  options.configuration = configuration_;
  options.device = device_;
  options.entities = cell.document.snapshotEntities();
  options.pairs = cell.document.state().pairPolicy();
  options.guides = cell.document.state().guides;
  options.entity = cell.movable[draw(cell.movable.size())];
  options.hand = randomHand(random_, hand_seconds);
  constexpr double kRates[] = {10.0, 30.0, 60.0};
  options.configuration.manipulation.rate_hz = kRates[draw(3)];
  options.rate_gui_hz = 10.0;
  options.latency_s = 1e-3 * between(0.0, 20.0);
  options.scale = {manipulation::ScaleLevel::kNumber, between(0.5, 6.0)};
  if (options.entity == "operator") {
    using mannequin::Side;
    const MovedBy ways[] = {by::Whole{}, by::Hand{Side::kLeft}, by::Hand{Side::kRight}, by::BothHands{}, by::Head{}};
    options.moved_by = ways[draw(5)];
  } else if (options.entity == "robot") {
    options.moved_by = draw(4) == 0 ? MovedBy(by::Base{}) : MovedBy(by::Tool{});
  }
  options.on_contact = draw(3) == 0 ? workcell::OnContact::kStop : workcell::OnContact::kSlide;
  options.force_class = static_cast<workcell::ForceClass>(draw(3));
  options.recording.emplace();
  return options;
}

void Day::runOneSession(Cell& cell, const SessionOptions& options, ShiftReport& report) {
  bool finite = true;
  const auto watch = [&finite](const manipulation::TraceRow& row) {
    finite = finite && std::isfinite(row.force_D.x + row.force_D.y + row.force_D.z) && row.X_DP.isValid() &&
             row.X_WM.isValid();
  };
  const Expected<SessionReport> session =
      server_port_ == 0 ? manipulation::runSession(options, watch)
                        : manipulation::runSessionOnServer(options, "127.0.0.1", server_port_, watch);
  if (!session) {
    report.broken.push_back("the session of '" + options.entity + "' did not run: " + session.error().message());
    return;
  }
  report.hand_s = session->duration_s;
  report.step_median_ms = session->delays.step_median_ms;
  report.step_p99_ms = session->delays.step_p99_ms;
  report.force_max_n = session->forces.force_max_n;
  report.force_step_n_per_ms = session->forces.force_max_step_n_per_ms;
  report.penetration_m = session->forces.penetration_blocked_m;
  report.energy_j = session->forces.energy_min_j;
  report.what = options.entity + " " + manipulation::wordOf(options.moved_by, false) + ", " +
                std::to_string(std::lround(options.configuration.manipulation.rate_hz)) + " Hz, class " +
                std::to_string(1 + static_cast<int>(*options.force_class));
  if (!finite) report.broken.push_back("a force or pose is no number");
  if (session->forces.force_max_n > device_.peak_force + kRounding)
    report.broken.push_back("the force is above the peak");
  if (server_port_ == 0 && session->forces.force_max_step_n_per_ms > kSlew + kRounding) {
    report.broken.push_back("the force changes by more than 1 N in a millisecond");
  }
  if (session->forces.penetration_blocked_m > kEntered) {
    report.broken.push_back("'" + options.entity + "' enters what blocks it by " +
                            std::to_string(1e3 * session->forces.penetration_blocked_m) + " mm");
  }
  keepIfWorst(cell, options, report);
  keepResult(cell, options, *session, report);
}

void Day::keepIfWorst(const Cell& cell, const SessionOptions& options, ShiftReport& report) {
  if (kept_.empty() || report.energy_j >= worst_energy_) return;
  worst_energy_ = report.energy_j;
  if (const auto kept = keepSession(cell.document, options, kept_); !kept)
    report.broken.push_back("the worst session is not kept: " + kept.error().message());
}

void Day::keepResult(Cell& cell, const SessionOptions& options, const SessionReport& session, ShiftReport& report) {
  const workcell::Entity* entity = cell.document.findByName(options.entity);
  if (!entity || !options.recording) return;
  const workcell::SetConfiguration moved{entity->id, session.end.configuration.X_WE, session.end.configuration.joints};
  if (const auto done = cell.document.execute(moved); !done) {
    report.broken.push_back("the document refuses where '" + options.entity + "' ended: " + done.error().message());
  }
  report.frames = session.recording.size();
  if (!session.recording.empty()) checkRecording(session.recording, report);
}

void Day::checkRecording(const trajectory::Trajectory& recording, ShiftReport& report) const {
  const std::filesystem::path file = folder_ / "recording.htraj";
  const std::string text = trajectory::toJsonText(recording);
  if (const auto written = workcell::writeFileAtomically(file.string(), text); !written) {
    report.broken.push_back("the recording is not written: " + written.error().message());
    return;
  }
  const auto read = trajectory::readTrajectory(file);
  if (!read) {
    report.broken.push_back("the recording is not read: " + read.error().message());
  } else if (trajectory::toJsonText(*read) != text) {
    report.broken.push_back("the recording is read back as another one");
  }
}

void Day::goThroughHistory(Cell& cell, std::size_t steps, ShiftReport& report) {
  Document& document = cell.document;
  const std::string before = textOf(document);
  std::size_t undone = 0;
  while (undone < steps && document.undo()) ++undone;
  for (std::size_t i = 0; i < undone; ++i) document.redo();
  if (textOf(document) != before) report.broken.push_back("undo and redo give another document");

  if (document.undoTexts().size() < kLongHistory) return;
  while (document.undo()) continue;
  document = Document(document.state());
}

void Day::saveAndRead(Cell& cell, ShiftReport& report) const {
  // A copy: the cell's own file is a shipped one.
  Document copy(cell.document.state());
  const std::filesystem::path file = folder_ / "kept.hcell";
  if (const auto saved = workcell::saveDocument(copy, file); !saved) {
    report.broken.push_back("the document is not saved: " + saved.error().message());
    return;
  }
  Diagnostics diagnostics;
  const auto read = workcell::loadDocument(file, diagnostics);
  if (!read) {
    report.broken.push_back("the document is not read: " + read.error().message());
  } else if (workcell::documentText(read->state(), folder_) != bytesOf(file)) {
    report.broken.push_back("the document is read back as another one");
  }
}

void Day::importAndRemove(Cell& cell, ShiftReport& report) {
  const std::filesystem::path file = folder_ / "given_back.step";
  Diagnostics diagnostics;
  workcell::DocumentState some = cell.document.state();
  std::erase_if(some.entities, [](const auto& entity) { return entity->kind() != workcell::EntityKind::kSolid; });
  if (const auto written = workcell::exportState(some, file, {}, diagnostics); !written) {
    report.broken.push_back("the cell is not exported: " + written.error().message());
    return;
  }
  workcell::EntityLoader loader(folder_);
  auto imported = loader.loadTree(file.string(), {}, diagnostics);
  if (!imported) {
    report.broken.push_back("the exported cell is not read: " + imported.error().message());
    return;
  }
  const std::string before = textOf(cell.document);
  const std::size_t count = cell.document.state().entities.size();
  const auto added = workcell::addImported(cell.document, std::move(imported->entities), Pose::identity());
  if (!added || cell.document.state().entities.size() <= count) {
    report.broken.push_back("what was imported is not added");
  } else if (!cell.document.undo() || textOf(cell.document) != before) {
    report.broken.push_back("undoing an import gives another document");
  }
  report.imported = true;
}

}  // namespace hapticell::endurance
