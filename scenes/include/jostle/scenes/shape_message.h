// SPDX-License-Identifier: MIT
//
// Converts jostle.v1.Shape to physics::ShapeDef and back. Scene files, spawned bodies and queries
// use these functions. Any thread.
#pragma once

#include <string>
#include <string_view>

#include "jostle/physics/world.h"

namespace jostle::v1 {
class Shape;
}

namespace jostle::scenes {

/// Converts an untrusted message; every number is checked. An error names the field, with `path` as
/// the beginning of its path ("shapes[0].box.half_extents.x: -1 ..."). The world checks whether a
/// body of some type may have the shape.
physics::Result<physics::ShapeDef> shape_from_message(const v1::Shape& message,
                                                      const std::string& path);

/// Writes the complete shape except user_data, so that shape_from_message() restores it.
void write_shape(v1::Shape& out, const physics::ShapeDef& def);
/// Returns the complete shape as a serialized message, for storage.
std::string shape_bytes(const physics::ShapeDef& def);
/// Inverse of shape_bytes(). The bytes are untrusted; errors are those of shape_from_message(), and
/// corrupt_data if the bytes are not a message.
physics::Result<physics::ShapeDef> shape_from_bytes(std::string_view bytes,
                                                    const std::string& path);
/// Writes filter and material fields that differ from the defaults, for clients that predict
/// motion.
void write_contact_properties(v1::Shape& out, const physics::ShapeDef& def);
/// Writes kind, dimensions and pose only, for display.
void write_geometry(v1::Shape& out, const physics::Geometry& geometry,
                    const physics::Transform& pose);

}  // namespace jostle::scenes
