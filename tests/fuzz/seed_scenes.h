// SPDX-License-Identifier: MIT
//
// Scenes and worlds to begin with: each as small as it can be, so that a run stays short.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "jostle/modules/particles.h"
#include "jostle/physics/world.h"
#include "jostle/v1/scene.pb.h"
#include "tests/support/world_builder.h"

namespace jostle::fuzz {

namespace detail {

// "link[3]", the fourth copy of a body, becomes a body of its own: "link_3".
inline std::string plain_name(std::string name) {
    std::erase(name, ']');
    std::ranges::replace(name, '[', '_');
    return name;
}

inline void add_body(v1::Scene& piece, const v1::Scene& whole, const std::string& name) {
    const std::string own = name.substr(0, name.find('['));
    const auto has = [](const std::string& bone_options) {
        return [bone_options](const v1::Body& body) { return body.name() == bone_options; };
    };
    if (std::ranges::any_of(piece.bodies(), has(plain_name(name)))) return;
    const auto at = std::ranges::find_if(whole.bodies(), has(own));
    if (at == whole.bodies().end()) return;
    v1::Body& body = *piece.add_bodies();
    body = *at;
    body.set_name(plain_name(name));
    body.clear_repeat();
    if (own != name) body.mutable_position()->set_x(body.position().x() + piece.bodies_size());
}

}  // namespace detail

// A scene in pieces: each joint with its bodies, and each kind of shape alone.
inline std::vector<v1::Scene> single_feature_scenes(const v1::Scene& whole) {
    std::vector<v1::Scene> pieces;
    const auto begin = [&]() -> v1::Scene& {
        v1::Scene& piece = pieces.emplace_back();
        piece.set_name("piece");
        *piece.mutable_world() = whole.world();
        return piece;
    };
    for (const v1::Joint& joint : whole.joints()) {
        v1::Scene& piece = begin();
        detail::add_body(piece, whole, joint.body_a());
        detail::add_body(piece, whole, joint.body_b());
        v1::Joint& own = *piece.add_joints();
        own = joint;
        own.clear_repeat();
        own.set_body_a(detail::plain_name(joint.body_a()));
        own.set_body_b(detail::plain_name(joint.body_b()));
    }
    std::vector<int> kinds;
    for (const v1::Body& body : whole.bodies())
        for (const v1::Shape& shape : body.shapes()) {
            if (std::ranges::find(kinds, shape.kind_case()) != kinds.end()) continue;
            kinds.push_back(shape.kind_case());
            v1::Body& own = *begin().add_bodies();
            own = body;
            own.clear_repeat();
        }
    return pieces;
}

// Particles of each kind: emitted on a body, linked by springs, in eddies, hitting each other.
inline std::vector<physics::World> particle_worlds() {
    using namespace physics;
    using namespace modules;
    using namespace test;
    ParticleGroupDef spray{.count_max = 12, .mass = 0.01, .world_fields = true};
    spray.emitter = {.shape = EmitterShape::disc, .position = {0, 2, 0}, .rate = 60, .cone = 1};
    spray.planes = {{}};
    ParticleGroupDef rope{.integrator = ParticleIntegrator::implicit_euler, .count_max = 3};
    ParticleGroupDef eddies{.integrator = ParticleIntegrator::runge_kutta_4, .count_max = 6};
    eddies.follow_flow = true;
    eddies.flow = {.speed = 1, .octaves = 1, .walls = {{}, {.radius = 2}}};
    eddies.emitter = {.burst = 6};
    ParticleGroupDef balls{.count_max = 8, .radius = 0.2, .collide_particles = true};
    balls.attractors = {{.point = {0, 1, 0}}};
    balls.emitter = {.shape = EmitterShape::box, .burst = 8};
    std::vector<World> worlds;
    for (const ParticleGroupDef& def : {spray, rope, eddies, balls}) {
        worlds.push_back(make_world());
        add_floor(worlds.back());
        add(worlds.back(), {.position = {0, 0.6, 0}});
        auto module = std::make_unique<Particles>();
        ParticleGroup& group = *module->group(must(module->add(worlds.back(), def)));
        if (def.integrator == ParticleIntegrator::implicit_euler) {
            must(group.add(
                std::vector<ParticleStart>{{.position = {1, 2, 0}}, {.position = {1, 1.5, 0}}}));
            must(group.add_springs(std::vector<ParticleSpring>{
                {.a = 0, .anchor = {1, 3, 0}, .rest_length = 1}, {.a = 1, .b = 0}}));
        }
        must(worlds.back().add_module(std::move(module)));
        test::run(worlds.back(), 0.2);
    }
    return worlds;
}

// Worlds with something of each store: touching, asleep, jointed, kinematic, triggered.
inline std::vector<physics::World> small_worlds() {
    using namespace physics;
    using namespace test;
    std::vector<World> worlds;
    const auto with_floor = [&](const WorldDef& def = {}) -> World& {
        worlds.push_back(make_world(def));
        add_floor(worlds.back());
        return worlds.back();
    };
    const auto two_boxes = [](World& world) {
        add(world, {.position = {0, 0.5, 0}});
        add(world, {.position = {0.1, 1.5, 0}, .velocity = {0.1, 0, 0}});
    };
    worlds.push_back(make_world());
    two_boxes(with_floor());
    test::run(worlds.back(), 0.2);
    two_boxes(with_floor());
    test::run(worlds.back(), 4);  // asleep
    two_boxes(with_floor({.tolerance = 1e-3}));
    test::run(worlds.back(), 0.4);
    two_boxes(with_floor({.planar = true}));
    test::run(worlds.back(), 0.1);
    // Fast, spinning and thin: continuous collision and gyroscopic bodies.
    World& fast = with_floor();
    add(fast, {.geometry = Box{{0.5, 0.02, 0.3}},
               .position = {0, 1, 0},
               .velocity = {0, -60, 0},
               .spin = {20, 30, 5}});
    add(fast, {.geometry = Capsule{0.1, 0.5}, .position = {0, 0.3, 0}, .spin = {0, 60, 1}});
    must(fast.step(1.0 / 60));
    // A trigger, a force field, a kinematic body, a hull.
    World& fair = with_floor();
    must(fair.create_body({.type = BodyType::static_body},
                          {.geometry = Sphere{1}, .trigger = true}));
    must(fair.create_field({.force = UniformWind{.velocity = {3, 0, 0}}}));
    add(fair, {.geometry = Box{{1, 0.1, 1}},
               .position = {0, 0.3, 0},
               .spin = {0, 1, 0},
               .type = BodyType::kinematic});
    const Vec3 corners[] = {{0.5, 0, 0}, {-0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}};
    add(fair, {.geometry = Hull{must(build_hull(corners))}, .position = {0, 0.9, 0}});
    test::run(fair, 0.3);
    for (World& world : particle_worlds()) worlds.push_back(std::move(world));
    return worlds;
}

}  // namespace jostle::fuzz
