// SPDX-License-Identifier: MIT
//
// Ropes, cables, chains, elastic rods and strands of hair. A rope is solved directly in each
// sub-step, together with the bodies that it is attached to or touches: it does not stretch more
// than its stiffness says, no matter how heavy its load is, and bodies receive equal and opposite
// impulses.
//
//     auto ropes = std::make_unique<Ropes>();
//     const RopeKey rope = ropes->add(world, {.points = {{0, 5, 0}, {0, 2, 0}}}).value();
//     ropes->attach(world, rope, {.node = 0, .point = {0, 5, 0}}).expect();
//     ropes->attach(world, rope, {.node = 20, .body = crate, .point = {0, 0.5, 0}}).expect();
//     world.add_module(std::move(ropes)).expect();
//
// A rope moves in the sub-steps of the group of its bodies. A rope without dynamic bodies moves at
// the start of the step. It falls asleep with its bodies.
//
// All force fields of the world act on ropes: drag of media across the links, as on a cylinder, and
// forces per metre of rope. Ropes do not sleep in worlds with force fields.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "jostle/modules/deformables.h"
#include "jostle/modules/rope_def.h"
#include "jostle/physics/force_fields.h"
#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::modules {

namespace rope_detail {
struct Rope;
}

/// Module that owns the ropes of a world. Tag: "rope".
class Ropes : public physics::Module, public Deformables {
public:
    static constexpr std::size_t ropes_max = 1024;      ///< maximum number of ropes
    static constexpr std::size_t links_max = 20000;     ///< of all ropes
    static constexpr std::size_t attachments_max = 64;  ///< of a rope
    static constexpr double published_step_min = 0.001, published_step_max = 0.01;  ///< m
    static constexpr int points_divisor = 2;  ///< steps between publications

    Ropes();
    ~Ropes() override;

    /// Adds a rope at rest. Errors: invalid_argument, naming the field; resource_exhausted above
    /// ropes_max or links_max.
    physics::Result<RopeKey> add(physics::World& world, const RopeDef& def);
    /// Removes a rope. Errors of this and the following calls: not_found for an unknown key.
    physics::Status remove(physics::World& world, RopeKey rope);
    /// Attaches a node, instead of its previous attachment. Errors: invalid_argument, naming the
    /// field.
    physics::Status attach(physics::World& world, RopeKey rope, const RopeAttachment& attachment);
    /// Releases a node. Errors: not_found if it is not attached.
    physics::Status detach(physics::World& world, RopeKey rope, std::uint32_t node);
    /// Cuts a rope at the inner node nearest to a point (m). Returns the key of the new rope, which
    /// begins there. Errors: failed_precondition for a rope of one link; as add().
    physics::Result<RopeKey> cut(physics::World& world, RopeKey rope, physics::Vec3 point);
    /// Joins the first end of `next` to the last end of `rope`, with a link of the length of the
    /// gap, and removes the key `next`. Errors: invalid_argument if their mass, stiffness or radius
    /// differ, or if the gap is longer than the longest link; failed_precondition for one rope.
    physics::Status join(physics::World& world, RopeKey rope, RopeKey next);
    /// Sets the speed at which a winch pays rope out at an end, m/s, within 100; negative reels it
    /// in. Links are added and removed at the end, which must be attached. At most half the length
    /// of a link per step. Reeling in stops at the next attachment and at the last link, paying out
    /// at RopeDef::links_max links.
    physics::Status set_winch(physics::World& world, RopeKey rope, RopeEnd end, double speed);

    /// Keys of all ropes, in the order of add().
    std::vector<RopeKey> ropes() const;
    bool contains(RopeKey rope) const { return find(rope) != nullptr; }
    /// Definition of a rope; `points`, `links` and `length` are those of add().
    const RopeDef& def(RopeKey rope) const;
    /// Nodes of a rope in order: positions in m and velocities in m/s. Empty for an unknown key.
    /// Valid until the ropes change.
    std::span<const physics::Vec3> positions(RopeKey rope) const;
    std::span<const physics::Vec3> velocities(RopeKey rope) const;
    /// Rest lengths of the links, m.
    std::span<const double> rest_lengths(RopeKey rope) const;
    std::span<const RopeAttachment> attachments(RopeKey rope) const;
    /// Tension of a link in the last sub-step, N; negative: compression.
    double tension(RopeKey rope, std::size_t link) const;
    /// Returns whether a rope is awake.
    bool is_awake(RopeKey rope) const;
    /// Changes since the start of the last step, in order. Not saved.
    std::span<const RopeEvent> events() const { return events_; }

    // --- tools of players: deformables.h. Objects are the numbers of keys, elements are nodes ---
    std::optional<DeformableHit> cast_ray(const physics::Ray& ray) const override;
    std::optional<DeformablePoint> nearest(std::uint32_t object,
                                           physics::Vec3 point) const override;
    physics::Status push(physics::World& world, DeformablePoint at, physics::Vec3 impulse) override;
    physics::Status grab(physics::World& world, std::uint32_t holder, DeformablePoint at) override;
    bool drag(std::uint32_t holder, physics::Vec3 target) override;
    void release(std::uint32_t holder) override;
    physics::Status cut_at(physics::World& world, std::uint32_t object,
                           physics::Vec3 point) override;
    void apply_pulse(physics::World& world, const PressurePulse& pulse) override;

    std::string_view tag() const override { return "rope"; }
    void visit(physics::StateVisitor& v) override;
    void restored(const physics::World& world) override;
    /// Adds one rope from the settings of an object of RopeModule
    /// (docs/reference/scene_format.md).
    physics::Status configure(physics::World& world,
                              const physics::ModuleSettings& settings) override;

    /// Publishes the channel "rope" of the form points every points_divisor steps: each rope as a
    /// strand, with positions in steps of an eighth of its radius, 1 mm to 1 cm.
    std::vector<physics::ChannelKind> channels() const override;
    void publish(const physics::World& world, physics::ChannelWriter& channels) const override;

    physics::StepHooks hooks() const override;
    void before_step(physics::World& world, double dt) override;
    void before_substep(physics::SubstepContext& substep) override;
    void after_step(physics::World& world, double dt) override;

private:
    rope_detail::Rope* find(RopeKey key) const;
    std::size_t link_count() const;
    physics::Result<RopeKey> split(physics::World& world, rope_detail::Rope& rope, std::size_t node,
                                   RopeEventKind kind, double tension);

    std::vector<std::unique_ptr<rope_detail::Rope>> ropes_;  ///< sorted by key
    std::uint32_t last_key_ = 0;
    std::vector<RopeEvent> events_;
    std::vector<physics::FieldDef> fields_;  ///< of the world in this step; not state
};

/// Registers the module for scenes and loading. May be called repeatedly.
void register_ropes();

}  // namespace jostle::modules
