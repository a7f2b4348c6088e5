// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "config/configuration.h"
#include "config/device_profile.h"
#include "manipulation/session/session.h"
#include "workcell/document/document.h"

namespace hapticell::endurance {

/// What one shift showed.
struct ShiftReport {
  std::string what;     ///< Who was moved, how, at which rate of the loop.
  double hand_s = 0.0;  ///< Time of the hand, virtual or real.
  double step_median_ms = 0.0, step_p99_ms = 0.0;
  double force_max_n = 0.0, force_step_n_per_ms = 0.0;
  double penetration_m = 0.0;  ///< Of pairs that must not pass through each other.
  double energy_j = 0.0;       ///< The worst second; taps of more than 0.25 m/s are among them.
  std::uint64_t frames = 0;    ///< Recorded.
  bool imported = false;
  bool left_out = false;            ///< Drawn, not run.
  std::vector<std::string> broken;  ///< A sentence for each invariant that did not hold; empty when all did.
};

/// The day of a user in small pieces, drawn by lot: a shift takes something of one of three cells (robot, solid, door,
/// mannequin) and moves it with a random hand while it is recorded, puts the result into the document, undoes and does
/// again, saves and reads back, imports now and then a STEP file of its own making. The documents, with their
/// history, and all caches live as long as this object.
///
/// Invariants, each tick or at the end of each shift: forces finite, within the device's peak and slew; nothing blocked
/// is entered; undo gives the text back to the byte; saving and reading give it too; a recording is read back as it
/// was.
class Day {
 public:
  /// Files go to `folder`, which must be there. `server_port` 0: virtual time; else the sessions go in real time
  /// through the server there. Errors: a shipped file that is not there.
  static Expected<Day> begin(std::uint64_t seed, const std::filesystem::path& folder, int server_port = 0);

  /// Sessions in other cells than this one ("workbench") are drawn but left out: those that remain are the same.
  void workOnlyIn(std::string cell) { only_ = std::move(cell); }
  /// The session of the worst energy yet is kept in `folder` (kept_session.h).
  void keepWorst(std::filesystem::path folder) { kept_ = std::move(folder); }

  ShiftReport work(double hand_seconds);

 private:
  struct Cell {
    std::string name;
    workcell::Document document;
    std::vector<std::string> movable;
  };

  manipulation::SessionOptions drawOptions(Cell& cell, double hand_seconds);
  void runOneSession(Cell& cell, const manipulation::SessionOptions& options, ShiftReport& report);
  void keepResult(Cell& cell, const manipulation::SessionOptions& options, const manipulation::SessionReport& session,
                  ShiftReport& report);
  void checkRecording(const trajectory::Trajectory& recording, ShiftReport& report) const;
  void keepIfWorst(const Cell& cell, const manipulation::SessionOptions& options, ShiftReport& report);
  void goThroughHistory(Cell& cell, std::size_t steps, ShiftReport& report);
  void saveAndRead(Cell& cell, ShiftReport& report) const;
  void importAndRemove(Cell& cell, ShiftReport& report);

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  std::size_t draw(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }

  std::mt19937_64 random_;
  std::filesystem::path folder_;
  int server_port_ = 0;
  std::uint64_t shifts_ = 0;
  std::string only_;
  std::filesystem::path kept_;
  double worst_energy_ = 0.0;
  config::Configuration configuration_;
  config::DeviceProfile device_;
  std::vector<Cell> cells_;
};

}  // namespace hapticell::endurance
