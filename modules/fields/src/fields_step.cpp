// SPDX-License-Identifier: MIT
//
// Evaluates fields in a step.
#include <algorithm>
#include <cstddef>
#include <optional>

#include "jostle/modules/fields.h"
#include "modules/fields/src/field_scratch.h"
#include "modules/fields/src/load.h"

namespace jostle::modules {

using namespace physics;
using fields_detail::Load;

namespace {

constexpr double wake_distance = 0.25;  // m that a target moves before it wakes bodies again
constexpr double noticeable_acceleration = 0.05;  // m/s^2

double to_power(double x, std::uint32_t n) {
    double power = 1;
    for (std::uint32_t k = 0; k < n; k++) power *= x;
    return power;
}

// Acceleration of a body of the given mass at a distance, m/s^2.
double pull_of(const Central& central, double distance, double mass) {
    const double force =
        central.strength / to_power(maximum(distance, central.min_distance), central.falloff);
    return central.per_mass ? force : force / mass;
}

// Current position of a target in a sub-step of a group: from the group if it contains the target,
// otherwise the position at the start of the step. nullopt if the target was destroyed.
std::optional<Vec3> target_of(const Central& central, const SubstepContext& substep,
                              double middle) {
    if (is_null(central.body)) return central.point;
    if (substep.contains(central.body)) return substep.body(central.body).center + central.point;
    const Result<BodyState> body = substep.world().body(central.body);
    if (!body.ok()) return std::nullopt;
    const double since = middle - substep.world().time();
    return body->center + body->linear_velocity * since + central.point;
}

void pull(const Central& central, Vec3 target, Load& load) {
    if (central.body == load.body.id) return;
    const Vec3 offset = target - load.body.center;
    const double distance = length(offset);
    if (!(distance > 0)) return;
    load.push(offset *
              (pull_of(central, distance, load.body.mass) * load.body.mass * load.h / distance));
}

void apply_turbulence(const Turbulence& turbulence, Load& load) {
    load.drag(
        flow_at(turbulence, load.body.center, load.time), turbulence.density, turbulence.drag,
        [&](Vec3 direction) {
            return fields_detail::projected_area(
                load.record, inverse_rotate(load.body.pose.rotation, direction));
        },
        load.gravity);
}

void push(const UserField& user, const UserForce& force, Load& load) {
    const Vec3 force_or_acceleration = force({.position = load.body.center,
                                              .velocity = load.body.linear_velocity,
                                              .mass = load.body.mass,
                                              .time = load.time,
                                              .h = load.h,
                                              .parameters = user.parameters});
    const Vec3 impulse = force_or_acceleration * (load.h * (user.per_mass ? load.body.mass : 1));
    if (is_finite(impulse)) load.push(impulse);
}

// True if the force on the body changes noticeably with time. Central is handled by
// follow_targets().
struct IsTimeVarying {
    const BodyState& body;
    const fields_detail::BodyFieldData& record;

