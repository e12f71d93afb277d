// SPDX-License-Identifier: MIT
//
// Memory that a step uses and the next one uses again. Neither description nor state: never saved,
// never hashed.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <compare>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "collision/broadphase/broad_phase.h"
#include "collision/narrowphase/collide_composite.h"
#include "constraint_graph/constraint_graph.h"
#include "constraint_graph/joint_constraint_wide.h"
#include "constraint_graph/solver_body.h"
#include "constraint_graph/solver_tier.h"
#include "foundation/uninitialized_array.h"
#include "state/body_store.h"

namespace jostle::physics {

// One narrow phase call and what came of it. Small: there may be tens of thousands.
struct ContactCheck {
    std::uint32_t contact = 0;
    // Of a composite pair: its parts are in StepScratch::parts[list]. Else: the manifold that may
    // begin is StepScratch::fresh[list].
    std::int32_t list = -1;
    bool goes_on = false;     // has points, and a lane that they were written to ...
    bool done = false;     // ... and stays in: nothing is left to decide
    float direction[3] = {};  // along which they are apart by `near`; zero: not known
    double gap_ahead = 0;     // m: smallest gap of any point at the end of the step, as the bodies
                              // move now
    // m: the smallest gap now. Of a composite pair: everything nearer than this beyond the
    // speculative margin is among its parts.
    double near = 0;
};

// What one task of update_pairs found.
struct NewPairs {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  // shapes
    std::vector<std::uint32_t> near;                             // shapes, of one query
};

// One manifold of a composite pair.
struct FoundPart {
    PartManifold part;
    double gap_ahead = 0;
    std::uint32_t contact = 0xffffffff;  // that had it before
};

// A manifold that gets a lane: of a check, and which part of it (-1: the check's own).
struct NewLane {
    std::uint32_t check = 0;
    std::int32_t part = -1;
};

// What stands of an island, by its bodies' centres of mass.
struct IslandExtent {
    double low = 1e300, high = -1e300;  // m, upwards
    double thickness = 0;               // m, of all bodies
    int bodies = 0;
    // Sums over the bodies of where they are on the ground, from the first of them, m and m^2.
    Vec3 first;
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    bool tier_chosen = false;  // its tier was looked at together with another's
};

// Of a frozen body: how much is to thaw with it, kg.
struct Disturbance {
    std::uint32_t body = none;
    double mass = 0;
    auto operator<=>(const Disturbance&) const = default;
};

struct FoundJoint {
    std::uint32_t joint = 0;
    std::int32_t a = 0, b = 0;  // as JointConstraintWideMeta's
    std::uint32_t run = 0;      // level * joint_kinds + kind
};

// The joints of one part of the solver's work.
struct JointScratch {
    std::vector<std::uint64_t> marks;    // a bit per joint
    std::vector<FoundJoint> found;       // rising
    std::vector<std::uint32_t> reached;  // by hot index: level that the body's next joint may have
    std::vector<int> places;             // by run number: lanes of all blocks before, then the next
    std::vector<JointRun> runs;
    std::vector<JointConstraintWide> blocks;
    std::vector<JointAngularWide> turns;
    std::vector<JointConstraintWideMeta> sides;  // by block
};

// A body that turns far in a step, and not evenly: what each sub-step needs of it.
struct GyroscopicBody {
    Mat3 axes;  // of the body at the start of the step
    Vec3 bend;  // PrincipalRatios, if its axes are the principal ones
    bool principal = false;
};

// Hot records by hot index. [0] is nobody, whom joints may read: it stands still and cannot be
// pushed. Below it are bodies for unused lanes, which are read and written like all others: threads
// that work at the same time have each their own.
class HotBodies {
public:
    static constexpr std::size_t spare = 2 * solved_set_count;

    // Unused lanes of the stores of one part, by its first, and of one of its two lists.
    static constexpr std::int32_t spare_index(std::size_t first_store, bool single) {
        return -1 - static_cast<std::int32_t>(2 * first_store + (single ? 1 : 0));
    }

