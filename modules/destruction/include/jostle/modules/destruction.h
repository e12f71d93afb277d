// SPDX-License-Identifier: MIT
//
// Bodies that break: chunks held together by bonds, one body for all that hangs together. Loads
// (weight, contacts, impacts, inertia) go through the bonds as through short beams; bonds that bear
// too much break, and after the step what no longer hangs together becomes bodies of its own.
//
//     auto module = std::make_unique<Destruction>();
//     Destruction& destruction = *module;
//     world.add_module(std::move(module));
//     FracturedShape wall = fracture_box(half, random_seeds(half, 200, 7)).value();
//     anchor(wall, {0, -1, 0}, half.y - 0.01);
//     DestructibleId id = *destruction.add(world, wall, {.pose = {.position = {0, half.y, 0}}});
//
// What hangs together with an anchored chunk is a static body: whole, it costs what one static body
// costs. What bonds bear is asked anew only when loads changed by a twentieth.
//
// The solver lets bodies meet as if nothing broke. But what breaks pushes no harder than its bonds
// bear: where bonds broke, what was more is taken back from both bodies, less what the broken bonds
// took of the energy, and in the next step they meet again with what is left. Single chunks that
// are knocked out do not jam: for a fifth of a second they pass what they broke out of.
//
// Thread rule: that of the World.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "jostle/modules/fractured_shape.h"
#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::modules {

namespace destruction_detail {
class BlockFactor;
struct ReversedContact;
struct Group;
struct ReversalBody;
struct PreStepState;
using BodyPairs = std::vector<std::pair<std::size_t, std::size_t>>;
struct ChunkContact;
// Upon a chunk: at its centre of mass, in the frame of the whole.
struct ChunkLoad {
    physics::Vec3 force, torque;  // N, N m
};
}  // namespace destruction_detail

// What bonds are made of. The defaults are those of weak concrete.
struct BondMaterial {
    double young = 2e10;          // Pa, 1 to 1e13
    double poisson = 0.2;         // 0 to 0.5
    double tensile = 1.5e6;       // Pa that break a bond, each 1 to 1e13
    double shear = 3e6;           // Pa
    double compressive = 2e7;     // Pa
    double fracture_energy = 80;  // J/m^2 that breaking takes of an impact, 0 to 1e9
    // s, 1e-5 to 1: how long an impact presses. Its force is the impulse over this time, or over
    // the step's where that is shorter.
    double contact_time = 0.005;
};

struct DestructibleDef {
    physics::Transform pose = {};        // of the shape's frame
    physics::Vec3 linear_velocity = {};  // m/s, of the centre of mass; nothing is anchored
    physics::Vec3 angular_velocity = {};
    double density = 2400;  // kg/m^3, 1e-3 to 1e6
    physics::Material surface = {};
    physics::Filter filter = {};
    BondMaterial bonds = {};
};

// What a step may take; the rest waits for the next one.
struct DestructionLimits {
    int rounds = 8;              // of breaking and solving anew in a step, 1 to 64
    int pieces_per_step = 2048;  // new bodies, 1 to 1000000
    // Products of 6 x 6 blocks that new factors take, 1 to 1e12; one factor is always made.
    std::int64_t work_per_step = 40000;
    double debris_life = 0;    // s, 0 to 1e6: loose single chunks vanish after; 0: never
    double debris_volume = 0;  // m^3, 0 to 1e12: of those that are smaller
    // m^3, 0 to 1e12: loose single chunks that are smaller pass each other, meet all else, and are
    // not swept. For thousands at once: what does not meet costs next to nothing. Not where a
    // filter has a group.
    double passing_volume = 0;
};

struct DestructibleId {
    std::uint32_t index = 0xffffffff;
    std::uint32_t generation = 0;

    auto operator<=>(const DestructibleId&) const = default;
};

class Destruction : public physics::Module {
public:
    Destruction();
    ~Destruction() override;

    std::string_view tag() const override { return "destruction"; }
    void visit(physics::StateVisitor& v) override;
    // Walls of a scene, side by side along x, anchored at their foot: count (0 to 100), spacing
    // (m), width, height, thickness (m), chunks (1 to 2000), seed; x, y, z of the middle of the
    // first one's foot; density; tensile, shear (Pa), fracture_energy; debris_life, debris_volume,
    // passing_volume; heading (rad, about y), compressive. With the bytes `shape` of a fracture
    // file: what it holds instead of walls, its origin at x, y, z.
    physics::Status configure(physics::World& world,
                              const physics::ModuleSettings& settings) override;
    // "destruction": of each how many pieces, bonds that hold, bonds that were.
    std::vector<physics::ChannelKind> channels() const override { return {{}}; }
    void publish(const physics::World& world, physics::ChannelWriter& channels) const override;
    physics::StepHooks hooks() const override { return {.pre_solve = true}; }
    void before_step(physics::World& world, double dt) override;
    void pre_solve(physics::PreSolve& pair) override;
    void after_step(physics::World& world, double dt) override;

