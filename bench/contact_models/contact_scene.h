// SPDX-License-Identifier: MIT
//
// One scene for all contact_models: sixteen balls drop on a plane, ten stand in a stack, one slides
// until friction stops it. Balls do not turn: what is compared is how a contact is resolved, and
// nothing else. SI units, z up, the plane is z = 0.
#pragma once

#include <vector>

#include "jostle/physics/vec3.h"

namespace jostle::bench::contact_models {

using physics::Vec3;

inline constexpr double gravity = 9.81;  // m/s^2, down
inline constexpr double radius = 0.1;    // m, of every ball
inline constexpr double mass = 1;        // kg, likewise

struct Ball {
    Vec3 position, velocity;
    double restitution = 0;
    double friction = 0;
};

inline constexpr int plane = -1;

// Two balls, or a ball and the plane, that are closer than a margin.
struct Contact {
    int a = plane, b = 0;
    Vec3 normal;     // unit, from a to b
    double gap = 0;  // m; negative: overlap
};
// In order of b, the plane first.
std::vector<Contact> find_contacts(const std::vector<Ball>& balls, double margin);

// The plane does not move.
Vec3 relative_velocity(const std::vector<Ball>& balls, const Contact& contact);
// 1/kg: 1/m of one ball, or of both.
double inverse_masses(const Contact& contact);
// Equal and opposite, N s, on b.
void push(std::vector<Ball>& balls, const Contact& contact, Vec3 impulse);
// The part of a vector that lies in the contact's plane.
Vec3 along_surface(Vec3 v, const Contact& contact);

// The balls' restitution and friction; of two balls their product's root.
double restitution_of(const std::vector<Ball>& balls, const Contact& contact);
double friction_of(const std::vector<Ball>& balls, const Contact& contact);

inline constexpr double scene_seconds = 2;

// Of one run.
struct SceneErrors {
    double overlap = 0;   // m: deepest of the stack over the second second
    double energy = 0;    // of the dropped balls after the bounce, by their apex: RMS error over it
    double slide = 0;     // error of the stopping distance over the distance
    bool failed = false;  // a ball is faster than it can have become, or no number
};

// Makes the scene for a time step, looks at it after each, and tells the errors.
class ContactScene {
public:
    explicit ContactScene(double dt);

    std::vector<Ball> balls;

    void sample();  // after a step
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