    void resize(std::size_t count) {  // nobody included
        all_.resize(spare + count);
        std::fill(all_.begin(), all_.begin() + spare + 1, HotBody{});
    }
    std::size_t size() const { return all_.size() - spare; }
    HotBody* data() { return all_.data() + spare; }
    HotBody& operator[](std::size_t index) { return all_[spare + index]; }

private:
    std::vector<HotBody> all_;
};

// Numbers of bodies, store after store.
struct ByStore {
    std::vector<std::uint32_t> all;
    std::array<std::uint32_t, solved_set_count + 1> begin{};

    std::span<const std::uint32_t> of(std::size_t first, std::size_t last) const {  // stores
        return std::span(all).subspan(begin[first], begin[last] - begin[first]);
    }
};

// A colour in use, with the list of its manifolds of one point: their bodies are distinct.
struct ColourRun {
    GraphColour* colour = nullptr;
    GraphColour* single = nullptr;  // null of an overflow list
    int number = 0;                 // of `colour`
    int blocks = 0, singles = 0;
    bool shared = false;  // among threads
};

struct StepScratch {
    HotBodies hot;                 // awake body i is [i + 1]
    std::vector<BodyDrive> drive;  // as hot
    // Hot indices of dynamic bodies with manifolds or joints, and of those of them with joints.
    ByStore in_solver, jointed_in_solver;
    std::vector<std::uint8_t> set_of;  // by awake body: index of its store, if it is in the solver
    std::vector<std::uint32_t> drivers;  // hot indices of kinematic bodies that the solver reads
    std::vector<std::uint32_t> free;     // the other awake bodies, and all kinematic ones
    std::vector<NewPairs> new_pairs;     // of some of the shapes that moved each
    std::vector<std::uint8_t> due;       // by waiting pair: it waited long enough
    std::vector<ContactCheck> checks;
    std::int32_t part_lists = 0;  // given to checks of composite pairs
    UninitializedVector<Manifold>
        fresh;  // of checks without a lane, as far as fresh_count, in any order
    std::atomic<int> fresh_count = 0;
    std::vector<std::vector<FoundPart>> parts;
    std::vector<NewLane> new_lanes;
    std::vector<std::uint32_t> to_wake, pairs_changed, found;
    // Both by the first store of a part.
    std::array<JointScratch, solved_set_count> joints;
    std::array<std::vector<ColourRun>, solved_set_count> colour_runs;
    std::vector<std::uint8_t> gyroscopic;  // by hot index: whether it has a gyroscopic_body
    std::vector<GyroscopicBody> gyroscopic_bodies;  // by hot index, of those
    std::vector<std::uint8_t> held;     // by awake body: had a manifold when the step began
    std::vector<std::uint8_t> fast;     // by awake body: moved far, to be swept
    std::vector<std::uint8_t> strayed;  // by awake body: fast, and not on the way that its fat
                                        // boxes foresaw
    std::vector<std::vector<std::uint32_t>> ahead;  // by fast body: shapes it may meet
    std::vector<std::uint8_t> thrown;  // by awake body: not fast, and did not go as its velocity
                                       // says: contacts turned it round in the step
    std::vector<BodyWarm> before;  // by awake body: before the step, of what is fast or was thrown
    std::atomic<int> any_fast = 0;
    std::vector<std::uint32_t> touch_changes;   // contacts whose touching flag changes
    std::vector<std::uint8_t> left_fat_aabb;    // by awake body: some shape of it did
    std::vector<BroadPhaseIndex::Move> moves;   // of their boxes
    std::vector<std::uint8_t> not_finite;       // by awake body
    std::vector<IslandExtent> extents;          // by island
    std::vector<std::uint32_t> island_weights;  // by island
    std::vector<double> island_sleep_time, island_longest_sleep_time;
    // By hot index: moves; or touches one that does, or is jointed to one of either.
    std::vector<std::uint8_t> restless, beside;
    std::vector<std::uint32_t> resting;  // by island: bodies that could be frozen, or are
    std::vector<Disturbance> hits,
        support_lost;  // of frozen bodies: from outside; by touches that ended
    std::vector<std::uint32_t> loads_changed, falling_asleep;  // bodies
    std::vector<std::uint8_t> met, seen_jointed;               // by body; zero between uses
    std::vector<std::uint8_t> visited_jointed;                 // by body
    std::vector<std::uint32_t> jointed;                        // bodies
    std::vector<std::uint32_t> stack;
};

}  // namespace jostle::physics
