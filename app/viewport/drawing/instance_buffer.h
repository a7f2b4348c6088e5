// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/viewport/drawing/gl.h"
#include "app/viewport/drawing/item_batches.h"

namespace hapticell::app {

/// The mesh instances that a pass draws, in the graphics card's memory; filled again for each pass.
class InstanceBuffer {
 public:
  explicit InstanceBuffer(Gl& gl);
  ~InstanceBuffer();
  InstanceBuffer(const InstanceBuffer&) = delete;
  InstanceBuffer& operator=(const InstanceBuffer&) = delete;

  void fill(const std::vector<ItemInstance>& uses);
  /// Sets attributes 2 to 6 of the bound vertex array: rows, albedo and id from the `first` use on, one per instance.
  void attach(std::size_t first) const;

 private:
  Gl& gl_;
  GLuint buffer_ = 0;
};

}  // namespace hapticell::app
