// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/shapes/vector.h"

namespace hapticell::test {

/// Writes C3D as each of the three processors would; an independent way from the reader's: byte by byte from values.
class C3dText {
 public:
  explicit C3dText(int processor) : processor_(processor) {}

  void byte(int value) { bytes += static_cast<char>(value); }
  void word(unsigned value) {
    const int low = static_cast<int>(value & 0xff), high = static_cast<int>(value >> 8 & 0xff);
    byte(processor_ == 86 ? high : low);
    byte(processor_ == 86 ? low : high);
  }
  void real(float value) {
    if (processor_ == 85) value *= 4.0f;
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, 4);
    word(processor_ == 84 ? bits & 0xffff : bits >> 16);
    word(processor_ == 84 ? bits >> 16 : bits & 0xffff);
  }
  void text(const std::string& letters) { bytes += letters; }
  void fillTo(std::size_t size) { bytes.resize(size, '\0'); }
  void group(int number, const std::string& name) {
    byte(static_cast<int>(name.size()));
    byte(-number);
    text(name);
    word(3);
    byte(0);
  }
  /// `content` is what stands behind the dimensions.
  void parameter(int group, const std::string& name, int type, const std::vector<int>& sizes, const C3dText& content) {
    byte(static_cast<int>(name.size()));
    byte(group);
    text(name);
    word(static_cast<unsigned>(2 + 2 + sizes.size() + content.bytes.size() + 1));
    byte(type);
    byte(static_cast<int>(sizes.size()));
    for (int size : sizes) byte(size);
    text(content.bytes);
    byte(0);
  }
  std::string bytes;

 private:
  int processor_;
};

/// A C3D file of which header and parameters may say different things. What is not given is left out.
struct C3dFile {
  int processor = 84;
  bool real = true;
  int frames = 20;
  std::vector<std::string> labels{"M1", "M2", "M3"};
  std::function<std::optional<dvec3>(int frame, int marker)> place{};  ///< In the file's unit; nothing: not seen.
  double scale = 0.05;                                                 ///< With which whole numbers are written.
  int analog = 0;                                                      ///< Numbers a frame that stand in the file.
  std::optional<int> header_analog{}, header_first{}, header_last{}, header_block{}, header_points{};
  std::optional<double> header_scale{};
  std::optional<double> parameter_scale{}, analog_used{}, analog_rate{}, long_frames{};
  std::optional<int> parameter_start{}, parameter_frames{};
  std::optional<std::string> unit = "mm", up = "+Z";
  bool last_link_swapped = false;
  double rate = 100.0;

  std::string bytes() const {
    const int points = static_cast<int>(labels.size());
    const std::string section = parameters();
    const int blocks = static_cast<int>((section.size() + 4 + 511) / 512);
    C3dText file(processor);
    file.byte(2);
    file.byte(0x50);
    file.word(static_cast<unsigned>(header_points.value_or(points)));
    file.word(static_cast<unsigned>(header_analog.value_or(analog)));
    file.word(static_cast<unsigned>(header_first.value_or(1)) & 0xffff);
    file.word(static_cast<unsigned>(header_last.value_or(frames)) & 0xffff);
    file.word(0);
    file.real(static_cast<float>(header_scale.value_or(real ? -1.0 : scale)));
    file.word(static_cast<unsigned>(header_block.value_or(2 + blocks)));
    file.word(1);
    file.real(static_cast<float>(rate));
    file.fillTo(512);
    file.byte(1);
    file.byte(0x50);
    file.byte(blocks);
    file.byte(processor);
    file.text(section);
    file.fillTo(512 * static_cast<std::size_t>(1 + blocks));
    const auto number = [&](double v) {
      if (real) return file.real(static_cast<float>(v));
      file.word(static_cast<unsigned>(static_cast<int>(std::lround(v / scale))) & 0xffff);
    };
    for (int f = 0; f < frames; ++f) {
      for (int m = 0; m < points; ++m) {
        const std::optional<dvec3> p = place ? place(f, m) : std::optional(dvec3(10.0 * f, 100.0 * m, 1500.0));
        for (int k = 0; k < 3; ++k) number(p ? (*p)[k] : 0.0);
        if (real)
          file.real(p ? 0.0f : -1.0f);
        else
          file.word(p ? 0u : 0xffffu);
      }
      for (int a = 0; a < analog; ++a) real ? file.real(5.0f) : file.word(5u);
    }
    return file.bytes;
  }

 private:
  std::string parameters() const {
    C3dText text(processor);
    text.group(1, "POINT");
    std::size_t width = 1;
    for (const std::string& label : labels) width = std::max(width, label.size());
    C3dText names(processor);
    for (std::string label : labels) {
      label.resize(width, ' ');
      names.text(label);
    }
    text.parameter(1, "LABELS", -1, {static_cast<int>(width), static_cast<int>(labels.size())}, names);
    const auto word = [&](const char* name, const std::optional<std::string>& value) {
      if (!value) return;
      C3dText content(processor);
      content.text(*value);
      text.parameter(1, name, -1, {static_cast<int>(value->size())}, content);
    };
    const auto real_number = [&](int group, const char* name, const std::optional<double>& value) {
      if (!value) return;
      C3dText content(processor);
      content.real(static_cast<float>(*value));
      text.parameter(group, name, 4, {1}, content);
    };
    const auto whole = [&](const char* name, const std::optional<int>& value) {
      if (!value) return;
      C3dText content(processor);
      content.word(static_cast<unsigned>(*value) & 0xffff);
      text.parameter(1, name, 2, {1}, content);
    };
    word("UNITS", unit);
    word("Y_SCREEN", up);
    whole("DATA_START", parameter_start);
    whole("FRAMES", parameter_frames);
    real_number(1, "SCALE", parameter_scale);
    real_number(1, "LONG_FRAMES", long_frames);
    text.group(2, "ANALOG");
    real_number(2, "USED", analog_used);
    real_number(2, "RATE", analog_rate);
    const std::size_t last = text.bytes.size();
    real_number(1, "RATE", rate);
    if (last_link_swapped) std::swap(text.bytes[last + 6], text.bytes[last + 7]);  // Behind its length, group and name.
    text.byte(0);
    text.byte(0);
    return text.bytes;
  }
};

}  // namespace hapticell::test
