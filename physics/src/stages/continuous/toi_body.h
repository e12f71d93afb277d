// SPDX-License-Identifier: MIT
//
// A body in motion within a step, as solve_continuous tracks it from impact to impact.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/src/collision/narrowphase/impact_points.h"
#include "physics/src/collision/narrowphase/time_of_impact.h"
#include "physics/src/geometry/bvh.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {

// The positions of a multi-shape body's shapes on its remaining path, for finding the shapes that
// may hit another body.
struct SweptShapes {
    bool known = false;
    std::vector<std::uint32_t> shapes;  // in the body's order
    Bvh tree;                           // over the shapes; empty if there are few
};

// One side of an impact, or a moving body.
struct ToiBody {
    std::uint32_t body = none;
    // Its current path. A gyroscopic body does not rotate at a constant rate: its path is split
    // into legs that start and end at its exact poses.
    Sweep sweep;
    Vec3 velocity, gain;    // m/s at the start of the sweep; velocity change over a whole step
    double flies_from = 0;  // fraction from which only those forces act
    bool held = false;      // contacts supported it in this step and still do: no gain
    // Spin and orientation at one time of the step. Euler's equations yield them at other times.
    double spin_at = 1;  // fraction
    Vec3 spin;           // rad/s
    Quat spin_rotation;
    Quat end_rotation;     // at the end of the step, without further impacts
    Vec3 end_spin;         // rad/s, at the end of the step
    bool fast = false;     // is swept against others
    bool changed = false;  // its pose or velocity differs from the result of the step
    int impacts = 0;
    int legs = 0;                         // number of completed legs
    std::vector<Sweep> past;              // its path before the sweep, in a world with triggers
    int impact_chain_length = 0;          // number of its impacts, found by it or by another body
    bool checked = false;                 // the impact below is the first on its path
    bool queued = false;                  // in the queue of bodies to be swept
    std::uint32_t full_search_round = 0;  // the round of its last full search
    std::vector<std::uint32_t> deflected_bodies;  // bodies deflected since then
    // The first known impact, if any.
    double fraction = Impact::never;  // of the step
    std::uint32_t own_shape = none, other_shape = none;
    std::vector<ImpactPoint> points;
    double closing = 0;     // m/s, at that time; the hardest of simultaneous impacts is first
    bool at_start = false;  // the shapes touched at the start of its sweep
    Aabb swept;             // contains its remaining path
    std::vector<std::uint32_t> candidates;  // shapes that may overlap that box, sorted, unique
    SweptShapes swept_shapes;               // of its sweep; computed on first use
    bool manifolds_known = false;
    std::vector<std::uint64_t> manifolds;  // pair_key() of the shapes of its manifolds, sorted
};

// The motion from the pose before the step to the pose after it.
Sweep even_sweep(const BodyWarm& previous, const BodyWarm& now, double dt);

struct Speed {
    Vec3 v, w;  // m/s, rad/s
};
// The velocity at a fraction of the step, which must not precede the sweep.
Speed speed_at(const WorldState& world, const ToiBody& t, double fraction, double dt);

// Returns whether touching contacts, joints or sleep hold a body.
bool is_supported(const WorldState& world, const BodyCold& cold);
// Velocity change of a body by gravity in a step, m/s.
Vec3 gain_in_free_fall(const WorldState& world, const BodyCold& cold, double dt);

// Initialises a fast body at the start of the step, with `previous` as its record before the step.
void begin_toi(const WorldState& world, ToiBody& t, const BodyWarm& previous, double dt);
// Continues from the end of a leg.
void next_leg(const WorldState& world, ToiBody& t, double dt);

struct Departure {
    Vec3 center;  // m
    Quat rotation;
    Vec3 v, w;  // m/s, rad/s: after the impact
};
// Continues after an impact with another velocity. The body may become fast.
void depart(const WorldState& world, ToiBody& t, double fraction, const Departure& from, double dt);
// Returns whether the body has used up its impacts and has reached its final pose of the step.
bool is_exhausted(const ToiBody& t);
// Moves a body away from the pose that the step computed: warm record, motion bound, fat boxes.
void move_body_to(WorldState& world, std::uint32_t body, Vec3 center, Quat rotation, double dt);
// Moves the body to the end of its path, with its velocity there.
void finish_toi(WorldState& world, const ToiBody& t, double dt);

}  // namespace jostle::physics
