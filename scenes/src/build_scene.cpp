// SPDX-License-Identifier: MIT
#include "jostle/scenes/scene.h"

namespace jostle::scenes {

using physics::Error;
using physics::Result;

namespace {

Error in_body(const SceneDescription& scene, std::size_t i, const Error& error) {
    return {error.code,
            "bodies[" + std::to_string(i) + "] '" + scene.bodies[i].name + "': " + error.message};
}

}  // namespace

Result<BuiltScene> build_scene(const SceneDescription& scene) {
    Result<physics::World> world = physics::World::create(scene.world);
    if (!world.ok()) return Error{world.error().code, "world: " + world.error().message};
    BuiltScene built{std::move(*world), {}};
    built.bodies.reserve(scene.bodies.size());
    for (std::size_t i = 0; i < scene.bodies.size(); i++) {
        const SceneBody& body = scene.bodies[i];
        if (body.shapes.empty())
            return in_body(
                scene, i,
                {physics::ErrorCode::invalid_argument, "it has no shape; give it at least one"});
        const Result<physics::BodyId> id = built.world.create_body(body.body, body.shapes.front());
        if (!id.ok()) return in_body(scene, i, id.error());
        for (std::size_t k = 1; k < body.shapes.size(); k++)
            if (const auto shape = built.world.create_shape(*id, body.shapes[k]); !shape.ok())
                return in_body(scene, i,
                               {shape.error().code,
                                "shapes[" + std::to_string(k) + "]: " + shape.error().message});
        built.bodies.push_back(*id);
    }
    return built;
}

}  // namespace jostle::scenes
