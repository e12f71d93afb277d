// SPDX-License-Identifier: MIT
#include "jostle/modules/particle_group.h"

#include <algorithm>

#include "jostle/physics/limits.h"
#include "modules/particles/src/body_impacts.h"
#include "modules/particles/src/emit.h"
#include "modules/particles/src/integrate_particles.h"
#include "modules/particles/src/particle_contacts.h"
#include "modules/particles/src/particle_fields.h"
#include "modules/particles/src/surface_response.h"

namespace jostle::modules {

using namespace physics;
using namespace particles_detail;

namespace {

constexpr double fast = 1e6;          // m/s; faster particles are removed
constexpr double ended = -1;          // lifetime of a particle that is to be removed
constexpr double lifetime_max = 1e6;  // s
// Ids of emitted particles are even at a rate and odd in bursts; those that callers add follow
// their own count.

bool in_range(Vec3 position, Vec3 velocity) {
    const Vec3 p = abs(position), v = abs(velocity);
    const double far = limits::max_coordinate;
    return p.x <= far && p.y <= far && p.z <= far && v.x <= fast && v.y <= fast && v.z <= fast;
}

// Reflects a particle that moved behind a plane.
void hit_plane(const ParticleGroupDef& def, const ParticleSupport& plane, Vec3 before,
               Vec3 acceleration, double h, double rest_speed, Vec3& position, Vec3& velocity) {
    const Vec3 n = plane.normal;
    const double after = dot(n, position) - plane.offset;
    if (after >= 0) return;
    const double start = dot(n, before) - plane.offset;
    const double fraction = start > 0 ? start / (start - after) : 0;
    Vec3 touch = before + (position - before) * fraction;
    if (start <= 0) touch -= n * start;
    const ParticleBounce bounce = bounce_particle(
        {.velocity = velocity, .acceleration = acceleration, .left = h * (1 - fraction)},
        {.normal = n}, {def.mass, def.restitution, def.friction}, rest_speed);
    position = touch + bounce.move;
    // A motion that ends behind the plane again, within the same substep, ends on it.
    const double still = dot(n, position) - plane.offset;
    if (still < 0) position -= n * still;
    velocity = bounce.velocity;
}

}  // namespace

namespace {

bool has_room_for_springs(std::size_t springs, const ParticleGroupDef& def) {
    return springs <= ParticleGroupDef::springs_max &&
           springs * def.substeps <= ParticleGroupDef::springs_max;
}

bool valid(const ParticleSpring& spring, std::size_t particles) {
    const Vec3 p = abs(spring.anchor);
    const double far = limits::max_coordinate;
    const auto within = [](double x, double most) { return x >= 0 && x <= most; };
    return spring.a < particles && spring.a != spring.b &&
           (spring.b < particles || spring.b == spring_anchor) && p.x <= far && p.y <= far &&
           p.z <= far && within(spring.rest_length, 1e4) && within(spring.stiffness, 1e9) &&
           within(spring.damping, 1e6);
}

}  // namespace

ParticleGroup::ParticleGroup() : scratch_(std::make_unique<ParticleScratch>()) {}
ParticleGroup::ParticleGroup(ParticleGroup&&) noexcept = default;
ParticleGroup& ParticleGroup::operator=(ParticleGroup&&) noexcept = default;
ParticleGroup::~ParticleGroup() = default;

Result<ParticleGroup> ParticleGroup::create(const ParticleGroupDef& def) {
    ParticleGroup group;
    if (Status s = group.set_def(def); !s.ok()) return s.error();
    return group;
}

Status ParticleGroup::set_def(const ParticleGroupDef& def) {
    if (Status s = check(def); !s.ok()) return s;
    if (!has_room_for_springs(springs_.size(), def))
        return Error{ErrorCode::resource_exhausted,
                     "springs times substeps is " + std::to_string(springs_.size() * def.substeps) +
                         "; the maximum is 20000"};
    if (def.cosmetic && !def_.cosmetic) clear();
    if (def.planar && !def_.planar) {
        for (Vec3& p : positions_) p.z = 0;
        for (Vec3& u : velocities_) u.z = 0;
    }
    def_ = def;
    return {};
}

Status ParticleGroup::add(std::span<const ParticleStart> particles) {
    if (def_.cosmetic && !particles.empty())
        return Error{ErrorCode::failed_precondition,
                     "the group is cosmetic; only its emitter creates particles"};
    if (particles.size() > def_.count_max - std::min<std::size_t>(size(), def_.count_max))
        return Error{ErrorCode::resource_exhausted, "the group has " + std::to_string(size()) +
                                                        " particles; count_max is " +
                                                        std::to_string(def_.count_max)};
    for (std::size_t k = 0; k < particles.size(); k++) {
        const auto& [position, velocity, lifetime] = particles[k];
        const Vec3 v = abs(velocity);
        const double most = limits::max_speed;
        if (!in_range(position, velocity) || !(v.x <= most && v.y <= most && v.z <= most) ||
            !(lifetime >= 0 && lifetime <= lifetime_max))
            return invalid_argument("particles[" + std::to_string(k) +
                                    "] is out of range; position must be within 1e7 m, velocity "
                                    "within 1e4 m/s, lifetime from 0 to 1e6 s");
    }
    for (const auto& [position, velocity, lifetime] : particles) {
        Vec3 p = position, v = velocity;
        if (def_.planar) p.z = v.z = 0;
        positions_.push_back(p), velocities_.push_back(v);
        ages_.push_back(0), lifetimes_.push_back(lifetime);
        ids_.push_back(next_id_++);
    }
    return {};
}

Status ParticleGroup::add_springs(std::span<const ParticleSpring> springs) {
    if (springs.size() > ParticleGroupDef::springs_max - springs_.size())
        return Error{
            ErrorCode::resource_exhausted,
            "the group has " + std::to_string(springs_.size()) + " springs; the maximum is 100000"};
    if (def_.cosmetic && !springs.empty())
        return Error{ErrorCode::failed_precondition, "cosmetic particles have no springs"};
    for (std::size_t k = 0; k < springs.size(); k++)
        if (!valid(springs[k], size()))
            return invalid_argument(
                "springs[" + std::to_string(k) +
                "] is out of range; a and b must be particles of the group, rest_length from 0 to "
                "1e4 m, stiffness from 0 to 1e9 N/m, damping from 0 to 1e6 N s/m");
    springs_.insert(springs_.end(), springs.begin(), springs.end());
    return {};
}

void ParticleGroup::clear() {
    positions_.clear(), velocities_.clear(), ages_.clear(), lifetimes_.clear(), ids_.clear();
    springs_.clear();
}

// Particles that start within the interval move to its end: exactly in uniform gravity.
void ParticleGroup::emit(Vec3 gravity, double from, double to) {
    const auto start = [&](const EmittedParticle& made) {
        const double age = to - made.time;
        if (size() >= def_.count_max || !(age < made.lifetime)) return;
        const Vec3 g = gravity * def_.gravity_scale;
        positions_.push_back(made.position + made.velocity * age + g * (0.5 * age * age));
        velocities_.push_back(made.velocity + g * age);
        ages_.push_back(age), lifetimes_.push_back(made.lifetime);
        ids_.push_back(made.id);
    };
    const Emitter& e = def_.emitter;
    const EmittedRange rate = emitted_at_rate(e, from, to, def_.count_max);
    for (std::uint64_t k = rate.first; k < rate.last; k++)
        start(particle_at_rate(e, k, def_.planar));
    const EmittedRange bursts = emitted_in_bursts(e, from, to, def_.count_max);
    for (std::uint64_t k = bursts.first; k < bursts.last; k++)
        start(particle_of_burst(e, k, def_.planar));
}

void ParticleGroup::advance(const ParticleEnvironment& environment, double from, double to) {
    ParticleEnvironment inside = environment;
    if (def_.planar) inside.gravity.z = 0;
    if (!def_.world_fields) inside.fields = {};
    const double dt = to - from, h = dt / def_.substeps;
    for (std::uint32_t k = 0; k < def_.substeps && size() > 0; k++)
        substep(inside, from + k * h, h);
    for (double& age : ages_) age += dt;
    remove_expired();
    emit(inside.gravity, from, to);
}

void ParticleGroup::substep(const ParticleEnvironment& environment, double time, double h) {
    ParticleScratch& s = *scratch_;
    const bool hits_bodies = environment.bodies != nullptr && def_.collide_bodies && !def_.cosmetic;
    s.before_position = positions_;
    s.mean_acceleration = velocities_;
    const ParticleForces forces{def_, environment, springs_};
    integrate_particles(def_.integrator, forces, positions_, velocities_, time, h, s);
    for (std::size_t k = 0; k < positions_.size(); k++) {
        if (in_range(positions_[k], velocities_[k])) continue;
        positions_[k] = s.before_position[k];
        velocities_[k] = {};
        lifetimes_[k] = ended;
    }
    // Of the integration, without impacts; 0 for tracers, which have no inertia.
    for (std::size_t k = 0; k < positions_.size(); k++)
        s.mean_acceleration[k] =
            def_.follow_flow ? Vec3{} : (velocities_[k] - s.mean_acceleration[k]) * (1 / h);
    // The speed that gravity causes within a substep, with a margin for the order of impacts.
    const double rest_speed = 2 * h * length(environment.gravity) * absolute(def_.gravity_scale);
    s.supports.clear();
    if (hits_bodies)
        environment.bodies->resolve(*this, s.before_position, s.mean_acceleration, h, rest_speed);
    s.planes.clear();
    for (const auto& [normal, offset] : def_.planes)
        s.planes.push_back({normal * (1 / length(normal)), offset + def_.radius, 0});
    for (const ParticleSupport& plane : s.planes)
        for (std::size_t k = 0; k < positions_.size(); k++)
            hit_plane(def_, plane, s.before_position[k], s.mean_acceleration[k], h, rest_speed,
                      positions_[k], velocities_[k]);
    if (!def_.collide_particles) return;
    s.stage_position = positions_;
    resolve_contacts(def_, h, rest_speed, environment.world, s.before_position, positions_,
                     velocities_, s);
    if (hits_bodies) environment.bodies->hold(*this, s.stage_position);
}

// Keeps the order, so that results do not depend on which particles ended before.
void ParticleGroup::remove_expired() {
    std::vector<std::uint32_t>& new_index = scratch_->new_index;
    new_index.resize(size());
    std::uint32_t left = 0;
    for (std::size_t k = 0; k < size(); k++) {
        const bool over = lifetimes_[k] < 0 || (lifetimes_[k] > 0 && ages_[k] >= lifetimes_[k]) ||
                          !in_range(positions_[k], velocities_[k]);
        new_index[k] = over ? spring_anchor : left;
        if (over) continue;
        positions_[left] = positions_[k], velocities_[left] = velocities_[k];
        ages_[left] = ages_[k], lifetimes_[left] = lifetimes_[k], ids_[left] = ids_[k];
        left++;
    }
    if (left == size()) return;
    std::erase_if(springs_, [&](const ParticleSpring& spring) {
        return new_index[spring.a] == spring_anchor ||
               (spring.b != spring_anchor && new_index[spring.b] == spring_anchor);
    });
    for (ParticleSpring& spring : springs_) {
        spring.a = new_index[spring.a];
        if (spring.b != spring_anchor) spring.b = new_index[spring.b];
    }
    positions_.resize(left), velocities_.resize(left);
    ages_.resize(left), lifetimes_.resize(left), ids_.resize(left);
}

void ParticleGroup::apply_pulse(const PressurePulse& pulse) {
    if (def_.cosmetic || def_.radius == 0) return;
    const double area = pi * def_.radius * def_.radius;
    for (std::size_t k = 0; k < positions_.size(); k++) {
        if (length_squared(positions_[k] - pulse.center) >= pulse.radius * pulse.radius) continue;
        Vec3 change = pulse.change_of(positions_[k], area, def_.mass);
        if (def_.planar) change.z = 0;
        velocities_[k] += change;
    }
}

double ParticleGroup::kinetic_energy() const {
    double sum = 0;
    for (const Vec3& v : velocities_) sum += length_squared(v);
    return 0.5 * def_.mass * sum;
}

Vec3 ParticleGroup::momentum() const {
    Vec3 sum;
    for (const Vec3& v : velocities_) sum += v;
    return sum * def_.mass;
}

void ParticleGroup::visit(StateVisitor& v) {
    v.enter("def");
    StateFields fields(v);
    visit_def(fields, def_);
    v.leave();
    if (v.loading() && !v.failed())
        if (Status s = check(def_); !s.ok()) v.fail("def", s.error().message);
    std::size_t count = v.count("size", size());
    if (v.loading()) {
        if (v.failed()) count = 0;
        if (count > ParticleGroupDef::particles_max) {
            v.fail("size", "is more than 100000");
            count = 0;
        }
        positions_.resize(count), velocities_.resize(count);
        ages_.resize(count), lifetimes_.resize(count), ids_.resize(count);
    }
    v.field("positions", std::span(positions_));
    v.field("velocities", std::span(velocities_));
    v.field("ages", std::span(ages_));
    v.field("lifetimes", std::span(lifetimes_));
    v.field("ids", std::span(ids_));
    v.field("next_id", next_id_);
    v.all("springs", springs_, [&](ParticleSpring& spring) {
        v.field("a", spring.a);
        v.field("b", spring.b);
        v.field("anchor", spring.anchor);
        v.field("rest_length", spring.rest_length);
        v.field("stiffness", spring.stiffness);
        v.field("damping", spring.damping);
    });
    if (v.loading()) check_loaded(v);
}

void ParticleGroup::check_loaded(StateVisitor& v) const {
    if (v.failed()) return;
    for (std::size_t k = 0; k < size(); k++) {
        if (!in_range(positions_[k], velocities_[k]))
            v.fail("positions", "or velocities of particle " + std::to_string(k) +
                                    " are out of range; they must be within 1e7 m and 1e6 m/s");
        if (!(ages_[k] >= 0 && ages_[k] <= 1e12 && lifetimes_[k] >= 0 &&
              lifetimes_[k] <= 2 * lifetime_max))
            v.fail("ages", "or lifetimes of particle " + std::to_string(k) +
                               " are out of range; they must be from 0 to 1e12 s and 2e6 s");
        if (def_.planar && (positions_[k].z != 0 || velocities_[k].z != 0))
            v.fail("positions", "leave the xy plane in a planar group");
    }
    if (!has_room_for_springs(springs_.size(), def_))
        v.fail("springs", "times substeps is more than 20000");
    if (def_.cosmetic && size() + springs_.size() > 0)
        v.fail("size", "is not 0 for cosmetic particles, which clients simulate");
    for (const ParticleSpring& spring : springs_)
        if (!valid(spring, size())) v.fail("springs", "has a spring that is out of range");
}

}  // namespace jostle::modules
