// SPDX-License-Identifier: MIT
#include "jostle/physics/nearby_shapes.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "jostle/base/check.h"
#include "physics/src/collision/narrowphase/collide.h"
#include "physics/src/collision/narrowphase/collide_composite.h"
#include "physics/src/collision/narrowphase/shape_distance.h"
#include "physics/src/geometry/shape_measures.h"
#include "physics/src/state/body_sets.h"
#include "physics/src/state/world_access.h"

namespace jostle::physics {

// A copy: a listener may create and destroy shapes before the step is solved.
struct NearbyShapes::Shape {
    Geometry geometry;
    Material material;
    Vec3 offset;  // of the shape's origin from the centre of mass, in body axes
    Mat3 axes;    // of the shape in the body
    bool aligned = false;
    ShapeId id;
    std::uint32_t body = 0;
    TransformedShape now;
    Aabb bounds;  // at the current pose; unused by planes
};

struct NearbyShapes::Scratch {
    std::vector<std::uint32_t> found;
    std::vector<ChildManifold> parts;
    Geometry capsule;
};

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_plane(const TransformedShape& shape) {
    return kind_of(*shape.geometry) == ShapeKind::plane;
}

// Upper bound of the displacement of any point of a body in a step.
double travel_of(const BodyWarm& warm, const BodyCold& cold, Vec3 gravity, double dt) {
    const double fall = cold.type == BodyType::dynamic ? length(gravity) * dt : 0;
    return dt * (length(warm.v) + fall + length(warm.w) * cold.radius);
}

double greatest_travel(const WorldState& world, double dt) {
    double most = 0;
    for (const BodyWarm& warm : world.bodies.awake)
        most = maximum(most, travel_of(warm, world.bodies.cold[warm.body], world.def.gravity, dt));
    return most;
}

Aabb grow_all(const Aabb& box, double by) {
    return {box.low - Vec3{by, by, by}, box.high + Vec3{by, by, by}};
}

bool reaches_plane(const TransformedShape& plane, const Aabb& box) {
    const Vec3 n = plane.axes * std::get<Plane>(*plane.geometry).normal;
    const Vec3 lowest{n.x > 0 ? box.low.x : box.high.x, n.y > 0 ? box.low.y : box.high.y,
                      n.z > 0 ? box.low.z : box.high.z};
    return dot(lowest - plane.position, n) <= 0;
}

NearbyShapes::Body body_of_set(const WorldState& world, std::uint32_t index) {
    const BodyCold& cold = world.bodies.cold[index];
    const BodyWarm& warm = warm_of(world, index);
    const Transform pose = pose_of(warm, cold);
    const bool moves = cold.set == BodySet::awake && !cold.asleep_in_place;
    return {.id = body_id(world.bodies, index),
            .type = cold.type,
            .awake = moves,
            .start_center = warm.center,
            .start_rotation = warm.rotation,
            .linear_velocity = moves ? warm.v : Vec3{},
            .angular_velocity = moves ? warm.w : Vec3{},
            .origin = {inverse_rotate(warm.rotation, pose.position - warm.center),
                       conjugate(warm.rotation) * pose.rotation},
            .radius = cold.radius,
            .center = warm.center,
            .rotation = warm.rotation};
}

}  // namespace

NearbyShapes::NearbyShapes() : scratch_(std::make_unique<Scratch>()) {}
NearbyShapes::NearbyShapes(NearbyShapes&&) noexcept = default;
NearbyShapes& NearbyShapes::operator=(NearbyShapes&&) noexcept = default;
NearbyShapes::~NearbyShapes() = default;

void NearbyShapes::clear() {
    shapes_.clear();
    bodies_.clear();
}

void NearbyShapes::collect(const World& world, const Aabb& box, double dt,
                           const QueryFilter& filter) {
    clear();
    const WorldState& state = state_of(world);
    std::vector<std::uint32_t>& found = scratch_->found;
    found.clear();
    state.shapes.statics->query(box, filter.categories, found);
    state.shapes.moving->query(grow_all(box, greatest_travel(state, dt)), filter.categories, found);
    found.insert(found.end(), state.shapes.planes.begin(), state.shapes.planes.end());
    std::sort(found.begin(), found.end());
    for (const std::uint32_t index : found) {
        const ShapeRecord& record = state.shapes.shapes[index];
        const BodyId body = body_id(state.bodies, record.body);
        if ((record.filter.category & filter.categories) == 0) continue;
        if (record.trigger && !filter.triggers) continue;
        if (!is_null(filter.ignore) && body == filter.ignore) continue;
        const BodyWarm& warm = warm_of(state, record.body);
        const BodyCold& cold = state.bodies.cold[record.body];
        const TransformedShape now = transformed_shape(record, warm);
        const Aabb reach = grow_all(
            box, cold.set == BodySet::awake ? travel_of(warm, cold, state.def.gravity, dt) : 0);
        Aabb bounds;
        if (is_plane(now)) {
            if (!reaches_plane(now, reach)) continue;
        } else {
            bounds = bounds_of(now);
            if (!overlap(bounds, reach)) continue;
        }
        shapes_.push_back({record.geometry, record.material, record.offset, record.axes,
                           record.aligned, shape_id(state.shapes, index), record.body, now,
                           bounds});
    }
    for (const Shape& shape : shapes_) {
        const BodyId body = body_id(state.bodies, shape.body);
        const auto at = std::ranges::lower_bound(bodies_, body, {}, &Body::id);
        if (at == bodies_.end() || at->id != body)
            bodies_.insert(at, body_of_set(state, shape.body));
    }
    for (Shape& shape : shapes_) {
        const BodyId body = body_id(state.bodies, shape.body);
        shape.body = static_cast<std::uint32_t>(
            std::ranges::lower_bound(bodies_, body, {}, &Body::id) - bodies_.begin());
        shape.now.geometry = &shape.geometry;
    }
}

