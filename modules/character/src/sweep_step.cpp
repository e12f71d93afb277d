// SPDX-License-Identifier: MIT
#include "modules/character/src/character_steps.h"

#include "modules/character/src/footing.h"
#include "modules/character/src/nearest_velocity.h"
#include "modules/character/src/steering.h"
#include "modules/character/src/sweep_parts.h"

namespace jostle::modules::character_detail {
namespace {

using namespace physics;

constexpr double touching_gap = 0.002;  // m beyond the skin within which it stands
constexpr double contact_reach = 0.02;  // m beyond the skin: contacts that may be reached next
constexpr double recovery_speed = 3;    // m/s at which it leaves obstacles closer than the skin
constexpr double ground_leave_speed = 0.05;  // m/s: above it, a rising character has left the floor
constexpr double coordinate_max = 9e6;       // m from the origin, along each axis
constexpr double lookahead_skins = 2;
constexpr int slide_iterations_max = 6;

// Moves a character in the frame of its ground before the step, then moves it along with the
// ground. It therefore follows a platform exactly, regardless of the platform's motion.
class SweepStep {
public:
    SweepStep(World& world, CharacterData& record, double dt)
        : world_(world),
          data_(record),
          environment_(make_environment_query(world, record)),
          dt_(dt),
          min_walkable_normal_y_(min_walkable_normal_y(record)),
          effort_(record.abilities.strength * dt) {}

    void run() {
        data_.applied_impulse = {};
        const CharacterControls controls = current_controls(data_, dt_);
        update_crouch(world_, data_, controls.crouch);
        core_ = capsule_of(data_, current_height(data_));
        center_ = data_.feet + up * (0.5 * current_height(data_));
        steer(controls);
        move();
        find_ground();
        move_with_ground();
        finish();
    }

private:
    // --- desired motion ---
    void steer(const CharacterControls& controls) {
        if (data_.ground != GroundKind::on_ground) detect_ground();
        grounded_ = data_.ground == GroundKind::on_ground;
        initial_velocity_ = velocity_ = data_.velocity;
        if (grounded_) ground_velocity_ = predicted_ground_velocity(data_.feet);
        if (grounded_ && is_ground_slipping()) leave_ground();
        if (should_jump(data_, controls.jump))
            jump();
        else if (grounded_)
            accelerate_on_ground(controls.walk);
        if (!grounded_) accelerate_in_air(controls.walk);
        turn_to_walk_direction(data_, controls.walk, dt_);
    }
    // The floor may have risen to it since the last step.
    void detect_ground() {
        final_velocity_ = data_.velocity;
        footing_ = probe_ground();
        if (footing_.kind != GroundKind::on_ground || is_leaving_ground(footing_)) return;
        data_.ground = footing_.kind;
        store_ground();
        data_.ground_velocity = predicted_ground_velocity(data_.feet);
        data_.velocity = horizontal(data_.velocity - data_.ground_velocity);
    }
    // A dynamic body that is knocked away does not carry the character along. A kinematic platform
    // always does.
    bool is_ground_slipping() const {
        const Result<BodyState> ground = world_.body(data_.ground_body);
        return ground.ok() && ground->type == BodyType::dynamic &&
               length(ground_velocity_ - data_.ground_velocity) >
                   data_.abilities.ground_acceleration * dt_;
    }
    void leave_ground() {
        data_.velocity += data_.ground_velocity;
        data_.ground = GroundKind::in_air;
        initial_velocity_ = velocity_ = data_.velocity;
        ground_velocity_ = {};
        grounded_ = false;
    }
    void accelerate_on_ground(Vec3 walk) {
        const Vec3 change =
            acceleration_step(velocity_, walk, data_.abilities.ground_acceleration, dt_);
        pre_push_states_.store(world_, data_.ground_body);
        // Includes the velocity change of the ground since the last step, so the ground carries the
        // mass of the character.
        push_off(world_, data_, change + horizontal(ground_velocity_ - data_.ground_velocity));
        ground_velocity_ = predicted_ground_velocity(data_.feet);
        velocity_ += change;
        desired_velocity_ = final_velocity_ = horizontal(velocity_);
        walk_velocity_ = horizontal(walk);
    }
    void jump() {
        pre_push_states_.store(world_, data_.ground_body);
        velocity_ += ground_velocity_ + push_off(world_, data_, up * data_.abilities.jump_speed);
        initial_velocity_ = velocity_;
        ground_velocity_ = {};
        grounded_ = false;
        data_.ground = GroundKind::in_air;
    }
    // velocity_ becomes the mean velocity of a parabola and final_velocity_ the velocity at its
    // end, so integration is exact.
    void accelerate_in_air(Vec3 walk) {
        if (horizontal(walk) != Vec3{}) {
            Vec3 change = acceleration_step(velocity_, walk, data_.abilities.air_acceleration, dt_);
            const Vec3 wall = normalized(horizontal(data_.ground_normal), Vec3{});
            if (data_.ground == GroundKind::on_steep_ground)
                change -= wall * minimum(dot(change, wall), 0);
            velocity_ += change;
        }
        const Vec3 fall = world_.gravity() * dt_;
        final_velocity_ = velocity_ + fall;
        initial_velocity_ += fall;
        velocity_ += fall * 0.5;
    }

