// SPDX-License-Identifier: MIT
//
// Bodies and joints for the scenes of the accuracy benchmark, and the arithmetic that engines
// share.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/accuracy/accuracy_scene.h"

namespace jostle::bench::accuracy {

inline constexpr double g = 9.81;  // m/s^2
inline constexpr Vec3 half_cube{0.5, 0.5, 0.5};

// Moments of inertia of solids about the centre of mass.
Vec3 box_inertia(double mass, Vec3 half_extents);
Vec3 sphere_inertia(double mass, double radius);

// Half extents of the box with this inertia. If the largest moment is the sum of the others, the
// body is an infinitely thin plate; the box is then 2 mm thick.
Vec3 box_of_inertia(double mass, Vec3 inertia);

Vec3 capsule_inertia(double mass, double radius, double half_length);  // along y

// Bodies with these shapes, at rest and axis-aligned.
Body solid_box(double mass, Vec3 half_extents, Vec3 position);
Body solid_sphere(double mass, double radius, Vec3 position);
Body solid_cylinder(double mass, double radius, double half_length, Vec3 position);
Body solid_capsule(double mass, double radius, double half_length, Vec3 position);
// A convex solid with a density in kg/m^3 and points in world coordinates. Its principal axes must
// be the world's axes, which holds for solids with two planes of symmetry along them.
Body solid_hull(double density, std::span<const Vec3> points);

Body fixed_plane();  // the plane z = 0, solid below
Body fixed_box(Vec3 half_extents, Vec3 position);
Body fixed_shape(physics::Geometry geometry, Vec3 position, Quat rotation = {});

// A feature of the scene that only Jostle's adapter supports, in the plural. Empty: none.
std::string feature_of_jostle_only(const Scene& scene);

// The same mass without collision.
Body without_shape(Body body);

Joint ball_at(int a, int b, Vec3 anchor);
Joint hinge_at(int a, int b, Vec3 anchor, Vec3 axis = {0, 1, 0});

// A rotation that maps z to the given axis.
Quat axes_along(Vec3 axis);
Transform pose_of(const Scene& scene, int body);  // of the ground: identity

// Reduced mass of the two bodies of a spring.
double reduced_mass(const Scene& scene, const Joint& joint);

// Mutual attraction of the bodies, N per body.
std::vector<Vec3> mutual_forces(std::span<const double> masses, std::span<const Vec3> at,
                                double pull);

// Rotation of the scene about z by an angle.
Vec3 azimuth(double angle);  // the image of x

double kinetic_energy(const Body& body, Quat rotation, Vec3 velocity, Vec3 spin);
Vec3 spin_momentum(const Body& body, Quat rotation, Vec3 spin);  // about the centre of mass

// Each body is attached to the tree by one joint; the other joints close loops. A free body has no
// joint.
struct BodyTree {
    struct Node {
        int parent = ground;
        std::optional<Joint> joint;  // none: free or fixed
    };
    std::vector<Node> nodes;  // by body
    std::vector<Joint> loops;
};
BodyTree tree_of(const Scene& scene);

}  // namespace jostle::bench::accuracy
