// SPDX-License-Identifier: MIT
//
// How large what a client is told about a shape is, without making the message. Any thread.
#pragma once

#include <cstddef>

#include "jostle/physics/geometry.h"

namespace jostle::scenes {

// At least as many bytes as kind and sizes take in a jostle.v1.Shape, and not many more.
std::size_t geometry_message_bytes(const physics::Geometry& geometry);
// Play streams tell a shape of more than this once, not with each body that has it. What a client
// may spawn has less.
inline constexpr std::size_t inline_geometry_bytes_max = 1024;
// Of a shape with numbers that bodies may share, where they lie; null of others.
const void* shared_data(const physics::Geometry& geometry);

}  // namespace jostle::scenes
