// SPDX-License-Identifier: MIT
//
// SceneDescription: a world as plain data, before it is built. The catalogue makes one by name, a
// scene file is read into one. Tests, benchmarks, jostle-sim and the server build their worlds from
// it. Plain C++ types: no protobuf here.
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

struct SceneBody {
    std::string name;
    physics::BodyDef body;
    std::vector<physics::ShapeDef> shapes;
    std::optional<std::uint32_t> color;  // 0xRRGGBB
};

// In place of SceneJoint::body_a: the joint joins body_b to the world.
inline constexpr std::size_t world_body = static_cast<std::size_t>(-1);

struct SceneJoint {
    std::string name;
    std::size_t body_a = 0, body_b = 0;  // index in SceneDescription::bodies
    physics::JointDef joint;             // build_scene fills in its bodies
};

// A module that the registry makes (jostle/physics/module.h). It gets its settings in the order of
// their names.
struct SceneModule {
    std::string tag;
    std::map<std::string, double> settings;
    std::map<std::string, std::size_t> bodies;  // of SceneDescription::bodies
    // Things that it makes, each from settings of its own: configured one after the other, after
    // the settings above.
    struct ModuleObject {
        std::string list;  // of the module's message in scene files: "cars"
        std::map<std::string, double> settings;
        std::map<std::string, std::size_t> bodies;
        std::map<std::string, std::vector<std::byte>> bytes = {};
    };
    std::vector<ModuleObject> objects = {};
    // Of save_module(), read after the settings; empty: as it begins. Ids in it are those of the
    // world in which it was kept.
    std::vector<std::byte> state;
};
inline constexpr std::size_t modules_max = 64;           // of a scene file and of a hosted world
inline constexpr std::size_t module_objects_max = 4096;  // of a module in a scene file

struct SceneDescription {
    std::string name;
    std::string description;
    physics::WorldDef world;
    double hz = 60;  // steps per second, 4 to 1000 in a file; whoever steps the world keeps to it
    std::vector<SceneBody> bodies;
    std::vector<SceneJoint> joints;
    std::vector<SceneModule> modules;  // added in this order
};

struct BuiltScene {
    physics::World world;
    std::vector<physics::BodyId> bodies;   // bodies[i] was made from description.bodies[i]
    std::vector<physics::JointId> joints;  // likewise
};

// Makes the world. Every body has a shape. An error names the body ("bodies[3] 'ramp': ..."), joint
// or module, and what is wrong with it.
physics::Result<BuiltScene> build_scene(const SceneDescription& description);

}  // namespace jostle::scenes
