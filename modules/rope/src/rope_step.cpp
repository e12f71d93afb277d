// SPDX-License-Identifier: MIT
#include "modules/rope/src/rope_step.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "jostle/base/check.h"
#include "jostle/physics/scalar.h"
#include "modules/rope/src/rope_contacts.h"
#include "modules/rope/src/rope_winch.h"

namespace jostle::modules::rope_detail {

using namespace physics;

namespace {

// A rope and its bodies rest for this time before they sleep, as bodies do, s.
constexpr double time_to_sleep = 0.5;
constexpr double rest_speed = CarriedBodies::rest_speed;

// Destroyed bodies release the rope.
void drop_lost_bodies(const World& world, Rope& rope) {
    const std::size_t before = rope.attachments.size();
    std::erase_if(rope.attachments, [&](const RopeAttachment& attachment) {
        return !is_null(attachment.body) && !world.contains(attachment.body);
    });
    if (rope.attachments.size() != before) wake(rope);
    rope.bodies.begin_step(world, supports_of(rope));
}

// ---- a sub-step ----

class Advance {
public:
    Advance(Rope& rope, const RopeSubstep& substep, int parts, double dt)
        : rope_(rope), substep_(substep), h_(substep.h / parts), dt_(dt) {}

    // Up to the forces on the nodes. `part` is that of the sub-step.
    void begin(int part) {
        run_winches(rope_, h_, dt_);
        rope_.bodies.pull_grabs(h_);
        rope_.bodies.place(rope_.nearby);
        find_contacts();
        count_shares();
        make_loads();
        make_travels();
        apply_fields(substep_.time + part * h_);
    }
    StrandJob job(bool coupled) {
        return {.strand = &rope_.strand,
                .input = {.h = h_,
                          .gravity = substep_.gravity,
                          .forces = rope_.forces,
                          .loads = rope_.loads,
                          .clamps = rope_.clamps,
                          .contacts = rope_.strand_contacts,
                          .coupled = coupled,
                          .iterations_max = coupled ? 16 : 12},
                .scratch = &rope_.scratch};
    }
    void end() {
        take_impulses();
        save_contacts();
        rope_.bodies.move(h_);
        finish_strand();
    }

private:
    CarriedBody& body_of(std::size_t contact) {
        return rope_.bodies.all()[rope_.contact_body[contact]];
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
        const double margin = 0.25 * rope_.def.radius +
                              h_ * (greatest_speed(rope_.strand) + rope_.bodies.greatest_speed() +
                                    h_ * length(substep_.gravity));
        std::size_t saved = 0;
        for (std::uint32_t k = 0; k < rope_.strand.links(); k++) find_contacts_of(k, margin, saved);
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
            const std::uint32_t body =
                rope_.bodies.index_of_nearby(rope_.nearby.body_of(contact.shape));
            if (body == CarriedBodies::none ||
                rope_.bodies.is_attached_to(rope_.bodies.all()[body].id))
                continue;
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
        for (CarriedBody& body : rope_.bodies.all()) body.touching = 0;
        for (const std::uint32_t body : rope_.contact_body) rope_.bodies.all()[body].touching++;
    }

    // Response of a point of a body, of which the rope gets a share for each place where it acts.
    static Mat3 response_at(const CarriedBody& body, Vec3 arm) {
        return point_response(body.response, arm) *
               static_cast<double>(std::max<std::uint32_t>(body.attached + body.touching, 1));
    }

