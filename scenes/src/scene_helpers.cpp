// SPDX-License-Identifier: MIT
#include "scenes/src/scene_helpers.h"

#include "jostle/physics/hull.h"

namespace jostle::scenes {

using namespace physics;

SceneBody fixed_box(std::string name, Vec3 center, Vec3 half_extents, Quat rotation) {
    return {.name = std::move(name),
            .body = {.type = BodyType::static_body, .pose = {center, rotation}},
            .shapes = {{.geometry = Box{half_extents}}},
            .color = {}};
}

SceneBody ground() {
    return fixed_box("ground", {0, -1, 0}, {200, 1, 200});
}

SceneBody dynamic_body(std::string name, Vec3 position, Geometry geometry, Quat rotation) {
    return {.name = std::move(name),
            .body = {.pose = {position, rotation}},
            .shapes = {{.geometry = geometry}},
            .color = {}};
}

Geometry stone(Random& random, double radius) {
    std::vector<Vec3> points;
    for (int k = 0; k < 14; k++) {
        const double x = random.in(-1, 1), y = random.in(-1, 1), z = random.in(-1, 1);
        points.push_back(normalized(Vec3{x, y, z}) * radius);
    }
    // Fourteen random directions are never coplanar; the box is an unreachable fallback.
    const auto hull = build_hull(points);
    return hull.ok() ? Geometry(Hull{*hull}) : Geometry(Box{{radius, radius, radius}});
}

SceneBody colored(SceneBody body, std::uint32_t color) {
    body.color = color;
    return body;
}

namespace {

// Converts a frame in the world to the frame of a body in its initial pose.
Transform seen_from(const SceneBody& body, const Transform& frame) {
    const Transform& pose = body.body.pose;
    return {apply_inverse(pose, frame.position), conjugate(pose.rotation) * frame.rotation};
}

}  // namespace

void join(SceneDescription& scene, const char* name, std::size_t a, std::size_t b,
          const Transform& frame, const JointKind& kind) {
    SceneJoint joint{.name = name, .body_a = a, .body_b = b, .joint = {}};
    joint.joint.frame_a = seen_from(scene.bodies[a], frame);
    joint.joint.frame_b = seen_from(scene.bodies[b], frame);
    joint.joint.kind = kind;
    scene.joints.push_back(joint);
}

}  // namespace jostle::scenes
