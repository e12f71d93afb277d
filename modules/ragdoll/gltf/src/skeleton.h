// SPDX-License-Identifier: MIT
//
// The joints of a skin with their poses, and the mesh points bound to each.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "jostle/physics/mat3.h"
#include "modules/ragdoll/gltf/src/gltf_file.h"

namespace jostle::modules::gltf {

inline constexpr std::size_t joints_max = 1024;
inline constexpr std::size_t points_max = 1u << 20;  // in all meshes of a skin

// v -> linear v + shift, in the file's units.
struct Affine {
    physics::Mat3 linear;
    physics::Vec3 shift;
};
physics::Vec3 apply(const Affine& m, physics::Vec3 v);
Affine operator*(const Affine& a, const Affine& b);

struct SkeletonJoint {
    std::size_t node = 0;
    std::string name = {};  // "node 7" if the file has no name
    int parent = -1;        // index of an earlier joint; -1 for the root, which is the first
    Affine world = {};      // pose in the file
    // in the scene; points with the largest weight on this joint
    std::vector<physics::Vec3> points = {};
};

// Returns the joints in an order in which parents come first; there is exactly one root.
physics::Result<std::vector<SkeletonJoint>> read_skeleton(const File& file, std::size_t skin);

}  // namespace jostle::modules::gltf
