// SPDX-License-Identifier: MIT
//
// jostle.v1.Shape to physics::ShapeDef and back: the one place that knows every kind and field.
#pragma once

#include <string>

#include "jostle/physics/world.h"

namespace jostle::v1 {
class Shape;
}

namespace jostle::scenes {

// Foreign numbers. Errors name the field with its path, which begins with `path`
// ("shapes[0].box.half_extents.x: -1 ..."). Whether a body of some type may carry the shape is the
// world's to say.
physics::Result<physics::ShapeDef> shape_from_message(const v1::Shape& message,
                                                      const std::string& path);

// Everything that differs from its default.
void write_shape(v1::Shape& out, const physics::ShapeDef& def);
// Kind, size and place only: what a viewer draws.
void write_outline(v1::Shape& out, const physics::Geometry& geometry,
                   const physics::Transform& pose);

}  // namespace jostle::scenes
