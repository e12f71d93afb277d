// SPDX-License-Identifier: MIT
//
// The fields of a group's definition with their ranges, listed once: for settings of scenes, for
// checks, for saved state and for clients. A visitor F has
//     choice(name, enumeration, last)     count(name, uint32, low, high)
//     whole(name, int32, low, high)       flag(name, bool)
//     number(name, double, low, high)     vector(name, Vec3, most of a component)
//     direction(name, Vec3)               enter(name), leave()
//     list(name, vector, most, visit_item)
// The order is the order of saved bytes.
#pragma once

#include "jostle/modules/particle_group.h"
#include "jostle/physics/limits.h"

namespace jostle::modules::particles_detail {

inline constexpr double coordinate_max = physics::limits::max_coordinate;
inline constexpr double speed_max = physics::limits::max_speed;

template <class F>
void visit_emitter(F& f, Emitter& e) {
    f.choice("shape", e.shape, EmitterShape::sphere);
    f.vector("position", e.position, coordinate_max);
    f.direction("direction", e.direction);
    f.number("radius", e.radius, 0, 1e4);
    f.vector("half_extents", e.half_extents, 1e4);
    f.number("rate", e.rate, 0, 1e6);
    f.count("burst", e.burst, 0, 1e5);
    f.number("burst_period", e.burst_period, 0, 1e6);
    f.number("start", e.start, 0, 1e12);
    f.number("duration", e.duration, 0, 1e12);
    f.number("speed", e.speed, 0, speed_max);
    f.number("speed_spread", e.speed_spread, 0, 1);
    f.number("cone", e.cone, 0, 3.141592653589794);
    f.number("lifetime", e.lifetime, 1e-3, 1e6);
    f.number("lifetime_spread", e.lifetime_spread, 0, 1);
    f.count("seed", e.seed, 0, 4294967295.0);
}

template <class F>
void visit_flow(F& f, ParticleFlow& flow) {
    f.vector("wind", flow.wind, speed_max);
    f.number("speed", flow.speed, 0, 1e3);
    f.number("scale", flow.scale, 0.01, 1e6);
    f.number("rate", flow.rate, 0, 1e3);
    f.count("octaves", flow.octaves, 1, 8);
    f.count("seed", flow.seed, 0, 4294967295.0);
    f.number("ramp", flow.ramp, 1e-3, 1e6);
    f.list("walls", flow.walls, ParticleFlow::walls_max, [&](FlowWall& wall) {
        f.vector("point", wall.point, coordinate_max);
        f.direction("normal", wall.normal);
        f.number("radius", wall.radius, 0, 1e6);
        f.flag("inside", wall.inside);
    });
}

template <class F>
void visit_def(F& f, ParticleGroupDef& d) {
    f.choice("integrator", d.integrator, ParticleIntegrator::runge_kutta_4);
    f.count("substeps", d.substeps, 1, 64);
    f.count("count_max", d.count_max, 1, ParticleGroupDef::particles_max);
    f.number("mass", d.mass, 1e-9, 1e6);
    f.number("radius", d.radius, 0, 100);
    f.number("gravity_scale", d.gravity_scale, -1e3, 1e3);
    f.number("linear_drag", d.linear_drag, 0, 1e6);
    f.number("quadratic_drag", d.quadratic_drag, 0, 1e6);
    f.flag("follow_flow", d.follow_flow);
    f.flag("world_fields", d.world_fields);
    f.count("category", d.category, 0, 4294967295.0);
    f.number("attraction", d.attraction, -1e12, 1e12);
    f.number("softening", d.softening, 1e-6, 1e4);
    f.flag("collide_bodies", d.collide_bodies);
    f.count("body_categories", d.body_categories, 0, 4294967295.0);
    f.flag("collide_particles", d.collide_particles);
    f.number("restitution", d.restitution, 0, 1);
    f.number("friction", d.friction, 0, 10);
    f.flag("planar", d.planar);
    f.flag("cosmetic", d.cosmetic);
    f.count("color", d.color, 0, 0xffffff);
    f.enter("emitter");
    visit_emitter(f, d.emitter);
    f.leave();
    f.enter("flow");
    visit_flow(f, d.flow);
    f.leave();
    f.list("attractors", d.attractors, ParticleGroupDef::attractors_max,
           [&](ParticleAttractor& attractor) {
               f.vector("point", attractor.point, coordinate_max);
               f.number("strength", attractor.strength, -1e9, 1e9);
               f.whole("falloff", attractor.falloff, -1, 4);
               f.number("min_distance", attractor.min_distance, 1e-6, 1e6);
           });
    f.list("planes", d.planes, ParticleGroupDef::planes_max, [&](ParticlePlane& plane) {
        f.direction("normal", plane.normal);
        f.number("offset", plane.offset, -coordinate_max, coordinate_max);
    });
}

/// Adapts the list to a StateVisitor. Ranges are checked afterwards with check().
class StateFields {
public:
    explicit StateFields(physics::StateVisitor& v) : v_(v) {}

    template <class E>
    void choice(std::string_view name, E& value, E last) {
        v_.field(name, value, last);
    }
    void count(std::string_view name, std::uint32_t& value, double, double) {
        v_.field(name, value);
    }
    void whole(std::string_view name, std::int32_t& value, double, double) {
        v_.field(name, value);
    }
    void flag(std::string_view name, bool& value) { v_.field(name, value); }
    void number(std::string_view name, double& value, double, double) { v_.field(name, value); }
    void vector(std::string_view name, physics::Vec3& value, double) { v_.field(name, value); }
    void direction(std::string_view name, physics::Vec3& value) { v_.field(name, value); }
    void enter(std::string_view name) { v_.enter(name); }
    void leave() { v_.leave(); }
    template <class Item, class Visit>
    void list(std::string_view name, std::vector<Item>& items, std::size_t most, Visit&& visit) {
        v_.all(name, items, [&](Item& item) {
            if (items.size() <= most) visit(item);
        });
        if (v_.loading() && items.size() > most)
            v_.fail(name, "has more than " + std::to_string(most) + " elements");
    }

private:
    physics::StateVisitor& v_;
};

}  // namespace jostle::modules::particles_detail
