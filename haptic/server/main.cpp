// SPDX-License-Identifier: Apache-2.0
// hapticell-haptic-server: a force loop, its device and its network thread. docs/library/protocol.md tells what it
// speaks.
#include <signal.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "config/configuration.h"
#include "config/program_log.h"
#include "config/program_version.h"
#include "config/user_folders.h"
#include "geometry/system/plain_text.h"
#include "haptic/devices/device_choice.h"
#include "haptic/devices/device_recording.h"
#include "haptic/devices/simulated_device.h"
#include "haptic/server/configured_loop.h"
#include "haptic/server/fault_file.h"
#include "haptic/server/force_loop.h"
#include "haptic/server/loop_report.h"
#include "haptic/server/network_server.h"
#include "haptic/server/real_time_runner.h"
#include "haptic/server/server_options.h"

namespace hapticell::haptic {
namespace {

/// Bytes of a line of the log: a page of a sentence. Half: some paths are cut; twice: a driver can write twice as much.
constexpr std::size_t kLongestLine = 2000;

/// The key that this start is protected with; empty: none.
std::filesystem::path keyFile(const ServerOptions& asked) {
  if (!asked.key.empty()) return asked.key;
  std::error_code ignored;
  const bool this_machine = asked.listen == "localhost" || asked.listen == "::1" || asked.listen.starts_with("127.");
  return !this_machine && std::filesystem::exists(serverKeyFile(), ignored) ? serverKeyFile() : std::filesystem::path();
}

Expected<void> pair(const ServerOptions& asked) {
  const auto file = asked.key.empty() ? serverKeyFile() : std::filesystem::path(asked.key);
  const auto key = PairingKey::make();
  HAPTICELL_TRY(key);
  if (const auto saved = saveKey(*key, file); !saved) return saved;
  std::printf("%s\n", key->code().c_str());
  std::fprintf(
      stderr,
      "On the other station: hapticell-cli pair HOST, and type the code. Who has this code can take the stylus.\n"
      "Then start here: hapticell-haptic-server --listen ADDRESS\n");
  return {};
}

Expected<NetworkOptions> networkOptions(const ServerOptions& asked, const config::Configuration& configuration) {
  NetworkOptions options;
  options.address = asked.listen;
  options.port = asked.port.value_or(static_cast<std::uint16_t>(configuration.server.port));
  const auto file = keyFile(asked);
  if (!file.empty()) {
    const auto key = loadKey(file);
    HAPTICELL_TRY(key);
    options.key = *key;
  }
  options.state_rate_hz = asked.state_rate_hz;
  // A busy machine must not keep a lost client from being noticed.
  options.priority = asked.real_time ? 40 : 0;
  options.report = [](const std::string& sentence) { spdlog::info("{}", plainText(sentence, kLongestLine)); };
  return options;
}

/// s between two looks for a fault to be written: it ends 0.2 s after the fault. Half: twice as many wake-ups; twice:
/// the file comes later.
constexpr double kFaultPeriod = 0.25;

void writeFaults(ForceLoop& loop, FaultFiles& files) {
  if (!loop.faults().pending()) return;
  const FaultRecord record = loop.faults().copy();
  loop.faults().release();
  const auto written = files.write(record, RealClock().now());
  if (written && !*written) return;
  if (written)
    spdlog::warn("Fault ({}) at tick {}: the ticks around it are in {}; {} more faults have no file",
                 toString(record.kind), record.tick, plainText((*written)->string(), kLongestLine), files.leftOut());
  else
    spdlog::warn("Fault ({}) at tick {}: {}", toString(record.kind), record.tick, written.error().message());
}

/// Each line of what is printed, for the log file as well.
void logLines(config::ProgramLog* log, const std::string& text) {
  if (log == nullptr) return;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) log->write(config::LogLevel::kInfo, line);
}

void printReport(ForceLoop& loop, config::ProgramLog* log) {
  loop.updateReport();
  const std::string report = loopReport(loop.report());
  std::fputs(report.c_str(), stderr);
  logLines(log, report);
}

/// Waits for a signal to end, or for the time to be over; prints the figures at SIGUSR1.
void waitForTheEnd(ForceLoop& loop, const sigset_t& signals, double seconds, FaultFiles& faults,
                   const RecordingDevice* recording, config::ProgramLog* log) {
  const RealClock clock;
  const std::int64_t end = clock.now() + toNanoseconds(seconds);
  bool told = false;
  while (true) {
    writeFaults(loop, faults);
    if (const auto fault = recording != nullptr && !told ? recording->fault() : std::nullopt) {
      told = true;  // At once, not only when the session is over.
      spdlog::error("The recording is given up: {}", fault->message());
    }
    std::int64_t left = toNanoseconds(kFaultPeriod);
    if (seconds > 0.0) left = std::min(left, end - clock.now());
    if (left <= 0) return;
    const timespec wait{static_cast<time_t>(left / 1'000'000'000), static_cast<long>(left % 1'000'000'000)};
    const int signal = sigtimedwait(&signals, nullptr, &wait);
    if (signal == SIGINT || signal == SIGTERM) return;
    if (signal == SIGUSR1) printReport(loop, log);
  }
}

sigset_t blockSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) sigaddset(&signals, signal);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // Inherited by every thread that is started later.
  signal(SIGPIPE, SIG_IGN);
  return signals;
}