    // --- movement ---
    void move() {
        const Vec3 start = center_;
        slide();
        if (!grounded_) return;
        const double size = length(desired_velocity_) * dt_;
        if (size < 1e-6) return;
        const double got = dot(center_ - start, desired_velocity_) / length(desired_velocity_);
        if (got > size - 1e-4 * (size + 0.01)) return;
        // A riser stopped it; it tries to climb.
        const Vec3 direction = (length_squared(walk_velocity_) > length_squared(desired_velocity_)
                                    ? walk_velocity_
                                    : desired_velocity_) *
                               dt_;
        if (const auto landing = climb(environment_, data_, start, direction, got + 1e-5)) {
            vertical_step_ = landing->y - start.y;
            center_ = *landing;
            final_velocity_ = desired_velocity_;
        }
    }

    void slide() {
        double left = dt_;
        std::optional<Contact> blocking_contact;
        for (int k = 0; k < slide_iterations_max; k++) {
            std::vector<Contact> contacts = current_contacts();
            if (blocking_contact) contacts.push_back(*blocking_contact);
            push(contacts, left);
            if (grounded_) follow_floor(contacts);
            const Vec3 velocity = allowed_velocities(contacts, left).nearest(velocity_);
            const VelocityPlanes touching = touching_velocities(contacts);
            final_velocity_ = touching.nearest(final_velocity_);
            if (!grounded_) velocity_ = touching.nearest(velocity_);
            const Vec3 motion = velocity * left;
            if (length_squared(motion) < 1e-16) return;
            const double fraction = advance(motion, blocking_contact);
            left *= 1 - fraction;
            if (!blocking_contact || left < 1e-6 * dt_) return;
        }
    }

