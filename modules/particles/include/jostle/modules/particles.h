// SPDX-License-Identifier: MIT
//
// Particles in a world: spray, sparks, smoke, balls, ropes and clouds of points. They hit the
// shapes of the world and push its dynamic bodies with equal and opposite impulses.
//
//     auto particles = std::make_unique<Particles>();
//     particles->add(world, {.radius = 0.03, .emitter = {.rate = 500, .speed = 8}}).value();
//     world.add_module(std::move(particles)).expect();
//
// Groups move after each step of the world, against the new poses of its bodies. A particle of
// radius 0 is swept as a ray and others as balls, so they do not tunnel through bodies at rest. A
// sleeping body is not woken by impulses that would change the velocity at its centre by less than
// wake_speed in a step; it then acts as if it were static.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "jostle/modules/particle_group.h"
#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::modules {

/// Identifies a group of a module. Keys are never reused.
struct ParticleKey {
    std::uint32_t number = 0;

    auto operator<=>(const ParticleKey&) const = default;
};

/// Module that owns the particles of a world. Tag: "particles".
class Particles : public physics::Module, public PulseReceiver {
public:
    static constexpr std::size_t groups_max = 64;  ///< maximum number of groups
    /// Maximum of work(): a step takes less than about a second even with extreme settings.
    static constexpr double work_max = 4e6;
    /// m/s; see above.
    static constexpr double wake_speed = 0.02;
    /// m: published positions are multiples of a quarter of the radius, within these limits.
    static constexpr double published_step_min = 0.002, published_step_max = 0.02;
    /// Publishing interval of the points, in steps.
    static constexpr int points_divisor = 2;

    Particles();
    ~Particles() override;

    /// Adds a group. Returns invalid_argument, naming the field, or resource_exhausted above
    /// groups_max or work_max.
    physics::Result<ParticleKey> add(const physics::World& world, const ParticleGroupDef& def);
    /// Removes a group. Returns not_found for an unknown key.
    physics::Status remove(ParticleKey key);
    /// Replaces the definition of a group. Errors as add(), and not_found.
    physics::Status set(ParticleKey key, const ParticleGroupDef& def);
    /// Sum of work_of() of the groups that the world simulates.
    double work() const { return work_except({}); }
    /// Keys of all groups, in the order of add().
    std::vector<ParticleKey> groups() const;
    /// Returns a group; null for an unknown key. Valid until add() or remove().
    ParticleGroup* group(ParticleKey key);
    const ParticleGroup* group(ParticleKey key) const;

    /// Pulses of pressure, such as explosions, push particles with a radius (deformables.h).
    void apply_pulse(physics::World& world, const PressurePulse& pulse) override;

    std::string_view tag() const override { return "particles"; }
    void visit(physics::StateVisitor& v) override;
    void restored(const physics::World& world) override;
    /// Adds one group from the settings of an object of ParticlesModule
    /// (docs/reference/scene_format.md).
    physics::Status configure(physics::World& world,
                              const physics::ModuleSettings& settings) override;

    /// Publishes two channels.
    ///
    /// "particles", of the form points, every points_divisor steps: an object of loose points per
    /// group that is not cosmetic, with the key of the group, its radius and its color.
    ///
    /// "particles.cosmetic", of the form seed: the definitions of cosmetic groups, as
    /// encode_cosmetic() writes them (cosmetic_particles.h). It changes only with them.
    std::vector<physics::ChannelKind> channels() const override;
    void publish(const physics::World& world, physics::ChannelWriter& channels) const override;

    void after_step(physics::World& world, double dt) override;

private:
    struct Entry {
        ParticleKey key;
        ParticleGroup group;
    };

    Entry* find(ParticleKey key);
    double work_except(ParticleKey key) const;
    physics::Status check_work(ParticleKey key, const ParticleGroupDef& def) const;
    void refresh_fields(const physics::World& world);
    void check_loaded(physics::StateVisitor& v) const;

    std::vector<Entry> entries_;
    std::uint32_t last_key_ = 0;
    /// World time at the end of the last step of the groups, s. Emission continues from it.
    double time_ = 0;

    /// Not state: reused memory.
    std::unique_ptr<particles_detail::BodyImpacts> impacts_;
    std::vector<physics::FieldDef> fields_;
};

/// Registers the module for scenes and loading. May be called repeatedly.
void register_particles();

}  // namespace jostle::modules
