// SPDX-License-Identifier: MIT
//
// Reference solutions: closed forms, and the classical Runge-Kutta method with steps of 1/19200 s,
// a multiple of every step rate of the benchmark.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/accuracy/accuracy_scene.h"

namespace jostle::bench::accuracy {

inline constexpr int reference_hz = 19200;

// Trajectory of a point, one entry per reference step.
using Trajectory = std::vector<Vec3>;
Vec3 at_time(const Trajectory& track, double t);

// Cached by name, because all rows of a scene share it.
std::shared_ptr<const Trajectory> cached_trajectory(const std::string& name,
                                                    const std::function<Trajectory()>& make);

// dy/dt = rate(y). One step of h seconds.
using State = std::vector<double>;
using Rate = std::function<void(const State&, State&)>;
void runge_kutta_step(State& y, double h, const Rate& rate);

// --- pendulums ---

// Complete elliptic integral of the first kind, and the Jacobi function cd(u, k) = cn / dn.
double elliptic_k(double k);
double jacobi_cd(double u, double k);

// theta'' = -rate^2 sin(theta), released at rest.
double pendulum_angle(double rate, double start_angle, double t);
double pendulum_period(double rate, double start_angle);

// --- chains of links in the xz plane, hung from the origin ---

// Angles are measured from straight down, towards +x.
struct ChainLink {
    double mass = 1, inertia = 1;     // kg, kg m^2 about the centre
    double length = 1, center = 0.5;  // m: to the next joint and to the centre of mass
};
// Trajectory of the centre of link `which` for `seconds`, released at rest with all links at one
// angle.
Trajectory planar_chain(const std::vector<ChainLink>& links, double start_angle, double seconds,
                        std::size_t which);

// --- free bodies ---

// Trajectory of the body's y axis in the world: Euler's equations with the rotation quaternion,
// starting from no rotation.
Trajectory free_axis_y(Vec3 inertia, Vec3 spin, double seconds);

// --- hanging chains at rest ---

// n equal links between two points at the same height: depth of the lowest joint.
double catenary_sag(int links, double link_length, double span);

}  // namespace jostle::bench::accuracy
