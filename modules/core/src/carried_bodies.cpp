// SPDX-License-Identifier: MIT
#include "jostle/modules/carried_bodies.h"

#include <algorithm>
#include <utility>

#include "jostle/modules/settings.h"
#include "jostle/physics/scalar.h"

namespace jostle::modules {

using namespace physics;

namespace {

// Steps after the last contact for which a body stays tied.
constexpr std::uint32_t touch_memory = 10;
// A sleeping body wakes if an impulse would move it faster than this, m/s.
constexpr double wake_speed = 0.02;
constexpr double impulse_max = 1e12;  // N s and N m s, of loaded states

// Of a body outside of the group; inside, SubstepContext::response() is exact.
BodyResponse response_of(const BodyState& body, Vec3 gravity) {
    if (body.type != BodyType::dynamic || !body.awake) return {};
    const Vec3 free{(body.locks & lock_x) != 0 ? 0.0 : 1.0, (body.locks & lock_y) != 0 ? 0.0 : 1.0,
                    (body.locks & lock_z) != 0 ? 0.0 : 1.0};
    const AxisLocks rotations = lock_rotation_x | lock_rotation_y | lock_rotation_z;
    const bool turns = (body.locks & rotations) == 0;
    return {.inverse_mass = free * (1 / body.mass),
            .inverse_inertia = turns ? inverse(body.inertia) : diagonal({0, 0, 0}),
            .acceleration = gravity};
}

CarriedBody carried(const BodyState& body, Vec3 gravity) {
    const bool moves = body.awake || body.type == BodyType::kinematic;
    CarriedBody c;
    c.id = body.id;
    c.type = body.type;
    c.center = c.start_center = body.center;
    c.velocity = moves ? body.linear_velocity : Vec3{};
    c.spin = moves ? body.angular_velocity : Vec3{};
    c.rotation = body.pose.rotation;
    c.origin = {inverse_rotate(body.pose.rotation, body.pose.position - body.center), {}};
    c.response = response_of(body, gravity);
    return c;
}

CarriedBody carried(const PointGrab& grab) {
    CarriedBody c;
    c.holder = grab.holder;
    c.center = c.start_center = grab.position;
    c.velocity = grab.velocity;
    const double response = 1 / grab.mass;
    c.response.inverse_mass = {response, response, response};
    return c;
}

bool is_moving(const World& world, BodyId id) {
    const Result<BodyState> body = world.body(id);
    if (!body.ok() || (!body->awake && body->type != BodyType::kinematic)) return false;
    const double speed = body->type == BodyType::kinematic ? 0 : CarriedBodies::rest_speed;
    return length_squared(body->linear_velocity) > speed * speed ||
           length_squared(body->angular_velocity) > speed * speed;
}

}  // namespace

bool CarriedBody::is_pushed() const {
    return type == BodyType::dynamic &&
           (response.inverse_mass != Vec3{} || response.inverse_inertia.x != Vec3{});
}

Vec3 CarriedBody::arm_to(Vec3 point) const {
    return rotate(rotation, point + origin.position);
}

Vec3 CarriedBody::travel_of(Vec3 arm, double h) const {
    if (type == BodyType::static_body) return {};
    const Vec3 moved = (velocity + response.acceleration * h) * h;
    if (spin == Vec3{}) return moved;
    return moved + (rotate(from_rotation_vector(spin * h), arm) - arm);
}

void CarriedBody::push(Vec3 new_impulse, Vec3 arm) {
    push_both(new_impulse, cross(arm, new_impulse));
}

void CarriedBody::push_both(Vec3 linear, Vec3 angular) {
    if (type != BodyType::dynamic) return;
    impulse += linear;
    angular_impulse += angular + cross(center - start_center, linear);
    velocity += scaled(linear, response.inverse_mass);
    spin += response.inverse_inertia * angular;
}

void CarriedBodies::begin_step(const World& world, std::vector<Support> supports) {
    supports_ = std::move(supports);
    std::erase_if(touched_, [&](const Touched& touched) { return !world.contains(touched.body); });
    std::erase_if(grabs_, [&](const PointGrab& grab) {
        return std::ranges::find(supports_, grab.holder, &Support::holder) == supports_.end();
    });
}

bool CarriedBodies::any_moves(const World& world, const NearbyShapes& nearby) const {
    return !grabs_.empty() || std::ranges::any_of(supports_, [&](const Support& support) {
        return !is_null(support.body) && is_moving(world, support.body);
    }) || std::ranges::any_of(nearby.bodies(), [&](const NearbyShapes::Body& body) {
        return body.type != BodyType::static_body && is_moving(world, body.id);
    });
}

void CarriedBodies::forget_old_contacts() {
    std::erase_if(touched_, [](Touched& touched) { return touched.steps_since++ >= touch_memory; });
}

void CarriedBodies::tie(World& world, std::span<const BodyId> others) {
    std::vector<BodyId> bodies;
    const auto add = [&](BodyId id) {
        const Result<BodyState> body = world.body(id);
        if (body.ok() && body->type == BodyType::dynamic) bodies.push_back(id);
    };
    for (const Support& support : supports_)
        if (!is_null(support.body)) add(support.body);
    for (const Touched& touched : touched_) add(touched.body);
    for (const BodyId body : others) add(body);
    std::ranges::sort(bodies);
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    // The world may refuse a tie if it has too many joints; the impulses then act after the step.
    static_cast<void>(ties_.update(world, bodies));
    for (const BodyId body : ties_.bodies()) static_cast<void>(world.wake(body));
}

std::uint32_t CarriedBodies::carry(const World& world, BodyId id) {
    for (std::size_t k = 0; k < bodies_.size(); k++)
        if (bodies_[k].id == id) return static_cast<std::uint32_t>(k);
    const Result<BodyState> body = world.body(id);
    if (!body.ok()) return none;
    bodies_.push_back(carried(*body, world.gravity()));
    return static_cast<std::uint32_t>(bodies_.size() - 1);
}

void CarriedBodies::find(const World& world, const NearbyShapes& nearby) {
    bodies_.clear();
    attached_.clear();
    nearby_.clear();
    for (const Support& support : supports_) {
        if (const PointGrab* held = support.holder == 0 ? nullptr : grab(support.holder)) {
            attached_.push_back(static_cast<std::uint32_t>(bodies_.size()));
            bodies_.push_back(carried(*held));
        } else {
            attached_.push_back(is_null(support.body) ? none : carry(world, support.body));
        }
    }
    for (const NearbyShapes::Body& body : nearby.bodies()) nearby_.push_back(carry(world, body.id));
    for (const std::uint32_t body : attached_)
        if (body != none) bodies_[body].attached++;
    pushes_as_before_ = false;
    for (CarriedBody& body : bodies_) {
        const auto push = std::ranges::lower_bound(last_pushes_, body.id, {}, &LastPush::body);
        if (push == last_pushes_.end() || push->body != body.id) continue;
        body.last = push->impulse;
        body.last_angular = push->angular_impulse;
    }
}

bool CarriedBodies::touch(BodyId body) {
    const auto found = std::ranges::lower_bound(touched_, body, {}, &Touched::body);
    if (found != touched_.end() && found->body == body) {
        found->steps_since = 0;
        return false;
    }
    touched_.insert(found, {body, 0});
    return true;
}

bool CarriedBodies::is_attached_to(BodyId body) const {
    return !is_null(body) && std::ranges::find(supports_, body, &Support::body) != supports_.end();
}

bool CarriedBodies::was_touched(BodyId body) const {
    return std::ranges::binary_search(touched_, body, {}, &Touched::body);
}

double CarriedBodies::greatest_speed() const {
    double most = 0;
    for (const CarriedBody& body : bodies_) most = maximum(most, length_squared(body.velocity));
    return square_root(most);
}

namespace {

void push(SubstepContext& group, const CarriedBody& body, Vec3 impulse, Vec3 angular_impulse,
          Vec3 center) {
    if (impulse != Vec3{}) group.add_impulse(body.id, impulse, center);
    if (angular_impulse != Vec3{}) group.add_angular_impulse(body.id, angular_impulse);
}

}  // namespace

void CarriedBodies::push_as_before(SubstepContext& group) {
    pushes_as_before_ = true;
    for (CarriedBody& body : bodies_) {
        if (body.type != BodyType::dynamic || !group.contains(body.id)) continue;
        body.expected = body.last;
        body.expected_angular = body.last_angular;
        push(group, body, body.expected, body.expected_angular, group.body(body.id).center);
    }
}

void CarriedBodies::read(const SubstepContext* group) {
    for (CarriedBody& body : bodies_) {
        if (body.type != BodyType::dynamic) continue;
        body.in_group = group != nullptr && group->contains(body.id);
        if (!body.in_group) continue;
        const MovingBody now = group->body(body.id);
        body.center = body.start_center = now.center;
        body.rotation = now.pose.rotation;
        body.response = group->response(body.id);
        body.velocity = now.linear_velocity - scaled(body.expected, body.response.inverse_mass);
        body.spin = now.angular_velocity - body.response.inverse_inertia * body.expected_angular;
        body.impulse = body.angular_impulse = {};
    }
}

void CarriedBodies::write(SubstepContext* group) {
    for (CarriedBody& body : bodies_) {
        if (!body.in_group) continue;
        push(*group, body, body.impulse - body.expected,
             body.angular_impulse - body.expected_angular, body.start_center);
        body.last = std::exchange(body.impulse, {});
        body.last_angular = std::exchange(body.angular_impulse, {});
        body.expected = body.expected_angular = {};
    }
}

void CarriedBodies::pull_grabs(double h) {
    for (CarriedBody& body : bodies_) {
        const PointGrab* held = body.holder == 0 ? nullptr : grab(body.holder);
        if (held == nullptr) continue;  // also if a listener released it in this step
        PointGrab now = *held;
        now.position = body.center;
        now.velocity = body.velocity;
        body.response.acceleration = now.pull(h);
    }
}

void CarriedBodies::place(NearbyShapes& nearby) const {
    for (std::size_t k = 0; k < nearby_.size(); k++) {
        if (nearby_[k] == none) continue;
        const CarriedBody& body = bodies_[nearby_[k]];
        if (body.type == BodyType::static_body) continue;
        if (!body.in_group && body.velocity == Vec3{} && body.spin == Vec3{}) continue;
        nearby.place(k, body.center, body.rotation * conjugate(nearby.bodies()[k].origin.rotation));
    }
}

void CarriedBodies::move(double h) {
    for (CarriedBody& body : bodies_) {
        if (body.type == BodyType::static_body) continue;
        body.velocity += body.response.acceleration * h;
        body.center += body.velocity * h;
        if (body.spin != Vec3{})
            body.rotation = normalized(from_rotation_vector(body.spin * h) * body.rotation);
    }
}

bool CarriedBodies::finish_step(World& world) {
    last_pushes_.clear();
    if (pushes_as_before_)
        for (const CarriedBody& body : bodies_)
            if (body.in_group && (body.last != Vec3{} || body.last_angular != Vec3{}))
                last_pushes_.push_back({body.id, body.last, body.last_angular});
    std::ranges::sort(last_pushes_, {}, &LastPush::body);
    bool rest = true;
    for (const CarriedBody& body : bodies_) {
        if (body.type != BodyType::dynamic) continue;
        if (body.holder != 0) {
            rest = false;
            PointGrab* held = grab(body.holder);
            if (held == nullptr) continue;
            held->position = body.center;
            held->velocity = body.velocity;
            continue;
        }
        rest = rest && !is_moving(world, body.id);
        if (body.in_group || (body.impulse == Vec3{} && body.angular_impulse == Vec3{})) continue;
        const Result<BodyState> state = world.body(body.id);
        if (!state.ok()) continue;
        if (!state->awake && length(body.impulse) < wake_speed * state->mass) continue;
        static_cast<void>(world.apply_impulse(body.id, body.impulse, state->center));
        static_cast<void>(world.apply_angular_impulse(body.id, body.angular_impulse));
    }
    return rest;
}

bool CarriedBodies::all_asleep(const World& world) const {
    return std::ranges::all_of(ties_.bodies(), [&](BodyId id) {
        const Result<BodyState> body = world.body(id);
        return !body.ok() || !body->awake;
    });
}

bool CarriedBodies::has_grabs_of(std::span<const Support> supports) {
    return std::ranges::all_of(supports, [&](const Support& support) {
        return support.holder == 0 || grab(support.holder) != nullptr;
    });
}

PointGrab* CarriedBodies::grab(std::uint32_t holder) {
    const auto found = std::ranges::lower_bound(grabs_, holder, {}, &PointGrab::holder);
    return found != grabs_.end() && found->holder == holder ? &*found : nullptr;
}

void CarriedBodies::add_grab(const PointGrab& added) {
    remove_grab(added.holder);
    grabs_.insert(std::ranges::lower_bound(grabs_, added.holder, {}, &PointGrab::holder), added);
}

void CarriedBodies::remove_grab(std::uint32_t holder) {
    std::erase_if(grabs_, [&](const PointGrab& each) { return each.holder == holder; });
}

void CarriedBodies::visit(StateVisitor& v) {
    v.all("touched", touched_, [&](Touched& touched) {
        v.field("body", touched.body);
        v.field("steps_since", touched.steps_since);
    });
    v.all("last_pushes", last_pushes_, [&](LastPush& push) {
        v.field("body", push.body);
        bounded(v, "impulse", push.impulse, impulse_max);
        bounded(v, "angular_impulse", push.angular_impulse, impulse_max);
    });
    v.enter("ties");
    ties_.visit(v);
    v.leave();
    v.all("grabs", grabs_, [&](PointGrab& grab) { grab.visit(v); });
    if (!v.loading() || v.failed()) return;
    for (std::size_t k = 1; k < grabs_.size(); k++)
        if (grabs_[k].holder <= grabs_[k - 1].holder)
            return v.fail("grabs", "have holders that are not strictly increasing");
    for (std::size_t k = 1; k < touched_.size(); k++)
        if (!(touched_[k - 1].body < touched_[k].body))
            return v.fail("touched", "has bodies that are not strictly increasing");
    for (std::size_t k = 1; k < last_pushes_.size(); k++)
        if (!(last_pushes_[k - 1].body < last_pushes_[k].body))
            return v.fail("last_pushes", "has bodies that are not strictly increasing");
}

}  // namespace jostle::modules