    // Moves until the skin touches the first obstacle and returns the fraction of the motion. Sets
    // blocking_contact if there is an obstacle. The sweep is longer than the motion, because the
    // skin must stay free too.
    double advance(Vec3 motion, std::optional<Contact>& blocking_contact) {
        blocking_contact.reset();
        const double size = length(motion), sweep_length = size + lookahead_skins * data_.skin;
        const Vec3 direction = motion * (1 / size);
        const auto hit = environment_.sweep(core_, center_, direction * sweep_length);
        const double closing = hit ? -dot(hit->normal, direction) : 0;
        if (hit && closing <= 0 && hit->fraction <= 0) return move_out_of_overlap(motion, *hit);
        if (!hit) return move_by(motion, 1);
        if (closing <= 0)  // grazing contact
            return move_by(motion, clamp(hit->fraction * sweep_length / size - 1e-6, 0, 1));
        const double room = hit->fraction * sweep_length * closing;  // m along the normal
        const double free = maximum(0, room - data_.skin) / closing;
        if (free >= size) return move_by(motion, 1);
        blocking_contact = environment_.contact_at(*hit, room - free * closing);
        return move_by(motion, free / size);
    }
    // Leaves an overlap with a body that moved into the character.
    double move_out_of_overlap(Vec3 motion, const ShapeCastHit& overlap) {
        const double size = length(motion);
        const Result<BodyState> body = world_.body(overlap.body);
        if (!body.ok() || body->type == BodyType::static_body)
            return move_by(motion, minimum(1, data_.skin / size));
        const auto hit = environment_.sweep_ignoring(core_, center_, motion, overlap.body);
        return move_by(motion, hit ? maximum(0, hit->fraction - data_.skin / size) : 1);
    }
    double move_by(Vec3 motion, double fraction) {
        center_ += motion * fraction;
        return fraction;
    }

    // --- contact constraints ---
    // Velocity of the contact relative to the ground that carries the character, m/s.
    Vec3 relative_velocity(const Contact& contact) const {
        if (grounded_ && contact.body == data_.ground_body) return {};
        return contact.velocity - ground_velocity_;
    }
    // The same before any push of this step: other bodies may block a body that was just pushed.
    Vec3 pre_push_relative_velocity(const Contact& contact) const {
        const Result<BodyState> body = pre_push_states_.of(world_, contact.body);
        if (!contact.dynamic || !body.ok()) return relative_velocity(contact);
        return body->linear_velocity + cross(body->angular_velocity, contact.point - body->center) -
               ground_velocity_;
    }
    // For a walking character, a steep slope is also a vertical wall. Otherwise it would walk up
    // the slope.
    void add(VelocityPlanes& set, const Contact& contact, double least) const {
        set.add(contact.normal, least);
        if (!grounded_ || contact.normal.y <= 0 || contact.normal.y >= min_walkable_normal_y_)
            return;
        const Vec3 flat = horizontal(contact.normal);
        const double size = length(flat);
        if (size > 1e-6) set.add(flat * (1 / size), least / size);
    }
    VelocityPlanes allowed_velocities(const std::vector<Contact>& contacts, double left) const {
        VelocityPlanes set;
        for (const Contact& contact : contacts) {
            const double room = contact.gap - data_.skin;
            double pace = dot(contact.normal, pre_push_relative_velocity(contact));
            // The character moves a body that it can push only by impulses.
            if (contact.dynamic) pace = minimum(pace, maximum(0, dot(contact.normal, velocity_)));
            add(set, contact, pace - maximum(room / left, -recovery_speed));
        }
        return set;
    }
    VelocityPlanes touching_velocities(const std::vector<Contact>& contacts) const {
        VelocityPlanes set;
        for (const Contact& contact : contacts) {
            const double pace = dot(contact.normal, relative_velocity(contact));
            if (contact.dynamic && contact.pushed)
                add(set, contact, minimum(pace, 0));
            else if (!contact.dynamic && contact.gap - data_.skin < 0.5 * touching_gap)
                add(set, contact, pace);
        }
        return set;
    }
    // Follows the floor up and down, with the full horizontal velocity.
    void follow_floor(const std::vector<Contact>& contacts) {
        velocity_ = horizontal(velocity_);
        double rise = 0;
        bool any = false;
        for (const Contact& contact : contacts) {
            const Vec3 n = contact.normal;
            if (n.y < min_walkable_normal_y_ || contact.gap > data_.skin + touching_gap) continue;
            const double along = -dot(horizontal(n), velocity_) / n.y;
            rise = any ? maximum(rise, along) : along;
            any = true;
        }
        velocity_.y = rise;
        final_velocity_ = velocity_;
    }

