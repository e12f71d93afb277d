// SPDX-License-Identifier: MIT
#include "modules/rope/src/rope_step.h"

#include <algorithm>
#include <utility>

#include "jostle/base/check.h"
#include "jostle/physics/scalar.h"
#include "modules/rope/src/rope_winch.h"

namespace jostle::modules::rope_detail {

using namespace physics;

namespace {

// A rope and its bodies rest below this speed (m/s) for this time (s), as bodies do.
constexpr double rest_speed = 0.05, time_to_sleep = 0.5;
// Steps after the last contact for which a body stays tied to a rope.
constexpr std::uint32_t touch_memory = 10;
// A sleeping body wakes if an impulse of a rope would move it faster than this, m/s.
constexpr double wake_speed = 0.02;

double greatest_speed(const Strand& strand) {
    double most = 0;
    for (const Vec3 v : strand.velocities) most = maximum(most, length_squared(v));
    return square_root(most);
}

Aabb bounds_of(const Rope& rope, double margin) {
    Aabb box{rope.strand.positions[0], rope.strand.positions[0]};
    for (const Vec3 p : rope.strand.positions) {
        box.low = min(box.low, p);
        box.high = max(box.high, p);
    }
    const Vec3 more{margin, margin, margin};
    return {box.low - more, box.high + more};
}

bool is_attached_to(const Rope& rope, BodyId body) {
    return std::ranges::any_of(rope.attachments, [&](const RopeAttachment& attachment) {
        return !is_null(attachment.body) && attachment.body == body;
    });
}

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
    return {.id = body.id,
            .type = body.type,
            .in_group = false,
            .center = body.center,
            .velocity = moves ? body.linear_velocity : Vec3{},
            .spin = moves ? body.angular_velocity : Vec3{},
            .start_center = body.center,
            .rotation = body.pose.rotation,
            .origin = {inverse_rotate(body.pose.rotation, body.pose.position - body.center), {}},
            .response = response_of(body, gravity),
            .impulse = {},
            .angular_impulse = {},
            .shares = 0};
}

// Index of a body among those of the rope; adds it.
std::uint32_t carry(const World& world, Rope& rope, BodyId id) {
    for (std::size_t k = 0; k < rope.bodies.size(); k++)
        if (rope.bodies[k].id == id) return static_cast<std::uint32_t>(k);
    const Result<BodyState> body = world.body(id);
    if (!body.ok()) return no_body;
    rope.bodies.push_back(carried(*body, world.gravity()));
    return static_cast<std::uint32_t>(rope.bodies.size() - 1);
}

void expect_pushes(Rope& rope) {
    for (CarriedBody& body : rope.bodies) {
        const auto at = std::ranges::lower_bound(rope.pushes, body.id, {}, &BodyPush::body);
        if (at == rope.pushes.end() || at->body != body.id) continue;
        body.expected = at->impulse;
        body.expected_angular = at->angular_impulse;
    }
}

void save_pushes(Rope& rope) {
    rope.pushes.clear();
    for (const CarriedBody& body : rope.bodies)
        if (body.expected != Vec3{} || body.expected_angular != Vec3{})
            rope.pushes.push_back({body.id, body.expected, body.expected_angular});
    std::ranges::sort(rope.pushes, {}, &BodyPush::body);
}

void find_bodies(const World& world, Rope& rope) {
    rope.bodies.clear();
    rope.attached_body.clear();
    rope.nearby_body.clear();
    for (const RopeAttachment& attachment : rope.attachments)
        rope.attached_body.push_back(
            is_null(attachment.body) ? no_body : carry(world, rope, attachment.body));
    for (const NearbyShapes::Body& body : rope.nearby.bodies())
        rope.nearby_body.push_back(carry(world, rope, body.id));
    expect_pushes(rope);
    rope.may_touch = std::ranges::any_of(
        rope.nearby.bodies(), [&](const auto& body) { return !is_attached_to(rope, body.id); });
}

// Destroyed bodies release the rope.
void drop_lost_bodies(const World& world, Rope& rope) {
    const std::size_t before = rope.attachments.size();
    std::erase_if(rope.attachments, [&](const RopeAttachment& attachment) {
        return !is_null(attachment.body) && !world.contains(attachment.body);
    });
    if (rope.attachments.size() != before) wake(rope);
    std::erase_if(rope.touched,
                  [&](const TouchedBody& touched) { return !world.contains(touched.body); });
}

bool is_moving(const World& world, BodyId id) {
    const Result<BodyState> body = world.body(id);
    if (!body.ok() || (!body->awake && body->type != BodyType::kinematic)) return false;
    const double speed = body->type == BodyType::kinematic ? 0 : rest_speed;
    return length_squared(body->linear_velocity) > speed * speed ||
           length_squared(body->angular_velocity) > speed * speed;
}

// Something that moves near a sleeping rope, or carries it, wakes it.
bool is_disturbed(const World& world, const Rope& rope) {
    for (const RopeAttachment& attachment : rope.attachments)
        if (!is_null(attachment.body) && is_moving(world, attachment.body)) return true;
    return std::ranges::any_of(rope.nearby.bodies(), [&](const NearbyShapes::Body& body) {
        return body.type != BodyType::static_body && is_moving(world, body.id);
    });
}

void tie_bodies(World& world, Rope& rope) {
    std::vector<BodyId> bodies;
    const auto add = [&](BodyId id) {
        const Result<BodyState> body = world.body(id);
        if (body.ok() && body->type == BodyType::dynamic) bodies.push_back(id);
    };
    for (const RopeAttachment& attachment : rope.attachments)
        if (!is_null(attachment.body)) add(attachment.body);
    for (const TouchedBody& touched : rope.touched) add(touched.body);
    std::ranges::sort(bodies);
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    // The world may refuse a tie if it has too many joints; the impulses then act after the step.
    static_cast<void>(rope.ties.update(world, bodies));
    for (const BodyId body : rope.ties.bodies()) static_cast<void>(world.wake(body));
}

// ---- a sub-step ----

void push_body(SubstepContext& group, const CarriedBody& body, Vec3 impulse, Vec3 angular) {
    if (impulse != Vec3{}) group.add_impulse(body.id, impulse, group.body(body.id).center);
    if (angular != Vec3{}) group.add_angular_impulse(body.id, angular);
}

class Advance {
public:
    Advance(Rope& rope, const RopeSubstep& substep, int parts, double dt)
        : rope_(rope), substep_(substep), h_(substep.h / parts), dt_(dt) {}

