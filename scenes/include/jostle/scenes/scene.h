// SPDX-License-Identifier: MIT
//
// SceneDescription: a world as plain data, before it is built. The catalogue creates one by name,
// and scene files are read into one. Tests, benchmarks, jostle-sim and the server build their
// worlds from it. Plain C++ types, without protobuf.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "jostle/physics/world.h"

namespace jostle::scenes {

/// A body of a scene.
struct SceneBody {
    /// Need not be unique.
    std::string name;
    physics::BodyDef body;
    std::vector<physics::ShapeDef> shapes;
    std::optional<std::uint32_t> color;  ///< 0xRRGGBB
};

/// Value of SceneJoint::body_a that joins body_b to the world.
inline constexpr std::size_t world_body = static_cast<std::size_t>(-1);

/// A joint of a scene.
struct SceneJoint {
    std::string name;
    std::size_t body_a = 0, body_b = 0;  ///< indices in SceneDescription::bodies
    physics::JointDef joint;             ///< build_scene() sets its bodies
};

/// A module created by the registry (jostle/physics/module.h). It receives its settings sorted by
/// name.
struct SceneModule {
    std::string tag;
    std::map<std::string, double> settings;
    std::map<std::string, std::size_t> bodies;  ///< indices in SceneDescription::bodies
    /// An object that the module creates from settings of its own. Objects are configured in order,
    /// after the settings above.
    struct ModuleObject {
        std::string list;  ///< list in the module's message in scene files, such as "cars"
        std::map<std::string, double> settings;
        std::map<std::string, std::size_t> bodies;
        std::map<std::string, std::vector<std::byte>> bytes = {};
    };
    std::vector<ModuleObject> objects = {};
    /// Result of save_module(), loaded after the settings; empty for the initial state. Its ids are
    /// those of the world in which it was saved.
    std::vector<std::byte> state;
};
/// Maximum number of modules of a scene file and of a hosted world.
inline constexpr std::size_t modules_max = 64;
/// Maximum number of objects of a module in a scene file.
inline constexpr std::size_t module_objects_max = 4096;

/// Greatest error of the poses that clients decode (v1::Precision). All 0: not set.
struct StreamPrecision {
    double position = 0;    ///< m, 0.0001 to 1
    double rotation = 0;    ///< rad, 0.0002 to 0.5
    double far_factor = 0;  ///< coarser in distant cells, 1 to 1000; 0: 1
};

/// Initial view of a scene (v1::View). It does not change the simulation.
struct SceneView {
    physics::Vec3 eye, target;  ///< m
    double field_of_view = 0;   ///< rad, vertical; 0: chosen by the viewer

    bool operator==(const SceneView&) const = default;
};

/// A world as plain data.
struct SceneDescription {
    std::string name;
    std::string description;
    physics::WorldDef world;
    /// Steps per second, 4 to 1000 in a file; the caller that steps the world uses it.
    double hz = 60;
    StreamPrecision precision;
    std::optional<SceneView> view;  ///< absent: chosen by the viewer
    std::vector<SceneBody> bodies;
    std::vector<SceneJoint> joints;
    std::vector<SceneModule> modules;  ///< in the order in which they are added
    std::string room = {};             ///< encoded jostle.v1.RoomSettings, for servers; empty: none
};

/// Result of build_scene().
struct BuiltScene {
    physics::World world;
    std::vector<physics::BodyId> bodies;   ///< bodies[i] was created from description.bodies[i]
    std::vector<physics::JointId> joints;  ///< joints[i] was created from description.joints[i]
};

/// Builds the world. Every body must have a shape. An error names the body ("bodies[3] 'ramp':
/// ..."), joint or module, and the reason.
physics::Result<BuiltScene> build_scene(const SceneDescription& description);

}  // namespace jostle::scenes
