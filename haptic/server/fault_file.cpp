// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/fault_file.h"

#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>

#include "geometry/atomic_file.h"

namespace hapticell::haptic {

namespace fs = std::filesystem;

fs::path defaultFaultFolder() {
  if (const char* state = std::getenv("XDG_STATE_HOME"); state != nullptr && *state != '\0') {
    return fs::path(state) / "hapticell";
  }
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') {
    return fs::path(home) / ".local" / "state" / "hapticell";
  }
  return fs::path(".");
}

Expected<fs::path> writeFault(const FaultRecord& record, const fs::path& folder) {
  std::error_code problem;
  fs::create_directories(folder, problem);
  const fs::path path = folder / ("fault-" + std::to_string(record.tick) + ".csv");
  std::ostringstream file;
  file << "# fault: " << toString(record.kind) << " at tick " << record.tick << "\n"
       << "tick,stamp_ns,x,y,z,qw,qx,qy,qz,proxy_x,proxy_y,proxy_z,wanted_x,wanted_y,wanted_z,fx,fy,fz,"
          "rows,set,skipped,buttons,forces_on\n";
  for (const FaultSample& s : record.samples) {
    char line[512];
    std::snprintf(line, sizeof line,
                  "%llu,%lld,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%u,%llu,"
                  "%u,%u,%d\n",
                  static_cast<unsigned long long>(s.tick), static_cast<long long>(s.stamp_ns), s.X_DS.p.x, s.X_DS.p.y,
                  s.X_DS.p.z, s.X_DS.q.w, s.X_DS.q.x, s.X_DS.q.y, s.X_DS.q.z, s.X_DP.p.x, s.X_DP.p.y, s.X_DP.p.z,
                  s.wanted_D.x, s.wanted_D.y, s.wanted_D.z, s.commanded_D.x, s.commanded_D.y, s.commanded_D.z, s.rows,
                  static_cast<unsigned long long>(s.adopted_set), s.skipped, s.buttons, s.forces_on ? 1 : 0);
    file << line;
  }
  if (auto written = writeFileAtomically(path, file.str()); !written) return makeError(written.error());
  return path;
}

}  // namespace hapticell::haptic
