// SPDX-License-Identifier: MIT
#include "bench/contact_models/contact_scene.h"

#include <algorithm>
#include <cmath>

#include "jostle/analysis/work_error.h"
#include "jostle/physics/scalar.h"

namespace jostle::bench::contact_models {
namespace {

constexpr double drop_height = 0.5;  // m, below the ball
constexpr double bounce = 0.8;
constexpr double slide_speed = 2, slide_friction = 0.4;  // m/s; coefficient
// The available energy allows 6 m/s at the top of the stack; four times that is a failure.
constexpr double fastest = 25;

}  // namespace

std::vector<Contact> find_contacts(const std::vector<Ball>& balls, double margin) {
    std::vector<Contact> found;
    const int count = static_cast<int>(balls.size());
    for (int b = 0; b < count; b++) {
        const Vec3 at = balls[static_cast<std::size_t>(b)].position;
        if (at.z - radius < margin) found.push_back({plane, b, {0, 0, 1}, at.z - radius});
        for (int a = 0; a < b; a++) {
            const Vec3 offset = at - balls[static_cast<std::size_t>(a)].position;
            const double reach = 2 * radius + margin;
            if (length_squared(offset) >= reach * reach) continue;
            const double distance = length(offset);
            const Vec3 normal = distance > 0 ? offset * (1 / distance) : Vec3{0, 0, 1};
            found.push_back({a, b, normal, distance - 2 * radius});
        }
    }
    return found;
}

Vec3 relative_velocity(const std::vector<Ball>& balls, const Contact& contact) {
    const Vec3 b = balls[static_cast<std::size_t>(contact.b)].velocity;
    return contact.a == plane ? b : b - balls[static_cast<std::size_t>(contact.a)].velocity;
}

double inverse_masses(const Contact& contact) {
    return contact.a == plane ? 1 / mass : 2 / mass;
}

void push(std::vector<Ball>& balls, const Contact& contact, Vec3 impulse) {
    balls[static_cast<std::size_t>(contact.b)].velocity += impulse * (1 / mass);
    if (contact.a != plane)
        balls[static_cast<std::size_t>(contact.a)].velocity -= impulse * (1 / mass);
}

Vec3 along_surface(Vec3 v, const Contact& contact) {
    return v - contact.normal * dot(v, contact.normal);
}

double restitution_of(const std::vector<Ball>& balls, const Contact& contact) {
    const double b = balls[static_cast<std::size_t>(contact.b)].restitution;
    return contact.a == plane
               ? b
               : std::sqrt(b * balls[static_cast<std::size_t>(contact.a)].restitution);
}

double friction_of(const std::vector<Ball>& balls, const Contact& contact) {
    const double b = balls[static_cast<std::size_t>(contact.b)].friction;
    return contact.a == plane ? b
                              : std::sqrt(b * balls[static_cast<std::size_t>(contact.a)].friction);
}

// The dropped balls start a multiple of 1/16 of a step apart: the error of an impact depends on its
// time within the step.
ContactScene::ContactScene(double dt)
    : dt_(dt), bounced_(static_cast<std::size_t>(dropped)), apex_(bounced_.size()) {
    for (int k = 0; k < dropped; k++) {
        const double late = dt * k / dropped;
        balls.push_back(
            {.position = {2.0 + k, 0, radius + drop_height - 0.5 * gravity * late * late},
             .velocity = {0, 0, -gravity * late},
             .restitution = bounce});
    }
    for (int k = 0; k < stacked; k++) balls.push_back({.position = {0, 0, radius * (1 + 2 * k)}});
    const double azimuth = physics::pi / 6;  // not along an axis
    balls.push_back({.position = {0, 5, radius},
                     .velocity = Vec3{std::cos(azimuth), std::sin(azimuth), 0} * slide_speed,
                     .friction = slide_friction});
}

void ContactScene::sample() {
    steps_++;
    for (const Ball& ball : balls)
        if (!(length(ball.velocity) < fastest)) failed_ = true;
    for (std::size_t k = 0; k < bounced_.size(); k++) {
        const Ball& ball = balls[k];
        const bool rises = ball.velocity.z > 0;
        if (rises) bounced_[k] = true;
        // Only the first bounce counts: until the time when the ball would have landed again.
        const double flight = std::sqrt(2 * drop_height / gravity) * (1 + 2 * bounce);
        if (bounced_[k] && steps_ * dt_ < flight)
            apex_[k] = std::max(apex_[k], ball.position.z - radius);
    }
    if (steps_ * dt_ < 0.5 * scene_seconds) return;
    for (int k = 0; k < stacked; k++) {
        const std::size_t at = static_cast<std::size_t>(dropped + k);
        const double below = k == 0 ? -radius : balls[at - 1].position.z;
        overlap_ = std::max(overlap_, 2 * radius - (balls[at].position.z - below));
    }
}

SceneErrors ContactScene::errors() const {
    SceneErrors errors{.overlap = overlap_, .failed = failed_};
    analysis::Rms apex;
    for (const double height : apex_) {
        const double error = height / (bounce * bounce * drop_height) - 1;
        apex.add(error * error);
    }
    errors.energy = apex.value();
    const double distance = slide_speed * slide_speed / (2 * slide_friction * gravity);
    errors.slide = std::abs(length(balls.back().position - Vec3{0, 5, radius}) / distance - 1);
    return errors;
}

}  // namespace jostle::bench::contact_models