    void make_travels() {
        for (std::size_t k = 0; k < rope_.strand_contacts.size(); k++) {
            StrandContact& contact = rope_.strand_contacts[k];
            const CarriedBody& body = body_of(k);
            if (body.type == BodyType::static_body) continue;
            const Vec3 arm = rope_.contact_point[k] - body.center;
            contact.travel = body.travel_of(arm, h_);
            if (!body.is_pushed()) continue;
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
        rope_.clamp_attachment.clear();
        for (std::size_t k = 0; k < rope_.attachments.size(); k++) {
            const RopeAttachment& attachment = rope_.attachments[k];
            NodeLoad load{.node = attachment.node, .fixed = true, .target = attachment.point};
            Vec3 direction = attachment.direction;
            if (const CarriedBody* body = rope_.bodies.attached(k)) {
                const Vec3 arm = body->arm_to(attachment.point);
                load.target = body->center + arm + body->travel_of(arm, h_);
                direction = rotate(from_rotation_vector(body->spin * h_),
                                   rotate(body->rotation, direction));
                if (body->is_pushed()) set_mass(load, response_at(*body, arm));
            }
            rope_.loads.push_back(load);
            if (direction == Vec3{}) continue;
            rope_.clamps.push_back(
                {.last = attachment.node != 0, .direction = normalized(direction)});
            rope_.clamp_attachment.push_back(k);
        }
    }
    static void set_mass(NodeLoad& load, const Mat3& response) {
        const double most = maximum(response.x.x, maximum(response.y.y, response.z.z));
        if (!(most > 0)) return;  // all axes are locked
        load.fixed = false;
        load.mass = inverse(symmetric_part(response) + scalar_matrix(1e-9 * most));
    }

    // ---- results ----

    void take_impulses() {
        for (std::size_t k = 0; k < rope_.attachments.size(); k++)
            if (CarriedBody* body = rope_.bodies.attached(k))
                body->push(rope_.loads[k].impulse, body->arm_to(rope_.attachments[k].point));
        for (std::size_t k = 0; k < rope_.clamps.size(); k++)
            if (CarriedBody* body = rope_.bodies.attached(rope_.clamp_attachment[k]))
                body->push_angular(rope_.clamps[k].moment);
        for (std::size_t k = 0; k < rope_.strand_contacts.size(); k++) {
            const StrandContact& contact = rope_.strand_contacts[k];
            if (contact.grip == ContactGrip::open) continue;
            CarriedBody& body = body_of(k);
            body.push(contact.impulse, rope_.contact_point[k] - body.center);
        }
    }

    void save_contacts() {
        rope_.contacts.clear();
        for (std::size_t k = 0; k < rope_.strand_contacts.size(); k++) {
            const StrandContact& contact = rope_.strand_contacts[k];
            if (const CarriedBody& body = body_of(k); body.type == BodyType::dynamic)
                rope_.bodies.touch(body.id);
            if (contact.grip == ContactGrip::open) continue;
            rope_.contacts.push_back({contact.link, rope_.nearby.shape(rope_.contact_shape[k]),
                                      contact.grip, contact.slip, contact.pressure});
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

double reach_of(const Rope& rope, double dt, Vec3 gravity) {
    return 1.25 * rope.def.radius + dt * (greatest_speed(rope.strand) + dt * length(gravity));
}

void wake(Rope& rope) {
    rope.awake = true;
    rope.rest_time = 0;
}

void begin_step(World& world, Rope& rope, double dt, bool in_fields) {
    drop_lost_bodies(world, rope);
    rope.peak_tension = 0;
    rope.peak_link = 0;
    rope.substeps_done = 0;
    rope.leader = nullptr;
    rope.companions.clear();
    rope.obstacles.clear();
    const double reach = reach_of(rope, dt, world.gravity());
    if (rope.def.collide_bodies)
        rope.nearby.collect(world, bounds_of(rope, reach), dt,
                            {.categories = rope.def.body_categories});
    if (!rope.awake && (in_fields || rope.bodies.any_moves(world, rope.nearby))) wake(rope);
}

void find_bodies(World& world, Rope& rope, double dt) {
    rope.bodies.forget_old_contacts();
    // One group of sub-steps owns a leader and its companions, which find their bodies first.
    bool moves = greatest_speed(rope.strand) > rest_speed || rope.rest_time == 0;
    std::vector<BodyId> others;
    for (const Rope* companion : rope.companions) {
        const std::span<const BodyId> tied = companion->bodies.ties().bodies();
        others.insert(others.end(), tied.begin(), tied.end());
        moves = moves || companion->rest_time == 0;
    }
    if (moves) rope.bodies.tie(world, others);
    rope.bodies.find(world, rope.nearby);
    rope.may_touch = std::ranges::any_of(rope.nearby.bodies(), [&](const auto& body) {
        return !rope.bodies.is_attached_to(body.id);
    });
    if (rope.leader != nullptr) return;
    if (rope.companions.empty() && rope.obstacles.empty() && !rope.def.collide_self) {
        rope.rope_contacts = nullptr;
        return;
    }
    std::vector<Rope*> members{&rope};
    members.insert(members.end(), rope.companions.begin(), rope.companions.end());
    if (rope.rope_contacts == nullptr) rope.rope_contacts = std::make_shared<RopeContacts>();
    rope.rope_contacts->begin_step(members, rope.obstacles, dt, world.gravity());
}

void advance(Rope& rope, const RopeSubstep& substep, int count) {
    ASSERT(count >= 1 && substep.h > 0 && rope.leader == nullptr);
    std::vector<Rope*> members{&rope};
    members.insert(members.end(), rope.companions.begin(), rope.companions.end());
    int least = 1;
    for (const Rope* member : members)
        least = std::max(least, static_cast<int>(member->def.substeps));
    const bool ropes_touch = rope.rope_contacts != nullptr && !rope.rope_contacts->empty();
    int parts = (least + count - 1) / count;
    if (ropes_touch)
        parts = rope.rope_contacts->parts_of(substep.h, parts);
    else
        for (Rope* member : members) member->link_contacts.clear();
    const double h = substep.h / parts;
    std::vector<Advance> advances;
    for (Rope* member : members) {
        advances.emplace_back(*member, substep, parts, substep.h * count);
        member->bodies.read(substep.group);
    }
    std::vector<StrandJob> jobs;
    for (int n = 0; n < parts; n++) {
        for (Advance& each : advances) each.begin(n);
        const bool coupled = ropes_touch && rope.rope_contacts->begin_substep(h);
        jobs.clear();
        for (Advance& each : advances) jobs.push_back(each.job(coupled));
        if (coupled)
            advance_strands(jobs, *rope.rope_contacts);
        else
            for (const StrandJob& job : jobs) advance_strand(*job.strand, job.input, *job.scratch);
        if (ropes_touch) rope.rope_contacts->end_substep();
        for (Advance& each : advances) each.end();
    }
    for (Rope* member : members) {
        member->bodies.write(substep.group);
        member->substeps_done++;
    }
}

void end_step(World& world, Rope& rope, double dt, bool in_fields) {
    if (!rope.awake) return;
    const bool bodies_rest = rope.bodies.finish_step(world);
    const bool rests = bodies_rest && !in_fields && rope.winch[0] == 0 && rope.winch[1] == 0 &&
                       greatest_speed(rope.strand) <= rest_speed;
    rope.rest_time = rests ? rope.rest_time + dt : 0;
    if (rope.rest_time < time_to_sleep) return;
    if (!rope.bodies.all_asleep(world)) return;
    rope.awake = false;
    for (Vec3& v : rope.strand.velocities) v = {};
}

}  // namespace jostle::modules::rope_detail
