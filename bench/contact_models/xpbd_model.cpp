// SPDX-License-Identifier: MIT
//
// Position-based dynamics with sub-steps (Macklin and others 2019; Müller and others 2020, rigid
// bodies). Each sub-step integrates all bodies without contacts, separates overlapping bodies by
// their masses, and derives the velocities from the displacements. Hard contacts have no
// compliance, so XPBD equals PBD in this scene. One iteration in each of ten sub-steps is more
// accurate than ten iterations in one step: the error falls with the square of the sub-step.
// Friction reverts the sliding, restitution is a pass over the velocities. The drawback: deriving
// velocities from positions loses energy, first order in the sub-step.
#include <algorithm>
#include <cmath>

#include "bench/contact_models/contact_models.h"

namespace jostle::bench::contact_models {
namespace {

constexpr int substeps = 10;

struct Touched {
    Contact contact;
    double approach;    // m/s before the sub-step
    double correction;  // m along the normal
};

class XpbdModel final : public ContactModel {
public:
    void step(std::vector<Ball>& balls, double dt) override {
        for (int k = 0; k < substeps; k++) substep(balls, dt / substeps);
    }

private:
    static void substep(std::vector<Ball>& balls, double h) {
        std::vector<Vec3> before;
        for (Ball& ball : balls) {
            before.push_back(ball.position);
            ball.velocity.z -= gravity * h;
            ball.position += ball.velocity * h;
        }
        const std::vector<Touched> touched = move_apart(balls, before);
        for (std::size_t k = 0; k < balls.size(); k++)
            balls[k].velocity = (balls[k].position - before[k]) * (1 / h);
        for (const Touched& touch : touched) bounce(balls, touch, h);
    }

    // One iteration. Overlaps are recomputed for each contact, because earlier contacts have moved
    // its balls.
    static std::vector<Touched> move_apart(std::vector<Ball>& balls,
                                           const std::vector<Vec3>& before) {
        std::vector<Touched> touched;
        for (const Contact& contact : find_contacts(balls, 0)) {
            const Contact now = updated(balls, contact);
            if (now.gap >= 0) continue;
            const double approach = -dot(relative_velocity(balls, now), now.normal);
            move(balls, now, now.normal * -now.gap);
            // Static friction reverts all sliding of the sub-step; sliding friction reverts mu
            // times its normal correction.
            const Vec3 slid = along_surface(relative_displacement(balls, before, now), now);
            const double limit = friction_of(balls, now) * -now.gap, size = length(slid);
            move(balls, now, slid * (size > limit ? -limit / size : -1));
            touched.push_back({now, approach, -now.gap});
        }
        return touched;
    }

    // Limits the separation velocity to the value that restitution allows.
    static void bounce(std::vector<Ball>& balls, const Touched& touch, double h) {
        const double speed = dot(relative_velocity(balls, touch.contact), touch.contact.normal);
        // A contact that approaches more slowly than gravity accelerates a body in two sub-steps
        // rests.
        const bool rests = touch.approach < 2 * gravity * h;
        const double target = rests ? 0 : restitution_of(balls, touch.contact) * touch.approach;
        push(balls, touch.contact,
             touch.contact.normal * ((target - speed) / inverse_masses(touch.contact)));
    }

    static Contact updated(const std::vector<Ball>& balls, const Contact& contact) {
        const Vec3 b = balls[static_cast<std::size_t>(contact.b)].position;
        if (contact.a == plane) return {plane, contact.b, {0, 0, 1}, b.z - radius};
        const Vec3 offset = b - balls[static_cast<std::size_t>(contact.a)].position;
        const double distance = length(offset);
        return {contact.a, contact.b, distance > 0 ? offset * (1 / distance) : Vec3{0, 0, 1},
                distance - 2 * radius};
    }

    // Moves the two balls apart by `by` in total, in proportion to their inverse masses.
    static void move(std::vector<Ball>& balls, const Contact& contact, Vec3 by) {
        const double share = contact.a == plane ? 1 : 0.5;
        balls[static_cast<std::size_t>(contact.b)].position += by * share;
        if (contact.a != plane) balls[static_cast<std::size_t>(contact.a)].position -= by * share;
    }

    static Vec3 relative_displacement(const std::vector<Ball>& balls,
                                      const std::vector<Vec3>& before, const Contact& contact) {
        const auto displacement = [&](int ball) {
            const auto k = static_cast<std::size_t>(ball);
            return balls[k].position - before[k];
        };
        return contact.a == plane ? displacement(contact.b)
                                  : displacement(contact.b) - displacement(contact.a);
    }
};

}  // namespace

std::unique_ptr<ContactModel> make_xpbd_model() {
    return std::make_unique<XpbdModel>();
}

}  // namespace jostle::bench::contact_models
