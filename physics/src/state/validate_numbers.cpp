// SPDX-License-Identifier: MIT
#include "physics/src/state/validate.h"

#include "jostle/physics/limits.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/geometry/geometry_checks.h"

namespace jostle::physics {
namespace {

using Fault = std::optional<std::string>;

// Relative tolerance for rounding.
constexpr double rounding = 1e-6;
// Exceeds the values that impulses within their range can produce before the next step checks them.
// Sums and squares of such values are finite.
constexpr double beyond_all = 1e60;

std::string named(const char* what, std::size_t index, const std::string& problem) {
    return std::string(what) + "[" + std::to_string(index) + "]" + problem;
}

bool within(double x, double low, double high) {
    return low <= x && x <= high;
}
bool within(Vec3 v, double limit) {
    return within(v.x, -limit, limit) && within(v.y, -limit, limit) && within(v.z, -limit, limit);
}

Fault world_numbers(const WorldDef& def) {
    if (!within(def.gravity, 1e4)) return "world.gravity is out of range";
    if (!within(def.hit_speed, 0, 1e6)) return "world.hit_speed is out of range";
    return {};
}

// Returns whether the inertia is physically possible: symmetric, and no principal moment exceeds
// the sum of the other two. Equivalently, half the trace minus the inertia (the second moments of
// the mass) is positive semi-definite.
bool is_inertia(const Mat3& i) {
    const double trace = i.x.x + i.y.y + i.z.z, small = rounding * trace;
    if (!(trace >= 0 && i.x.x >= 0 && i.y.y >= 0 && i.z.z >= 0)) return false;
    if (absolute(i.x.y - i.y.x) > small || absolute(i.x.z - i.z.x) > small ||
        absolute(i.y.z - i.z.y) > small)
        return false;
    const Mat3 moments = diagonal(Vec3{1, 1, 1} * (0.5 * trace + small)) - i;
    const double two = moments.x.x * moments.y.y - moments.x.y * moments.y.x;
    return moments.x.x >= 0 && moments.y.y >= 0 && moments.z.z >= 0 && two >= 0 &&
           determinant(moments) >= 0;
}

bool is_even(const Mat3& i) {
    return i == diagonal({i.x.x, i.x.x, i.x.x});
}

Fault body_numbers(const BodyCold& b, std::size_t index) {
    const auto wrong = [&](const char* problem) { return named("bodies", index, problem); };
    if (!within(b.linear_damping, 0, 1e4) || !within(b.angular_damping, 0, 1e4))
        return wrong(" has a damping out of range");
    if (!within(b.gravity_scale, -1e3, 1e3)) return wrong(" has a gravity scale out of range");
    if (b.locks >= 64) return wrong(" has locks beyond the six axes");
    if (!check_mass(b.mass_override).ok()) return wrong(" has an explicit mass out of range");
    if (b.type != BodyType::dynamic && (b.mass != 0 || b.inertia != diagonal({0, 0, 0})))
        return wrong(" has a mass but is not dynamic");
    if (!within(b.mass, 0, 1e25)) return wrong(" has a mass out of range");
    if (!is_inertia(b.inertia)) return wrong(" has an impossible inertia");
    if (b.isotropic && !is_even(b.inertia)) return wrong(" has an inertia that is not isotropic");
    // No mass is further from the centre than the furthest point.
    if (b.inertia.x.x + b.inertia.y.y + b.inertia.z.z >
        3 * b.mass * b.radius * b.radius * (1 + rounding))
        return wrong(" has an inertia that is too large for its size");
    if (!within(b.radius, 0, 4 * limits::max_coordinate) || !(b.inner_radius >= 0))
        return wrong(" has a radius out of range");
    if (!within(b.local_center, 4 * limits::max_coordinate))
        return wrong(" has its centre too far from its origin");
    return {};
}

Fault motion_numbers(const BodyWarm& b, const char* set, std::size_t index) {
    // A step ends with every body within the limit; calls may then move it by the extent of its
    // shapes.
    if (!within(b.center, 2 * tuning::quarantine_coordinate))
        return named(set, index, " is too far from the origin");
    for (const Vec3 v : {b.v, b.w, b.force, b.torque, b.drift, b.drift_turn})
        if (!within(v, beyond_all))
            return named(set, index, " has a velocity, force or displacement out of range");
    if (!(b.sleep_time >= 0)) return named(set, index, " has a negative time at rest");
    return {};
}

Fault numbers_of_motions(const std::vector<BodyWarm>& set, const char* name) {
    for (std::size_t i = 0; i < set.size(); i++)
        if (Fault f = motion_numbers(set[i], name, i)) return f;
    return {};
}

Fault numbers_of_bodies(const BodySets& sets) {
    for (std::uint32_t i = 0; i < sets.bodies.cold.size(); i++)
        if (sets.bodies.ids.alive(i))
            if (Fault f = body_numbers(sets.bodies.cold[i], i)) return f;
    for (std::size_t i = 0; i < sets.bodies.motion.size(); i++) {
        const MotionBound& m = sets.bodies.motion[i];
        if (!within(m.travel, 0, beyond_all) || !within(m.turned, 0, beyond_all) ||
            !within(m.bound, 0, beyond_all * beyond_all))
            return named("bodies.motion", i, " has a bound out of range");
    }
    if (Fault f = numbers_of_motions(sets.bodies.statics, "bodies.statics")) return f;
    if (Fault f = numbers_of_motions(sets.bodies.awake, "bodies.awake")) return f;
    for (const Island& island : sets.islands.islands)
        if (Fault f = numbers_of_motions(island.sleepers, "sleepers")) return f;
    return {};
}

Fault shape_numbers(const ShapeRecord& s, std::size_t index) {
    const auto wrong = [&](const Status& status) {
        return named("shapes", index, ": " + status.error().message);
    };
    if (Status checked = check_geometry("geometry", s.geometry); !checked.ok())
        return wrong(checked);
    if (Status checked = check_pose("pose", s.pose); !checked.ok()) return wrong(checked);
    if (!within(norm_squared(s.pose.rotation), 1 - 1e-7, 1 + 1e-7))
        return named("shapes", index, " has a rotation that is not a unit quaternion");
    if (Status checked = check_material(s.material); !checked.ok()) return wrong(checked);
    if (Status checked = check_mass(s.mass); !checked.ok()) return wrong(checked);
    if (Status checked = check_range("density", s.density, 0, limits::max_density); !checked.ok())
        return wrong(checked);
    const Vec3 low = s.fat.low, high = s.fat.high;
    if (!is_plane(s) && !(low.x <= high.x && low.y <= high.y && low.z <= high.z))
        return named("shapes", index, " has an inverted fat box");
    return {};
}

Fault numbers_of_contacts(const ContactStore& store) {
    const double most = beyond_all * beyond_all;
    for (std::uint32_t i = 0; i < store.contacts.size(); i++)
        if (store.ids.alive(i) && !within(store.contacts[i].limit, -most, most))
            return named("contacts", i, " has a limit out of range");
    for (std::size_t i = 0; i < store.bounds.size(); i++)
        if (!within(store.bounds[i].limit, -most, most) ||
            !within(store.bounds[i].budget, SeparationBound::not_measured, most))
            return named("contacts.bounds", i, " has a limit out of range");
    return {};
}

Fault numbers_of_shapes(const ShapeStore& shapes) {
    for (std::uint32_t i = 0; i < shapes.shapes.size(); i++)
        if (shapes.ids.alive(i))
            if (Fault f = shape_numbers(shapes.shapes[i], i)) return f;
    return {};
}

// Impulses of the solver, which are floats, and quantities derived from them.
bool is_impulse(double x) {
    return within(x, -1e32, 1e32);
}
bool is_impulse(Vec3 v) {
    return within(v, 1e32);
}

bool are_impulses(const Joint& j) {
    for (const double x : {j.lower, j.upper, j.swing, j.spring, j.motor})
        if (!is_impulse(x)) return false;
    for (const double x : j.memory)
        if (!is_impulse(x)) return false;
    return is_impulse(j.point) && is_impulse(j.angular) && is_impulse(j.friction) &&
           is_impulse(j.force) && is_impulse(j.torque);
}

Fault numbers_of_joints(const JointStore& joints) {
    for (std::uint32_t i = 0; i < joints.joints.size(); i++) {
        if (!joints.ids.alive(i)) continue;
        const Joint& j = joints.joints[i];
        for (const Transform& frame : {j.frame_a, j.frame_b})
            if (!check_pose("frame", frame).ok() ||
                !within(norm_squared(frame.rotation), 0.99, 1.01))
                return named("joints", i, " has an invalid frame");
        if (!(j.break_force >= 0 && j.break_torque >= 0))
            return named("joints", i, " has a negative break force or torque");
        if (!are_impulses(j)) return named("joints", i, " has an impulse out of range");
    }
    return {};
}

}  // namespace

std::optional<std::string> find_number_fault(const WorldStores& world) {
    if (Fault f = world_numbers(world.def)) return f;
    if (Fault f = numbers_of_bodies(world)) return f;
    if (Fault f = numbers_of_shapes(world.shapes)) return f;
    if (Fault f = numbers_of_joints(world.joints)) return f;
    return numbers_of_contacts(world.contacts);
}

}  // namespace jostle::physics
