// SPDX-License-Identifier: MIT
//
// Wavefront OBJ files, as far as geometry goes: vertices and faces. Faces of more than three
// corners are fans; all groups are one mesh; everything else is passed over.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "jostle/physics/result.h"
#include "jostle/physics/vec3.h"

namespace jostle::convert {

struct ObjMesh {
    std::vector<physics::Vec3> vertices;
    std::vector<std::uint32_t> indices;  // three per triangle
};

// An error names the line. At most 1,000,000 vertices and as many triangles.
physics::Result<ObjMesh> read_obj(std::string_view text);

}  // namespace jostle::convert