    // --- pushing ---
    void push(std::vector<Contact>& contacts, double left) {
        for (Contact& contact : contacts) {
            if (!contact.dynamic) continue;
            const double closing =
                dot(contact.normal, contact.velocity - final_velocity_ - ground_velocity_);
            if (contact.gap - data_.skin > maximum(closing * left, 0.5 * touching_gap)) continue;
            pre_push_states_.store(world_, contact.body);
            PushState push{initial_velocity_ + ground_velocity_,
                           final_velocity_ + ground_velocity_,
                           effort_,
                           dt_,
                           grounded_,
                           !grounded_ || contact.body != data_.pushed};
            const PushResult given = push_body(world_, contact, data_.abilities.mass, push);
            const double impulse = given.impact + given.effort;
            if (impulse <= 0) continue;
            contact.pushed = true;
            if (is_null(pushed_)) pushed_ = contact.body;
            data_.applied_impulse -= contact.normal * impulse;
            if (grounded_) apply_ground_impulse(world_, data_, contact.normal * given.effort);
            apply_reaction(push);
            refresh_velocities(contacts, contact.body);
            contact.velocity -= contact.normal * given.velocity_change;
        }
    }
    void apply_reaction(const PushState& push) {
        const Vec3 change = push.velocity - ground_velocity_ - final_velocity_;
        effort_ = push.effort;
        initial_velocity_ += change;
        velocity_ += change;
        final_velocity_ += change;
    }
    // Velocity of the ground at a point over the step, m/s. If the ground was pushed, only its new
    // horizontal velocity is used: whether it sinks or tilts depends on its support.
    Vec3 predicted_ground_velocity(Vec3 point) const {
        const Result<BodyState> was = pre_push_states_.of(world_, data_.ground_body),
                                now = world_.body(data_.ground_body);
        if (!was.ok() || !now.ok()) return {};
        BodyState ground = *was;
        ground.linear_velocity = horizontal(now->linear_velocity) + up * was->linear_velocity.y;
        return ground_velocity_at(world_, ground, data_.ground_shape, point, dt_);
    }
    void refresh_velocities(std::vector<Contact>& contacts, BodyId body) const {
        for (Contact& contact : contacts)
            if (contact.body == body)
                contact.velocity = surface_velocity(world_, body, contact.shape, contact.point);
    }

    // --- ground contact ---
    // Contacts at the current position. The query is repeated only if the character moved or pushed
    // a body.
    const std::vector<Contact>& current_contacts() {
        if (!contacts_valid_ || contacts_center_ != center_)
            contacts_ = environment_.contacts(core_, center_, data_.skin + contact_reach);
        contacts_valid_ = is_null(pushed_);
        contacts_center_ = center_;
        return contacts_;
    }
    Footing probe_ground() {
        return find_footing(environment_, data_, center_ - up * (0.5 * current_height(data_)),
                            current_contacts(), data_.skin + touching_gap);
    }
    void find_ground() {
        Footing footing = probe_ground();
        if (grounded_ && footing.kind != GroundKind::on_ground) {
            if (const auto landing = step_down(environment_, data_, center_,
                                               data_.abilities.floor_snap, center_.y)) {
                vertical_step_ += landing->y - center_.y;
                center_ = *landing;
                footing = probe_ground();
            }
        }
        if (!grounded_) final_velocity_ = touching_velocities(contacts_).nearest(final_velocity_);
        if (footing.kind == GroundKind::on_ground && !grounded_ && is_leaving_ground(footing))
            footing = {};
        if (footing.kind == GroundKind::on_ground) close_floor_gap(footing);
        set_footing(footing);
    }
    bool is_leaving_ground(const Footing& footing) const {
        const Result<BodyState> body = pre_push_states_.of(world_, footing.body);
        if (!body.ok()) return false;
        const Vec3 ground = ground_velocity_at(world_, *body, footing.shape, footing.point, dt_);
        return dot(footing.normal, final_velocity_ - ground) > ground_leave_speed;
    }
    // Removes the gap between the skin and the floor that is due to rounding and curved floors.
    void close_floor_gap(const Footing& footing) {
        const double gap = footing.gap - data_.skin;
        if (absolute(gap) < 1e-6 || footing.contact.y < 0.3) return;
        const double drop = gap / footing.contact.y;
        // Moves only if all obstacles are farther away than the gap. Upwards, it stays within the
        // skin.
        if (contacts_.front().gap > absolute(drop)) center_.y -= drop;
    }
    void set_footing(const Footing& footing) {
        footing_ = footing;
        data_.ground = footing.kind;
        walked_off_ = grounded_ && footing.kind != GroundKind::on_ground;
        if (walked_off_)
            // Keeps the velocity of the old ground for this step
            final_velocity_ += ground_velocity_;
        else
            store_ground();
    }
    void store_ground() {
        data_.ground_body = footing_.body;
        data_.ground_shape = footing_.shape;
        data_.ground_normal = footing_.normal;
        data_.ground_point = footing_.point;
    }