    void run(int parts) {
        read_group();
        for (int n = 0; n < parts; n++) {
            run_winches(rope_, h_, dt_);
            place_shapes();
            find_contacts();
            count_shares();
            make_loads();
            make_travels();
            apply_fields(substep_.time + n * h_);
            advance_strand(rope_.strand,
                           {.h = h_,
                            .gravity = substep_.gravity,
                            .forces = rope_.forces,
                            .loads = rope_.loads,
                            .clamps = rope_.clamps,
                            .contacts = rope_.strand_contacts},
                           rope_.scratch);
            take_impulses();
            save_contacts();
            move_bodies();
            finish_strand();
        }
        write_group();
    }

private:
    CarriedBody* body_of(std::uint32_t index) {
        return index == no_body ? nullptr : &rope_.bodies[index];
    }
    static bool is_pushed(const CarriedBody& body) {
        return body.response.inverse_mass != Vec3{} || body.response.inverse_inertia.x != Vec3{};
    }

    void read_group() {
        for (CarriedBody& body : rope_.bodies) {
            if (body.type != BodyType::dynamic) continue;
            body.in_group = substep_.group != nullptr && substep_.group->contains(body.id);
            if (!body.in_group) continue;
            const MovingBody now = substep_.group->body(body.id);
            body.center = body.start_center = now.center;
            body.rotation = now.pose.rotation;
            body.response = substep_.group->response(body.id);
            body.velocity = now.linear_velocity - scaled(body.expected, body.response.inverse_mass);
            body.spin =
                now.angular_velocity - body.response.inverse_inertia * body.expected_angular;
            body.impulse = body.angular_impulse = {};
        }
    }
    void write_group() {
        for (CarriedBody& body : rope_.bodies) {
            if (!body.in_group) {
                body.expected = body.expected_angular = {};
                continue;
            }
            push_body(*substep_.group, body, body.impulse - body.expected,
                      body.angular_impulse - body.expected_angular);
            body.expected = std::exchange(body.impulse, {});
            body.expected_angular = std::exchange(body.angular_impulse, {});
        }
    }

