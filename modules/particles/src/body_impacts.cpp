// SPDX-License-Identifier: MIT
#include "modules/particles/src/body_impacts.h"

#include <algorithm>

#include "jostle/modules/particles.h"
#include "jostle/physics/limits.h"
#include "modules/particles/src/particle_scratch.h"
#include "modules/particles/src/surface_response.h"

namespace jostle::modules::particles_detail {

using namespace physics;

namespace {

// Distance from a shape at which a particle is left, m, so that it is outside in the next step.
constexpr double skin = 1e-5;
// Impacts of a particle in a substep; it stops at the last one.
constexpr int impacts_max = 4;
// Shapes near a group whose bounds are tested before a query; with more, each particle queries.
constexpr std::size_t near_shapes_max = 48;

// Signed distance of a point from a shape, and the direction out of it.
struct PointDistance {
    double distance;
    Vec3 normal;
};

// Of the shape alone if it is convex or a plane: a search over all shapes costs much more near
// height fields and meshes.
std::optional<PointDistance> distance_to(const World& world, const Queries& queries, ShapeId id,
                                         Vec3 point, double reach, const QueryFilter& filter) {
    constexpr double probe = 1e-3;  // m, radius of a ball at the point
    const Result<ShapeState> shape = world.shape(id);
    const Result<BodyState> body = world.body(shape.ok() ? shape->body : BodyId{});
    if (body.ok()) {
        const auto apart =
            distance(Sphere{probe}, {point, {}}, shape->geometry, compose(body->pose, shape->pose));
        if (apart.ok()) return PointDistance{apart->distance + probe, -apart->normal};
    }
    const auto closest = queries.closest_point(point, reach, filter);
    if (!closest.ok() || !*closest) return std::nullopt;
    return PointDistance{(*closest)->distance, (*closest)->normal};
}

// The particle starts inside a shape, because the shape moved onto it: leave by the nearest point.
std::optional<ShapeImpact> leave_shape(const World& world, const Queries& queries, ShapeId shape,
                                       BodyId body, Vec3 from, double radius,
                                       const QueryFilter& filter) {
    const auto at = distance_to(world, queries, shape, from, radius + skin, filter);
    if (!at || at->distance >= radius) return std::nullopt;
    return ShapeImpact{body, from + at->normal * (radius + skin - at->distance), at->normal, 0};
}

ParticleSupport support_of(const ShapeImpact& impact, const SurfaceAtImpact& surface) {
    return {impact.normal, dot(impact.normal, impact.center), dot(impact.normal, surface.velocity)};
}

}  // namespace

std::optional<ShapeImpact> find_impact(const World& world, const Queries& queries, Vec3 from,
                                       Vec3 to, double radius, const QueryFilter& filter) {
    // A particle at rest is tested for shapes that moved onto it.
    const bool still = to == from;
    const Vec3 motion = still ? Vec3{skin, 0, 0} : to - from;
    if (radius == 0) {
        const auto hit = queries.cast_ray({from, motion}, filter);
        if (!hit.ok() || !*hit) return std::nullopt;
        const RayHit& at = **hit;
        if (at.fraction == 0)
            return leave_shape(world, queries, at.shape, at.body, from, radius, filter);
        if (still) return std::nullopt;
        return ShapeImpact{at.body, at.point + at.normal * skin, at.normal, at.fraction};
    }
    const auto hit = queries.cast_shape(
        {.geometry = Sphere{radius}, .pose = {from, {}}, .motion = motion}, filter);
    if (!hit.ok() || !*hit) return std::nullopt;
    const ShapeCastHit& at = **hit;
    if (at.fraction == 0)
        return leave_shape(world, queries, at.shape, at.body, from, radius, filter);
    if (still) return std::nullopt;
    return ShapeImpact{at.body, from + motion * at.fraction + at.normal * skin, at.normal,
                       at.fraction};
}

struct BodyImpacts::Task {
    ParticleGroup& group;
    std::span<const Vec3> before, acceleration;
    const Queries& queries;
    QueryFilter filter;
    double h, rest_speed;
};

// A particle that is at `from` with `left` seconds until the end of the substep, which it will
// reach at `to` with `velocity` unless it hits something.
struct BodyImpacts::Motion {
    Vec3 from, to, velocity, acceleration;
    double left;

    Motion(const Task& task, std::size_t k)
        : from(task.before[k]),
          to(task.group.positions_[k]),
          velocity(task.group.velocities_[k]),
          acceleration(task.acceleration[k]),
          left(task.h) {}