std::size_t NearbyShapes::size() const {
    return shapes_.size();
}
ShapeId NearbyShapes::shape(std::size_t index) const {
    ASSERT(index < shapes_.size());
    return shapes_[index].id;
}
const Material& NearbyShapes::material(std::size_t index) const {
    ASSERT(index < shapes_.size());
    return shapes_[index].material;
}
std::uint32_t NearbyShapes::body_of(std::size_t index) const {
    ASSERT(index < shapes_.size());
    return shapes_[index].body;
}
std::span<const NearbyShapes::Body> NearbyShapes::bodies() const {
    return bodies_;
}

void NearbyShapes::place_shapes(std::size_t body) {
    const Body& at = bodies_[body];
    const Mat3 axes = to_matrix(at.rotation);
    for (Shape& shape : shapes_) {
        if (shape.body != body) continue;
        shape.now.position = at.center + axes * shape.offset;
        shape.now.axes = shape.aligned ? axes : axes * shape.axes;
        if (!is_plane(shape.now)) shape.bounds = bounds_of(shape.now);
    }
}

void NearbyShapes::place(std::size_t body, Vec3 center, Quat rotation) {
    ASSERT(body < bodies_.size());
    bodies_[body].center = center;
    bodies_[body].rotation = rotation;
    place_shapes(body);
}

void NearbyShapes::move_to(double seconds) {
    for (std::size_t k = 0; k < bodies_.size(); k++) {
        const Body& body = bodies_[k];
        if (body.type != BodyType::kinematic) continue;
        if (body.linear_velocity == Vec3{} && body.angular_velocity == Vec3{}) continue;
        place(k, body.start_center + body.linear_velocity * seconds,
              normalized(from_rotation_vector(body.angular_velocity * seconds) *
                         body.start_rotation));
    }
}

void NearbyShapes::move_to(const SubstepContext& substep) {
    move_to(substep.index() * substep.h());
    for (std::size_t k = 0; k < bodies_.size(); k++) {
        if (bodies_[k].type != BodyType::dynamic || !substep.contains(bodies_[k].id)) continue;
        const MovingBody body = substep.body(bodies_[k].id);
        place(k, body.center,
              normalized(body.pose.rotation * conjugate(bodies_[k].origin.rotation)));
    }
}

void NearbyShapes::closest_points(std::span<const Vec3> points, double radius,
                                  std::span<std::optional<ClosestPoint>> nearest) const {
    ASSERT(nearest.size() >= points.size());
    const Vec3 reach{radius, radius, radius};
    for (std::size_t k = 0; k < points.size(); k++) {
        nearest[k].reset();
        const Aabb box{points[k] - reach, points[k] + reach};
        double best = radius;
        for (const Shape& shape : shapes_) {
            if (is_plane(shape.now) ? !reaches_plane(shape.now, box) : !overlap(shape.bounds, box))
                continue;
            const SurfacePoint p = nearest_point(shape.now, points[k]);
            if (p.distance > best || (nearest[k] && p.distance >= best)) continue;
            best = p.distance;
            nearest[k] =
                ClosestPoint{shape.id, bodies_[shape.body].id, p.distance, p.point, p.normal};
        }
    }
}

void NearbyShapes::capsule_contacts(Vec3 a, Vec3 b, double radius, double margin,
                                    std::vector<CapsuleContact>& contacts) const {
    const Vec3 axis = b - a;
    const double height = length(axis);
    ASSERT(height > 0);
    const double reach = radius + margin;
    const Aabb box = grow_all({min(a, b), max(a, b)}, reach);
    TransformedShape capsule;
    const auto add = [&](std::uint32_t index, const Manifold& m) {
        for (int k = 0; k < m.count; k++) {
            const double along = dot(m.point[k] - a, axis) / (height * height);
            contacts.push_back({index, clamp(along, 0, 1), m.point[k], -m.normal, m.gap[k]});
        }
    };
    for (std::size_t k = 0; k < shapes_.size(); k++) {
        const Shape& shape = shapes_[k];
        if (is_plane(shape.now) ? !reaches_plane(shape.now, box) : !overlap(shape.bounds, box))
            continue;
        if (capsule.geometry == nullptr) {
            scratch_->capsule = Capsule{.radius = radius, .half_length = 0.5 * height};
            const Vec3 y = axis * (1 / height);
            const Vec3 x =
                normalized(cross(y, absolute(y.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 0, 1}));
            capsule = {&scratch_->capsule, (a + b) * 0.5, {x, y, cross(x, y)}};
        }
        const auto index = static_cast<std::uint32_t>(k);
        if (!is_composite(kind_of(*shape.now.geometry))) {
            PairCache cache;
            add(index, collide(capsule, shape.now, margin, cache));
            continue;
        }
        scratch_->parts.clear();
        collide_composite(capsule, shape.now, margin, scratch_->parts);
        for (const ChildManifold& part : scratch_->parts) add(index, part.manifold);
    }
}

}  // namespace jostle::physics