    void place_shapes() {
        for (std::size_t k = 0; k < rope_.nearby_body.size(); k++) {
            const CarriedBody* body = body_of(rope_.nearby_body[k]);
            if (body == nullptr || body->type == BodyType::static_body) continue;
            if (!body->in_group && body->velocity == Vec3{} && body->spin == Vec3{}) continue;
            rope_.nearby.place(
                k, body->center,
                body->rotation * conjugate(rope_.nearby.bodies()[k].origin.rotation));
        }
    }

    // Forces of fields on the nodes, N. The drag acts across each link, as on a cylinder, and is
    // integrated over the sub-step, so any drag is stable: du/dt = -k |u| u has the solution
    // u / (1 + k |u| h).
    void apply_fields(double time) {
        rope_.forces.clear();
        if (substep_.fields.empty()) return;
        const Strand& strand = rope_.strand;
        rope_.forces.resize(strand.positions.size());
        for (std::size_t k = 0; k < strand.links(); k++) {
            const Vec3 center = (strand.positions[k] + strand.positions[k + 1]) * 0.5;
            const Vec3 along = normalized(strand.positions[k + 1] - strand.positions[k]);
            const double mass = strand.mass_per_length * strand.rest_lengths[k];
            Vec3 velocity = (strand.velocities[k] + strand.velocities[k + 1]) * 0.5, sum;
            for (const FieldDef& field : substep_.fields) {
                const FieldSample at = sample(field, center, time);
                sum += at.acceleration * mass + at.force * strand.rest_lengths[k];
                if (at.density == 0) continue;
                const Vec3 flow = at.flow - velocity, across = flow - along * dot(along, flow);
                const double area = 2 * rope_.def.radius * strand.rest_lengths[k];
                const double rate = 0.5 * at.density * at.drag * area / mass * length(across);
                const Vec3 change = across * (1 - 1 / (1 + rate * h_));
                velocity += change;
                sum += change * (mass / h_);
            }
            rope_.forces[k] += sum * 0.5;
            rope_.forces[k + 1] += sum * 0.5;
        }
    }

    // ---- contacts ----

