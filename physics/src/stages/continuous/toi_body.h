// SPDX-License-Identifier: MIT
//
// A body under way within a step, as solve_continuous follows it from impact to impact.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/src/collision/narrowphase/impact_points.h"
#include "physics/src/collision/narrowphase/time_of_impact.h"
#include "physics/src/geometry/bvh.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {

// Where the shapes of a body of many are on what is left of its way: which of them may meet
// another.
struct SweptShapes {
    bool known = false;
    std::vector<std::uint32_t> shapes;  // in the body's order
    Bvh tree;                           // over them; empty where there are few
};

// One end of an impact, or one body under way.
struct ToiBody {
    std::uint32_t body = none;
    // How it goes on. A gyroscopic body does not turn evenly: its way is cut into legs, each from
    // where it really is to where it really will be.
    Sweep sweep;
    Vec3 velocity, gain;    // m/s at the start of the sweep, and what forces add over a whole step
    double flies_from = 0;  // fraction: since when nothing but those forces acts on it
    bool held = false;      // contacts bore it in this step, and still do: no gain
    // The spin and the attitude at one moment of the step; at others Euler's equations give it.
    double spin_at = 1;  // fraction
    Vec3 spin;           // rad/s
    Quat spin_rotation;
    Quat end_rotation;     // at the end of the step, if no impact comes before
    Vec3 end_spin;         // rad/s, then
    bool fast = false;     // looks for impacts itself
    bool changed = false;  // its pose or velocity is no longer what the step made it
    int impacts = 0;
    int legs = 0;                                 // that lie behind it
    int impact_chain_length = 0;                  // impacts that it had, found by itself or another
    bool checked = false;                         // the impact below is the first on its way
    bool queued = false;                          // on the list of those that are to look
    std::uint32_t full_search_round = 0;          // the round in which it last looked at everything
    std::vector<std::uint32_t> deflected_bodies;  // bodies that go another way since then
    // The first impact that is known, if any.
    double fraction = Impact::never;  // of the step
    std::uint32_t own_shape = none, other_shape = none;
    std::vector<ImpactPoint> points;
    double closing = 0;     // m/s, then: of several impacts at one moment the hardest is the first
    bool at_start = false;  // they touched already when its sweep began
    Aabb swept;             // holds all that is left of its way
    std::vector<std::uint32_t> candidates;  // shapes that may be in that box, rising, once each
    SweptShapes swept_shapes;               // of its sweep, when first asked for
    bool manifolds_known = false;
    std::vector<std::uint64_t> manifolds;  // pair_key() of the shapes of its manifolds, rising
};

// From where a step found a body to where it took it.
Sweep even_sweep(const BodyWarm& previous, const BodyWarm& now, double dt);

struct Speed {
    Vec3 v, w;  // m/s, rad/s
};
// At a fraction of the step, from the sweep's beginning on.
Speed speed_at(const WorldState& world, const ToiBody& t, double fraction, double dt);

// What gravity adds to the velocity of a body in a step, m/s.
Vec3 gain_in_free_fall(const WorldState& world, const BodyCold& cold, double dt);

// A fast body from the beginning of the step, where it was `before`: as the step took it.
void begin_toi(const WorldState& world, ToiBody& t, const BodyWarm& previous, double dt);
// From the end of a leg on.
void next_leg(const WorldState& world, ToiBody& t, double dt);

struct Departure {
    Vec3 center;  // m
    Quat rotation;
    Vec3 v, w;  // m/s, rad/s: from here on
};
// From an impact on, with another velocity. It may be fast now.
void depart(const WorldState& world, ToiBody& t, double fraction, const Departure& from, double dt);
// Whether it has used up its impacts and is where it will be when the step ends.
bool is_exhausted(const ToiBody& t);
// Puts a body somewhere else than where the step left it: warm record, motion bound, fat boxes.
void move_body_to(WorldState& world, std::uint32_t body, Vec3 center, Quat rotation, double dt);
// Puts its body where its way ends, with the velocity that it has there.
void finish_toi(WorldState& world, const ToiBody& t, double dt);

}  // namespace jostle::physics