    void bounce(const ParticleGroupDef& def, const ShapeImpact& impact,
                const SurfaceAtImpact& surface, double rest_speed, SurfaceImpulse& impulse) {
        left *= 1 - impact.fraction;
        const ParticleBounce bounce = bounce_particle(
            {.velocity = velocity, .acceleration = acceleration, .left = left}, surface,
            {.mass = def.mass, .restitution = def.restitution, .friction = def.friction},
            rest_speed);
        from = impact.center;
        to = impact.center + bounce.move;
        velocity = bounce.velocity;
        impulse = bounce.impulse;
        if (def.planar) from.z = to.z = velocity.z = 0;
    }
};

void BodyImpacts::begin(const World& world) {
    world_ = &world;
    bodies_.clear();
}

BodyImpacts::PushedBody* BodyImpacts::find(const BodyState& state) {
    const auto at =
        std::lower_bound(bodies_.begin(), bodies_.end(), state.id,
                         [](const PushedBody& body, BodyId id) { return body.state.id < id; });
    if (at != bodies_.end() && at->state.id == state.id) return &*at;
    PushedBody body{.state = state,
                    .inverse_inertia = inverse(state.inertia),
                    .inverse_mass = 1 / state.mass,
                    .impulse = {},
                    .angular_impulse = {}};
    return &*bodies_.insert(at, body);
}

void BodyImpacts::collect_near_shapes(const ParticleGroup& group, std::span<const Vec3> before) {
    Aabb box{group.positions_[0], group.positions_[0]};
    for (std::size_t k = 0; k < before.size(); k++) {
        box.low = min(box.low, min(before[k], group.positions_[k]));
        box.high = max(box.high, max(before[k], group.positions_[k]));
    }
    const double margin = group.def_.radius + skin;
    const double most = limits::max_coordinate;
    for (int axis = 0; axis < 3; axis++) {
        box.low[axis] = maximum(box.low[axis] - margin, -most);
        box.high[axis] = minimum(box.high[axis] + margin, most);
    }
    bounds_.clear(), planes_.clear();
    const auto shapes =
        world_->queries().overlap_box(box, {.categories = group.def_.body_categories});
    test_all_ = !shapes.ok() || shapes->size() > near_shapes_max;
    if (test_all_) return;
    for (const ShapeId id : *shapes) {
        if (const Result<Aabb> bounds = world_->bounds(id); bounds.ok()) {
            bounds_.push_back({bounds->low - Vec3{margin, margin, margin},
                               bounds->high + Vec3{margin, margin, margin}});
            continue;
        }
        const Result<ShapeState> shape = world_->shape(id);
        const auto* plane = shape.ok() ? std::get_if<Plane>(&shape->geometry) : nullptr;
        const Result<BodyState> body = world_->body(shape.ok() ? shape->body : BodyId{});
        if (plane == nullptr || !body.ok()) {
            test_all_ = true;
            return;
        }
        const Transform pose = compose(body->pose, shape->pose);
        const Vec3 normal = rotate(pose.rotation, plane->normal);
        planes_.push_back({normal, dot(normal, pose.position)});
    }
}

bool BodyImpacts::may_hit(Vec3 from, Vec3 to, double radius) const {
    if (test_all_) return true;
    const double reach = radius + skin;
    for (const NearPlane& plane : planes_)
        if (minimum(dot(plane.normal, from), dot(plane.normal, to)) < plane.offset + reach)
            return true;
    const Aabb swept{min(from, to), max(from, to)};
    for (const Aabb& bounds : bounds_)
        if (overlap(bounds, swept)) return true;
    return false;
}

// Moves a particle that hits static and kinematic bodies only. Returns false, without effect, if it
// hits a dynamic one.
bool BodyImpacts::move_along_fixed(const Task& task, std::size_t k) const {
    const ParticleGroupDef& def = task.group.def_;
    Motion motion(task, k);
    if (!may_hit(motion.from, motion.to, def.radius)) return true;
    bool hit = false;
    ParticleSupport support;
    for (int n = 0; n < impacts_max; n++) {
        const auto impact =
            find_impact(*world_, task.queries, motion.from, motion.to, def.radius, task.filter);
        if (!impact) break;
        const Result<BodyState> body = world_->body(impact->body);
        if (!body.ok()) break;
        if (body->type == BodyType::dynamic) return false;
        hit = true;
        SurfaceImpulse unused;
        const SurfaceAtImpact surface = surface_of(*body, {}, 0, impact->center, impact->normal);
        support = support_of(*impact, surface);
        motion.bounce(def, *impact, surface, task.rest_speed, unused);
        if (n + 1 == impacts_max) motion.to = motion.from;
    }
    if (hit) {
        task.group.positions_[k] = motion.to;
        task.group.velocities_[k] = motion.velocity;
        task.group.scratch_->supports[k] = support;
    }
    return true;
}

// Moves a particle that may hit dynamic bodies, and pushes them.
void BodyImpacts::move(const Task& task, std::size_t k) {
    const ParticleGroupDef& def = task.group.def_;
    Motion motion(task, k);
    for (int n = 0; n < impacts_max; n++) {
        const auto impact =
            find_impact(*world_, task.queries, motion.from, motion.to, def.radius, task.filter);
        if (!impact) break;
        const Result<BodyState> state = world_->body(impact->body);
        if (!state.ok()) break;
        PushedBody* body = state->type == BodyType::dynamic ? find(*state) : nullptr;
        const SurfaceAtImpact surface =
            body != nullptr ? surface_of(body->state, body->inverse_inertia, body->inverse_mass,
                                         impact->center, impact->normal)
                            : surface_of(*state, {}, 0, impact->center, impact->normal);
        if (body == nullptr) task.group.scratch_->supports[k] = support_of(*impact, surface);
        SurfaceImpulse impulse;
        motion.bounce(def, *impact, surface, task.rest_speed, impulse);
        if (body != nullptr) {
            // The impulse acts at the centre of the particle, so that angular momentum is conserved
            // although the particle has no spin.
            const Vec3 torque = cross(impact->center - body->state.center, impulse.on_surface);
            body->impulse += impulse.on_surface;
            body->angular_impulse += torque;
            body->state.linear_velocity += impulse.on_surface * body->inverse_mass;
            body->state.angular_velocity += body->inverse_inertia * torque;
        }
        if (n + 1 == impacts_max) motion.to = motion.from;
    }
    task.group.positions_[k] = motion.to;
    task.group.velocities_[k] = motion.velocity;
}

void BodyImpacts::resolve(ParticleGroup& group, std::span<const Vec3> before,
                          std::span<const Vec3> acceleration, double h, double rest_speed) {
    if (before.empty()) return;
    collect_near_shapes(group, before);
    if (!test_all_ && bounds_.empty() && planes_.empty()) return;
    const Queries queries = world_->queries();
    const Task task{
        group, before,    acceleration, queries, {.categories = group.def_.body_categories},
        h,     rest_speed};
    pending_.assign(before.size(), 0);
    group.scratch_->supports.assign(before.size(), {});
    struct Run {
        BodyImpacts& impacts;
        const Task& task;
    } run{*this, task};
    world_->parallel_for(static_cast<int>(before.size()), 64, [&run](int first, int last) {
        for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); k++)
            run.impacts.pending_[k] = run.impacts.move_along_fixed(run.task, k) ? 0 : 1;
    });
    for (std::size_t k = 0; k < pending_.size(); k++)
        if (pending_[k] != 0) move(task, k);
}

