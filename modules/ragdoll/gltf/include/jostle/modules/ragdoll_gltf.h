// SPDX-License-Identifier: MIT
//
// A figure from the skeleton of a glTF 2.0 file (.gltf or .glb): one bone for each joint of a skin,
// a capsule from the joint to the next, as thick as the mesh that hangs on it, as heavy as its
// volume. The file is a stranger's: sizes are bounded, indices and numbers checked, and an error
// names what was wrong and where.
//
//     GltfFigureOptions options;
//     options.bones.push_back({.name = "LeftForeArm", .kind = GltfBoneKind::hinge,
//                              .axis = {0, 1, 0}, .lower = -0.1, .upper = 2.2});
//     Result<GltfFigure> figure = read_gltf_figure("robot.glb", options);
//     ragdolls.add(world, figure->def, {.position = {0, 1, 0}});
//
// Not read: sparse accessors, compressed meshes (extensions), a second set of weights.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "jostle/modules/ragdoll.h"

namespace jostle::modules {

enum class GltfBoneKind : std::uint8_t {
    cone_twist,  // about the bone, within `swing` and `lower`..`upper`
    hinge,       // about `axis`, within `lower`..`upper`
    ball,
    merged,  // no bone of its own: fingers, toes, twist joints. What hangs on it is its parent's
};

// What the joint of a name becomes.
struct GltfBoneOptions {
    std::string name = {};
    GltfBoneKind kind = GltfBoneKind::cone_twist;
    physics::Vec3 axis = {1, 0, 0};    // of a hinge, in the joint's own axes
    double swing = 0.7;                // rad, 0 to pi
    double lower = -0.4, upper = 0.4;  // rad, -pi to pi, from how it stands in the file
    Muscle muscle = {};
};

struct GltfFigureOptions {
    std::size_t skin = 0;               // which of the file's
    double scale = 1;                   // m of a unit of the file, 1e-4 to 1e4
    double density = 1000;              // kg/m^3
    double min_radius = 0.02;           // m, of a bone's capsule, after scaling
    GltfBoneOptions default_bone = {};  // joints that are not named below
    std::vector<GltfBoneOptions> bones = {};
};

struct GltfFigure {
    RagdollDef def;
    std::vector<std::size_t> nodes;  // of the file, by bone: which node a bone moves
};

// The bytes of a buffer that lies outside, by its URI as it stands in the file.
using GltfBufferReader =
    std::function<physics::Result<std::vector<std::byte>>(const std::string& uri)>;

// Of at most 64 MB, as are all its buffers together. Without a reader a buffer outside is an error.
physics::Result<GltfFigure> figure_from_gltf(std::span<const std::byte> file,
                                             const GltfFigureOptions& options = {},
                                             const GltfBufferReader& outside = {});
// With buffers beside it: in its folder or below, nowhere else.
physics::Result<GltfFigure> read_gltf_figure(const std::string& path,
                                             const GltfFigureOptions& options = {});

}  // namespace jostle::modules
