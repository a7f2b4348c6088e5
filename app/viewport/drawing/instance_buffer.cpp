// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/drawing/instance_buffer.h"

#include <cstddef>

#include "app/viewport/drawing/buffer_offset.h"

namespace hapticell::app {

InstanceBuffer::InstanceBuffer(Gl& gl) : gl_(gl) {
  gl_.glGenBuffers(1, &buffer_);
}
InstanceBuffer::~InstanceBuffer() {
  gl_.glDeleteBuffers(1, &buffer_);
}

void InstanceBuffer::fill(const std::vector<ItemInstance>& uses) {
  gl_.glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  // New memory each time: what is still being drawn from the old is not waited for.
  gl_.glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(uses.size() * sizeof(ItemInstance)), uses.data(),
                   GL_STREAM_DRAW);
}

void InstanceBuffer::attach(std::size_t first) const {
  const auto at = [first](std::size_t member) { return bufferOffset(first * sizeof(ItemInstance) + member); };
  constexpr GLsizei kStride = sizeof(ItemInstance);
  gl_.glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  for (GLuint row = 0; row < 3; ++row)
    gl_.glVertexAttribPointer(2 + row, 4, GL_FLOAT, GL_FALSE, kStride, at(row * sizeof(glm::vec4)));
  gl_.glVertexAttribPointer(5, 3, GL_FLOAT, GL_FALSE, kStride, at(offsetof(ItemInstance, albedo)));
  gl_.glVertexAttribIPointer(6, 1, GL_UNSIGNED_INT, kStride, at(offsetof(ItemInstance, id)));
  for (GLuint attribute = 2; attribute <= 6; ++attribute) {
    gl_.glEnableVertexAttribArray(attribute);
    gl_.glVertexAttribDivisor(attribute, 1);
  }
}

}  // namespace hapticell::app
