// SPDX-License-Identifier: MIT
#include "physics/src/state/force_fields.h"

#include "jostle/base/check.h"
#include "jostle/physics/limits.h"
#include "physics/src/foundation/messages.h"
#include "physics/src/geometry/geometry_checks.h"
#include "physics/src/geometry/shape_measures.h"

namespace jostle::physics {
namespace {

double to_power(double x, int n) {
    ASSERT(n >= 0);
    double power = 1;
    for (int k = 0; k < n; k++) power *= x;
    return power;
}

// Calls visit(shape) for each shape of the body that is not a trigger.
template <class Visit>
void for_each_solid(const ShapeStore& shapes, const BodyWarm& now, const BodyCold& cold,
                    Visit&& visit) {
    for (std::uint32_t s = cold.first_shape; s != none; s = shapes.shapes[s].next)
        if (!shapes.shapes[s].trigger) visit(transformed_shape(shapes.shapes[s], now));
}

// Input of the field laws for one body, and the sum of their forces.
struct Pushed {
    const WorldState& world;
    const BodyCold& cold;
    BodyWarm now;  // velocities change from field to field
    double time, h;
    FieldPush sum = {};

    void push(Vec3 force, Vec3 point) {
        sum.force += force;
        sum.torque += cross(point - now.center, force);
    }

    // Quadratic drag by a medium that flows with `flow`, on area * drag. du/dt = -k |u| u has the
    // solution u / (1 + k |u| h).
    void drag(Vec3 flow, double density, double coefficient, double share,
              double (*area_of)(const Pushed&, Vec3)) {
        const Vec3 u = flow - now.v;
        const double speed = length(u);
        if (!(speed > 1e-9) || density == 0 || coefficient == 0) return;
        const double area = share * area_of(*this, u * (1 / speed));
        ASSERT(area >= 0);
        const double k = 0.5 * density * coefficient * area * cold.inverse_mass;
        const Vec3 change = u * (1 - 1 / (1 + k * speed * h));
        now.v += change;
        sum.force += change * (cold.mass / h);
    }

    void operator()(const UniformWind& wind) {
        Vec3 velocity = wind.velocity;
        // Evaluated in the middle of the sub-step.
        if (wind.gust != Vec3{})
            velocity += wind.gust * sin_cos(2 * pi * (time + 0.5 * h) / wind.gust_period).sin;
        drag(velocity, wind.density, wind.drag, 1, shown_area);
    }
    void operator()(const RadialField& radial) {
        const Vec3 away = now.center - radial.center;
        const double r = length(away);
        if (!(r > 0)) return;
        sum.force += away * (strength_at(radial, radial.strength, r) / r);
    }
    void operator()(const VortexField& vortex) {
        const Vec3 from = now.center - vortex.center;
        const Vec3 out = from - vortex.axis * dot(from, vortex.axis);
        ASSERT(absolute(length_squared(vortex.axis) - 1) < 1e-5);
        const double r = length(out);
        sum.force += vortex.axis * strength_at(vortex, vortex.lift, r);
        if (!(r > 0)) return;
        sum.force += cross(vortex.axis, out) * (strength_at(vortex, vortex.strength, r) / r) -
                     out * (strength_at(vortex, vortex.pull, r) / r);
    }
    void operator()(const BuoyancyField& fluid) {
        double below = 0, total = 0;
        Vec3 moment;
        for_each_solid(world.shapes, now, cold, [&](const TransformedShape& shape) {
            const Vec3 normal = transposed_times(shape.axes, fluid.normal);
            const double offset = fluid.offset - dot(fluid.normal, shape.position);
            const Displacement part = displacement(*shape.geometry, normal, offset);
            below += part.volume;
            moment += (shape.position + shape.axes * part.center) * part.volume;
            total += displacement(*shape.geometry, normal, 1e30).volume;
        });
        if (!(below > 0)) return;
        ASSERT(below <= total * (1 + 1e-6));
        const double displaced = fluid.density * below;  // kg
        push(world.def.gravity * -displaced, moment * (1 / below));
        drag(fluid.flow, fluid.density, fluid.drag, below / total, shown_area);
        const double rate = fluid.angular_drag * displaced * cold.inverse_mass;
        const Vec3 change = now.w * (1 / (1 + rate * h) - 1);
        now.w += change;
        const Vec3 own = transposed_times(now.axes, change);
        sum.torque += now.axes * (cold.inertia * own) * (1 / h);
    }

