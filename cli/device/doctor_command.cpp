// SPDX-License-Identifier: Apache-2.0
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "cli/device/device_commands.h"
#include "cli/device/device_list.h"
#include "cli/device/health_check.h"
#include "config/program_version.h"
#include "workcell/text/file_content.h"

namespace hapticell::cli {

namespace {

using nlohmann::ordered_json;

const char* wordOf(Health health) {
  switch (health) {
    case Health::kGood:
      return "ok";
    case Health::kNote:
      return "note";
    case Health::kProblem:
      break;
  }
  return "problem";
}

/// "Debian GNU/Linux 12 (bookworm)"; empty where the system does not say.
std::string systemName() {
  const auto text = workcell::readFileContent("/etc/os-release");
  constexpr std::string_view kKey = "PRETTY_NAME=\"";
  const std::size_t at = text ? text->find(kKey) : std::string::npos;
  if (at == std::string::npos) return {};
  const std::size_t from = at + kKey.size();
  return text->substr(from, text->find('"', from) - from);
}

std::string machine() {
  utsname system{};
  uname(&system);
  return std::string(system.sysname) + " " + system.release + " " + system.machine;
}

std::vector<HealthCheck> allChecks(const config::Configuration& configuration) {
  // Drivers are asked in processes of their own, before this one has threads.
  std::vector<DriverEntries> drivers;
  for (const haptic::LoadedDriver& loaded : haptic::loadDrivers(haptic::driverFolders(), configuration.drivers))
    drivers.push_back(entriesAskedApart(loaded));
  std::vector<HealthCheck> checks = graphicsChecks();
  const auto add = [&checks](const std::vector<HealthCheck>& more) {
    checks.insert(checks.end(), more.begin(), more.end());
  };
  add(grantChecks());
  add(deviceChecks(drivers));
  add(programChecks());
  add({portCheck(configuration)});
  add(diskChecks());
  return checks;
}

ordered_json healthJson(const std::vector<HealthCheck>& checks, bool well) {
  ordered_json list = ordered_json::array();
  for (const HealthCheck& check : checks)
    list.push_back({{"name", check.what},
                    {"ok", check.health != Health::kProblem},
                    {"state", wordOf(check.health)},
                    {"found", check.found},
                    {"fix", check.fix.empty() ? ordered_json(nullptr) : ordered_json(check.fix)}});
  return {{"hapticell", HAPTICELL_VERSION},
          {"commit", std::string(config::builtCommit())},
          {"system", systemName()},
          {"kernel", machine()},
          {"well", well},
          {"checks", std::move(list)}};
}

void print(std::FILE* to, const std::vector<HealthCheck>& checks) {
  std::fprintf(to, "HaptiCell %s, commit %s\n%s, %s\n\n", HAPTICELL_VERSION, std::string(config::builtCommit()).c_str(),
              systemName().c_str(), machine().c_str());
  std::size_t width = 0;
  for (const HealthCheck& check : checks) width = std::max(width, check.what.size());
  for (const HealthCheck& check : checks) {
    std::fprintf(to, "%-8s %-*s  %s\n", wordOf(check.health), static_cast<int>(width), check.what.c_str(),
                check.found.c_str());
    if (!check.fix.empty()) std::fprintf(to, "%-8s %-*s  fix: %s\n", "", static_cast<int>(width), "", check.fix.c_str());
  }
  const auto problems = std::count_if(checks.begin(), checks.end(),
                                      [](const HealthCheck& check) { return check.health == Health::kProblem; });
  if (problems == 0)
    std::fputs("\nNo problems found.\n", to);
  else
    std::fprintf(to, "\nProblems to fix: %d\n", static_cast<int>(problems));
}

ExitStatus run(const std::string& file, const ResultWriter& writer) {
  const auto configuration = config::loadConfiguration(file);
  if (!configuration) {
    report(configuration.error());
    return ExitStatus::kBadInput;
  }
  const std::vector<HealthCheck> checks = allChecks(*configuration);
  const bool well = std::none_of(checks.begin(), checks.end(),
                                 [](const HealthCheck& check) { return check.health == Health::kProblem; });
  // People read text on a terminal; programs read JSON. A report that goes to a file shows the text beside it.
  const bool people = !writer.isAsked() && ::isatty(STDOUT_FILENO) != 0;
  if (!writer.isAsked()) print(people ? stdout : stderr, checks);
  const auto written = people ? Expected<void>() : writer.write(healthJson(checks, well));
  if (!written) {
    report(written.error());
    return ExitStatus::kBadInput;
  }
  return well ? ExitStatus::kDone : ExitStatus::kCheckFound;
}

}  // namespace

void addDoctorCommand(Subcommand app, Action& chosen) {
  Subcommand command = app.add(
      "doctor",
      "Check graphics, real-time permissions, devices, udev rules, ports and disk, and say how to fix problems");
  const auto file = std::make_shared<std::string>();
  command.option("--config", *file, "hapticell.toml whose values override the shipped ones").takes(ValueKind::kToml);
  command.onChosen([file, &chosen] { chosen = [file](ResultWriter& writer) { return run(*file, writer); }; });
}

}  // namespace hapticell::cli
