// SPDX-License-Identifier: MIT
//
// The joints of a skin and where they stand, and the points of the meshes that hang on each.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "jostle/physics/mat3.h"
#include "modules/ragdoll/gltf/src/gltf_file.h"

namespace jostle::modules::gltf {

inline constexpr std::size_t joints_max = 1024;
inline constexpr std::size_t points_max = 1u << 20;  // of all meshes of a skin

// v -> linear v + shift, in the file's units.
struct Affine {
    physics::Mat3 linear;
    physics::Vec3 shift;
};
physics::Vec3 apply(const Affine& m, physics::Vec3 v);
Affine operator*(const Affine& a, const Affine& b);

struct SkeletonJoint {
    std::size_t node = 0;
    std::string name = {};                   // "node 7" if the file gives none
    int parent = -1;                         // an earlier joint; -1: the root, which is first
    Affine world = {};                       // as it stands in the file
    std::vector<physics::Vec3> points = {};  // likewise, of which it bears most
};

// In an order in which parents come first; exactly one is a root.
physics::Result<std::vector<SkeletonJoint>> read_skeleton(const File& file, std::size_t skin);

}  // namespace jostle::modules::gltf
