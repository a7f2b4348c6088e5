// SPDX-License-Identifier: Apache-2.0
#include "workcell/entity/built_in_parts.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/shapes/shapes.h"
#include "geometry/system/plain_number.h"
#include "workcell/text/text_cursor.h"

namespace hapticell::workcell {
namespace {

using geometry::TriangleMesh;
using Sizes = std::span<const double>;
using Origin = BuiltInPart::Origin;

/// m: a limit of sizes in sources, beyond kFarthest of a cell. Half, twice: no effect, what does not fit in a cell is
/// refused there.
constexpr double kGreatest = 1e6;

/// Adds a box between two corners.
void addBox(TriangleMesh& mesh, const dvec3& least, const dvec3& most) {
  geometry::append(mesh, geometry::makeBox(most - least), Pose::translation(0.5 * (least + most)));
}

/// Adds a cylinder about a vertical line, from z0 to z1.
void addPost(TriangleMesh& mesh, const glm::dvec2& middle, double radius, double z0, double z1) {
  geometry::append(mesh, geometry::makeCylinder(radius, z1 - z0, 32),
                   Pose::translation({middle.x, middle.y, 0.5 * (z0 + z1)}));
}

/// Four square legs at the corners of a footprint, up to z1.
void addLegs(TriangleMesh& mesh, double width, double depth, double leg, double z1) {
  for (const double x : {-0.5 * width, 0.5 * width - leg}) {
    for (const double y : {-0.5 * depth, 0.5 * depth - leg}) addBox(mesh, {x, y, 0.0}, {x + leg, y + leg, z1});
  }
}

TriangleMesh table(Sizes s) {
  // m, a usual table's, our choice. Half, twice: a thinner or thicker top and legs.
  constexpr double kTop = 0.03, kLeg = 0.06;
  TriangleMesh mesh;
  addBox(mesh, {-0.5 * s[0], -0.5 * s[1], s[2] - kTop}, {0.5 * s[0], 0.5 * s[1], s[2]});
  addLegs(mesh, s[0], s[1], kLeg, s[2] - kTop);
  return mesh;
}

/// An adjustable work bench: a top on two telescopes with feet; the lower tubes stay as they are whatever the height.
TriangleMesh bench(Sizes s) {
  // m, a usual work bench's, our choice. Half, twice: other beams and tubes, and other room for feet and knees.
  constexpr double kTop = 0.03, kBeam = 0.03, kFoot = 0.04, kTube = 0.5, kOuter = 0.045, kInner = 0.035, kIn = 0.15;
  TriangleMesh mesh;
  const double x = 0.5 * s[0], y = 0.5 * s[1], under = s[2] - kTop - kBeam;
  addBox(mesh, {-x, -y, s[2] - kTop}, {x, y, s[2]});
  for (const double at : {-x + kIn, x - kIn}) {
    addBox(mesh, {at - kInner, -y + 0.05, under}, {at + kInner, y - 0.05, s[2] - kTop});
    addBox(mesh, {at - kInner, -kInner, kTube}, {at + kInner, kInner, under});
    addBox(mesh, {at - kOuter, -kOuter, kFoot}, {at + kOuter, kOuter, kTube});
    addBox(mesh, {at - kOuter, -y + 0.05, 0.0}, {at + kOuter, y - 0.05, kFoot});
  }
  return mesh;
}

/// Two sides, and boards at most 0.4 m apart.
TriangleMesh shelf(Sizes s) {
  // m, a usual shelf's. Half the distance: twice the boards; twice: boards 0.8 m apart.
  constexpr double kBoard = 0.02, kBetween = 0.4;
  TriangleMesh mesh;
  const double x = 0.5 * s[0], y = 0.5 * s[1];
  addBox(mesh, {-x, -y, 0.0}, {-x + kBoard, y, s[2]});
  addBox(mesh, {x - kBoard, -y, 0.0}, {x, y, s[2]});
  const int spaces = std::max(1, static_cast<int>(std::ceil((s[2] - 0.1) / kBetween)));
  for (int i = 0; i <= spaces; ++i) {
    const double z = 0.08 + (s[2] - 0.08 - kBoard) * i / spaces;
    addBox(mesh, {-x + kBoard, -y, z}, {x - kBoard, y, z + kBoard});
  }
  return mesh;
}

TriangleMesh cabinet(Sizes s) {
  // m: room for toes under a cabinet, as most have. Half, twice: toes touch it, or a figure stands nearer.
  constexpr double kPlinth = 0.08, kBack = 0.03;
  TriangleMesh mesh;
  addBox(mesh, {-0.5 * s[0] + kBack, -0.5 * s[1] + kBack, 0.0}, {0.5 * s[0] - kBack, 0.5 * s[1] - kBack, kPlinth});
  addBox(mesh, {-0.5 * s[0], -0.5 * s[1], kPlinth}, {0.5 * s[0], 0.5 * s[1], s[2]});
  return mesh;
}

TriangleMesh stool(Sizes s) {
  TriangleMesh mesh;
  addPost(mesh, {0.0, 0.0}, 0.2, 0.0, 0.025);
  addPost(mesh, {0.0, 0.0}, 0.03, 0.025, s[0] - 0.05);
  addPost(mesh, {0.0, 0.0}, 0.18, s[0] - 0.05, s[0]);
  return mesh;
}

/// A worker's chair; who sits on it looks along -y.
TriangleMesh chair(Sizes s) {
  // m, a usual chair's seat of 0.44 m. Half, twice: a stool, or a bench.
  constexpr double kHalf = 0.22, kLeg = 0.035, kSeat = 0.05;
  TriangleMesh mesh;
  addLegs(mesh, 2.0 * kHalf, 2.0 * kHalf, kLeg, s[0] - kSeat);
  addBox(mesh, {-kHalf, -kHalf, s[0] - kSeat}, {kHalf, kHalf, s[0]});
  for (const double x : {-kHalf, kHalf - kLeg}) addBox(mesh, {x, kHalf - kLeg, s[0]}, {x + kLeg, kHalf, s[0] + 0.2});
  addBox(mesh, {-kHalf, kHalf - kLeg, s[0] + 0.2}, {kHalf, kHalf, s[0] + 0.45});
  return mesh;
}

/// Boards over blocks over runners, 144 mm high as the exchange pallet of EN 13698-1.
TriangleMesh pallet(Sizes s) {
  // m, heights of the exchange pallet of EN 13698-1: runners, blocks, cross boards, top boards.
  constexpr double kRunner = 0.022, kBlocks = 0.1, kCross = 0.122, kHigh = 0.144;
  TriangleMesh mesh;
  const double x = 0.5 * s[0], y = 0.5 * s[1];
  for (const double side : {-1.0, 0.0, 1.0}) {
    const double middle = side * (y - 0.05);
    addBox(mesh, {-x, middle - 0.05, 0.0}, {x, middle + 0.05, kRunner});
    for (const double end : {-1.0, 0.0, 1.0}) {
      const double at = end * (x - 0.0725);
      addBox(mesh, {at - 0.0725, middle - 0.05, kRunner}, {at + 0.0725, middle + 0.05, kBlocks});
    }
  }
  for (const double end : {-1.0, 0.0, 1.0}) {
    const double at = end * (x - 0.0725);
    addBox(mesh, {at - 0.0725, -y, kBlocks}, {at + 0.0725, y, kCross});
  }
  const int boards = std::max(2, static_cast<int>(std::lround(s[1] / 0.16)));
  const double each = s[1] / (boards + 0.25 * (boards - 1));
  for (int i = 0; i < boards; ++i) {
    const double at = -y + 1.25 * each * i;
    addBox(mesh, {-x, at, kCross}, {x, at + each, kHigh});
  }
  return mesh;
}

/// Posts at most 1.5 m apart with a frame between them, and bars of 8 mm every 0.1 m, so that no hand reaches through.
TriangleMesh fence(Sizes s) {
  // m: post, bar, distance of bars, frame, free height over the floor. Half the distance: twice the triangles; twice:
  // an arm reaches through.
  constexpr double kPost = 0.05, kBar = 0.008, kApart = 0.1, kRail = 0.03, kFoot = 0.15;
  TriangleMesh mesh;
  const int fields = std::max(1, static_cast<int>(std::ceil(s[0] / 1.5)));
  const double field = (s[0] - kPost) / fields;
  for (int i = 0; i <= fields; ++i) {
    const double x = -0.5 * s[0] + field * i;
    addBox(mesh, {x, -0.5 * kPost, 0.0}, {x + kPost, 0.5 * kPost, s[1]});
    if (i == fields) break;
    const double from = x + kPost, to = x + field;
    for (const double z : {kFoot, s[1] - kRail}) addBox(mesh, {from, -0.5 * kRail, z}, {to, 0.5 * kRail, z + kRail});
    const int bars = std::max(1, static_cast<int>(std::ceil((to - from) / kApart)) - 1);
    for (int k = 1; k <= bars; ++k) {
      const double at = from + (to - from) * k / (bars + 1);
      addBox(mesh, {at - 0.5 * kBar, -0.5 * kBar, kFoot + kRail}, {at + 0.5 * kBar, 0.5 * kBar, s[1] - kRail});
    }
  }
  return mesh;
}

/// A belt about two rollers between side plates, on legs; it runs along x, its upper side at the height.
TriangleMesh conveyor(Sizes s) {
  // m, a light conveyor's, our choice. Half, twice: other rollers and plates.
  constexpr double kRoller = 0.05, kPlate = 0.02, kLeg = 0.05;
  TriangleMesh mesh;
  const double x = 0.5 * s[0] - kRoller, y = 0.5 * s[1], z = s[2] - kRoller;
  std::vector<glm::dvec2> belt;
  // Corners of half a roller; 11 degrees each. Half: corners are seen; twice: twice the triangles.
  constexpr int kSteps = 16;
  for (const double end : {1.0, -1.0}) {
    for (int i = 0; i <= kSteps; ++i) {
      const double angle =
          std::numbers::pi * (static_cast<double>(i) / kSteps - 0.5) + (end > 0.0 ? 0.0 : std::numbers::pi);
      belt.push_back({end * x + kRoller * std::cos(angle), kRoller * std::sin(angle)});
    }
  }
  const Pose upright{{0.0, y - kPlate, z}, quaternionFromRotationVector({0.5 * std::numbers::pi, 0.0, 0.0})};
  geometry::append(mesh, geometry::makePrism(belt, s[1] - 2.0 * kPlate), upright);
  for (const double side : {-y, y - kPlate}) addBox(mesh, {-x, side, z - 0.06}, {x, side + kPlate, z + 0.03});
  for (const double at : {-x, x - kLeg}) {
    for (const double side : {-y, y - kLeg}) addBox(mesh, {at, side, 0.0}, {at + kLeg, side + kLeg, z - 0.06});
  }
  return mesh;
}

/// Two parallel fingers on a body, so far apart as the size says.
TriangleMesh gripper(Sizes s) {
  // m along z: flange, body, fingers' width, tips; a small parallel gripper, our choice. Half, twice: another gripper.
  constexpr double kFlange = 0.02, kBody = 0.1, kFinger = 0.02, kTip = 0.16;
  TriangleMesh mesh;
  const double half = 0.5 * s[0] + kFinger;
  addPost(mesh, {0.0, 0.0}, 0.04, 0.0, kFlange);
  addBox(mesh, {-half - 0.01, -0.04, kFlange}, {half + 0.01, 0.04, kBody});
  for (const double side : {-half, half - kFinger}) addBox(mesh, {side, -0.015, kBody}, {side + kFinger, 0.015, kTip});
  return mesh;
}

// m: the least size, so that triangles are not empty. Half, twice: no effect, parts are some mm.
constexpr double kAny = 1e-6;
constexpr PartSize kBox[] = {{"length", 0.5, kAny}, {"width", 0.3, kAny}, {"height", 0.2, kAny}};
constexpr PartSize kRound[] = {{"radius", 0.1, kAny}, {"height", 0.3, kAny}};
constexpr PartSize kSphere[] = {{"radius", 0.1, kAny}};
constexpr PartSize kPipe[] = {{"outer radius", 0.1, kAny}, {"inner radius", 0.08, kAny}, {"height", 0.3, kAny}};
constexpr PartSize kTable[] = {{"width", 1.2, 0.2}, {"depth", 0.8, 0.2}, {"height", 0.75, 0.1}};
constexpr PartSize kBench[] = {{"width", 1.2, 0.5}, {"depth", 0.8, 0.3}, {"height", 0.95, 0.6}};
constexpr PartSize kShelf[] = {{"width", 1.0, 0.2}, {"depth", 0.4, 0.1}, {"height", 1.8, 0.3}};
constexpr PartSize kCabinet[] = {{"width", 0.8, 0.2}, {"depth", 0.4, 0.2}, {"height", 1.8, 0.2}};
constexpr PartSize kStool[] = {{"height", 0.6, 0.2}};
constexpr PartSize kChair[] = {{"seat height", 0.46, 0.2}};
constexpr PartSize kPallet[] = {{"length", 1.2, 0.45}, {"width", 0.8, 0.3}};
constexpr PartSize kFence[] = {{"length", 3.0, 0.3}, {"height", 2.0, 0.5}};
constexpr PartSize kConveyor[] = {{"length", 2.0, 0.4}, {"width", 0.5, 0.15}, {"height", 0.9, 0.2}};
constexpr PartSize kGripper[] = {{"opening", 0.08, 0.005}};

constexpr std::array<float, 3> kGrey{0.72F, 0.74F, 0.76F}, kWood{0.79F, 0.64F, 0.44F}, kSteel{0.56F, 0.6F, 0.64F},
    kYellow{0.93F, 0.75F, 0.13F}, kDark{0.3F, 0.32F, 0.35F}, kBlue{0.35F, 0.47F, 0.6F};

const BuiltInPart kParts[] = {
    {"box", kBox, Origin::kMiddle, kGrey,
     [](Sizes s) {
       return geometry::makeBox({s[0], s[1], s[2]});
     }},
    {"cylinder", kRound, Origin::kMiddle, kGrey, [](Sizes s) { return geometry::makeCylinder(s[0], s[1]); }},
    {"sphere", kSphere, Origin::kMiddle, kGrey, [](Sizes s) { return geometry::makeSphere(s[0]); }},
    {"cone", kRound, Origin::kMiddle, kGrey, [](Sizes s) { return geometry::makeCone(s[0], s[1]); }},
    {"pipe", kPipe, Origin::kMiddle, kGrey,
     [](Sizes s) { return s[1] < s[0] ? geometry::makePipe(s[0], s[1], s[2]) : TriangleMesh{}; }},
    {"table", kTable, Origin::kFloor, kWood, table},
    {"bench", kBench, Origin::kFloor, kWood, bench},
    {"shelf", kShelf, Origin::kFloor, kSteel, shelf},
    {"cabinet", kCabinet, Origin::kFloor, kGrey, cabinet},
    {"stool", kStool, Origin::kFloor, kDark, stool},
    {"chair", kChair, Origin::kFloor, kDark, chair},
    {"pallet", kPallet, Origin::kFloor, kWood, pallet},
    {"fence", kFence, Origin::kFloor, kYellow, fence},
    {"conveyor", kConveyor, Origin::kFloor, kBlue, conveyor},
    {"gripper", kGripper, Origin::kFlange, kDark, gripper},
};

/// The sizes behind the scheme, metres; the standard ones where there are none; nothing where they cannot be used.
std::optional<std::vector<double>> sizesOf(std::string_view words, const BuiltInPart& part, double scale) {
  std::vector<double> sizes;
  if (words.empty()) {
    for (const PartSize& size : part.sizes) sizes.push_back(size.standard);
    return sizes;
  }
  for (std::size_t i = 0; i < part.sizes.size(); ++i) {
    const std::size_t end = words.find(',');
    const bool last = i + 1 == part.sizes.size();
    if ((end == std::string_view::npos) != last) return std::nullopt;
    const std::optional<double> value = parseNumber(words.substr(0, end));
    if (!value || !(*value * scale >= part.sizes[i].least) || !(*value * scale <= kGreatest)) return std::nullopt;
    sizes.push_back(*value * scale);
    words = last ? std::string_view{} : words.substr(end + 1);
  }
  return sizes;
}

Error sizesRefused(const std::string& what, const std::string& words, const BuiltInPart& part) {
  Text list;
  for (const PartSize& size : part.sizes) {
    char least[64];
    std::snprintf(least, sizeof least, "%g", size.least);
    const Text name(size.name);
    const Text one = size.least > kAny ? Text("%1 (%2 m or more)", name, least) : Text("%1 (above 0)", name);
    list = list.empty() ? one : Text("%1, %2", list, one);
  }
  if (part.sizes.data() == kPipe) list = Text("%1, with an inner radius below the outer one", list);
  return {.file = what, .found = Text("invalid dimensions '%1'", words), .expected = Text("%1:%2", part.scheme, list)};
}

}  // namespace

std::span<const BuiltInPart> builtInParts() {
  return kParts;
}

const BuiltInPart* findBuiltInPart(std::string_view scheme) {
  const auto found = std::find_if(std::begin(kParts), std::end(kParts),
                                  [&](const BuiltInPart& part) { return scheme == part.scheme; });
  return found == std::end(kParts) ? nullptr : found;
}

std::string partSource(const BuiltInPart& part, const std::vector<double>& sizes) {
  std::string text = std::string(part.scheme) + ":";
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (i > 0) text += ',';
    text += plainNumber(sizes[i], std::chars_format::general, 9);
  }
  return text;
}