Expected<void> serve(const ServerOptions& asked, config::ProgramLog* log) {
  const auto configuration = config::loadConfiguration(asked.config);
  HAPTICELL_TRY(configuration);
  auto options = networkOptions(asked, *configuration);
  HAPTICELL_TRY(options);
  auto made = makeDevice(asked.device.value_or(configuration->haptic.device), *configuration,
                         [](const std::string& sentence) { spdlog::warn("{}", plainText(sentence, kLongestLine)); });
  HAPTICELL_TRY(made);
  RecordingDevice* recording = nullptr;
  if (!asked.record.empty()) {
    auto recorded = std::make_unique<RecordingDevice>(std::move(*made), asked.record);
    recording = recorded.get();
    made = std::move(recorded);
  }
  Device& device = **made;
  if (SimulatedDevice* const simulated = device.simulated()) {
    simulated->hand().setOptions(configuredHand(*configuration));
  }
  HAPTICELL_TRY(device.open());

  const sigset_t signals = blockSignals();
  const RealClock clock;
  ForceLoop loop(device, clock, configuredLoop(device, *configuration));
  RealTimeRunner runner(loop, {.fifo = asked.real_time, .lock_memory = asked.real_time});
  options->care = device.care();
  auto network = NetworkServer::start(loop, clock, describe(device), *options);
  HAPTICELL_TRY(network);
  runner.start();
  for (const Text& warning : runner.warnings()) spdlog::warn("{}", english(warning));
  const std::string listening =
      fmt::format("hapticell-haptic-server listens on {}:{}: {} at {:g} Hz.", (*network)->address(), (*network)->port(),
                  device.capabilities().name, configuration->haptic.rate_hz);
  std::puts(listening.c_str());
  std::fflush(stdout);
  logLines(log, listening);
  FaultFiles faults(asked.fault_log.empty() ? config::userStateFolder()
                                            : Expected<std::filesystem::path>(asked.fault_log));
  waitForTheEnd(loop, signals, asked.seconds, faults, recording, log);

  runner.stop();  // Force zero before anything else ends.
  network->reset();
  printReport(loop, log);
  return recording != nullptr ? recording->finish() : Expected<void>();
}

/// The server's own lines go to standard error and to the log file; null: only to the former.
std::unique_ptr<config::ProgramLog> startLog(config::LogLevel level, const std::string& version) {
  constexpr std::array kLevels{spdlog::level::err, spdlog::level::warn, spdlog::level::info, spdlog::level::debug};
  spdlog::set_level(kLevels[static_cast<std::size_t>(level)]);
  auto log = config::ProgramLog::open("hapticell-haptic-server", level);
  if (!log) {
    spdlog::warn("{}", plainText("There is no log file: " + log.error().message(), kLongestLine));
    return nullptr;
  }
  spdlog::default_logger()->sinks().push_back((*log)->sink());
  spdlog::flush_on(spdlog::level::trace);
  logLines(log->get(), version);
  return std::move(*log);
}

Expected<void> start(const ServerOptions& asked, const std::string& version) {
  if (asked.pair) return pair(asked);
  const auto log = startLog(asked.log_level, version);
  auto served = serve(asked, log.get());
  if (log && !served) log->write(config::LogLevel::kError, served.error().message());
  if (log) log->write(config::LogLevel::kInfo, "hapticell-haptic-server ends");
  return served;
}

int run(int count, char** words) {
  const std::vector<std::string_view> given(words + 1, words + count);
  const auto options = parseServerOptions(given);
  if (options && options->help) {
    std::fputs(std::string(serverUsage()).c_str(), stdout);
    return 0;
  }
  const std::string spdlog_version = std::to_string(SPDLOG_VER_MAJOR) + "." + std::to_string(SPDLOG_VER_MINOR) + "." +
                                     std::to_string(SPDLOG_VER_PATCH);
  const std::string version = config::versionText("hapticell-haptic-server", {{"spdlog", spdlog_version}});
  if (options && options->version) {
    std::puts(version.c_str());
    return 0;
  }
  const auto served = options.and_then([&version](const auto& asked) { return start(asked, version); });
  if (served) return 0;
  std::fprintf(stderr, "hapticell-haptic-server: %s\n", served.error().message().c_str());
  return 2;
}

}  // namespace
}  // namespace hapticell::haptic

int main(int count, char** words) {
  hapticell::config::cleanEnvironment();
  try {
    spdlog::set_default_logger(spdlog::stderr_logger_mt("server"));
    spdlog::set_pattern("%H:%M:%S.%e %l: %v");
    return hapticell::haptic::run(count, words);
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "hapticell-haptic-server: %s\n", failure.what());
    return 2;
  }
}
