// SPDX-License-Identifier: MIT
//
// Force fields in addition to those of the solver (jostle/physics/force_fields.h): attraction to a
// moving body, turbulent air, water with waves, and user-defined laws, each in a volume; and
// charges that explode at a set time. Fields are evaluated in every sub-step at the current
// position of each body.
//
// Like the solver's fields, they do not wake bodies by themselves. Adding, changing or removing a
// field wakes the bodies in its volume. A body does not fall asleep while a time-varying field
// accelerates it noticeably (by more than 0.05 m/s^2).
//
//
//     auto fields = std::make_unique<Fields>();
//     fields->add(world, {.law = Turbulence{.wind = {6, 0, 0}}}).value();
//     world.add_module(std::move(fields)).expect();
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "jostle/modules/blast.h"
#include "jostle/modules/volume_field.h"
#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::modules {

namespace fields_detail {
struct SubstepFieldState;
struct Load;
struct FieldScratch;
}  // namespace fields_detail

/// Module that owns the fields and charges of a world. Tag: "fields".
class Fields : public physics::Module {
public:
    /// Maximum numbers of fields and of pending charges.
    static constexpr std::size_t fields_max = 64, charges_max = 128;
    /// Maximum number of Waves fields, which are the most expensive.
    static constexpr std::size_t waters_max = 4;
    /// Maximum number of explosions per step; the rest follow in later steps.
    static constexpr std::size_t blasts_max = 8;

    Fields();
    ~Fields() override;

    /// Adds a field to the world that owns, or will own, this module, and wakes the bodies in its
    /// volume. The error names the invalid field. Returns resource_exhausted if there are
    /// fields_max fields or waters_max waters already, and not_found if a Central body does not
    /// exist.
    physics::Result<FieldKey> add(physics::World& world, const VolumeField& field);
    /// Replaces a field. Errors are those of add(), and not_found for an unknown key.
    physics::Status set(physics::World& world, FieldKey key, const VolumeField& field);
    /// Removes a field. Returns not_found for an unknown key.
    physics::Status remove(physics::World& world, FieldKey key);
    physics::Result<VolumeField> field(FieldKey key) const;
    /// Keys of all fields, in the order of add().
    std::vector<FieldKey> fields() const;

    /// Adds a charge. Returns invalid_argument, naming the field, or resource_exhausted if
    /// charges_max charges are pending.
    physics::Status add_charge(const Charge& charge);
    /// Charges that have not exploded yet.
    const std::vector<Charge>& charges() const { return charges_; }
    /// Explosions of charges before the last step.
    const std::vector<Explosion>& blasts() const { return blasts_; }

    std::string_view tag() const override { return "fields"; }
    void visit(physics::StateVisitor& v) override;
    void restored(const physics::World& world) override;
    /// Configures the module from a scene. For each prefix with at least one setting, adds one
    /// field: turbulence_*, waves_* with wave1_* to wave4_*, and central_* with the body `center`.
    /// blast_* adds a charge that explodes at blast_time. docs/reference/scene_format.md lists
    /// all settings.
    physics::Status configure(physics::World& world,
                              const physics::ModuleSettings& settings) override;
    /// Publishing interval of "fields.waves", in steps.
    static constexpr int waves_divisor = 60;
    /// Publishes two channels.
    ///
    /// "fields.waves", every waves_divisor steps. For each water: level and density (f32) and the
    /// number of components; for each component amplitude and length (f32), heading and phase at
    /// that step (16 bits each, 0 to 2 pi) and omega (f32). Clients advance the waves themselves.
    ///
    /// "fields": the number of other fields. For each its kind (0 central, 1 turbulence, 2 user),
    /// then for central the position (3 x f32), for turbulence the mean wind (3 x f32) and speed
    /// (f32). Then for each explosion of the last step the position (3 x f32) and radius (f32).
    std::vector<physics::ChannelKind> channels() const override;
    void publish(const physics::World& world, physics::ChannelWriter& channels) const override;

    physics::StepHooks hooks() const override {
        return {.substeps = !entries_.empty(), .concurrent = true};
    }
    void before_step(physics::World& world, double dt) override;
    void before_substep(physics::SubstepContext& substep) override;
    void after_step(physics::World& world, double dt) override;

private:
    struct Entry {
        FieldKey key;
        VolumeField field;
        /// Position of the target of a Central field when it last woke bodies.
        physics::Vec3 last_wake_position = {};
        std::shared_ptr<const UserForce> force;  ///< derived from the name of the law
    };

    fields_detail::SubstepFieldState substep_field_state(const physics::SubstepContext& substep,
                                                         double middle,
                                                         physics::Vec3 gravity) const;
    void apply_field(std::size_t at, fields_detail::SubstepFieldState& field_state,
                     fields_detail::Load& load) const;
    void follow_targets(physics::World& world);
    void explode_due(physics::World& world);
    Entry* find(FieldKey key);
    std::size_t count_waters_except(FieldKey key) const;
    physics::Status check_field(const physics::World& world, FieldKey key,
                                const VolumeField& field) const;
    void visit_entry(physics::StateVisitor& v, Entry& entry);

    std::vector<Entry> entries_;
    std::uint32_t last_key_ = 0;
    std::vector<Charge> charges_;

    /// Not state: values derived from the world, and reused memory.
    std::unique_ptr<fields_detail::FieldScratch> scratch_;
    std::vector<Explosion> blasts_;
};

/// Registers the module for scenes and loading. May be called repeatedly.
void register_fields();

}  // namespace jostle::modules
