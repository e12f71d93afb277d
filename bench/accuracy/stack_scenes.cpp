// SPDX-License-Identifier: MIT
#include "bench/accuracy/stack_scenes.h"

#include <cmath>

#include "bench/accuracy/accuracy_bodies.h"

namespace jostle::bench::accuracy {
namespace {

using physics::pi;

// A wedge between two angles of the semicircle. It is built upright, where its principal axes are
// the world's axes, then rotated and moved.
Body wedge(double from, double to, double inner_radius, double outer_radius) {
    const double half_angle = 0.5 * (to - from);
    std::vector<Vec3> corners;
    for (const double radius : {inner_radius, outer_radius})
        for (const double side : {-1.0, 1.0})
            for (const double y : {-0.2, 0.2})
                corners.push_back(
                    {side * radius * std::sin(half_angle), y, radius * std::cos(half_angle)});
    Body body = solid_hull(1000, corners);
    const Quat turned = physics::from_axis_angle({0, 1, 0}, 0.5 * (from + to) - 0.5 * pi);
    body.pose = {rotate(turned, body.pose.position), turned};
    return body;
}

}  // namespace

Scene box_stack(int count, Vec3 half_extents, double mass) {
    Scene scene{.name = "stack", .friction = 0.5, .planar = true};
    for (int k = 0; k < count; k++)
        scene.bodies.push_back(solid_box(mass, half_extents, {0, 0, half_extents.z * (2 * k + 1)}));
    scene.bodies.push_back(fixed_plane());
    return scene;
}

// The inner upper edges of the cards meet above the origin; each stands on an edge.
Scene leaning_cards(double friction) {
    const double lean = 20 * pi / 180, half_height = 0.5, half_thickness = 0.01;
    Scene scene{.name = "cards", .friction = friction, .planar = true};
    for (const double side : {-1.0, 1.0}) {
        const double out = half_height * std::sin(lean) + half_thickness * std::cos(lean);
        const double up = half_height * std::cos(lean) + half_thickness * std::sin(lean);
        Body card = solid_box(1, {half_thickness, 0.4, half_height}, {side * out, 0, up});
        card.pose.rotation = physics::from_axis_angle({0, 1, 0}, -side * lean);
        scene.bodies.push_back(card);
    }
    scene.bodies.push_back(fixed_plane());
    return scene;
}

// Angles run from -x over the top to +x.
Scene arch(double inner_radius, double outer_radius) {
    constexpr int wedges = 15;
    Scene scene{.name = "arch", .friction = 0.7};
    for (int k = 0; k < wedges; k++)
        scene.bodies.push_back(
            wedge(k * pi / wedges, (k + 1) * pi / wedges, inner_radius, outer_radius));
    scene.bodies.push_back(fixed_plane());
    return scene;
}

}  // namespace jostle::bench::accuracy
