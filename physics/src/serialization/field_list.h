// SPDX-License-Identifier: MIT
//
// The list of all persisted fields. Save, load, hash and first difference are four visitors of this
// list, so all of them cover the same fields. Other data is derived (serialization/derive.h) or
// scratch.
//
// A visitor v provides:
// - v.field(name, number&) for bools, integers, floats and enums;
// - v.enter(name) / v.enter(index) and v.leave() for the path;
// - v.count(name, size) -> size, which a loader replaces with the loaded size (and bounds);
// - v.optional(name, number&, version) for a field that is usually zero and was added in a version
//   of saved worlds: saved like any other field, but a zero does not change the hash;
// - v.unhashed(name, number&, version), likewise, but never hashed;
// - kLoading.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "jostle/physics/joint_fields.h"
#include "physics/src/serialization/module_visitor.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/world_state.h"

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

// Sets the variant to its alternative with this index, default-constructed. Returns false if there
// is none.
template <class... Kinds>
bool make_kind(std::size_t kind, std::variant<Kinds...>& value) {
    std::size_t at = 0;
    static_cast<void>(((at++ == kind ? (value = Kinds{}, true) : false) || ...));
    return kind < sizeof...(Kinds);
}

// Visits an array of records: its length, then each record under its index.
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
    v.field("may_sleep", b.sleep_allowed);
    v.field("linear_damping", b.linear_damping);
    v.field("angular_damping", b.angular_damping);
    v.field("gravity_scale", b.gravity_scale);
    v.field("continuous", b.continuous);
    v.field("locks", b.locks);
    v.field("mass_override", b.mass_override);
    v.field("user_data", b.user_data);
    v.field("mass", b.mass);
    v.field("inverse_mass", b.inverse_mass);
    visit(v, "inertia", b.inertia);
    visit(v, "inverse_inertia", b.inverse_inertia);
    visit(v, "local_center", b.local_center);
    v.field("radius", b.radius);
    v.field("inner_radius", b.inner_radius);
    v.field("isotropic", b.isotropic);
    v.field("set", b.set);
    v.field("at", b.at);
    v.field("asleep_in_place", b.asleep_in_place);
    v.field("first_shape", b.first_shape);
    v.field("last_shape", b.last_shape);
    v.field("first_edge", b.first_edge);
    v.field("first_joint", b.first_joint);
    v.field("island", b.island);
    v.field("island_prev", b.island_prev);
    v.field("island_next", b.island_next);
    v.field("colours", b.colours);
    v.field("constraints", b.constraints);
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
    v.field("sleep_time", b.sleep_time);
    visit(v, "drift", b.drift);
    visit(v, "drift_turn", b.drift_turn);
}

template <class V>
void visit(V& v, std::string_view name, Transform& t) {
    v.enter(name);
    visit(v, "position", t.position);
    visit(v, "rotation", t.rotation);
    v.leave();
}

