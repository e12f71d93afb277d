// SPDX-License-Identifier: MIT
//
// jostle.v1.Shape to physics::ShapeDef and back. Scene files, spawned bodies and queries all read
// shapes here.
#pragma once

#include <string>
#include <string_view>

#include "jostle/physics/world.h"

namespace jostle::v1 {
class Shape;
}

namespace jostle::scenes {

// The message is foreign: every number is checked. An error names the field; its path begins with
// `path` ("shapes[0].box.half_extents.x: -1 ..."). Whether a body of some type may carry the shape
// is for the world to say.
physics::Result<physics::ShapeDef> shape_from_message(const v1::Shape& message,
                                                      const std::string& path);

// The whole shape but its user_data, so that shape_from_message() gives it back.
void write_shape(v1::Shape& out, const physics::ShapeDef& def);
// As bytes of the message, for who keeps them.
std::string shape_bytes(const physics::ShapeDef& def);
physics::Result<physics::ShapeDef> shape_from_bytes(std::string_view bytes,
                                                    const std::string& path);
// What decides whom it touches and how, as far as it is not as usual: for those who foresee motion.
void write_contact_properties(v1::Shape& out, const physics::ShapeDef& def);
// Kind, size and place only: what a viewer draws.
void write_geometry(v1::Shape& out, const physics::Geometry& geometry,
                    const physics::Transform& pose);

}  // namespace jostle::scenes