    bool operator()(const Central&) const { return false; }
    // The area along any direction is at most the sum of the areas along three axes.
    bool operator()(const Turbulence& t) const {
        if (t.speed == 0 || t.rate == 0) return false;
        const double area = fields_detail::projected_area(record, {1, 0, 0}) +
                            fields_detail::projected_area(record, {0, 1, 0}) +
                            fields_detail::projected_area(record, {0, 0, 1});
        const double fastest = length(t.wind) + 3 * t.speed;
        return 0.5 * t.density * t.drag * area * fastest * fastest >
               noticeable_acceleration * body.mass;
    }
    bool operator()(const UserField& user) const { return !user.steady; }
    bool operator()(const Waves& waves) const {
        double highest = 0;
        for (const WaveComponent& wave : waves.components) highest += wave.amplitude;
        return highest > 0 && body.pose.position.y - record.reach < waves.level + highest;
    }
};

bool is_time_varying(const FieldLaw& law, const BodyState& body,
                     const fields_detail::BodyFieldData& record) {
    return std::visit(IsTimeVarying{body, record}, law);
}

// Maximum panel length for the shortest wave of all waters; 0 if there is no water.
template <class Entries>
double longest_panel(const Entries& entries) {
    double longest = 0;
    for (const auto& entry : entries) {
        const auto* waves = std::get_if<Waves>(&entry.field.law);
        if (waves == nullptr) continue;
        if (longest == 0) longest = 1e30;
        for (const WaveComponent& wave : waves->components)
            if (wave.amplitude > 0) longest = minimum(longest, wave.length / 8);
    }
    return longest;
}

}  // namespace

void Fields::before_step(World& world, double) {
    // The cache is invalid if another world, or this world at another step, was stepped since.
    if (world.step_count() != scratch_->step + 1) scratch_->body_cache.clear();
    scratch_->step = world.step_count();
    scratch_->body_cache.set_longest_panel(longest_panel(entries_));
    scratch_->body_cache.reserve(world.body_index_end());
    follow_targets(world);
    explode_due(world);
}

void Fields::before_substep(SubstepContext& substep) {
    if (entries_.empty()) return;
    if (substep.index() == 0) scratch_->body_cache.refresh(substep.world(), substep.bodies());
    const double middle = substep.time() + 0.5 * substep.h();
    const Vec3 gravity = substep.world().gravity();
    fields_detail::SubstepFieldState field_state = substep_field_state(substep, middle, gravity);
    for (const BodyId id : substep.bodies()) {
        if (!scratch_->body_cache.has(id)) continue;
        Load load{substep.body(id), scratch_->body_cache.of(id), gravity, middle, substep.h()};
        for (std::size_t k = 0; k < entries_.size(); k++) {
            const VolumeField& field = entries_[k].field;
            if ((load.record.categories & field.mask) != 0 &&
                contains(field.volume, load.body.center))
                apply_field(k, field_state, load);
        }
        if (load.impulse != Vec3{}) substep.add_impulse(id, load.impulse, load.body.center);
        if (load.angular_impulse != Vec3{}) substep.add_angular_impulse(id, load.angular_impulse);
    }
}

fields_detail::SubstepFieldState Fields::substep_field_state(const SubstepContext& substep,
                                                             double middle, Vec3 gravity) const {
    fields_detail::SubstepFieldState field_state;
    field_state.targets.resize(entries_.size());
    field_state.trains.resize(entries_.size());
    for (std::size_t k = 0; k < entries_.size(); k++) {
        const FieldLaw& law = entries_[k].field.law;
        if (const auto* central = std::get_if<Central>(&law))
            field_state.targets[k] = target_of(*central, substep, middle);
        if (const auto* waves = std::get_if<Waves>(&law))
            field_state.trains[k] = fields_detail::WaveTrain(*waves, -gravity.y, middle);
    }
    return field_state;
}

void Fields::apply_field(std::size_t at, fields_detail::SubstepFieldState& field_state,
                         Load& load) const {
    const Entry& entry = entries_[at];
    if (const auto* central = std::get_if<Central>(&entry.field.law)) {
        if (field_state.targets[at]) pull(*central, *field_state.targets[at], load);
    } else if (const auto* turbulence = std::get_if<Turbulence>(&entry.field.law)) {
        apply_turbulence(*turbulence, load);
    } else if (const auto* user = std::get_if<UserField>(&entry.field.law)) {
        push(*user, *entry.force, load);
    } else {
        fields_detail::apply_water_forces(std::get<Waves>(entry.field.law), field_state.trains[at],
                                          load, field_state.water);
    }
}

// Wakes sleeping bodies when an attracting body moves.
void Fields::follow_targets(World& world) {
    for (Entry& entry : entries_) {
        const auto* central = std::get_if<Central>(&entry.field.law);
        if (central == nullptr || is_null(central->body)) continue;
        const Result<BodyState> target = world.body(central->body);
        if (!target.ok()) continue;
        const Vec3 at = target->center + central->point;
        if (!(length_squared(at - entry.last_wake_position) > wake_distance * wake_distance))
            continue;
        entry.last_wake_position = at;
        std::vector<BodyState> bodies;
        world.copy_bodies(bodies);
        for (const BodyState& body : bodies) {
            if (body.type != BodyType::dynamic || body.awake || body.id == central->body) continue;
            if (!contains(entry.field.volume, body.center)) continue;
            const double pull = pull_of(*central, length(at - body.center), body.mass);
            if (absolute(pull) > noticeable_acceleration &&
                (fields_detail::categories_of(world, body.id) & entry.field.mask) != 0)
                world.wake(body.id).expect();
        }
    }
}

void Fields::explode_due(World& world) {
    blasts_.clear();
    for (std::size_t k = 0; k < charges_.size() && blasts_.size() < blasts_max;) {
        if (charges_[k].time > world.time()) {
            k++;
            continue;
        }
        blasts_.push_back(charges_[k].explosion);
        charges_.erase(charges_.begin() + static_cast<std::ptrdiff_t>(k));
        static_cast<void>(explode(world, blasts_.back()));  // was checked by add_charge()
    }
}

// Wakes bodies that just fell asleep under the influence of a time-varying field. They were awake
// in this step, so they have records.
void Fields::after_step(World& world, double) {
    if (entries_.empty()) return;
    const std::vector<BodyId> asleep(world.events().fell_asleep.begin(),
                                     world.events().fell_asleep.end());
    for (const BodyId id : asleep) {
        const Result<BodyState> body = world.body(id);
        if (!body.ok() || body->awake || !scratch_->body_cache.has(id)) continue;
        const fields_detail::BodyFieldData& record = scratch_->body_cache.of(id);
        for (const Entry& entry : entries_)
            if ((record.categories & entry.field.mask) != 0 &&
                contains(entry.field.volume, body->center) &&
                is_time_varying(entry.field.law, *body, record))
                static_cast<void>(world.wake(id));
    }
}

}  // namespace jostle::modules
