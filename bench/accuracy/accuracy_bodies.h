// SPDX-License-Identifier: MIT
//
// Bodies and joints for the scenes of the laboratory, and the arithmetic that engines share.
#pragma once

#include <span>
#include <vector>

#include "bench/accuracy/accuracy_scene.h"

namespace jostle::bench::accuracy {

inline constexpr double g = 9.81;  // m/s^2
inline constexpr Vec3 half_cube{0.5, 0.5, 0.5};

// Of solids, about the centre of mass.
Vec3 box_inertia(double mass, Vec3 half_extents);
Vec3 sphere_inertia(double mass, double radius);

// Half extents of the box that has this inertia. An inertia whose largest moment is the sum of the
// others belongs to a plate without thickness; the box is then 2 mm thick.
Vec3 box_of_inertia(double mass, Vec3 inertia);

// Bodies of such shapes, at rest, along the world's axes.
Body solid_box(double mass, Vec3 half_extents, Vec3 position);
Body solid_sphere(double mass, double radius, Vec3 position);
Body solid_cylinder(double mass, double radius, double half_length, Vec3 position);
// A convex solid of so many kg/m^3; its points are in the world. Its principal axes must be the
// world's, as they are of what is symmetric about two of them.
Body solid_hull(double density, std::span<const Vec3> points);

Body fixed_plane();  // z = 0, its inside below
Body fixed_box(Vec3 half_extents, Vec3 position);

// The same mass that meets nothing.
Body without_shape(Body body);

Joint ball_at(int a, int b, Vec3 anchor);
Joint hinge_at(int a, int b, Vec3 anchor, Vec3 axis = {0, 1, 0});

// A rotation whose z axis is the given one.
Quat axes_along(Vec3 axis);
Transform pose_of(const Scene& scene, int body);  // of the ground: none

// The mass that a spring between the centres of two bodies moves.
double reduced_mass(const Scene& scene, const Joint& joint);

// What the others pull each body with, N.
std::vector<Vec3> mutual_forces(std::span<const double> masses, std::span<const Vec3> at,
                                double pull);

// Of a turn of the whole scene about z.
Vec3 azimuth(double angle);  // the unit vector that x becomes

double kinetic_energy(const Body& body, Quat rotation, Vec3 velocity, Vec3 spin);
Vec3 spin_momentum(const Body& body, Quat rotation, Vec3 spin);  // about the centre of mass

}  // namespace jostle::bench::accuracy
