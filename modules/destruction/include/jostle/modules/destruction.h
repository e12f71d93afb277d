// SPDX-License-Identifier: MIT
//
// Destructible bodies: chunks connected by bonds. Each connected group of chunks, called a piece,
// is one body. Loads (weight, contacts, impacts, inertia) are transmitted through the bonds as
// through short beams. Overloaded bonds break, and after the step each disconnected group of chunks
// becomes a body of its own.
//
//     auto module = std::make_unique<Destruction>();
//     Destruction& destruction = *module;
//     world.add_module(std::move(module));
//     FracturedShape wall = fracture_box(half, random_seeds(half, 200, 7)).value();
//     anchor(wall, {0, -1, 0}, half.y - 0.01);
//     DestructibleId id = *destruction.add(world, wall, {.pose = {.position = {0, half.y, 0}}});
//
// A piece with an anchored chunk is a static body. Undamaged, it costs as much as one static body.
// Bonds are evaluated again only after loads changed by 5 %.
//
// The solver handles contacts as if nothing broke, but a breaking piece cannot exert more force
// than its bonds bear. If bonds broke, the excess impulse is reversed on both bodies, minus the
// energy dissipated by the broken bonds, and the bodies collide again in the next step with the
// remaining speed. Single chunks that are knocked out do not jam: for 0.2 s they pass through the
// pieces of their destructible.
//
// Thread rule: that of World.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <vector>

#include "jostle/modules/fractured_shape.h"
#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::modules {

namespace destruction_detail {
struct DestructionState;
}

/// Material of bonds. The defaults are those of weak concrete.
struct BondMaterial {
    double young = 2e10;       ///< Pa, Young's modulus, 1 to 1e13
    double poisson = 0.2;      ///< Poisson's ratio, 0 to 0.5
    double tensile = 1.5e6;    ///< Pa, tensile strength, 1 to 1e13
    double shear = 3e6;        ///< Pa, shear strength, 1 to 1e13
    double compressive = 2e7;  ///< Pa, compressive strength, 1 to 1e13
    /// J/m^2, energy dissipated by breaking, taken from an impact; 0 to 1e9.
    double fracture_energy = 80;
    /// Duration of an impact, s, 1e-5 to 1. The impact force is the impulse divided by this time,
    /// or by the step length if that is shorter.
    double contact_time = 0.005;
};

/// Description of a destructible.
struct DestructibleDef {
    physics::Transform pose = {};  ///< of the frame of the shape
    /// m/s, of the centre of mass; used only if no chunk is anchored
    physics::Vec3 linear_velocity = {};
    physics::Vec3 angular_velocity = {};  ///< rad/s; used only if no chunk is anchored
    double density = 2400;                ///< kg/m^3, 1e-3 to 1e6
    physics::Material surface = {};
    physics::Filter filter = {};
    BondMaterial bonds = {};
};

/// Limits of the work per step. Work beyond them is deferred to later steps.
struct DestructionLimits {
    int rounds = 8;              ///< rounds of breaking bonds and solving again in a step, 1 to 64
    int pieces_per_step = 2048;  ///< new bodies per step, 1 to 1000000
    /// Products of 6 x 6 blocks for factorizations, 1 to 1e12. At least one factorization is done
    /// per step.
    std::int64_t work_per_step = 40000;
    /// s, 0 to 1e6: loose single chunks are removed after it; 0 disables removal
    double debris_life = 0;
    double debris_volume = 0;  ///< m^3, 0 to 1e12: removal applies to smaller chunks only
    /// Volume, m^3, 0 to 1e12, below which loose single chunks do not collide with each other and
    /// have no continuous collision detection. They still collide with everything else. Intended
    /// for thousands of chunks: skipped pairs cost almost nothing. It has no effect if the filter
    /// has a group.
    double passing_volume = 0;
};

/// Identifies a destructible. Valid until it is removed. A default id is null.
struct DestructibleId {
    std::uint32_t index = 0xffffffff;
    std::uint32_t generation = 0;

    auto operator<=>(const DestructibleId&) const = default;
};

/// Module that owns the destructibles of a world. Tag: "destruction".
class Destruction : public physics::Module {
public:
    Destruction();
    ~Destruction() override;

    std::string_view tag() const override { return "destruction"; }
    void visit(physics::StateVisitor& v) override;
    /// Configures the module from a scene: a row of walls along x, anchored at their foot. Numbers:
    /// - count (0 to 100), spacing (m, 0 to 1000), width, height (m, 0.1 to 100), thickness (m,
    ///   0.02 to 100), chunks (per wall, 1 to 2000), seed;
    /// - x, y, z: middle of the foot of the first wall (m); heading (rad about y);
    /// - density, tensile, shear, compressive (Pa) and fracture_energy;
    /// - debris_life, debris_volume and passing_volume.
    /// With the bytes `shape`, the contents of a fracture file, it creates that shape with its
    /// origin at x, y, z instead of walls.
    physics::Status configure(physics::World& world,
                              const physics::ModuleSettings& settings) override;
    /// Publishes the channel "destruction": for each destructible the numbers of pieces, of intact
    /// bonds, and of bonds in total.
    std::vector<physics::ChannelKind> channels() const override { return {{}}; }
    void publish(const physics::World& world, physics::ChannelWriter& channels) const override;
    physics::StepHooks hooks() const override { return {.pre_solve = true}; }
    void before_step(physics::World& world, double dt) override;
    void pre_solve(physics::PreSolve& pair) override;
    void after_step(physics::World& world, double dt) override;

    /// Replaces the limits. invalid_argument names the one that is out of range.
    physics::Status set_limits(const DestructionLimits& limits);
    const DestructionLimits& limits() const;

    /// Creates a destructible: one body, static if a chunk is anchored. On failure, nothing is
    /// created. invalid_argument names the chunk or bond that is invalid.
    physics::Result<DestructibleId> add(physics::World& world, const FracturedShape& shape,
                                        const DestructibleDef& def);
    /// Removes a destructible with all its pieces. Returns not_found for an unknown id, as all
    /// calls with an id do.
    physics::Status remove(physics::World& world, DestructibleId id);

    /// Breaks the bonds whose centre is within a ball (m, world). The pieces separate after the
    /// next step. Returns the number of broken bonds.
    physics::Result<std::size_t> break_near(const physics::World& world, DestructibleId id,
                                            physics::Vec3 center, double radius);

    /// The same for all destructibles.
    std::size_t break_near(const physics::World& world, physics::Vec3 center, double radius);

    /// Returns false after removal.
    bool contains(DestructibleId id) const;
    /// Number of destructibles.
    std::size_t size() const;
    /// Bodies of all pieces.
    physics::Result<std::vector<physics::BodyId>> bodies(DestructibleId id) const;
    /// Number of bonds that are not broken.
    physics::Result<std::size_t> intact_bonds(DestructibleId id) const;
    /// Returns the largest load of a bond of anchored pieces under gravity alone, as a fraction of
    /// its strength. Expensive: factorizes the stiffness of each connected group.
    physics::Result<double> max_load_ratio(const physics::World& world, DestructibleId id) const;

private:
    std::unique_ptr<destruction_detail::DestructionState> state_;
};

}  // namespace jostle::modules
