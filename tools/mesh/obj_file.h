// SPDX-License-Identifier: MIT
//
// Reads vertices and faces of Wavefront OBJ files. Faces with more than three corners become
// triangle fans; all groups become one mesh; other lines are ignored.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "jostle/physics/result.h"
#include "jostle/physics/vec3.h"

namespace jostle::mesh {

struct ObjMesh {
    std::vector<physics::Vec3> vertices;
    std::vector<std::uint32_t> indices;  // three per triangle
};

// Reads the content of an OBJ file: at most 1,000,000 vertices and 1,000,000 triangles. Errors
// contain the line.
physics::Result<ObjMesh> read_obj(std::string_view text);

}  // namespace jostle::mesh