    physics::Status set_limits(const DestructionLimits& limits);
    const DestructionLimits& limits() const { return limits_; }

    // All or nothing. Static when a chunk is anchored. An error names the chunk or the bond.
    physics::Result<DestructibleId> add(physics::World& world, const FracturedShape& shape,
                                        const DestructibleDef& def);
    // With all its pieces.
    physics::Status remove(physics::World& world, DestructibleId id);

    // Breaks the bonds whose middle is within a ball, in world space; they part after the next
    // step. How many broke.
    physics::Result<std::size_t> break_near(const physics::World& world, DestructibleId id,
                                            physics::Vec3 center, double radius);

    // ... of all of them.
    std::size_t break_near(const physics::World& world, physics::Vec3 center, double radius);

    bool contains(DestructibleId id) const { return find(id) != nullptr; }
    std::size_t size() const;
    physics::Result<std::vector<physics::BodyId>> bodies(DestructibleId id) const;
    physics::Result<std::size_t> intact_bonds(DestructibleId id) const;
    // What the bond that bears most bears under weight alone, as a share of its strength.
    physics::Result<double> max_load_ratio(const physics::World& world, DestructibleId id) const;

private:
    struct Chunk {
        physics::Vec3 center;  // in the frame of the whole, as all that follows
        double mass = 0;
        physics::Mat3 inertia;
        physics::ShapeId shape;
        bool anchored = false;
        physics::Vec3 force, torque;  // of contacts, when its bonds were last asked
        std::uint32_t piece = 0;      // derived
    };
    struct Bond {
        FractureBond face;
        bool broken = false;
    };
    // What hangs together: one body, whose axes are those of the whole.
    struct Piece {
        physics::BodyId body;
        physics::Vec3 origin;  // of the body, in the frame of the whole
        std::vector<std::uint32_t> chunks;
        bool anchored = false;
        bool solve_pending = true;   // is to be asked, whatever its loads
        bool solved = false;         // its factor was made, and paid for
        bool loaded = false;         // by contacts, when last asked
        bool loads_pending = false;  // its loads wait in its chunks: there was no time to ask
        bool split_pending = false;  // bonds broke: it is to be parted
        double spin2 = 0;            // rad^2/s^2, when last asked
        double energy = 0;           // J of the impacts whose loads wait
        double age = 0;              // s, of a loose single chunk
        double passing_time = 0;     // s, for which it passes what it broke out of

        physics::Vec3 linear, angular;  // m/s, rad/s: before the step

        // Derived: bonds within that hold; the factor of its stiffness.
        std::vector<std::uint32_t> bonds;
        std::shared_ptr<const destruction_detail::BlockFactor> factor;
    };
    struct Destructible {
        bool alive = false;
        std::uint32_t generation = 0;
        BondMaterial material;
        double density = 0;
        std::vector<Chunk> chunks;
        std::vector<Bond> bonds;
        std::vector<Piece> pieces;
    };
    struct BondedShape {  // of a shape that bonds hold
        physics::ShapeId shape;
        std::uint32_t destructible = 0, chunk = 0;
    };
    enum class SolveResult : std::uint8_t { held, broke, no_time };

    const Destructible* find(DestructibleId id) const;
    Destructible* find(DestructibleId id);
    static physics::Error unknown(DestructibleId id);
    std::size_t break_near(const physics::World& world, Destructible& destructible,
                           physics::Vec3 center, double radius);
    static void visit(physics::StateVisitor& v, Destructible& destructible);
    void visit_limits(physics::StateVisitor& v);
    static void check_destructible(physics::StateVisitor& v, const Destructible& destructible);

    // destruction_loads.cpp: what contacts press.
    void rebuild_derived_state();
    void update_gravity(const physics::World& world);
    void gather_contacts(const physics::World& world, double dt);
    void add_impact(const physics::World& world, double dt, physics::ShapeId a, physics::ShapeId b,
                    physics::BodyId body_a, physics::BodyId body_b, physics::Vec3 point,
                    physics::Vec3 normal, double approach);
    void add_stay(const physics::World& world, const physics::ContactStay& stay, double dt);
    void add_unreported_impacts(const physics::World& world, double dt);
    double pre_step_approach_speed(const physics::ContactStay& stay) const;
    void distribute_impacts();
    const BondedShape* find_bonded_shape(physics::ShapeId shape) const;
    bool is_impact(physics::ShapeId a, physics::ShapeId b) const;

