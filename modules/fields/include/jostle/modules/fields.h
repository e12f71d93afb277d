// SPDX-License-Identifier: MIT
//
// Fields beyond those of the solver (jostle/physics/force_fields.h): attraction to a body that
// moves, turbulent air, water with waves, and laws of a program's own, each in a volume; and
// charges that go off at a set time. Evaluated in every sub-step where the body then is.
//
// Like the solver's fields they wake nobody by themselves. To add, change or remove one wakes what
// is in its volume. What a load that changes with time pushes noticeably (by more than 0.05 m/s^2)
// does not fall asleep.
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

class Fields : public physics::Module {
public:
    static constexpr std::size_t fields_max = 64, charges_max = 128;
    static constexpr std::size_t waters_max = 4;  // fields that are Waves: they cost most
    static constexpr std::size_t blasts_max = 8;  // in one step; the others in those that follow

    Fields();
    ~Fields() override;

    // Of the world that has the module, or will have it.
    physics::Result<FieldKey> add(physics::World& world, const VolumeField& field);
    physics::Status set(physics::World& world, FieldKey key, const VolumeField& field);
    physics::Status remove(physics::World& world, FieldKey key);
    physics::Result<VolumeField> field(FieldKey key) const;
    std::vector<FieldKey> fields() const;

    physics::Status add_charge(const Charge& charge);
    const std::vector<Charge>& charges() const { return charges_; }  // that did not go off yet
    // By charges, before the last step.
    const std::vector<Explosion>& blasts() const { return blasts_; }

    std::string_view tag() const override { return "fields"; }
    void visit(physics::StateVisitor& v) override;
    void restored(const physics::World& world) override;
    // One field of each kind, where a number of it is given (all of docs/modules.md, "Fields"):
    // turbulence_*, waves_* and wave1_* to wave4_*, central_* with the body `center`, and
    // blast_*, a charge that goes off at blast_time.
    physics::Status configure(physics::World& world,
                              const physics::ModuleSettings& settings) override;
    // "fields.waves", told every waves_divisor steps: for each water level and density (f32) and
    // how many components; of each amplitude and length (f32), heading and phase at that step (16
    // bits of 0..2 pi), omega (f32). Clients move the waves on by themselves.
    // "fields": how many other fields, of each its kind (0 central, 1 turbulence, 2 user), then of
    // a central one its place (3 x f32), of turbulence the wind (3 x f32) and speed (f32). Then for
    // each blast of the last step its place (3 x f32) and radius (f32).
    static constexpr int waves_divisor = 60;
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
        physics::Vec3 last_wake_position =
            {};  // Central: where its body was when it last woke others
        std::shared_ptr<const UserForce> force;  // follows from the law's name
    };

    fields_detail::SubstepFieldState substep_field_state(const physics::SubstepContext& substep,
                                                         double middle,
                                                         physics::Vec3 gravity) const;
    void apply_field(std::size_t at, fields_detail::SubstepFieldState& moment,
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

    // Not state: what follows from the world, and memory used again.
    std::unique_ptr<fields_detail::FieldScratch> scratch_;
    std::vector<Explosion> blasts_;
};

// So that scenes and loads know it. May be called again.
void register_fields();

}  // namespace jostle::modules