    // --- moving with the ground ---
    void move_with_ground() {
        const bool stands = data_.ground == GroundKind::on_ground;
        Vec3 by;
        if (stands || walked_off_) {
            const Vec3 feet = center_ - up * (0.5 * current_height(data_));
            by = predicted_ground_velocity(feet);
            turn_with_ground();
            sweep_with_ground(by * dt_);
        }
        if (stands && !grounded_) final_velocity_ -= by;  // has landed
        if (stands)
            apply_ground_impulse(world_, data_, world_.gravity() * (data_.abilities.mass * dt_));
        store_ground();
        data_.velocity = stands ? horizontal(final_velocity_) : final_velocity_;
        data_.ground_velocity = stands ? by : Vec3{};
    }
    void turn_with_ground() {
        const Result<BodyState> ground = world_.body(data_.ground_body);
        if (ground.ok()) turn_by(data_, ground->angular_velocity.y * dt_);
    }
    void sweep_with_ground(Vec3 motion) {
        const double size = length(motion);
        if (size < 1e-12) return;
        const auto hit = environment_.sweep_ignoring(core_, center_, motion, data_.ground_body);
        if (!hit) {
            center_ += motion;
            return;
        }
        const double closing = maximum(-dot(hit->normal, motion) / size, 0.05);
        center_ += motion * maximum(0, hit->fraction - data_.skin / (closing * size));
    }

    void finish() {
        data_.pushed = pushed_;
        const Vec3 feet = center_ - up * (0.5 * current_height(data_)), a = abs(feet);
        if (!is_finite(feet) || a.x > coordinate_max || a.y > coordinate_max ||
            a.z > coordinate_max)
            data_.velocity = {};  // at the edge of the coordinate range
        else
            data_.feet = feet;
        move_kinematic_body(world_, data_, vertical_step_, length(velocity_ + ground_velocity_) + 1,
                            dt_);
    }

    World& world_;
    CharacterData& data_;
    EnvironmentQuery environment_;
    double dt_, min_walkable_normal_y_;
    double effort_;  // N s, remaining push budget
    Capsule core_;
    Vec3 center_;
    bool grounded_ = false, walked_off_ = false;
    double vertical_step_ = 0;  // m, upwards: climbing a step or following the floor down
    // m/s relative to the ground that carries it: initial, mean and final velocity of the step.
    Vec3 initial_velocity_, velocity_, final_velocity_, desired_velocity_, walk_velocity_;
    Vec3 ground_velocity_;           // m/s, of that ground
    std::vector<Contact> contacts_;  // at contacts_center_
    Vec3 contacts_center_;
    bool contacts_valid_ = false;
    Footing footing_;
    PrePushStates pre_push_states_;
    BodyId pushed_;  // first body pushed in this step
};

}  // namespace

void sweep_step(World& world, CharacterData& record, double dt) {
    SweepStep(world, record, dt).run();
}

}  // namespace jostle::modules::character_detail
