// SPDX-License-Identifier: Apache-2.0
// What the haptic panel says and what is heard, as plain functions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/virtual_desktop/devices/force_reason.h"
#include "app/virtual_desktop/devices/free_axes.h"
#include "app/virtual_desktop/devices/sound_synthesis.h"

namespace hapticell::app {
namespace {

constexpr double kRate = 48000.0;

std::vector<float> rendered(SoundSynthesis& synthesis, double seconds) {
  std::vector<float> samples(static_cast<std::size_t>(seconds * kRate));
  synthesis.render(samples.data(), samples.size());
  return samples;
}

/// How often the sound begins after a pause of 20 ms.
int onsets(const std::vector<float>& samples) {
  int count = 0, quiet = static_cast<int>(kRate);
  for (const float sample : samples) {
    if (std::abs(sample) > 0.003f) {
      if (quiet > 0.02 * kRate) ++count;
      quiet = 0;
    } else {
      ++quiet;
    }
  }
  return count;
}

float loudest(const std::vector<float>& samples) {
  return std::abs(
      *std::max_element(samples.begin(), samples.end(), [](float a, float b) { return std::abs(a) < std::abs(b); }));
}

TEST(ForceReason, NoForceAlwaysHasAReasonAndWhatMendsIt) {
  ForceFacts facts;
  EXPECT_EQ(forceReason(facts).fix, ForceReason::Fix::kConnect);
  facts.started = true;
  facts.problem = {Text("No haptic server answers at %1.", "127.0.0.1:4747")};
  EXPECT_EQ(forceReason(facts).fix, ForceReason::Fix::kStartServer);
  EXPECT_EQ(forceReason(facts).why, "No haptic server answers at 127.0.0.1:4747.");
  facts.connected = true;
  EXPECT_EQ(forceReason(facts).state, "Forces off");
  EXPECT_TRUE(forceReason(facts).why.contains("Ctrl+Space"));
  facts.wanted = true;
  EXPECT_EQ(forceReason(facts).state, "Forces pending");
  facts.on = true;
  facts.ramp = 0.43;
  EXPECT_EQ(forceReason(facts).why, "Ramp 43 %, 1 N/ms limit");
  facts.ramp = 1.0;
  EXPECT_EQ(forceReason(facts).why, "Ramp done, 1 N/ms limit");
  facts.stalled = true;
  EXPECT_TRUE(forceReason(facts).why.contains("not responding"));
}

TEST(ForceReason, ForcesThatCannotBeFeltSayWhyAndOfferTheRemedy) {
  ForceFacts facts;
  facts.started = facts.connected = facts.wanted = facts.on = true;
  facts.ramp = 1.0;
  facts.passes = true;
  EXPECT_EQ(forceReason(facts).fix, ForceReason::Fix::kSlide);
  facts.checked = false;
  EXPECT_EQ(forceReason(facts).fix, ForceReason::Fix::kCheck);
  facts.held = false;
  EXPECT_EQ(forceReason(facts).fix, ForceReason::Fix::kNone);
  EXPECT_TRUE(forceReason(facts).why.contains("Nothing is held"));
  facts.ramp = 0.5;
  EXPECT_EQ(forceReason(facts).why, "Ramp 50 %, 1 N/ms limit") << "the ramp comes first";
}

TEST(ForceReason, ForcesThatWentOffUnaskedAndTheDevicesEndAreSaid) {
  ForceFacts facts;
  facts.started = facts.connected = facts.wanted = facts.cut = true;
  EXPECT_EQ(forceReason(facts).state, "Forces off") << "not: they wait";
  EXPECT_TRUE(forceReason(facts).why.contains("Ctrl+Space"));
  facts.device_fault = true;
  EXPECT_TRUE(forceReason(facts).why.contains("not responding")) << "a known cause goes first";
  facts = {};
  facts.started = facts.connected = facts.wanted = facts.on = facts.at_edge = true;
  facts.ramp = 1.0;
  EXPECT_TRUE(forceReason(facts).why.contains("edge of its workspace"));
}

TEST(ForceReason, AProblemIsCutToItsFirstSentence) {
  ForceFacts facts;
  facts.started = true;
  facts.problem = {Text("No haptic server answers at %1.", "127.0.0.1:4747"), Text("Start hapticell-haptic-server.")};
  EXPECT_EQ(forceReason(facts).why, "No haptic server answers at 127.0.0.1:4747.");
}

TEST(FreeAxes, AKeyFreesMovingThenTurningThenAll) {
  FreeAxes axes;
  EXPECT_EQ(freeAxesText(axes), "X Y Z A B C");
  axes = afterKey(axes, 1);
  EXPECT_EQ(freeAxesText(axes), "Y");
  EXPECT_FALSE(axes.rotates());
  axes = afterKey(axes, 1);
  EXPECT_EQ(freeAxesText(axes), "B");
  EXPECT_FALSE(axes.translates());
  EXPECT_EQ(freeAxesText(afterKey(axes, 2)), "Z") << "another axis begins anew";
  EXPECT_EQ(afterKey(axes, 1), FreeAxes{});
  axes.turns = {false, false, false};
  EXPECT_EQ(freeAxesText(axes), "none");
}

TEST(ForceReason, ScaleIsSaidInMillimetres) {
  EXPECT_EQ(scaleNote(0.25), QString::fromUtf8("4 mm of hand → 1 mm in the cell"));
  EXPECT_EQ(scaleNote(4.0), QString::fromUtf8("1 mm of hand → 4 mm in the cell"));
  EXPECT_TRUE(scaleNote(0.0).isEmpty());
}

TEST(DeviceCheck, WithoutServerTheRestIsOpen) {
  const auto checks = deviceChecks("127.0.0.1:4747", {}, nullptr, {});
  ASSERT_GE(checks.size(), 2u);
  EXPECT_EQ(checks.front().result, DeviceCheck::Result::kProblem);
  EXPECT_EQ(checks.back().result, DeviceCheck::Result::kOpen);
}

TEST(DeviceCheck, ALateLoopIsAWarningWithTheMeansAgainstIt) {
  ForceFacts facts;
  facts.started = facts.connected = true;
  manipulation::SceneSnapshot now;
  now.server.rate_hz = 1000.0, now.server.late_p99_ms = 1.2, now.stylus.device_edge_m = 0.03;
  const auto checks = deviceChecks("127.0.0.1:4747", facts, nullptr, now);
  const auto late = std::find_if(checks.begin(), checks.end(),
                                 [](const auto& check) { return check.result == DeviceCheck::Result::kWarning; });
  ASSERT_NE(late, checks.end());
  EXPECT_TRUE(late->detail.contains("realtime"));
}

TEST(DeviceCheck, TellsHowSoonContactsAreSeen) {
  ForceFacts facts;
  facts.started = facts.connected = true;
  manipulation::SceneSnapshot now;
  TouchSight sight;
  const auto line = [&](const char* words) {
    for (const DeviceCheck& check : deviceChecks("far:4747", facts, nullptr, now, sight))
      if (check.title.contains(words)) return check;
    return DeviceCheck{};
  };
  EXPECT_EQ(line("No contact on the screen yet").result, DeviceCheck::Result::kOpen);
  sight = {{7, 0.030, 0.031, 0.062}, true, 0.020};
  EXPECT_EQ(line("displayed on time").result, DeviceCheck::Result::kGood);
  EXPECT_EQ(line("displayed on time").detail,
            "delay: median 31 ms, maximum 62 ms, contacts: 7; up to 50 ms is not noticeable");
  sight.software = false;  // A graphics card: 15 ms beyond the frame.
  sight.frame_s = 0.004;
  EXPECT_EQ(line("displayed late").result, DeviceCheck::Result::kWarning);
  EXPECT_TRUE(line("displayed late").detail.contains("19 ms is not noticeable"));
}

TEST(DeviceCheck, TellsTheClocksAndHowOldContactsAre) {
  ForceFacts facts;
  facts.started = facts.connected = true;
  manipulation::SceneSnapshot now;
  now.server.rate_hz = 1000.0, now.stylus.device_edge_m = 0.03;
  const auto line = [&](const char* words) {
    for (const DeviceCheck& check : deviceChecks("far:4747", facts, nullptr, now))
      if ((check.title + ' ' + check.detail).contains(words)) return check;
    return DeviceCheck{};
  };
  EXPECT_FALSE(line("round trip").detail.contains("clock")) << "not measured yet";
  EXPECT_EQ(line("No recent contacts").result, DeviceCheck::Result::kOpen);
  now.server.clock_offset_ms = -7.25e6;
  now.server.round_trip_ms = 41.5;
  EXPECT_EQ(line("round trip").detail, "far:4747, round trip 41.50 ms, clock offset 7250.000 s");
  now.server.set_age_p50_ms = 12.0, now.server.set_age_p99_ms = 31.5;
  now.server.late_sets = 3, now.server.refused_sets = 5;
  EXPECT_EQ(line("arrive on time").result, DeviceCheck::Result::kGood);
  EXPECT_EQ(line("arrive on time").detail,
            "age: median 12.0 ms, 99th percentile 31.5 ms; 3 late and 5 rejected since the server started");
  now.server.set_age_p99_ms = 140.0;
  EXPECT_EQ(line("sometimes late").result, DeviceCheck::Result::kWarning);
}

TEST(Sound, SilentWhileNothingIsNear) {
  SoundSynthesis synthesis(kRate);
  EXPECT_EQ(loudest(rendered(synthesis, 0.5)), 0.0f);
  EXPECT_TRUE(synthesis.isSilent());
}

TEST(Sound, TicksQuickenFromTwoToTwelveASecond) {
  for (const auto& [nearness, ticks] : {std::pair{0.0, 2}, std::pair{0.5, 7}, std::pair{1.0, 12}}) {
    SoundSynthesis synthesis(kRate);
    SoundCue cue;
    cue.near_miss = true, cue.nearness = nearness;
    synthesis.setCue(cue);
    EXPECT_NEAR(onsets(rendered(synthesis, 2.0)), 2 * ticks, 1) << nearness;
  }
}

TEST(Sound, ContactKnocksOnceAndLouderWhenQuicker) {
  const auto knock = [](double speed) {
    SoundSynthesis synthesis(kRate);
    SoundCue cue;
    cue.contact = true, cue.approach_speed = speed;
    synthesis.setCue(cue);
    auto samples = rendered(synthesis, 0.2);
    synthesis.setCue(cue);
    EXPECT_EQ(loudest(rendered(synthesis, 0.5)), 0.0f) << "a contact that lasts is quiet";
    return samples;
  };
  const auto soft = knock(0.01), hard = knock(0.5);
  EXPECT_EQ(onsets(soft), 1);
  EXPECT_GT(loudest(hard), 2.0f * loudest(soft));
  EXPECT_LE(loudest(hard), 1.0f);
}

TEST(Sound, ALimitKnocksTwice) {
  SoundSynthesis synthesis(kRate);
  SoundCue cue;
  cue.limit = true;
  synthesis.setCue(cue);
  EXPECT_EQ(onsets(rendered(synthesis, 0.5)), 2);
}

TEST(Sound, TheCueIsReadFromTwoSnapshots) {
  manipulation::SceneSnapshot before, now;
  manipulation::PairState pair;
  pair.distance = 0.008, pair.near_miss = true;
  before.pairs = {pair};
  before.time_s = 1.0;
  pair.distance = 0.005;
  now.pairs = {pair};
  now.time_s = 1.1;
  const SoundCue cue = soundCue(now, before);
  EXPECT_TRUE(cue.near_miss);
  EXPECT_FALSE(cue.contact);
  EXPECT_NEAR(cue.nearness, 0.5, 1e-12);
  EXPECT_NEAR(cue.approach_speed, 0.03, 1e-12);
  EXPECT_EQ(cue.sliding_speed, 0.0);
}

TEST(Sound, TicksAreOfThePairThatIsNearAndOfItsOwnDistance) {
  manipulation::SceneSnapshot before, now;
  now.stylus.held = before.stylus.held = 3;
  manipulation::PairState touching, near;
  touching.contact = touching.near_miss = true;
  near.distance = 0.03, near.near_miss = true, near.near_miss_distance = 0.04;
  before.pairs = now.pairs = {touching, near};
  before.time_s = 1.0, now.time_s = 1.1;
  now.stylus.X_WStylus.p = {0.0, 0.02, 0.0};
  const SoundCue cue = soundCue(now, before);
  EXPECT_TRUE(cue.contact);
  EXPECT_TRUE(cue.near_miss);
  EXPECT_NEAR(cue.nearness, 0.25, 1e-12);
  EXPECT_NEAR(cue.sliding_speed, 0.2, 1e-12);
  before.pairs = {near};
  EXPECT_EQ(soundCue(now, before).sliding_speed, 0.0) << "contact has only begun";
}

double loudness(const std::vector<float>& samples) {
  double sum = 0.0;
  for (const float s : samples) sum += static_cast<double>(s) * s;
  return std::sqrt(sum / static_cast<double>(samples.size()));
}

TEST(Sound, SlidingRustlesByItsSpeedAndEndsWithIt) {
  SoundSynthesis synthesis(kRate);
  SoundCue cue;
  cue.contact = true;
  synthesis.setCue(cue);
  rendered(synthesis, 0.5);  // The knock.
  cue.sliding_speed = 0.02;
  synthesis.setCue(cue);
  rendered(synthesis, 0.2);
  const double slow = loudness(rendered(synthesis, 0.5));
  cue.sliding_speed = 0.2;
  synthesis.setCue(cue);
  rendered(synthesis, 0.2);
  const auto fast = rendered(synthesis, 0.5);
  EXPECT_GT(slow, 0.0);
  EXPECT_GT(loudness(fast), 5.0 * slow);
  EXPECT_LT(loudest(fast), 0.1f) << "faint";
  cue.sliding_speed = 0.0;
  synthesis.setCue(cue);
  rendered(synthesis, 0.5);
  EXPECT_EQ(loudness(rendered(synthesis, 0.1)), 0.0);
  EXPECT_TRUE(synthesis.isSilent());
}

/// Hertz of what is heard between two times, by counting how often it crosses zero upwards.
double pitch(const std::vector<float>& samples, double from, double to) {
  int crossings = 0;
  for (auto i = static_cast<std::size_t>(from * kRate) + 1; i < static_cast<std::size_t>(to * kRate); ++i)
    crossings += samples[i - 1] < 0.0f && samples[i] >= 0.0f;
  return crossings / (to - from);
}

TEST(Sound, AFaultIsAFallingThirdOf300Milliseconds) {
  SoundSynthesis synthesis(kRate);
  synthesis.strike(SoundEvent::kFault);
  const auto samples = rendered(synthesis, 0.5);
  const double first = pitch(samples, 0.005, 0.105), second = pitch(samples, 0.185, 0.285);
  EXPECT_NEAR(first / second, 5.0 / 4.0, 0.04);
  EXPECT_EQ(loudness({samples.begin() + static_cast<int>(0.31 * kRate), samples.end()}), 0.0);
}

TEST(Sound, RecordingTicksHighAtItsStartAndLowAtItsEnd) {
  const auto tick = [](SoundEvent event) {
    SoundSynthesis synthesis(kRate);
    synthesis.strike(event);
    const auto samples = rendered(synthesis, 0.2);
    EXPECT_EQ(onsets(samples), 1);
    return pitch(samples, 0.0, 0.02);
  };
  EXPECT_GT(tick(SoundEvent::kRecordStart), 1.5 * tick(SoundEvent::kRecordStop));
}

TEST(Sound, AKnockIsWood) {
  SoundSynthesis synthesis(kRate);
  SoundCue cue;
  cue.contact = true, cue.approach_speed = 0.1;
  synthesis.setCue(cue);
  const auto samples = rendered(synthesis, 0.2);
  EXPECT_NEAR(pitch(samples, 0.0, 0.055), 180.0, 20.0);
  EXPECT_EQ(loudness({samples.begin() + static_cast<int>(0.065 * kRate), samples.end()}), 0.0) << "60 ms";
}

TEST(Sound, ATickIsOf1200HertzAndSoft) {
  SoundSynthesis synthesis(kRate);
  SoundCue cue;
  cue.near_miss = true;
  synthesis.setCue(cue);
  const auto samples = rendered(synthesis, 0.02);
  EXPECT_NEAR(pitch(samples, 0.0, 0.01), 1200.0, 110.0);
  EXPECT_LE(loudest(samples), 0.0632f) << "-24 dB";
}

}  // namespace
}  // namespace hapticell::app
