// SPDX-License-Identifier: MIT
//
// The reading half of shape_message.h, for readers of whole scenes that note one fault for all.
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
