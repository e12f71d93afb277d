// SPDX-License-Identifier: MIT
#include "jostle/physics/module.h"
#include "jostle/scenes/catalog.h"
#include "jostle/scenes/scene.h"

namespace jostle::scenes {

using physics::Error;
using physics::Result;
using physics::Status;

namespace {

Error in_body(const SceneDescription& scene, std::size_t i, const Error& error) {
    return {error.code,
            "bodies[" + std::to_string(i) + "] '" + scene.bodies[i].name + "': " + error.message};
}

// Replaces -0 by 0: scene files contain no -0, so a scene and its file produce bit-identical
// worlds.
physics::Vec3 plain(physics::Vec3 v) {
    return {v.x + 0.0, v.y + 0.0, v.z + 0.0};
}
physics::Transform plain(const physics::Transform& t) {
    const physics::Quat q = t.rotation;
    return {plain(t.position), {q.x + 0.0, q.y + 0.0, q.z + 0.0, q.w + 0.0}};
}
physics::BodyDef plain(physics::BodyDef def) {
    def.pose = plain(def.pose);
    def.linear_velocity = plain(def.linear_velocity);
    def.angular_velocity = plain(def.angular_velocity);
    return def;
}
physics::ShapeDef plain(physics::ShapeDef def) {
    def.pose = plain(def.pose);
    return def;
}

// Settings of a module or of one of its objects.
template <class Given>
physics::ModuleSettings settings_of(const Given& given,
                                    const std::vector<physics::BodyId>& bodies) {
    physics::ModuleSettings settings;
    for (const auto& [name, number] : given.settings)
        settings.numbers.emplace_back(name, number + 0.0);
    for (const auto& [name, body] : given.bodies)
        settings.bodies.emplace_back(name, bodies.at(body));
    if constexpr (requires { given.bytes; })
        settings.bytes.assign(given.bytes.begin(), given.bytes.end());
    return settings;
}

Status add_module(BuiltScene& built, const SceneModule& described) {
    Result<std::unique_ptr<physics::Module>> module = physics::make_module(described.tag);
    if (!module.ok()) return module.error();
    const auto configure = [&](const auto& given) {
        return (*module)->configure(built.world, settings_of(given, built.bodies));
    };
    // A module that is used only for its objects has no settings to read.
    if (described.objects.empty() || !described.settings.empty() || !described.bodies.empty())
        if (Status s = configure(described); !s.ok()) return s;
    std::map<std::string, int> counts;  // per list
    for (const SceneModule::ModuleObject& object : described.objects) {
        const int number = counts[object.list]++;
        if (Status s = configure(object); !s.ok())
            return Error{s.error().code,
                         object.list + "[" + std::to_string(number) + "]: " + s.error().message};
    }
    if (!described.state.empty())
        if (Status s = physics::load_module(**module, described.state); !s.ok()) return s;
    return built.world.add_module(std::move(*module));
}

// Calls restored() after all modules exist, as in a loaded world.
Status add_modules(BuiltScene& built, const SceneDescription& scene) {
    for (std::size_t i = 0; i < scene.modules.size(); i++) {
        const SceneModule& module = scene.modules[i];
        if (Status s = add_module(built, module); !s.ok())
            return Error{s.error().code, "modules[" + std::to_string(i) + "] '" + module.tag +
                                             "': " + s.error().message};
    }
    for (const SceneModule& module : scene.modules)
        if (!module.state.empty()) built.world.module(module.tag)->restored(built.world);
    return {};
}

}  // namespace

Result<BuiltScene> build_scene(const SceneDescription& scene) {
    register_catalog_modules();
    Result<physics::World> world = physics::World::create(scene.world);
    if (!world.ok()) return Error{world.error().code, "world: " + world.error().message};
    BuiltScene built{std::move(*world), {}, {}};
    built.bodies.reserve(scene.bodies.size());
    for (std::size_t i = 0; i < scene.bodies.size(); i++) {
        const SceneBody& body = scene.bodies[i];
        if (body.shapes.empty())
            return in_body(
                scene, i,
                {physics::ErrorCode::invalid_argument, "has no shape; it must have at least one"});
        const Result<physics::BodyId> id =
            built.world.create_body(plain(body.body), plain(body.shapes.front()));
        if (!id.ok()) return in_body(scene, i, id.error());
        for (std::size_t k = 1; k < body.shapes.size(); k++)
            if (const auto shape = built.world.create_shape(*id, plain(body.shapes[k]));
                !shape.ok())
                return in_body(scene, i,
                               {shape.error().code,
                                "shapes[" + std::to_string(k) + "]: " + shape.error().message});
        built.bodies.push_back(*id);
    }
    for (std::size_t i = 0; i < scene.joints.size(); i++) {
        const SceneJoint& joint = scene.joints[i];
        physics::JointDef def = joint.joint;
        def.frame_a = plain(def.frame_a);
        def.frame_b = plain(def.frame_b);
        if (joint.body_a != world_body) def.body_a = built.bodies.at(joint.body_a);
        def.body_b = built.bodies.at(joint.body_b);
        const auto id = built.world.create_joint(def);
        if (!id.ok())
            return Error{id.error().code, "joints[" + std::to_string(i) + "] '" + joint.name +
                                              "': " + id.error().message};
        built.joints.push_back(*id);
    }
    if (Status s = add_modules(built, scene); !s.ok()) return s.error();
    return built;
}

}  // namespace jostle::scenes
