// SPDX-License-Identifier: MIT
//
// Benchmark scenes, on which Jostle is compared with other engines. The catalogue contains those
// without parameters; the functions of this header create scenes of any size. All of them have
// gravity 9.81 m/s^2, density 1000 kg/m^3, friction 0.5, no restitution and damping 0.05 /s unless
// stated otherwise. Scenes with equal parameters never change, so results of different versions and
// engines are comparable. No bodies overlap at the start, except bones of one figure.
//
// Callers check the parameters: counts are at least 1, and values outside of the stated ranges may
// end the program.
#pragma once

#include "jostle/scenes/scene.h"

namespace jostle::scenes {

// Piles, between walls. Their depth does not depend on the number of bodies.

/// Returns bench_pile_5000 with another number of bodies, above 0. The bodies fall in columns over
/// a square whose area is proportional to the count, 0.02 m^2 per body. The depth of the settled
/// pile is therefore the same for every count.
SceneDescription bench_pile(int count);
/// Convex hulls with an even number of vertices: below 64 irregular stones, 8 or more; otherwise
/// prisms with two regular faces, up to 128.
SceneDescription bench_hull_heap(int count, int vertices);
/// Spheres, boxes and capsules, with densities from 10 to 10,000 kg/m^3.
SceneDescription bench_mixed_masses(int count);
/// Spheres with a radius of 0.3 m.
SceneDescription bench_spheres(int count);
/// Capsules 0.9 m long and 0.4 m thick.
SceneDescription bench_capsules(int count);
/// Figures of eleven bones and ten joints.
SceneDescription bench_ragdoll_pile(int figures);

// Other free bodies.

/// 2000 boxes, balls and capsules in the drum of bench_washer.
SceneDescription bench_drum(double degrees_per_second);
/// Stacks of three boxes, 3 m apart on a floor.
SceneDescription bench_stacks(int stacks);
/// A block of hulls that bursts at 10 to 40 m/s.
SceneDescription bench_debris(int hulls);
/// Balls, boxes, capsules and stones on a mesh of hills, 150 m wide, with cells of this size (m).
SceneDescription bench_mesh(int count, double cell);

// Jointed bodies.

/// bench_chain with another number of links, above 1; the first one is fixed.
SceneDescription bench_chain(int links);
/// A chain of ball joints that hangs from a fixed body, with waves in its lower half.
SceneDescription bench_hanging_chain(int links);
/// A chain of hinges with parallel axes, fixed at one end, that falls from level.
SceneDescription bench_hinge_chain(int links);
/// Trees of 88 links, with branches of branches, that hang from fixed bodies and swing.
SceneDescription bench_joint_tree(int trees);
/// 60 vehicles with an even number of wheels, up to 32, on flat ground. Wheels are prisms of 16
/// sides on hinges with motors. Chassis 300 kg/m^3; wheels 400 kg/m^3 and friction 0.9.
SceneDescription bench_wheels(int wheels);
/// The same on a mesh of low hills with cells of this size (m) and friction 0.9.
SceneDescription bench_wheels_mesh(int wheels, double cell);

}  // namespace jostle::scenes