std::vector<double> partSizes(const SourceFile& source) {
  const std::size_t colon = source.path.find(':');
  const BuiltInPart* part = colon == std::string::npos ? nullptr : findBuiltInPart(source.path.substr(0, colon));
  if (part == nullptr) return {};
  return sizesOf(std::string_view(source.path).substr(colon + 1), *part, source.scale).value_or(std::vector<double>{});
}

Expected<Entity> makeBuiltInPart(const std::string& what, double scale) {
  const std::size_t colon = what.find(':');
  const BuiltInPart* part = findBuiltInPart(what.substr(0, colon));
  if (part == nullptr || colon == std::string::npos) {
    return makeError(
        {.file = what, .found = "not a built-in part", .expected = "box:, table:, fence: or another built-in part"});
  }
  const std::string words = what.substr(colon + 1);
  const auto sizes = sizesOf(words, *part, scale);
  TriangleMesh mesh = sizes ? part->make(*sizes) : TriangleMesh{};
  if (mesh.triangles.empty()) return makeError(sizesRefused(what, words, *part));
  Entity entity;
  entity.name = part->scheme;
  entity.body = Solid{std::make_shared<const TriangleMesh>(std::move(mesh))};
  entity.color = part->color;
  entity.source = {what, scale};
  return entity;
}

}  // namespace hapticell::workcell
