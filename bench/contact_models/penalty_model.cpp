// SPDX-License-Identifier: MIT
//
// Penalty forces: a spring and a damper push overlapping bodies apart.
//     f = k * overlap - c * (velocity along the normal), never attractive.
// There is no solver; each contact is visited once, which is the whole cost. The drawbacks: bodies
// sink until the spring carries them (m g / k), and an explicit step is stable only if it is short
// relative to the stiffest spring and the strongest damper: in a stack dt < sqrt(m / k) and dt < m
// / (2 c), in this scene 1.1 ms. Stiffer contacts require smaller steps.
#include <algorithm>
#include <cmath>

#include "bench/contact_models/contact_models.h"
#include "jostle/physics/scalar.h"

namespace jostle::bench::contact_models {
namespace {

constexpr double stiffness = 1e5;  // N/m: the bottom of a stack of ten sinks by 1 mm

// A spring with a damper has restitution e if c = 2 z sqrt(k m), z = -ln(e) / sqrt(pi^2 + ln(e)^2).
// For e = 0 it is critically damped.
double damping_of(double restitution, double inverse_mass) {
    const double critical = 2 * std::sqrt(stiffness / inverse_mass);
    if (restitution <= 0) return critical;
    const double loss = std::log(restitution);
    return critical * -loss / std::sqrt(physics::pi * physics::pi + loss * loss);
}

class PenaltyModel final : public ContactModel {
public:
    void step(std::vector<Ball>& balls, double dt) override {
        const std::vector<Contact> contacts = find_contacts(balls, 0);
        // All forces come from the state at the start of the step, so their order does not matter.
        std::vector<Vec3> impulses;
        for (const Contact& contact : contacts) impulses.push_back(force(balls, contact, dt) * dt);
        for (std::size_t k = 0; k < contacts.size(); k++) push(balls, contacts[k], impulses[k]);
        for (Ball& ball : balls) {
            ball.velocity.z -= gravity * dt;
            ball.position += ball.velocity * dt;
        }
    }

private:
    static Vec3 force(const std::vector<Ball>& balls, const Contact& contact, double dt) {
        const Vec3 velocity = relative_velocity(balls, contact);
        const double inverse_mass = inverse_masses(contact);
        const double damping = damping_of(restitution_of(balls, contact), inverse_mass);
        const double normal =
            std::max(0.0, -stiffness * contact.gap - damping * dot(velocity, contact.normal));
        // Coulomb friction: opposes sliding with at most mu times the normal force, and at most the
        // force that stops the sliding within the step.
        const Vec3 sliding = along_surface(velocity, contact);
        const double speed = length(sliding);
        if (speed == 0) return contact.normal * normal;
        const double most = speed / (inverse_mass * dt);
        const double friction = std::min(friction_of(balls, contact) * normal, most);
        return contact.normal * normal - sliding * (friction / speed);
    }
};

}  // namespace

std::unique_ptr<ContactModel> make_penalty_model() {
    return std::make_unique<PenaltyModel>();
}

}  // namespace jostle::bench::contact_models
