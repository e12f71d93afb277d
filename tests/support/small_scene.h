// SPDX-License-Identifier: MIT
//
// A cheap scene for tests of servers that do not depend on the world.
#pragma once

#include <utility>

#include "jostle/scenes/scene.h"

namespace jostle::test {

// A floor, a stack of two boxes and a falling ball.
inline scenes::SceneDescription small_scene() {
    using namespace physics;
    scenes::SceneDescription scene{.name = "small"};
    const auto add = [&](const Geometry& geometry, Vec3 position, BodyType type) {
        scenes::SceneBody body{.name = "body"};
        body.body.pose.position = position;
        body.body.type = type;
        body.shapes.push_back(ShapeDef{.geometry = geometry});
        scene.bodies.push_back(std::move(body));
    };
    add(Plane{}, {}, BodyType::static_body);
    add(Box{{0.5, 0.5, 0.5}}, {0, 0.5, 0}, BodyType::dynamic);
    add(Box{{0.5, 0.5, 0.5}}, {0, 1.5, 0}, BodyType::dynamic);
    add(Sphere{0.3}, {2, 3, 0}, BodyType::dynamic);
    return scene;
}

}  // namespace jostle::test
