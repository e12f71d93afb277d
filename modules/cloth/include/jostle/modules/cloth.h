// SPDX-License-Identifier: MIT
//
// Cloth: flags, curtains, sails, nets and clothes. A cloth is solved thread by thread in each
// sub-step, so it does not stretch more than its stiffness says, no matter how many rows it has,
// and bodies receive equal and opposite impulses.
//
//     auto cloths = std::make_unique<Cloths>();
//     const ClothKey flag = cloths->add(world, {.grid = {.rows = 20, .columns = 30}}).value();
//     cloths->attach(world, flag, {.vertex = 0, .point = {0, 5, 0}}).expect();
//     world.add_module(std::move(cloths)).expect();
//
// A cloth moves in the sub-steps of the group of its bodies. A cloth without dynamic bodies moves
// at the start of the step. It falls asleep with its bodies. Winds of the world (force_fields.h)
// that contain the centre of the cloth push its faces; other force fields do not act on cloth.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "jostle/modules/cloth_def.h"
#include "jostle/modules/deformables.h"
#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::modules {

namespace cloth_detail {
struct Cloth;
}

/// Module that owns the cloth of a world. Tag: "cloth".
class Cloths : public physics::Module, public Deformables {
public:
    static constexpr std::size_t cloths_max = 256;        ///< maximum number of cloths
    static constexpr std::size_t vertices_max = 100000;   ///< of all cloths
    static constexpr std::size_t attachments_max = 1000;  ///< of a cloth
    static constexpr double published_step_min = 0.001, published_step_max = 0.01;  ///< m
    static constexpr int points_divisor = 2;  ///< steps between publications

    Cloths();
    ~Cloths() override;

    /// Adds a cloth at rest. Errors: invalid_argument, naming the field; resource_exhausted above
    /// cloths_max or vertices_max.
    physics::Result<ClothKey> add(physics::World& world, const ClothDef& def);
    /// Removes a cloth. Errors of this and the following calls: not_found for an unknown key.
    physics::Status remove(physics::World& world, ClothKey cloth);
    /// Attaches a vertex, instead of its previous attachment. Errors: invalid_argument, naming the
    /// field.
    physics::Status attach(physics::World& world, ClothKey cloth,
                           const ClothAttachment& attachment);
    /// Releases a vertex. Errors: not_found if it is not attached.
    physics::Status detach(physics::World& world, ClothKey cloth, std::uint32_t vertex);
    /// Breaks the threads at all vertices within `radius` (m, 0 to 1e6) of a point (m) and returns
    /// how many. Errors: invalid_argument.
    physics::Result<std::uint32_t> tear(physics::World& world, ClothKey cloth, physics::Vec3 point,
                                        double radius);
    /// Applies an impulse (N s) to a vertex. Errors: invalid_argument.
    physics::Status apply_impulse(physics::World& world, ClothKey cloth, std::uint32_t vertex,
                                  physics::Vec3 impulse);

    /// Keys of all cloths, in the order of add().
    std::vector<ClothKey> cloths() const;
    bool contains(ClothKey cloth) const { return find(cloth) != nullptr; }
    /// Definition of a cloth. That of an unknown key is the default.
    const ClothDef& def(ClothKey cloth) const;
    /// Positions in m and velocities in m/s of the vertices. Empty for an unknown key.
    std::vector<physics::Vec3> positions(ClothKey cloth) const;
    std::vector<physics::Vec3> velocities(ClothKey cloth) const;
    /// Masses of the vertices, kg.
    std::vector<double> masses(ClothKey cloth) const;
    /// Triangles that are not torn. Valid until the cloths change.
    std::span<const std::array<std::uint32_t, 3>> triangles(ClothKey cloth) const;
    std::span<const ClothAttachment> attachments(ClothKey cloth) const;
    /// Greatest tension of a thread in the last sub-step, N/m.
    double greatest_tension(ClothKey cloth) const;
    /// Returns whether a cloth is awake.
    bool is_awake(ClothKey cloth) const;
    /// Changes since the start of the last step, in order. Not saved.
    std::span<const ClothEvent> events() const { return events_; }

    // --- tools of players: deformables.h. Objects are the numbers of keys, elements are vertices.
    // cut_at() tears the threads of the nearest vertex. ---
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

    std::string_view tag() const override { return "cloth"; }
    void visit(physics::StateVisitor& v) override;
    void restored(const physics::World& world) override;
    /// Adds one cloth from the settings of an object of ClothModule
    /// (docs/reference/scene_format.md).
    physics::Status configure(physics::World& world,
                              const physics::ModuleSettings& settings) override;

    /// Publishes the channel "cloth" of the form points every points_divisor steps: each cloth of
    /// up to 65,536 vertices as a grid, or as triangles if it is a mesh or torn, in steps of half
    /// its thickness, 1 mm to 1 cm.
    std::vector<physics::ChannelKind> channels() const override;
    void publish(const physics::World& world, physics::ChannelWriter& channels) const override;

    physics::StepHooks hooks() const override;
    void before_step(physics::World& world, double dt) override;
    void before_substep(physics::SubstepContext& substep) override;
    void after_step(physics::World& world, double dt) override;

private:
    cloth_detail::Cloth* find(ClothKey key) const;
    std::size_t vertex_count() const;

    std::vector<std::unique_ptr<cloth_detail::Cloth>> cloths_;  ///< sorted by key
    std::uint32_t last_key_ = 0;
    std::vector<ClothEvent> events_;
};

/// Registers the module for scenes and loading. May be called repeatedly.
void register_cloths();

}  // namespace jostle::modules