    void find_contacts() {
        rope_.strand_contacts.clear();
        rope_.contact_body.clear();
        rope_.contact_shape.clear();
        rope_.contact_point.clear();
        if (!rope_.may_touch) return;
        const double margin =
            0.25 * rope_.def.radius +
            h_ * (greatest_speed(rope_.strand) + fastest_body() + h_ * length(substep_.gravity));
        std::size_t saved = 0;
        for (std::uint32_t k = 0; k < rope_.strand.links(); k++) find_contacts_of(k, margin, saved);
    }
    double fastest_body() const {
        double most = 0;
        for (const CarriedBody& body : rope_.bodies)
            most = maximum(most, length_squared(body.velocity));
        return square_root(most);
    }
    // `saved`: index in the contacts of the last sub-step, which are sorted by link too.
    void find_contacts_of(std::uint32_t link, double margin, std::size_t& saved) {
        const Vec3 a = rope_.strand.positions[link], b = rope_.strand.positions[link + 1];
        if (length_squared(b - a) < 1e-16) return;
        rope_.found.clear();
        rope_.nearby.capsule_contacts(a, b, rope_.def.radius, margin, rope_.found);
        if (rope_.found.empty()) return;
        while (saved < rope_.contacts.size() && rope_.contacts[saved].link < link) saved++;
        for (const CapsuleContact& contact : rope_.found) {
            // The next link has the same contact at its start.
            if (contact.fraction > 0.999 && link + 1 < rope_.strand.links()) continue;
            const std::uint32_t body = rope_.nearby_body[rope_.nearby.body_of(contact.shape)];
            if (body == no_body || is_attached_to(rope_, rope_.bodies[body].id)) continue;
            add_contact(link, contact, body, saved);
        }
    }
    void add_contact(std::uint32_t link, const CapsuleContact& found, std::uint32_t body,
                     std::size_t saved) {
        StrandContact contact{.link = link,
                              .fraction = found.fraction < 1e-3 ? 0 : found.fraction,
                              .normal = found.normal,
                              .gap = found.gap};
        contact.friction =
            square_root(rope_.def.friction * rope_.nearby.material(found.shape).friction);
        const ShapeId shape = rope_.nearby.shape(found.shape);
        for (std::size_t k = saved; k < rope_.contacts.size() && rope_.contacts[k].link == link;
             k++)
            if (rope_.contacts[k].shape == shape) {
                resume(contact, rope_.contacts[k]);
                break;
            }
        rope_.strand_contacts.push_back(contact);
        rope_.contact_body.push_back(body);
        rope_.contact_shape.push_back(found.shape);
        rope_.contact_point.push_back(found.point);
    }

    static void resume(StrandContact& contact, const SavedContact& saved) {
        contact.grip = saved.grip;
        contact.pressure = saved.pressure;
        contact.slip = saved.slip - contact.normal * dot(saved.slip, contact.normal);
        const double size = length(contact.slip);
        if (size > 1e-6)
            contact.slip *= 1 / size;
        else if (contact.grip == ContactGrip::slips)
            contact.grip = ContactGrip::sticks;
    }

    void count_shares() {
        for (CarriedBody& body : rope_.bodies) body.shares = 0;
        for (const std::uint32_t body : rope_.attached_body)
            if (body != no_body) rope_.bodies[body].shares++;
        for (const std::uint32_t body : rope_.contact_body) rope_.bodies[body].shares++;
    }

    // Response of a point of a body, of which the rope gets a share for each place where it acts.
    Mat3 response_at(const CarriedBody& body, Vec3 arm) const {
        return point_response(body.response, arm) *
               static_cast<double>(std::max<std::uint32_t>(body.shares, 1));
    }

    // Motion of a point of a body in this part of the sub-step without the rope.
    Vec3 travel_of(const CarriedBody& body, Vec3 arm) const {
        const Vec3 acceleration = body.response.acceleration;
        const Vec3 turned = rotate(from_rotation_vector(body.spin * h_), arm) - arm;
        return (body.velocity + acceleration * h_) * h_ + turned;
    }

    void make_travels() {
        for (std::size_t k = 0; k < rope_.strand_contacts.size(); k++) {
            StrandContact& contact = rope_.strand_contacts[k];
            const CarriedBody& body = rope_.bodies[rope_.contact_body[k]];
            if (body.type == BodyType::static_body) continue;
            const Vec3 arm = rope_.contact_point[k] - body.center;
            contact.travel = travel_of(body, arm);
            if (!is_pushed(body)) continue;
            const Mat3 response = response_at(body, arm);
            const double normal = dot(contact.normal, response * contact.normal);
            contact.response_normal = normal;
            contact.response_tangent = 0.5 * (response.x.x + response.y.y + response.z.z - normal);
        }
    }

    // ---- attachments ----

