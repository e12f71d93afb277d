// SPDX-License-Identifier: MIT
#include "physics/src/state/shape_proxy.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/collision/broadphase/fat_box.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/geometry/shape_measures.h"
#include "physics/src/math/is_unit.h"
#include "physics/src/state/force_fields.h"

namespace jostle::physics {
namespace {

// The index that contains the shape's box.
BroadPhaseIndex& index_of(const BodyStore& bodies, ShapeStore& shapes, const ShapeRecord& shape) {
    ASSERT(shape.body < bodies.cold.size() && !is_plane(shape));
    const bool fixed = bodies.cold[shape.body].type == BodyType::static_body;
    return fixed ? *shapes.statics : *shapes.moving;
}

}  // namespace

void derive_shape_pose(const BodyCold& cold, ShapeRecord& shape) {
    shape.offset = shape.pose.position - cold.local_center;
    shape.axes = to_matrix(shape.pose.rotation);
    shape.aligned = shape.pose.rotation == Quat{};
}

void buffer_move(ShapeStore& shapes, TriggerStore& triggers, std::uint32_t index) {
    ShapeRecord& shape = shapes.shapes[index];
    ASSERT(shapes.ids.alive(index));
    if (shape.trigger) triggers.fresh.push_back(index);
    if (shape.moved) return;
    shape.moved = true;
    shapes.moved.push_back(index);
}

void create_proxy(ShapedBodies& stores, std::uint32_t index) {
    ShapeRecord& shape = stores.shapes.shapes[index];
    ASSERT(stores.shapes.ids.alive(index));
    if (is_plane(shape)) {
        auto& planes = stores.shapes.planes;
        planes.insert(std::lower_bound(planes.begin(), planes.end(), index), index);
    } else {
        ASSERT(shape.leaf < 0);
        shape.leaf = index_of(stores.bodies, stores.shapes, shape)
                         .insert(shape.fat, index, shape.filter.category);
        ASSERT(shape.leaf >= 0);
    }
    stores.shapes.reporters += shape.report_stays ? 1 : 0;
    if (shape.trigger) {
        auto& triggers = stores.shapes.triggers;
        triggers.insert(std::lower_bound(triggers.begin(), triggers.end(), index), index);
    }
    buffer_move(stores.shapes, stores.triggers, index);
}

void destroy_proxy(ShapedBodies& stores, std::uint32_t index, std::vector<TriggerEvent>& left) {
    ShapeRecord& shape = stores.shapes.shapes[index];
    if (is_plane(shape)) {
        std::erase(stores.shapes.planes, index);
    } else {
        ASSERT(shape.leaf >= 0);
        index_of(stores.bodies, stores.shapes, shape).remove(shape.leaf);
        shape.leaf = -1;
    }
    ASSERT(!shape.report_stays || stores.shapes.reporters > 0);
    stores.shapes.reporters -= shape.report_stays ? 1 : 0;
    if (shape.trigger) {
        std::erase(stores.shapes.triggers, index);
        std::erase(stores.triggers.fresh, index);
    }
    // Report that the shape left its triggers, or that shapes left this trigger, with the next
    // step; record the events while the ids are valid.
    std::erase_if(stores.triggers.inside, [&](const Inside& pair) {
        if (pair.trigger != index && pair.shape != index) return false;
        left.push_back({shape_id(stores.shapes, pair.trigger), shape_id(stores.shapes, pair.shape),
                        body_id(stores.bodies, stores.shapes.shapes[pair.trigger].body),
                        body_id(stores.bodies, stores.shapes.shapes[pair.shape].body)});
        return true;
    });
    if (shape.moved) {
        shape.moved = false;
        std::erase(stores.shapes.moved, index);
    }
}

void enlarge_aabb(BodyStore& bodies, ShapeStore& shapes, std::uint32_t index, const BodyWarm& warm,
                  double dt) {
    ShapeRecord& shape = shapes.shapes[index];
    if (is_plane(shape)) return;
    shape.fat = bounds_of(transformed_shape(shape, warm));
    if (bodies.cold[shape.body].type != BodyType::static_body) {
        const double radius = bodies.cold[shape.body].radius;
        shape.fat = fat_box(shape.fat, warm.v * dt, radius);
    }
    bodies.motion[shape.body].fits_until = 0;
}

void enlarge_proxy(ShapedBodies& stores, std::uint32_t index, const BodyWarm& warm, double dt) {
    enlarge_aabb(stores.bodies, stores.shapes, index, warm, dt);
    const ShapeRecord& shape = stores.shapes.shapes[index];
    if (shape.leaf >= 0) index_of(stores.bodies, stores.shapes, shape).move(shape.leaf, shape.fat);
    ASSERT(is_plane(shape) || contains(shape.fat, bounds_of(transformed_shape(shape, warm))));
    buffer_move(stores.shapes, stores.triggers, index);
}

AabbMargin margin_in_fat_aabb(const ShapeRecord& shape, const BodyWarm& warm, double radius,
                              double dt) {
    if (is_plane(shape)) return {1e300, 1e300};
    // Leave the box a quarter of the margin early, because manifolds begin before surfaces touch.
    const Aabb box = grow(bounds_of(transformed_shape(shape, warm)),
                          tuning::fat_margin_reserve * fat_margin_of(radius));
    const Vec3 low = box.low - shape.fat.low, high = shape.fat.high - box.high;
    const Vec3 lookahead = warm.v * dt;
    const auto least = [](Vec3 a, Vec3 b) {
        const Vec3 m = min(a, b);
        return minimum(m.x, minimum(m.y, m.z));
    };
    return {least(low, high), least(low + min(lookahead, Vec3{}), high - max(lookahead, Vec3{}))};
}

bool fits_fat_aabb(const ShapeRecord& shape, const BodyWarm& warm, double radius, double dt) {
    return margin_in_fat_aabb(shape, warm, radius, dt).next >= 0;
}

bool reaches_plane(const BodySets& sets, const ShapeRecord& plane, const Aabb& box) {
    const TransformedShape p = transformed_shape(plane, warm_of(sets, plane.body));
    const Vec3 n = p.axes * std::get<Plane>(plane.geometry).normal;
    ASSERT(is_unit(n));
    const Vec3 lowest{n.x > 0 ? box.low.x : box.high.x, n.y > 0 ? box.low.y : box.high.y,
                      n.z > 0 ? box.low.z : box.high.z};
    return dot(lowest - p.position, n) <= 0;
}

void update_motion_bound(WorldState& world, std::uint32_t body, double dt) {
    const BodyCold& cold = world.bodies.cold[body];
    const BodyWarm& warm = warm_of(world, body);
    MotionBound& motion = world.bodies.motion[body];
    ASSERT(dt > 0);
    // 1.5 times the current speed, and twice the contribution of gravity and forces.
    const double speed = length(warm.v) + length(warm.w) * cold.radius;
    double acceleration = length(world.def.gravity) * absolute(cold.gravity_scale) +
                          length(warm.force) * cold.inverse_mass;
    if (!world.fields.empty()) acceleration += field_acceleration(world, warm, cold);
    motion.bound = motion.travel + 1.5 * dt * speed + dt * dt * acceleration;
}

}  // namespace jostle::physics
