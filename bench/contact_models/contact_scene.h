// SPDX-License-Identifier: MIT
//
// One scene for all contact models: sixteen balls drop on a plane, ten form a stack, one slides
// until friction stops it. Balls do not rotate, so that only the contact resolution is compared. SI
// units, z up, the plane is z = 0.
#pragma once

#include <vector>

#include "jostle/physics/vec3.h"

namespace jostle::bench::contact_models {

using physics::Vec3;

inline constexpr double gravity = 9.81;  // m/s^2, down
inline constexpr double radius = 0.1;    // m, of every ball
inline constexpr double mass = 1;        // kg, of every ball

struct Ball {
    Vec3 position, velocity;
    double restitution = 0;
    double friction = 0;
};

inline constexpr int plane = -1;

// Two balls, or a ball and the plane, closer than a margin.
struct Contact {
    int a = plane, b = 0;
    Vec3 normal;     // unit vector from a to b
    double gap = 0;  // m; negative: overlap
};
// Ordered by b, the plane first.
std::vector<Contact> find_contacts(const std::vector<Ball>& balls, double margin);

// The plane does not move.
Vec3 relative_velocity(const std::vector<Ball>& balls, const Contact& contact);
// 1/kg: 1/m of one ball, or the sum of two.
double inverse_masses(const Contact& contact);
// Applies an impulse in N s to b and the opposite one to a.
void push(std::vector<Ball>& balls, const Contact& contact, Vec3 impulse);
// The component of a vector in the contact plane.
Vec3 along_surface(Vec3 v, const Contact& contact);

// Restitution and friction of the balls; for two balls the root of the product.
double restitution_of(const std::vector<Ball>& balls, const Contact& contact);
double friction_of(const std::vector<Ball>& balls, const Contact& contact);

inline constexpr double scene_seconds = 2;

// The errors of one run.
struct SceneErrors {
    double overlap = 0;  // m: deepest overlap in the stack during the last second
    // RMS of the relative energy error of the dropped balls after the bounce, from their apex
    double energy = 0;
    double slide = 0;     // relative error of the stopping distance
    bool failed = false;  // a ball is faster than possible, or its velocity is not finite
};

// Creates the scene for a time step, samples it after each step and computes the errors.
class ContactScene {
public:
    explicit ContactScene(double dt);

    std::vector<Ball> balls;

    void sample();  // call after each step
    SceneErrors errors() const;

private:
    static constexpr int dropped = 16, stacked = 10;

    int steps_ = 0;
    double dt_;
    bool failed_ = false;
    double overlap_ = 0;
    std::vector<bool> bounced_;
    std::vector<double> apex_;
};

}  // namespace jostle::bench::contact_models