    void make_loads() {
        rope_.loads.clear();
        rope_.clamps.clear();
        rope_.clamp_body.clear();
        for (std::size_t k = 0; k < rope_.attachments.size(); k++) {
            const RopeAttachment& attachment = rope_.attachments[k];
            const std::uint32_t index = rope_.attached_body[k];
            NodeLoad load{.node = attachment.node, .fixed = true, .target = attachment.point};
            Vec3 direction = attachment.direction;
            if (const CarriedBody* body = body_of(index)) {
                const Vec3 arm = rotate(body->rotation, attachment.point - origin_offset(*body));
                load.target = body->center + arm + travel_of(*body, arm);
                direction = rotate(from_rotation_vector(body->spin * h_),
                                   rotate(body->rotation, direction));
                if (is_pushed(*body)) set_mass(load, response_at(*body, arm));
            }
            rope_.loads.push_back(load);
            if (direction == Vec3{}) continue;
            rope_.clamps.push_back(
                {.last = attachment.node != 0, .direction = normalized(direction)});
            rope_.clamp_body.push_back(index);
        }
    }
    // The centre of mass in the body's frame.
    static Vec3 origin_offset(const CarriedBody& body) { return -body.origin.position; }
    static void set_mass(NodeLoad& load, const Mat3& response) {
        const double most = maximum(response.x.x, maximum(response.y.y, response.z.z));
        if (!(most > 0)) return;  // all axes are locked
        load.fixed = false;
        load.mass = inverse(symmetric_part(response) + scalar_matrix(1e-9 * most));
    }

    // ---- results ----

    void push(CarriedBody& body, Vec3 impulse, Vec3 point) {
        if (body.type != BodyType::dynamic) return;
        push(body, impulse, cross(point - body.center, impulse), 0);
    }
    void push(CarriedBody& body, Vec3 impulse, Vec3 angular, int) {
        body.impulse += impulse;
        body.angular_impulse += angular + cross(body.center - body.start_center, impulse);
        body.velocity += scaled(impulse, body.response.inverse_mass);
        body.spin += body.response.inverse_inertia * angular;
    }

    void take_impulses() {
        for (std::size_t k = 0; k < rope_.attachments.size(); k++)
            if (CarriedBody* body = body_of(rope_.attached_body[k])) {
                const Vec3 arm =
                    rotate(body->rotation, rope_.attachments[k].point - origin_offset(*body));
                push(*body, rope_.loads[k].impulse, body->center + arm);
            }
        for (std::size_t k = 0; k < rope_.clamps.size(); k++)
            if (CarriedBody* body = body_of(rope_.clamp_body[k]))
                if (body->type == BodyType::dynamic) push(*body, {}, rope_.clamps[k].moment, 0);
        for (std::size_t k = 0; k < rope_.strand_contacts.size(); k++) {
            const StrandContact& contact = rope_.strand_contacts[k];
            if (contact.grip == ContactGrip::open) continue;
            push(rope_.bodies[rope_.contact_body[k]], contact.impulse, rope_.contact_point[k]);
        }
    }

    void save_contacts() {
        rope_.contacts.clear();
        for (std::size_t k = 0; k < rope_.strand_contacts.size(); k++) {
            const StrandContact& contact = rope_.strand_contacts[k];
            touch(rope_.bodies[rope_.contact_body[k]]);
            if (contact.grip == ContactGrip::open) continue;
            rope_.contacts.push_back({contact.link, rope_.nearby.shape(rope_.contact_shape[k]),
                                      contact.grip, contact.slip, contact.pressure});
        }
    }
    void touch(const CarriedBody& body) {
        if (body.type != BodyType::dynamic) return;
        const auto at = std::ranges::lower_bound(rope_.touched, body.id, {}, &TouchedBody::body);
        if (at != rope_.touched.end() && at->body == body.id)
            at->steps_since = 0;
        else
            rope_.touched.insert(at, {body.id, 0});
    }

    void move_bodies() {
        for (CarriedBody& body : rope_.bodies) {
            if (body.type == BodyType::static_body) continue;
            body.velocity += body.response.acceleration * h_;
            body.center += body.velocity * h_;
            if (body.spin != Vec3{})
                body.rotation = normalized(from_rotation_vector(body.spin * h_) * body.rotation);
        }
    }