    static double shown_area(const Pushed& body, Vec3 direction) {
        double area = 0;
        for_each_solid(body.world.shapes, body.now, body.cold, [&](const TransformedShape& shape) {
            area += projected_area(*shape.geometry, transposed_times(shape.axes, direction));
        });
        return area;
    }
    template <class Field>
    double strength_at(const Field& field, double strength, double r) const {
        const double force = strength / to_power(maximum(r, field.min_distance), field.falloff);
        return field.per_mass ? force * cold.mass : force;
    }
};

bool changes_with_time(const FieldDef& field) {
    const auto* wind = std::get_if<UniformWind>(&field.force);
    return wind != nullptr && wind->gust != Vec3{};
}

bool has_category(const ShapeStore& shapes, const BodyCold& cold, std::uint32_t mask) {
    for (std::uint32_t s = cold.first_shape; s != none; s = shapes.shapes[s].next)
        if ((shapes.shapes[s].filter.category & mask) != 0) return true;
    return false;
}

}  // namespace

bool reaches(const FieldStore& fields, Vec3 center, double radius) {
    const Vec3 r{radius, radius, radius};
    const Aabb box{center - r, center + r};
    for (const std::uint32_t index : fields.active) {
        const FieldDef& field = fields.fields[index];
        if (!field.region || overlap(*field.region, box)) return true;
    }
    return false;
}

bool acts_on(const ShapeStore& shapes, const FieldDef& field, const BodyWarm& now,
             const BodyCold& cold) {
    if (cold.type != BodyType::dynamic) return false;
    if (field.region && !contains(*field.region, Aabb{now.center, now.center})) return false;
    return field.mask == 0xffffffff || has_category(shapes, cold, field.mask);
}

FieldPush field_push(const WorldState& world, const BodyWarm& now, const BodyCold& cold,
                     double time, double h) {
    ASSERT(h > 0 && cold.mass > 0);
    Pushed body{world, cold, now, time, h};
    for (const std::uint32_t index : world.fields.active) {
        const FieldDef& field = world.fields.fields[index];
        if (acts_on(world.shapes, field, now, cold)) std::visit(body, field.force);
    }
    if (world.def.planar) {
        body.sum.force.z = 0;
        body.sum.torque.x = body.sum.torque.y = 0;
    }
    return body.sum;
}

double field_acceleration(const WorldState& world, const BodyWarm& now, const BodyCold& cold) {
    // A body under construction has no shapes and no mass yet.
    if (cold.type != BodyType::dynamic || cold.mass == 0 || !reaches(world.fields, now.center, 0))
        return 0;
    // Over a short interval, so that drag has its full strength.
    const FieldPush push = field_push(world, now, cold, world.time, 1e-5);
    return length(push.force) * cold.inverse_mass;
}

bool is_affected_by_gusts(const FieldStore& fields, const ShapeStore& shapes, const BodyWarm& now,
                          const BodyCold& cold) {
    for (const std::uint32_t index : fields.active) {
        const FieldDef& field = fields.fields[index];
        if (changes_with_time(field) && acts_on(shapes, field, now, cold)) return true;
    }
    return false;
}

namespace {

constexpr double most = 1e12;

Status check_unit(const char* name, Vec3 v) {
    if (is_finite(v) && absolute(length_squared(v) - 1) < 1e-6) return {};
    return Error{ErrorCode::invalid_argument, std::string(name) + " has length " + text(length(v)) +
                                                  "; it must be a unit vector"};
}

// Returns the first failed check.
Status all_of(std::initializer_list<Status> checks) {
    for (const Status& s : checks)
        if (!s.ok()) return s;
    return {};
}

Status check_solid(bool planar, const char* name) {
    if (!planar) return {};
    return Error{ErrorCode::failed_precondition,
                 std::string(name) +
                     " requires volumes and areas, which shapes in a planar world "
                     "do not have; use radial or vortex fields, or forces"};
}

struct CheckForce {
    bool planar;

