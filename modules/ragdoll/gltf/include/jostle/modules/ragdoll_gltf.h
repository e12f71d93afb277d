// SPDX-License-Identifier: MIT
//
// Creates a figure from the skeleton of a glTF 2.0 file (.gltf or .glb). Each joint of a skin
// becomes a bone: a capsule to the next joint, with a radius from the mesh that is bound to it and
// a mass from its volume. The file may come from an untrusted source: sizes are limited, indices
// and numbers are checked, and an error names the problem and its location.
//
//     GltfFigureOptions options;
//     options.bones.push_back({.name = "LeftForeArm", .kind = GltfBoneKind::hinge,
//                              .axis = {0, 1, 0}, .lower = -0.1, .upper = 2.2});
//     Result<GltfFigure> figure = read_gltf_figure("robot.glb", options);
//     ragdolls.add(world, figure->def, {.position = {0, 1, 0}});
//
// Not supported: sparse accessors, compressed meshes (extensions), a second set of weights.
//
// Thread rule: any thread.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "jostle/modules/ragdoll.h"

namespace jostle::modules {

/// Joint type of a bone.
enum class GltfBoneKind : std::uint8_t {
    cone_twist,  ///< swing up to `swing`, twist about the bone from `lower` to `upper`
    hinge,       ///< about `axis`, from `lower` to `upper`
    ball,        ///< without limits
    /// no bone of its own, for fingers, toes and twist joints; the mesh and children join the
    /// parent
    merged,
};

/// How to convert the joint of a name.
struct GltfBoneOptions {
    /// Name of the joint in the file.
    std::string name = {};
    GltfBoneKind kind = GltfBoneKind::cone_twist;
    physics::Vec3 axis = {1, 0, 0};  ///< hinge axis in the joint's own frame; not zero
    double swing = 0.7;              ///< rad, 0 to pi
    /// rad, -pi to pi, relative to the pose in the file; lower <= upper
    double lower = -0.4, upper = 0.4;
    Muscle muscle = {};
};

/// Options of the conversion.
struct GltfFigureOptions {
    std::size_t skin = 0;      ///< index of the skin in the file
    double scale = 1;          ///< m per unit of the file, 1e-4 to 1e4
    double density = 1000;     ///< kg/m^3, 1e-6 to 1e6
    double min_radius = 0.02;  ///< m, minimum radius of a bone's capsule after scaling, 1e-4 to 100
    GltfBoneOptions default_bone = {};  ///< for joints that are not listed in `bones`
    /// Joints with options of their own; each name must exist in the skin.
    std::vector<GltfBoneOptions> bones = {};
};

/// A converted figure.
struct GltfFigure {
    /// For Ragdolls::add().
    RagdollDef def;
    std::vector<std::size_t> nodes;  ///< index of the node in the file, by bone
};

/// Reads an external buffer, given its URI as written in the file.
using GltfBufferReader =
    std::function<physics::Result<std::vector<std::byte>>(const std::string& uri)>;

/// Converts a file in memory. The file and its buffers may have at most 64 MB each. Without a
/// reader, an external buffer is an error.
physics::Result<GltfFigure> figure_from_gltf(std::span<const std::byte> file,
                                             const GltfFigureOptions& options = {},
                                             const GltfBufferReader& outside = {});
/// Reads a file. External buffers must be in the same folder or below it.
physics::Result<GltfFigure> read_gltf_figure(const std::string& path,
                                             const GltfFigureOptions& options = {});

}  // namespace jostle::modules