void BodyImpacts::hold(ParticleGroup& group, std::span<const Vec3> before) {
    if (!test_all_ && bounds_.empty() && planes_.empty()) return;
    const Queries queries = world_->queries();
    struct Run {
        const BodyImpacts& impacts;
        ParticleGroup& group;
        std::span<const Vec3> before;
        const Queries& queries;
    } run{*this, group, before, queries};
    world_->parallel_for(static_cast<int>(before.size()), 64, [&run](int first, int last) {
        const ParticleGroupDef& def = run.group.def_;
        for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); k++) {
            Vec3& position = run.group.positions_[k];
            if (position == run.before[k] ||
                !run.impacts.may_hit(run.before[k], position, def.radius))
                continue;
            const auto impact =
                find_impact(*run.impacts.world_, run.queries, run.before[k], position, def.radius,
                            {.categories = def.body_categories});
            if (impact) position = impact->center;
            if (def.planar) position.z = 0;
        }
    });
}

void BodyImpacts::apply(World& world) {
    for (const PushedBody& body : bodies_) {
        const double change = length(body.impulse) * body.inverse_mass;
        if (!body.state.awake && change < Particles::wake_speed) continue;
        // Impulses beyond the limits of the world are refused: no body takes that much.
        static_cast<void>(world.apply_impulse(body.state.id, body.impulse, body.state.center));
        static_cast<void>(world.apply_angular_impulse(body.state.id, body.angular_impulse));
    }
    bodies_.clear();
}

}  // namespace jostle::modules::particles_detail