    Status operator()(const UniformWind& wind) const {
        return all_of({check_solid(planar, "wind"),
                       check_vector("wind.velocity", wind.velocity, limits::max_speed),
                       check_vector("wind.gust", wind.gust, limits::max_speed),
                       check_range("wind.gust_period", wind.gust_period, 1e-3, most),
                       check_range("wind.density", wind.density, 0, limits::max_density),
                       check_range("wind.drag", wind.drag, 0, 1e6)});
    }
    Status operator()(const RadialField& radial) const {
        return all_of({check_vector("radial.center", radial.center, limits::max_coordinate),
                       check_range("radial.strength", radial.strength, -most, most),
                       check_range("radial.falloff", radial.falloff, 0, 4),
                       check_range("radial.min_distance", radial.min_distance, 1e-6, most)});
    }
    Status operator()(const VortexField& vortex) const {
        return all_of({check_vector("vortex.center", vortex.center, limits::max_coordinate),
                       check_unit("vortex.axis", vortex.axis),
                       check_range("vortex.strength", vortex.strength, -most, most),
                       check_range("vortex.pull", vortex.pull, -most, most),
                       check_range("vortex.lift", vortex.lift, -most, most),
                       check_range("vortex.falloff", vortex.falloff, 0, 4),
                       check_range("vortex.min_distance", vortex.min_distance, 1e-6, most)});
    }
    Status operator()(const BuoyancyField& fluid) const {
        return all_of({check_solid(planar, "buoyancy"), check_unit("buoyancy.normal", fluid.normal),
                       check_range("buoyancy.offset", fluid.offset, -limits::max_coordinate,
                                   limits::max_coordinate),
                       check_range("buoyancy.density", fluid.density, 0, limits::max_density),
                       check_vector("buoyancy.flow", fluid.flow, limits::max_speed),
                       check_range("buoyancy.drag", fluid.drag, 0, 1e6),
                       check_range("buoyancy.angular_drag", fluid.angular_drag, 0, 1e6)});
    }
};

}  // namespace

Status check_field(const FieldDef& field, bool planar) {
    if (Status s = std::visit(CheckForce{planar}, field.force); !s.ok()) return s;
    if (!field.region) return {};
    const Vec3 low = field.region->low, high = field.region->high;
    if (Status s = check_vector("region.low", low, limits::max_coordinate); !s.ok()) return s;
    if (Status s = check_vector("region.high", high, limits::max_coordinate); !s.ok()) return s;
    if (low.x <= high.x && low.y <= high.y && low.z <= high.z) return {};
    return Error{ErrorCode::invalid_argument,
                 "region.low is above region.high; region.low must be the lower corner"};
}

namespace {

// The law of a field at a point, without its region.
struct SampleOf {
    Vec3 point;
    double time;

    FieldSample operator()(const UniformWind& wind) const {
        Vec3 flow = wind.velocity;
        if (wind.gust != Vec3{}) flow += wind.gust * sin_cos(2 * pi * time / wind.gust_period).sin;
        return {.flow = flow, .density = wind.density, .drag = wind.drag};
    }
    FieldSample operator()(const RadialField& radial) const {
        const Vec3 away = point - radial.center;
        const double r = length(away);
        if (!(r > 0)) return {};
        return pushed(radial, away * (strength(radial, radial.strength, r) / r));
    }
    FieldSample operator()(const VortexField& vortex) const {
        const Vec3 from = point - vortex.center;
        const Vec3 out = from - vortex.axis * dot(from, vortex.axis);
        const double r = length(out);
        Vec3 sum = vortex.axis * strength(vortex, vortex.lift, r);
        if (r > 0)
            sum += cross(vortex.axis, out) * (strength(vortex, vortex.strength, r) / r) -
                   out * (strength(vortex, vortex.pull, r) / r);
        return pushed(vortex, sum);
    }
    FieldSample operator()(const BuoyancyField& fluid) const {
        if (dot(fluid.normal, point) > fluid.offset) return {};
        return {.flow = fluid.flow, .density = fluid.density, .drag = fluid.drag};
    }

    template <class Field>
    static double strength(const Field& field, double strength, double r) {
        return strength / to_power(maximum(r, field.min_distance), field.falloff);
    }
    template <class Field>
    static FieldSample pushed(const Field& field, Vec3 push) {
        FieldSample sample;
        (field.per_mass ? sample.acceleration : sample.force) = push;
        return sample;
    }
};

}  // namespace

FieldSample sample(const FieldDef& field, Vec3 point, double time) {
    if (field.region && !contains(*field.region, Aabb{point, point})) return {};
    return std::visit(SampleOf{point, time}, field.force);
}

}  // namespace jostle::physics
