// SPDX-License-Identifier: MIT
//
// Size of the message of a shape, without creating the message. Any thread.
#pragma once

#include <cstddef>

#include "jostle/physics/geometry.h"

namespace jostle::scenes {

/// Returns an upper bound of the size of kind and dimensions in a jostle.v1.Shape, in bytes. It is
/// not much larger than the actual size.
std::size_t geometry_message_bytes(const physics::Geometry& geometry);
/// Larger shapes are sent once per play stream instead of with each body. Shapes that clients may
/// spawn are smaller.
inline constexpr std::size_t inline_geometry_bytes_max = 1024;
/// Address of the data of a shape whose data several bodies can share; null for other shapes.
const void* shared_data(const physics::Geometry& geometry);

}  // namespace jostle::scenes