// A loader creates the kind first and reports an unknown kind. Shared data is visited by reference:
// v.shared writes or reads its index in the table of shared geometry, and hashes its content.
template <class V>
void visit_geometry(V& v, Geometry& geometry) {
    auto kind = static_cast<std::uint8_t>(geometry.index());
    v.field("kind", kind);
    if constexpr (V::kLoading) {
        if (!make_kind(kind, geometry)) {
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
    if (auto* cylinder = std::get_if<Cylinder>(&geometry)) {
        v.field("radius", cylinder->radius);
        v.field("half_length", cylinder->half_length);
    }
    if (auto* cone = std::get_if<Cone>(&geometry)) {
        v.field("radius", cone->radius);
        v.field("half_length", cone->half_length);
    }
    if (auto* hull = std::get_if<Hull>(&geometry)) v.shared("hull", hull->data);
    if (auto* mesh = std::get_if<Mesh>(&geometry)) v.shared("mesh", mesh->data);
    if (auto* field = std::get_if<HeightField>(&geometry)) v.shared("height_field", field->data);
    if (auto* compound = std::get_if<Compound>(&geometry)) v.shared("compound", compound->data);
}

template <class V>
void visit_fields(V& v, Material& m) {
    v.field("friction", m.friction);
    v.field("restitution", m.restitution);
    v.field("rolling_friction", m.rolling_friction);
    v.field("torsional_friction", m.torsional_friction);
    visit(v, "surface_velocity", m.surface_velocity);
    v.field("friction_rule", m.friction_rule);
    v.field("restitution_rule", m.restitution_rule);
}

template <class V>
void visit_fields(V& v, ShapeRecord& s) {
    visit_geometry(v, s.geometry);
    visit(v, "position", s.pose.position);
    visit(v, "rotation", s.pose.rotation);
    visit_fields(v, s.material);
    v.field("density", s.density);
    v.field("mass", s.mass);
    v.field("category", s.filter.category);
    v.field("mask", s.filter.mask);
    v.field("group", s.filter.group);
    v.field("trigger", s.trigger);
    v.field("report_stays", s.report_stays);
    v.optional("user_data", s.user_data, 9);
    v.field("body", s.body);
    v.field("next", s.next);
    visit(v, "fat", s.fat);
    v.field("moved", s.moved);
}

// The fields of a joint kind as listed in its table (jostle/physics/joint_fields.h).
template <class V>
struct JointFieldList {
    V& v;

    void number(const char* name, double& x, double low, double high) {
        v.field(name, x);
        if constexpr (V::kLoading)
            if (!(x >= low && x <= high)) v.fail(name, "is out of range");
    }
    void ordered(const char* lower_name, double& lower, const char* upper_name, double& upper,
                 double low, double high) {
        number(lower_name, lower, low, high);
        number(upper_name, upper, lower, high);
    }
    void vector(const char* name, Vec3& x, double limit) {
        v.enter(name);
        number("x", x.x, -limit, limit);
        number("y", x.y, -limit, limit);
        number("z", x.z, -limit, limit);
        v.leave();
    }
    void flag(const char* name, bool& x) { v.field(name, x); }
    void later(const char* name, double& x, double low, double high, std::uint32_t since) {
        v.optional(name, x, since);
        if constexpr (V::kLoading)
            if (!(x >= low && x <= high)) v.fail(name, "is out of range");
    }
    // A drive without a spring is saved as a single zero.
    void drive(const char* name, RotationDrive& drive) {
        v.enter(name);
        later("hertz", drive.spring.hertz, 0, 1e4, 12);
        if (drive.spring.hertz > 0) {
            number("damping_ratio", drive.spring.damping_ratio, 0, 1e4);
            visit(v, "target", drive.target);
            number("max_torque", drive.max_torque, 0, 1e12);
            if constexpr (V::kLoading)
                if (!(norm_squared(drive.target) > 1e-6)) v.fail("target", "is not a rotation");
        }
        v.leave();
    }
    void points(const char* name, std::vector<Vec3>& points, std::size_t least, std::size_t most,
                double limit) {
        visit_all(v, name, points, [&](Vec3& x) { vector("", x, limit); });
        if constexpr (V::kLoading) {
            if (points.size() < least || points.size() > most)
                return v.fail(name, "has too few or too many points");
            for (std::size_t k = 1; k < points.size(); k++)
                if (!(length(points[k] - points[k - 1]) >= 1e-6))
                    return v.fail(name, "has two equal adjacent points");
        }
    }
    void limit(const char* name, JointLimit& limit, double low, double high) {
        v.enter(name);
        v.field("enabled", limit.enabled);
        visit_limit(*this, limit, low, high);
        v.leave();
    }
    void motor(const char* name, auto& motor) {
        v.enter(name);
        v.field("enabled", motor.enabled);
        visit_motor(*this, motor);
        v.leave();
    }
    void spring(const char* name, JointSpring& spring) {
        v.enter(name);
        visit_spring(*this, spring);
        v.leave();
    }
    void axis(const char* name, JointAxis& axis, double low, double high) {
        v.enter(name);
        visit_axis(*this, axis, low, high);
        v.leave();
    }
};

template <class V>
void visit_kind(V& v, JointKind& joint) {
    auto kind = static_cast<std::uint8_t>(joint.index());
    v.field("kind", kind);
    if constexpr (V::kLoading) {
        if (!make_kind(kind, joint)) {
            v.fail("kind", "is not a joint kind");
            return;
        }
    }
    std::visit(
        [&]<class Kind>(Kind& fields) {
            JointFieldList<V> list{v};
            JointFields<Kind>::visit(list, fields);
        },
        joint);
}

// 0: the world's default.
template <class V>
void visit_solver(V& v, std::optional<JointSolver>& solver) {
    std::uint8_t number = solver ? static_cast<std::uint8_t>(static_cast<int>(*solver) + 1) : 0;
    v.optional("solver", number, 14);
    if constexpr (V::kLoading) {
        if (number > static_cast<int>(JointSolver::direct) + 1)
            return v.fail("solver", "is not one of its values");
        if (number > 0) solver = static_cast<JointSolver>(number - 1);
    }
}

template <class V>
void visit_fields(V& v, Joint& j) {
    v.field("body_a", j.body_a);
    v.field("body_b", j.body_b);
    visit(v, "frame_a", j.frame_a);
    visit(v, "frame_b", j.frame_b);
    visit_kind(v, j.kind);
    v.field("collide_connected", j.collide_connected);
    v.field("break_force", j.break_force);
    v.field("break_torque", j.break_torque);
    v.field("user_data", j.user_data);
    visit_solver(v, j.solver);
    visit(v, "point", j.point);
    visit(v, "angular", j.angular);
    v.field("lower", j.lower);
    v.field("upper", j.upper);
    v.field("swing_impulse", j.swing);
    v.field("spring_impulse", j.spring);
    v.field("motor", j.motor);
    visit(v, "friction", j.friction);
    visit(v, "force", j.force);
    visit(v, "torque", j.torque);
    if (const std::size_t numbers = memory_of(j.kind); numbers > 0) {
        if constexpr (V::kLoading) j.memory.resize(numbers);
        v.enter("memory");
        for (std::size_t i = 0; i < numbers; i++) {
            v.enter(i);
            v.field("", j.memory[i]);
            v.leave();
        }
        v.leave();
    }
    for (int side = 0; side < 2; side++) {
        v.field("next", j.next[side]);
        v.field("prev", j.prev[side]);
    }
}

template <class V>
void visit_fields(V& v, Contact& c) {
    v.field("shape_a", c.shape_a);
    v.field("shape_b", c.shape_b);
    v.field("body_a", c.body_a);
    v.field("body_b", c.body_b);
    v.field("colour", c.colour);
    v.field("tier", c.colour_set.tier);
    v.field("batch", c.colour_set.batch);
    v.field("slot", c.slot);
    v.field("axis", c.cache.axis);
    visit(v, "direction", c.cache.direction);
    v.field("touching", c.touching);
    v.field("has_bound", c.has_bound);
    v.field("dormant", c.dormant);
    v.field("limit", c.limit);
    for (float& x : c.load) v.field("load", x);
    v.field("composite", c.composite);
    v.field("parent", c.parent);
    v.field("first_child", c.first_child);
    v.field("next_child", c.next_child);
    v.field("key", c.key);
    v.field("touching_children", c.touching_children);
    for (int side = 0; side < 2; side++) {
        v.field("next", c.next[side]);
        v.field("prev", c.prev[side]);
    }
}

template <class V>
void visit_fields(V& v, SavedContact& m) {
    v.field("contact", m.contact);
    for (float& row : m.rows) v.field("row", row);
    v.field("rolls", m.rolls);
    if (m.rolls)
        for (float& row : m.rolling_values) v.field("rolling_value", row);
    v.field("moved", m.moved);
    v.field("restitution", m.restitution);
    v.field("needs_rebuild", m.needs_rebuild);
}

// The contacts of one colour in order, because the order determines the bits of a solve.
template <class V>
void visit_fields(V& v, GraphColour& colour, int index) {
    const std::size_t count = v.count("contacts", static_cast<std::size_t>(colour.contacts));
    if constexpr (V::kLoading) {
        colour.contacts = static_cast<std::int32_t>(count);
        const std::size_t per_block = static_cast<std::size_t>(lanes_per_block(index));
        for (std::size_t k = 0; k < count; k += per_block) add_block(colour);
    }
    for (std::int32_t slot = 0; slot < colour.contacts; slot++) {
        v.enter(static_cast<std::size_t>(slot));
        const auto block = static_cast<std::size_t>(slot / lanes_per_block(index));
        const int lane = slot % lanes_per_block(index);
        ContactConstraintWideMeta& meta = colour.metas[block];
        v.field("contact", meta.contact[lane]);
        for (int row = 2; row < wide_rows; row++)
            v.field("row", float_at(colour.blocks[block], row, lane));
        auto rolls = static_cast<std::uint8_t>(meta.has(LaneFlag::rolls, lane) ? 1 : 0);
        v.field("rolls", rolls);
        if constexpr (V::kLoading) meta.set(LaneFlag::rolls, lane, (rolls & 1) != 0);
        if ((rolls & 1) != 0)
            for (int row = 0; row < rolling_rows; row++)
                v.field("rolling_value", float_at(colour.rollings[block], row, lane));
        v.field("moved", meta.moved[lane]);
        v.field("restitution", meta.restitution[lane]);
        auto rebuild = static_cast<std::uint8_t>(meta.has(LaneFlag::needs_rebuild, lane) ? 1 : 0);
        v.field("needs_rebuild", rebuild);
        if constexpr (V::kLoading) meta.set(LaneFlag::needs_rebuild, lane, (rebuild & 1) != 0);
        v.leave();
    }
}

template <class V>
void visit_fields(V& v, ColourSet& set) {
    const std::size_t lanes = v.count("contacts", static_cast<std::size_t>(set.contacts));
    if (lanes == 0) return;
    if constexpr (V::kLoading) set.contacts = 0;
    for (int c = 0; c < colour_count; c++) {
        v.enter(static_cast<std::size_t>(c));
        visit_fields(v, set.colours[static_cast<std::size_t>(c)], c);
        v.leave();
        if constexpr (V::kLoading)
            set.contacts += set.colours[static_cast<std::size_t>(c)].contacts;
    }
    if constexpr (V::kLoading)
        if (static_cast<std::size_t>(set.contacts) != lanes)
            v.fail("contacts", "does not match the contacts of its colours");
}

template <class V>
void visit_fields(V& v, Island& island) {
    v.field("first", island.first);
    v.field("last", island.last);
    v.field("bodies", island.bodies);
    v.field("may_be_split", island.may_be_split);
    v.field("split_at", island.split_at);
    v.field("asleep", island.asleep);
    v.field("tier", island.colour_set.tier);
    v.field("batch", island.colour_set.batch);
    v.field("calm", island.calm);
    v.field("uneven", island.uneven);
    v.field("mass", island.mass);
    v.field("remaining_load", island.remaining_load);
    v.optional("dt", island.dt, 11);
    v.optional("error_estimate", island.error.estimate, 13);
    v.optional("wanted_rung", island.error.target_level, 13);
    v.optional("easy", island.error.easy, 13);
    v.optional("fresh_estimate", island.error.fresh, 13);
    visit_all(v, "sleepers", island.sleepers, [&](BodyWarm& b) { visit_fields(v, b); });
    visit_all(v, "manifolds", island.manifolds, [&](SavedContact& m) { visit_fields(v, m); });
}

template <class V>
void visit_fields(V& v, UniformWind& wind) {
    visit(v, "velocity", wind.velocity);
    visit(v, "gust", wind.gust);
    v.field("gust_period", wind.gust_period);
    v.field("density", wind.density);
    v.field("drag", wind.drag);
}
template <class V>
void visit_fields(V& v, RadialField& radial) {
    visit(v, "center", radial.center);
    v.field("strength", radial.strength);
    v.field("falloff", radial.falloff);
    v.field("nearest", radial.min_distance);
    v.field("per_mass", radial.per_mass);
}
template <class V>
void visit_fields(V& v, VortexField& vortex) {
    visit(v, "center", vortex.center);
    visit(v, "axis", vortex.axis);
    v.field("strength", vortex.strength);
    v.field("pull", vortex.pull);
    v.field("lift", vortex.lift);
    v.field("falloff", vortex.falloff);
    v.field("nearest", vortex.min_distance);
    v.field("per_mass", vortex.per_mass);
}
template <class V>
void visit_fields(V& v, BuoyancyField& fluid) {
    visit(v, "normal", fluid.normal);
    v.field("offset", fluid.offset);
    v.field("density", fluid.density);
    visit(v, "flow", fluid.flow);
    v.field("drag", fluid.drag);
    v.field("angular_drag", fluid.angular_drag);
}
template <class V>
void visit_fields(V& v, FieldDef& field) {
    auto kind = static_cast<std::uint8_t>(field.force.index());
    v.field("kind", kind);
    if constexpr (V::kLoading)
        if (!make_kind(kind, field.force)) return v.fail("kind", "is not a kind of force field");
    std::visit([&](auto& force) { visit_fields(v, force); }, field.force);
    bool bounded = field.region.has_value();
    v.field("bounded", bounded);
    if (bounded) {
        Aabb region = field.region.value_or(Aabb{});
        visit(v, "region", region);
        field.region = region;
    }
    v.field("mask", field.mask);
    v.field("user_data", field.user_data);
}

// Data that exists only if it was added from outside: force fields, and contact modifiers of
// listeners.
template <class V>
void visit_entry_points(V& v, WorldStores& world) {
    v.unhashed("time", world.time, 10);
    auto fields = world.fields.ids.size();
    v.optional("fields", fields, 10);
    if (fields > 0) {
        v.enter("fields");
        v.field("time", world.time);
        visit(v, "ids", world.fields.ids);
        visit_all(v, "fields", world.fields.fields, [&](FieldDef& f) { visit_fields(v, f); });
        v.leave();
    }
    auto modifiers = static_cast<std::uint32_t>(world.contacts.modifiers.size());
    v.optional("answers", modifiers, 10);
    if (modifiers > 0) {
        v.enter("contacts");
        visit_all(v, "answers", world.contacts.modifiers, [&](ContactModifier& a) {
            v.field("contact", a.contact);
            v.field("friction", a.friction);
            v.field("restitution", a.restitution);
            visit(v, "surface_velocity", a.surface_velocity);
            v.field("enabled", a.enabled);
        });
        v.leave();
    }
}

// All fields except those of the modules, which follow.
template <class V>
void visit_stores(V& v, WorldStores& world) {
    v.enter("world");
    visit(v, "gravity", world.def.gravity);
    v.field("substeps", world.def.substeps);
    v.field("sleeping", world.def.sleeping);
    v.field("continuous", world.def.continuous);
    v.field("planar", world.def.planar);
    v.field("hit_speed", world.def.hit_speed);
    v.optional("joint_solver", world.def.joint_solver, 14);
    v.optional("tolerance", world.def.tolerance, 13);
    v.optional("substep_budget", world.def.substep_budget, 13);
    v.optional("step_budget", world.def.step_budget, 15);
    v.optional("strain", world.overload_level.level, 15);
    v.optional("easy_steps", world.overload_level.easy, 15);
    v.field("steps", world.steps);
    v.field("last_dt", world.last_dt);
    v.optional("stiffness_dt", world.stiffness_dt, 18);
    v.optional("size_levels", world.size_levels, 19);
    v.optional("max_pairs_per_shape", world.def.max_pairs_per_shape, 20);
    v.leave();

    v.enter("bodies");
    visit(v, "ids", world.bodies.ids);
    visit_all(v, "cold", world.bodies.cold, [&](BodyCold& b) { visit_fields(v, b); });
    visit_all(v, "motion", world.bodies.motion, [&](MotionBound& r) {
        v.field("travel", r.travel);
        v.field("bound", r.bound);
        v.field("turned", r.turned);
    });
    visit_all(v, "statics", world.bodies.statics, [&](BodyWarm& b) { visit_fields(v, b); });
    visit_all(v, "awake", world.bodies.awake, [&](BodyWarm& b) { visit_fields(v, b); });
    v.leave();

    v.enter("shapes");
    visit(v, "ids", world.shapes.ids);
    visit_all(v, "shapes", world.shapes.shapes, [&](ShapeRecord& s) { visit_fields(v, s); });
    visit_all(v, "moved", world.shapes.moved, [&](std::uint32_t& s) { v.field("", s); });
    v.leave();

    v.enter("joints");
    visit(v, "ids", world.joints.ids);
    visit_all(v, "joints", world.joints.joints, [&](Joint& j) { visit_fields(v, j); });
    v.leave();

    v.enter("triggers");
    visit_all(v, "inside", world.triggers.inside, [&](Inside& pair) {
        v.field("trigger", pair.trigger);
        v.field("shape", pair.shape);
    });
    visit_all(v, "fresh", world.triggers.fresh, [&](std::uint32_t& s) { v.field("", s); });
    v.leave();

    v.enter("contacts");
    visit(v, "ids", world.contacts.ids);
    visit_all(v, "contacts", world.contacts.contacts, [&](Contact& c) { visit_fields(v, c); });
    visit_all(v, "bounds", world.contacts.bounds, [&](SeparationBound& w) {
        v.field("contact", w.contact);
        v.field("body_a", w.body_a);
        v.field("body_b", w.body_b);
        for (float& x : w.apart) v.field("apart", x);
        v.field("directed", w.directed);
        v.field("budget", w.budget);
        v.field("limit", w.limit);
    });
    v.leave();

    v.enter("manifolds");
    for (std::size_t set = 0; set < world.graph.sets.size(); set++) {
        v.enter(set);
        visit_fields(v, world.graph.sets[set]);
        v.leave();
    }
    v.leave();

    v.enter("islands");
    visit(v, "ids", world.islands.ids);
    visit_all(v, "islands", world.islands.islands, [&](Island& i) { visit_fields(v, i); });
    v.leave();

    visit_entry_points(v, world);
}

template <class V>
void visit_world(V& v, WorldState& world) {
    visit_stores(v, world);
    visit_modules(v, world.listeners);
}

}  // namespace jostle::physics
