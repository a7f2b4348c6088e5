// SPDX-License-Identifier: Apache-2.0
#include "haptic/protocol/codec.h"

#include <gtest/gtest.h>
#include <regex>
#include <string>
#include <set>
#include <memory>
#include <fstream>

#include <rapidcheck/gtest.h>
#include <limits>
#include <random>

#include "haptic/protocol/wire_fields.h"
#include "tests/haptic/protocol/any_message.h"
#include "tests/haptic/protocol/same_message.h"
#include "tests/support/test_data.h"

namespace hapticell::haptic {
namespace {

std::vector<std::uint8_t> frameOf(const Message& message) {
  Encoder encoder;
  const auto frame = encoder.encode(message);
  return {frame.begin(), frame.end()};
}

Expected<Message> decodeFrame(std::span<const std::uint8_t> frame) {
  Message message;
  const auto decoded = decode(frame.subspan(kFrameHeaderBytes), message);
  HAPTICELL_TRY(decoded);
  return message;
}

ConstraintSet fullSet() {
  ConstraintSet set;
  set.sequence = 7;
  set.count = kMaxConstraints;
  for (std::size_t i = 0; i < set.count; ++i) {
    set.constraints[i].gradient[i % 6] = 1.0;
    set.constraints[i].curvature[i % 21] = 2.0;
    set.constraints[i].has_trim = true;
  }
  return set;
}

RC_GTEST_PROP(Codec, EveryFieldOfEveryMessageComesBack, ()) {
  const Message sent = any::message();
  const auto received = decodeFrame(frameOf(sent));
  RC_ASSERT(received.has_value());
  RC_ASSERT(same(*received, sent));
}

TEST(Codec, TheFrameBeginsWithItsLittleEndianLength) {
  const auto frame = frameOf(Refusal{"no"});
  const std::size_t length = frame[0] | frame[1] << 8 | frame[2] << 16 | static_cast<std::size_t>(frame[3]) << 24;
  EXPECT_EQ(length, frame.size() - kFrameHeaderBytes);
  EXPECT_EQ(std::string(frame.begin() + 8, frame.begin() + 12), "HCEL");
}

TEST(Codec, AFullSetFitsTheLimitAndAStateIsSmall) {
  EXPECT_LT(frameOf(fullSet()).size(), kMaxFrameBytes / 2);
  EXPECT_LT(frameOf(HapticState{}).size(), 400u);
}

TEST(Codec, ABufferAtAnOddAddressReadsTheSame) {
  const auto frame = frameOf(fullSet());
  for (std::size_t shift = 0; shift < 8; ++shift) {
    std::vector<std::uint8_t> moved(shift);
    moved.insert(moved.end(), frame.begin(), frame.end());
    const auto received = decodeFrame(std::span<const std::uint8_t>(moved).subspan(shift));
    ASSERT_TRUE(received.has_value()) << shift;
    EXPECT_TRUE(same(*received, fullSet()));
  }
}

TEST(Codec, ALongTextIsCut) {
  const auto received = decodeFrame(frameOf(Refusal{std::string(5000, 'x')}));
  ASSERT_TRUE(received.has_value());
  EXPECT_EQ(std::get<Refusal>(*received).sentence, std::string(kMaxTextBytes, 'x'));
}

TEST(Codec, DecodingASetAfterALargerOneLeavesNothingOfIt) {
  Message message;
  const auto large = frameOf(fullSet());
  ConstraintSet one = fullSet();
  one.count = 1;
  one.constraints[0].curvature = {};
  one.constraints[0].has_trim = false;
  const auto small = frameOf(one);
  ASSERT_TRUE(decode(std::span(large).subspan(kFrameHeaderBytes), message));
  ASSERT_TRUE(decode(std::span(small).subspan(kFrameHeaderBytes), message));
  EXPECT_TRUE(same(message, one));
}

TEST(Codec, NumbersThatAreNoneAreRefusedInWords) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const auto refused = [](const Message& message) {
    const auto received = decodeFrame(frameOf(message));
    return !received.has_value() && !received.error().message().empty();
  };
  for (const double bad : {nan, infinite, -infinite}) {
    ConstraintSet set = fullSet();
    set.constraints[63].gap = bad;
    EXPECT_TRUE(refused(set));
    set = fullSet();
    set.constraints[5].curvature[20] = bad;
    EXPECT_TRUE(refused(set));
    set = fullSet();
    set.constraints[5].trim_gradient[5] = bad;
    EXPECT_TRUE(refused(set));
    set = fullSet();
    set.zone_radius = bad;
    EXPECT_TRUE(refused(set));
    set = fullSet();
    set.X_DR.p.y = bad;
    EXPECT_TRUE(refused(set));
    EXPECT_TRUE(refused(HapticControl{true, bad, 0.0}));
    EXPECT_TRUE(refused(HapticControl{true, 0.0, bad}));
    EXPECT_TRUE(refused(HandTarget{true, Pose::translation(dvec3(0.0, bad, 0.0)), 0}));
    HapticState state;
    state.force_D.z = bad;
    EXPECT_TRUE(refused(state));
    Welcome welcome;
    welcome.device.peak_force = bad;
    EXPECT_TRUE(refused(welcome));
    welcome = {};
    welcome.tick_rate_hz = bad;
    EXPECT_TRUE(refused(welcome));
  }
  HandTarget not_a_rotation;
  not_a_rotation.X_DH.q = dquat(0.0, 0.0, 0.0, 0.0);
  EXPECT_TRUE(refused(not_a_rotation));
  EXPECT_TRUE(refused(HapticControl{true, -1.0, 0.0}));
  ConstraintSet no_zone;
  no_zone.zone_radius = 0.0;
  EXPECT_TRUE(refused(no_zone));
}

/// Finite numbers that nothing in a workcell and no hand has: each field just beyond its bound, one at a time.
TEST(Codec, EveryNumberHasABound) {
  std::vector<Message> beyond;
  const auto set = [&](auto&& change) {
    ConstraintSet wrong = fullSet();
    change(wrong, wrong.constraints[7]);
    beyond.emplace_back(wrong);
  };
  for (const double most : {1.0001, 1e6, 1e100, 1e300}) {
    set([&](auto&, Constraint& c) { c.gap = -most * bound::kLength; });
    set([&](auto&, Constraint& c) { c.trim_gap = most * bound::kLength; });
    set([&](auto&, Constraint& c) { c.gradient[5] = -most * bound::kSlope; });
    set([&](auto&, Constraint& c) { c.trim_gradient[0] = most * bound::kSlope; });
    set([&](auto&, Constraint& c) { c.curvature[20] = -most * bound::kCurvature; });
    set([&](auto&, Constraint& c) { c.stiffness = most * bound::kStiffness; });
    set([&](auto&, Constraint& c) { c.damping = most * bound::kDamping; });
    set([&](auto&, Constraint& c) { c.friction = most * bound::kFriction; });
    set([&](auto&, Constraint& c) { c.reach = most * bound::kLength; });
    set([&](auto&, Constraint& c) { c.velocity_D.y = -most * bound::kSpeed; });
    set([&](ConstraintSet& s, auto&) { s.X_DR.p.z = most * bound::kLength; });
    set([&](ConstraintSet& s, auto&) { s.zone_radius = most * bound::kLength; });
    set([&](ConstraintSet& s, auto&) { s.zone_radius = bound::kLeastZone / most; });
    beyond.emplace_back(HapticControl{.forces_enabled = true, .stiffness = most * bound::kStiffness});
    beyond.emplace_back(HapticControl{.forces_enabled = true, .damping = most * bound::kDamping});
    beyond.emplace_back(HapticControl{.load = {.mass = most * bound::kForce}});
    beyond.emplace_back(HapticControl{.load = {.damping = most * bound::kDamping}});
    beyond.emplace_back(HapticControl{.load = {.friction = most * bound::kForce}});
    beyond.emplace_back(HapticControl{.load = {.weight_D = dvec3(0.0, -most * bound::kForce, 0.0)}});
    beyond.emplace_back(HandTarget{true, Pose::translation({-most * bound::kLength, 0.0, 0.0}), 0});
    HapticState state;
    state.force_D.x = most * bound::kForce;
    beyond.emplace_back(state);
    state = {};
    state.v_DS.x = -most * bound::kSpeed;
    beyond.emplace_back(state);
    Welcome welcome;
    welcome.device.peak_force = most * bound::kForce;
    beyond.emplace_back(welcome);
  }
  for (std::size_t i = 0; i < beyond.size(); ++i) {
    const auto received = decodeFrame(frameOf(beyond[i]));
    ASSERT_FALSE(received.has_value()) << i;
    EXPECT_FALSE(received.error().message().empty());
  }
  EXPECT_TRUE(decodeFrame(frameOf(fullSet())).has_value());
}

TEST(Codec, EveryTruncationIsRefused) {
  for (const Message& message : {Message(fullSet()), Message(Hello{}), Message(Welcome{}), Message(HapticState{})}) {
    const auto frame = frameOf(message);
    const std::size_t whole = frame.size() - kFrameHeaderBytes;
    for (std::size_t length = 0; length < whole; length += 1 + length / 64) {
      Message received;
      const bool read =
          decode(std::span<const std::uint8_t>(frame).subspan(kFrameHeaderBytes, length), received).has_value();
      // A FlatBuffer may end in padding, of which nothing is read.
      EXPECT_TRUE(!read || (whole - length < 8 && same(received, message))) << length << " of " << whole;
    }
  }
}

/// Whatever the bytes, decode() returns; and what it accepts keeps the rules.
void expectHarmless(std::span<const std::uint8_t> flatbuffer) {
  Message message;
  if (!decode(flatbuffer, message)) return;
  const bool well_formed = std::visit(
      [](const auto& value) {
        if constexpr (requires { isWellFormed(value); }) return isWellFormed(value);
        return true;
      },
      message);
  EXPECT_TRUE(well_formed);
}

TEST(Codec, MutatedFramesDoNoHarm) {
  std::mt19937_64 random(20261121);
  const std::vector<std::vector<std::uint8_t>> seeds = {frameOf(fullSet()),          frameOf(Hello{.program = "seed"}),
                                                        frameOf(Welcome{}),          frameOf(HapticState{}),
                                                        frameOf(ServerStatistics{}), frameOf(HandTarget{}),
                                                        frameOf(Heartbeat{1, 2, 3})};
  for (int round = 0; round < 40'000; ++round) {
    auto bytes = seeds[random() % seeds.size()];
    const std::size_t changes = 1 + random() % 8;
    for (std::size_t i = 0; i < changes; ++i) {
      const std::size_t place = kFrameHeaderBytes + random() % (bytes.size() - kFrameHeaderBytes);
      // Offsets sit at the front of a FlatBuffer: change there more often than elsewhere.
      const std::size_t front = kFrameHeaderBytes + random() % 64;
      bytes[random() % 2 ? place : std::min(front, bytes.size() - 1)] = static_cast<std::uint8_t>(random());
    }
    if (random() % 4 == 0) bytes.resize(kFrameHeaderBytes + random() % (bytes.size() - kFrameHeaderBytes));
    expectHarmless(std::span<const std::uint8_t>(bytes).subspan(kFrameHeaderBytes));
  }
}

RC_GTEST_PROP(Codec, AnyBytesDoNoHarm, (const std::vector<std::uint8_t>& bytes)) {
  expectHarmless(bytes);
}

TEST(Codec, MoreConstraintsThanASetHoldsAreRefused) {
  // The count of the constraints' vector, made larger in place: the verifier must see that the buffer ends before.
  auto frame = frameOf(fullSet());
  std::size_t changed = 0;
  for (std::size_t i = kFrameHeaderBytes; i + 4 <= frame.size(); i += 4) {
    if (frame[i] != kMaxConstraints || frame[i + 1] != 0 || frame[i + 2] != 0 || frame[i + 3] != 0) continue;
    auto mutated = frame;
    mutated[i] = kMaxConstraints + 1;
    Message received;
    if (!decode(std::span<const std::uint8_t>(mutated).subspan(kFrameHeaderBytes), received)) ++changed;
  }
  EXPECT_GE(changed, 1u);
}

TEST(FrameReader, CutsAStreamThatComesInAnyPieces) {
  std::vector<std::uint8_t> stream;
  std::vector<std::vector<std::uint8_t>> frames;
  for (int i = 0; i < 20; ++i) {
    frames.push_back(frameOf(Refusal{std::string(static_cast<std::size_t>(i * 13), 'a')}));
    stream.insert(stream.end(), frames.back().begin(), frames.back().end());
  }
  for (std::size_t piece : {1u, 2u, 3u, 7u, 64u, 1000u, 100000u}) {
    FrameReader reader;
    std::size_t seen = 0;
    for (std::size_t begin = 0; begin < stream.size(); begin += piece) {
      reader.append(std::span<const std::uint8_t>(stream).subspan(begin, std::min(piece, stream.size() - begin)));
      for (auto frame = reader.next(); frame && !frame->empty(); frame = reader.next()) {
        ASSERT_LT(seen, frames.size());
        EXPECT_TRUE(
            std::equal(frame->begin(), frame->end(), frames[seen].begin() + kFrameHeaderBytes, frames[seen].end()));
        ++seen;
      }
    }
    EXPECT_EQ(seen, frames.size()) << "pieces of " << piece;
    EXPECT_EQ(reader.pending(), 0u);
  }
}

TEST(FrameReader, ALengthThatCannotBeIsAnErrorAndStaysOne) {
  for (const std::uint32_t length : {std::uint32_t{0}, std::uint32_t{kMaxFrameBytes + 1}, 0xffffffffu, 0x20544547u}) {
    FrameReader reader;
    std::array<std::uint8_t, 4> header;
    for (std::size_t i = 0; i < 4; ++i) header[i] = static_cast<std::uint8_t>(length >> (8 * i));
    reader.append(header);
    ASSERT_FALSE(reader.next()) << length;
    EXPECT_NE(reader.next().error().message().find("frame length"), std::string::npos);
    reader.append(header);
    EXPECT_FALSE(reader.next());
  }
}

/// The fields that a list of wire_fields.h names.
struct FieldNames {
  std::set<std::string> all;
  std::size_t calls = 0;
  void add(const auto& field) {
    ++calls;
    all.insert(field.name);
  }
  void operator()(auto&, const auto& field) { add(field); }
  void required(auto&, const auto& field) { add(field); }
  void text(auto&, const auto& field) { add(field); }
  void texts(auto&, const auto& field) { add(field); }
  void table(auto&, const auto& field) { add(field); }
  void tables(auto&, auto&, const auto& field) { add(field); }
  void trim(auto&, const auto& field) { add(field); }
  void known(auto&, const auto& is_known, const auto& field) {
    add(is_known);
    add(field);
  }
};

/// The fields of a table by the schema's text: "State.tick".
std::set<std::string> fieldsOfSchema(const std::string& table) {
  std::ifstream file(test::sourceFile("haptic/protocol/hapticell.fbs"));
  std::string text;
  for (std::string line; std::getline(file, line);) text += line.substr(0, line.find("//")) + " ";
  std::set<std::string> names;
  std::smatch body;
  if (!std::regex_search(text, body, std::regex("table " + table + "\\s*\\{([^}]*)\\}"))) return names;
  const std::string fields = body[1];
  const std::regex field("(\\w+)\\s*:");
  for (std::sregex_iterator at(fields.begin(), fields.end(), field), end; at != end; ++at) {
    std::string name = table;
    names.insert(name.append(".").append((*at)[1].str()));
  }
  return names;
}

template <typename Message>
void expectAllFields(const std::string& table) {
  FieldNames names;
  auto message = std::make_unique<Message>();
  wireFields(names, *message);
  const std::set<std::string> schema = fieldsOfSchema(table);
  EXPECT_FALSE(schema.empty()) << table;
  EXPECT_EQ(names.all, schema) << table;
  EXPECT_EQ(names.calls, schema.size()) << "none twice in " << table;
}

TEST(WireFields, EachListNamesEveryFieldOfItsTableOnce) {
  expectAllFields<Hello>("Hello");
  expectAllFields<DeviceDescription>("Device");
  expectAllFields<Welcome>("Welcome");
  expectAllFields<Refusal>("Refusal");
  expectAllFields<Constraint>("Constraint");
  expectAllFields<ConstraintSet>("ConstraintSet");
  expectAllFields<HapticState>("State");
  expectAllFields<ServerStatistics>("Statistics");
  expectAllFields<HapticControl>("Control");
  expectAllFields<HandTarget>("HandTarget");
  expectAllFields<Heartbeat>("Heartbeat");
  expectAllFields<DeviceCondition>("DeviceCondition");
  expectAllFields<Calibrate>("Calibrate");
}

}  // namespace
}  // namespace hapticell::haptic
