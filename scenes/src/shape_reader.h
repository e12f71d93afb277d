// SPDX-License-Identifier: MIT
//
// Reading of shapes as in shape_message.h, for readers of complete scenes that store one error.
#pragma once

#include "jostle/physics/defs.h"
#include "scenes/src/field_reader.h"

namespace jostle::v1 {
class Shape;
}

namespace jostle::scenes {

std::optional<physics::Geometry> read_geometry(FieldReader& in, const std::string& path,
                                               const v1::Shape& message);
physics::ShapeDef read_shape(FieldReader& in, const std::string& path, const v1::Shape& message);

}  // namespace jostle::scenes