    // destruction_crack.cpp: which bonds break.
    void break_all_bonds(const physics::World& world);
    void break_bonds_if_loaded(const physics::World& world, std::uint32_t destructible,
                               std::uint32_t piece,
                               std::span<destruction_detail::ChunkContact> chunk_contacts);
    bool break_bonds(Destructible& destructible, Piece& piece,
                     std::span<const destruction_detail::ChunkLoad> chunk_loads, physics::Vec3 spin,
                     physics::Vec3 gravity, double& energy);
    SolveResult solve_group(Destructible& destructible, const destruction_detail::Group& group,
                            Piece* cached,
                            std::span<const destruction_detail::ChunkLoad> chunk_loads,
                            physics::Vec3 spin, physics::Vec3 gravity, double& energy);
    static std::vector<double> loads_of(const Destructible& destructible,
                                        const destruction_detail::Group& group,
                                        const destruction_detail::BlockFactor& factor,
                                        std::span<const destruction_detail::ChunkLoad> chunk_loads,
                                        physics::Vec3 spin, physics::Vec3 gravity);
    static std::vector<destruction_detail::Group> connected_groups(
        const Destructible& destructible, const destruction_detail::Group& group);

    // destruction_losses.cpp: what others destroyed.
    void drop_lost_bodies(const physics::World& world);
    void drop_lost_chunks(const physics::World& world, Destructible& destructible, Piece& piece);

    // destruction_split.cpp: pieces become bodies.
    void split_all_pieces(physics::World& world);
    int split(physics::World& world, Destructible& destructible, std::size_t piece, int most);
    bool is_passing_debris(const Destructible& destructible,
                           const destruction_detail::Group& group) const;
    physics::Status detach_groups(physics::World& world, Destructible& destructible,
                                  std::size_t piece,
                                  std::span<const destruction_detail::Group> leaving,
                                  const destruction_detail::Group& staying);
    static void remove_detached_shapes(physics::World& world, Destructible& destructible,
                                       Piece& piece,
                                       std::span<const destruction_detail::Group> leaving);
    void reverse_excess_impulses(physics::World& world, double dt);
    void merge_mutual_impacts();
    void start_passing();
    void store_pre_step_state(const physics::World& world, std::uint32_t destructible,
                              Piece& piece);
    void store_pre_step_state(const physics::World& world, std::uint32_t destructible,
                              physics::BodyId body);
    const physics::BodyState* pre_step_body(physics::BodyId body) const;
    const destruction_detail::PreStepState* find_pre_step_state(physics::BodyId body) const;
    void limit_grounded_pieces(physics::World& world,
                               std::span<destruction_detail::ChunkContact> chunk_contacts,
                               double dt);
    static double remaining_speed(const destruction_detail::ChunkContact& chunk_contact);
    double restored_speed(const physics::World& world,
                          const destruction_detail::ChunkContact& chunk_contact) const;
    std::size_t add_reversal_body(const physics::World& world,
                                  std::vector<destruction_detail::ReversalBody>& bodies,
                                  physics::BodyId id, const Piece* piece, double dt) const;
    void add_nearby_bodies(const physics::World& world, std::uint32_t destructible, double dt,
                           std::vector<destruction_detail::ReversalBody>& bodies,
                           std::vector<std::size_t>& added) const;
    destruction_detail::BodyPairs shared_energy_pairs(
        const physics::World& world, double dt,
        std::vector<destruction_detail::ReversalBody>& bodies) const;
    void reverse_impacts(physics::World& world, double dt);
    const Piece& piece_of(const destruction_detail::ChunkContact& chunk_contact) const;
    void drop_debris(physics::World& world, double dt);

    DestructionLimits limits_;
    physics::Vec3 gravity_;  // when all were last asked
    std::vector<Destructible> destructibles_;
    std::vector<destruction_detail::ReversedContact> reversed_contacts_;

    // Derived, or of one step.
    bool derived_ = false;
    std::vector<BondedShape> bonded_shapes_;  // by shape
    std::vector<destruction_detail::ChunkContact> chunk_contacts_;
    std::vector<destruction_detail::ChunkLoad> chunk_loads_;  // by chunk; valid for one piece's
    std::vector<std::pair<physics::BodyId, std::uint32_t>> passing_bodies_;  // bodies, of wholes
    std::vector<physics::BodyState> reversed_bodies_;  // what got its speed back, before the step
    std::vector<destruction_detail::PreStepState>
        pre_step_states_;  // pieces, and what meets them; by body
    std::int64_t work_left_ = 0;
    double max_load_ratio_ = 0;  // of the piece that was asked last, before anything broke
};

}  // namespace jostle::modules
