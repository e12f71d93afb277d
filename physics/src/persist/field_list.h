// SPDX-License-Identifier: MIT
//
// ONE list of every persisted field. Save, load, hash and first difference are four visitors that
// walk it, so none of them can forget a field that another has. What is not here is derived
// (persist/derive.h) or scratch.
//
// A visitor v has: v.field(name, number&), for bools, integers, floats and enums; v.enter(name) /
// v.enter(index) and v.leave() for the path; v.count(name, size) -> size, which a loader replaces
// by what it reads (and bounds); and kLoading.
#pragma once

#include <string_view>

#include "state/lanes.h"
#include "state/world_state.h"

namespace jostle::physics {

template <class V>
void visit(V& v, std::string_view name, Vec3& x) {
    v.enter(name);
    v.field("x", x.x);
    v.field("y", x.y);
    v.field("z", x.z);
    v.leave();
}
template <class V>
void visit(V& v, std::string_view name, Quat& q) {
    v.enter(name);
    v.field("x", q.x);
    v.field("y", q.y);
    v.field("z", q.z);
    v.field("w", q.w);
    v.leave();
}
template <class V>
void visit(V& v, std::string_view name, Mat3& m) {
    v.enter(name);
    visit(v, "x", m.x);
    visit(v, "y", m.y);
    visit(v, "z", m.z);
    v.leave();
}
template <class V>
void visit(V& v, std::string_view name, Aabb& box) {
    v.enter(name);
    visit(v, "low", box.low);
    visit(v, "high", box.high);
    v.leave();
}

// An array of records: its length, then each under its index.
template <class V, class T, class Each>
void visit_all(V& v, std::string_view name, std::vector<T>& items, Each&& each) {
    v.enter(name);
    const std::size_t count = v.count("size", items.size());
    if constexpr (V::kLoading) items.resize(count);
    for (std::size_t i = 0; i < items.size(); i++) {
        v.enter(i);
        each(items[i]);
        v.leave();
    }
    v.leave();
}

template <class V>
void visit(V& v, std::string_view name, IdPool& ids) {
    v.enter(name);
    visit_all(v, "generation", ids.generations(), [&](auto& x) { v.field("", x); });
    visit_all(v, "alive", ids.alive_flags(), [&](auto& x) { v.field("", x); });
    v.leave();
}

template <class V>
void visit_fields(V& v, BodyCold& b) {
    v.field("type", b.type);
    v.field("may_sleep", b.may_sleep);
    v.field("linear_damping", b.linear_damping);
    v.field("angular_damping", b.angular_damping);
    v.field("gravity_scale", b.gravity_scale);
    v.field("user_data", b.user_data);
    v.field("mass", b.mass);
    v.field("inverse_mass", b.inverse_mass);
    visit(v, "inertia", b.inertia);
    visit(v, "inverse_inertia", b.inverse_inertia);
    visit(v, "local_center", b.local_center);
    v.field("radius", b.radius);
    v.field("isotropic", b.isotropic);
    v.field("set", b.set);
    v.field("at", b.at);
    v.field("first_shape", b.first_shape);
    v.field("last_shape", b.last_shape);
    v.field("first_edge", b.first_edge);
    v.field("island", b.island);
    v.field("island_prev", b.island_prev);
    v.field("island_next", b.island_next);
    v.field("colours", b.colours);
    v.field("lanes", b.lanes);
}

template <class V>
void visit_fields(V& v, BodyWarm& b) {
    v.field("body", b.body);
    visit(v, "center", b.center);
    visit(v, "rotation", b.rotation);
    visit(v, "v", b.v);
    visit(v, "w", b.w);
    visit(v, "force", b.force);
    visit(v, "torque", b.torque);
    v.field("quiet", b.quiet);
}

// A loader makes the kind first; an unknown kind is its error to report.
template <class V>
void visit_geometry(V& v, Geometry& geometry) {
    auto kind = static_cast<std::uint8_t>(geometry.index());
    v.field("kind", kind);
    if constexpr (V::kLoading) {
        switch (kind) {
            case 0:
                geometry = Sphere{};
                break;
            case 1:
                geometry = Capsule{};
                break;
            case 2:
                geometry = Box{};
                break;
            case 3:
                geometry = Plane{};
                break;
            default:
                v.fail("kind", "is not a shape kind");
                return;
        }
    }
    if (auto* sphere = std::get_if<Sphere>(&geometry)) v.field("radius", sphere->radius);
    if (auto* capsule = std::get_if<Capsule>(&geometry)) {
        v.field("radius", capsule->radius);
        v.field("half_length", capsule->half_length);
    }
    if (auto* box = std::get_if<Box>(&geometry)) visit(v, "half_extents", box->half_extents);
    if (auto* plane = std::get_if<Plane>(&geometry)) visit(v, "normal", plane->normal);
}

template <class V>
void visit_fields(V& v, ShapeRecord& s) {
    visit_geometry(v, s.geometry);
    visit(v, "position", s.pose.position);
    visit(v, "rotation", s.pose.rotation);
    v.field("friction", s.material.friction);
    v.field("restitution", s.material.restitution);
    v.field("density", s.density);
    v.field("body", s.body);
    v.field("next", s.next);
    visit(v, "fat", s.fat);
    v.field("moved", s.moved);
}

template <class V>
void visit_fields(V& v, Contact& c) {
    v.field("shape_a", c.shape_a);
    v.field("shape_b", c.shape_b);
    v.field("body_a", c.body_a);
    v.field("body_b", c.body_b);
    v.field("colour", c.colour);
    v.field("slot", c.slot);
    v.field("axis", c.axis);
    v.field("touching", c.touching);
    v.field("waiting", c.waiting);
    v.field("dormant", c.dormant);
    v.field("limit", c.limit);
    for (int side = 0; side < 2; side++) {
        v.field("next", c.next[side]);
        v.field("prev", c.prev[side]);
    }
}

template <class V>
void visit_fields(V& v, SavedManifold& m) {
    v.field("contact", m.contact);
    for (float& row : m.rows) v.field("row", row);
    v.field("moved", m.moved);
    v.field("restitution", m.restitution);
    v.field("aged", m.aged);
}

// The lanes of one colour in order: order decides the bits of a solve.
template <class V>
void visit_fields(V& v, Colour& colour, int index) {
    const std::size_t count = v.count("lanes", static_cast<std::size_t>(colour.lanes));
    if constexpr (V::kLoading) {
        colour.lanes = static_cast<std::int32_t>(count);
        const std::size_t per_block = static_cast<std::size_t>(lanes_per_block(index));
        for (std::size_t k = 0; k < count; k += per_block) add_block(colour);
    }
    for (std::int32_t slot = 0; slot < colour.lanes; slot++) {
        v.enter(static_cast<std::size_t>(slot));
        const auto block = static_cast<std::size_t>(slot / lanes_per_block(index));
        const int lane = slot % lanes_per_block(index);
        BlockSide& side = colour.sides[block];
        v.field("contact", side.contact[lane]);
        for (int row = 2; row < manifold_rows; row++)
            v.field("row", *lane_float(colour.blocks[block], row, lane));
        v.field("moved", side.moved[lane]);
        v.field("restitution", side.restitution[lane]);
        auto aged = static_cast<std::uint8_t>(side.aged >> lane & 1);
        v.field("aged", aged);
        if constexpr (V::kLoading) side.aged |= static_cast<std::uint8_t>((aged & 1) << lane);
        v.leave();
    }
}

template <class V>
void visit_fields(V& v, Island& island) {
    v.field("first", island.first);
    v.field("last", island.last);
    v.field("bodies", island.bodies);
    v.field("may_be_split", island.may_be_split);
    v.field("asleep", island.asleep);
    visit_all(v, "sleepers", island.sleepers, [&](BodyWarm& b) { visit_fields(v, b); });
    visit_all(v, "manifolds", island.manifolds, [&](SavedManifold& m) { visit_fields(v, m); });
}

template <class V>
void visit_world(V& v, WorldState& world) {
    v.enter("world");
    visit(v, "gravity", world.def.gravity);
    v.field("substeps", world.def.substeps);
    v.field("sleeping", world.def.sleeping);
    v.field("steps", world.steps);
    v.field("last_dt", world.last_dt);
    v.leave();

    v.enter("bodies");
    visit(v, "ids", world.bodies.ids);
    visit_all(v, "cold", world.bodies.cold, [&](BodyCold& b) { visit_fields(v, b); });
    visit_all(v, "reach", world.bodies.reach, [&](BodyReach& r) {
        v.field("travel", r.travel);
        v.field("reach", r.reach);
    });
    visit_all(v, "fixed", world.bodies.fixed, [&](BodyWarm& b) { visit_fields(v, b); });
    visit_all(v, "awake", world.bodies.awake, [&](BodyWarm& b) { visit_fields(v, b); });
    v.leave();

    v.enter("shapes");
    visit(v, "ids", world.shapes.ids);
    visit_all(v, "shapes", world.shapes.shapes, [&](ShapeRecord& s) { visit_fields(v, s); });
    visit_all(v, "moved", world.shapes.moved, [&](std::uint32_t& s) { v.field("", s); });
    v.leave();

    v.enter("contacts");
    visit(v, "ids", world.contacts.ids);
    visit_all(v, "contacts", world.contacts.contacts, [&](Contact& c) { visit_fields(v, c); });
    visit_all(v, "waiting", world.contacts.waiting, [&](Waiting& w) {
        v.field("contact", w.contact);
        v.field("body_a", w.body_a);
        v.field("body_b", w.body_b);
        v.field("limit", w.limit);
    });
    v.leave();

    v.enter("manifolds");
    for (int c = 0; c < colour_count; c++) {
        v.enter(static_cast<std::size_t>(c));
        visit_fields(v, world.manifolds.colours[static_cast<std::size_t>(c)], c);
        v.leave();
    }
    v.leave();

    v.enter("islands");
    visit(v, "ids", world.islands.ids);
    visit_all(v, "islands", world.islands.islands, [&](Island& i) { visit_fields(v, i); });
    v.leave();
}

}  // namespace jostle::physics