    void finish_strand() {
        Strand& strand = rope_.strand;
        if (rope_.def.damping > 0) {
            const double retained = 1 / (1 + rope_.def.damping * h_);
            for (Vec3& v : strand.velocities) v *= retained;
        }
        for (std::size_t k = 0; k < strand.links(); k++) {
            const double tension = strand.force_densities[k] * strand.rest_lengths[k];
            if (tension <= rope_.peak_tension) continue;
            rope_.peak_tension = tension;
            rope_.peak_link = k;
        }
    }

    Rope& rope_;
    const RopeSubstep& substep_;
    const double h_, dt_;  // of a part and of the whole step, s
};

}  // namespace

void wake(Rope& rope) {
    rope.awake = true;
    rope.rest_time = 0;
}

void begin_step(World& world, Rope& rope, double dt, bool in_fields) {
    drop_lost_bodies(world, rope);
    rope.peak_tension = 0;
    rope.peak_link = 0;
    rope.substeps_done = 0;
    rope.owned = false;
    const double speed = greatest_speed(rope.strand);
    const double reach = 1.25 * rope.def.radius + dt * (speed + dt * length(world.gravity()));
    if (rope.def.collide_bodies)
        rope.nearby.collect(world, bounds_of(rope, reach), dt,
                            {.categories = rope.def.body_categories});
    if (!rope.awake && (in_fields || is_disturbed(world, rope))) wake(rope);
    if (!rope.awake) return;
    std::erase_if(rope.touched,
                  [](TouchedBody& body) { return body.steps_since++ >= touch_memory; });
    if (speed > rest_speed || rope.rest_time == 0) tie_bodies(world, rope);
    find_bodies(world, rope);
}

void push_as_before(Rope& rope, SubstepContext& group) {
    for (const CarriedBody& body : rope.bodies)
        if (body.type == BodyType::dynamic && group.contains(body.id))
            push_body(group, body, body.expected, body.expected_angular);
}

void advance(Rope& rope, const RopeSubstep& substep, int count) {
    ASSERT(count >= 1 && substep.h > 0);
    const int least = static_cast<int>(rope.def.substeps);
    const int parts = (least + count - 1) / count;
    Advance(rope, substep, parts, substep.h * count).run(parts);
    rope.substeps_done++;
}

void end_step(World& world, Rope& rope, double dt, bool in_fields) {
    if (!rope.awake) return;
    save_pushes(rope);
    bool bodies_rest = true;
    for (const CarriedBody& body : rope.bodies) {
        if (body.type != BodyType::dynamic) continue;
        bodies_rest = bodies_rest && !is_moving(world, body.id);
        if (body.in_group || (body.impulse == Vec3{} && body.angular_impulse == Vec3{})) continue;
        const Result<BodyState> state = world.body(body.id);
        if (!state.ok()) continue;
        if (!state->awake && length(body.impulse) < wake_speed * state->mass) continue;
        static_cast<void>(world.apply_impulse(body.id, body.impulse, state->center));
        static_cast<void>(world.apply_angular_impulse(body.id, body.angular_impulse));
    }
    const bool rests = bodies_rest && !in_fields && rope.winch[0] == 0 && rope.winch[1] == 0 &&
                       greatest_speed(rope.strand) <= rest_speed;
    rope.rest_time = rests ? rope.rest_time + dt : 0;
    if (rope.rest_time < time_to_sleep) return;
    const auto sleeps = [&](BodyId id) {
        const Result<BodyState> body = world.body(id);
        return !body.ok() || !body->awake;
    };
    if (!std::ranges::all_of(rope.ties.bodies(), sleeps)) return;
    rope.awake = false;
    for (Vec3& v : rope.strand.velocities) v = {};
}

}  // namespace jostle::modules::rope_detail
