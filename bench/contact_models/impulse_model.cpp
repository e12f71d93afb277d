// SPDX-License-Identifier: MIT
//
// Velocity constraints by sequential impulses (Catto, GDC 2006): projected Gauss-Seidel. For each
// contact, compute the impulse that stops its approach, and iterate until all constraints hold:
//     v along the normal >= target,   impulse >= 0,   |friction impulse| <= mu * normal impulse.
// The impulses of the last step are the initial guess (warm starting): without them ten iterations
// do not carry ten boxes. Velocity constraints do not see positions, so a share of the overlap is
// added to the target in each step (Baumgarte).
#include <algorithm>
#include <cmath>

#include "bench/contact_models/contact_models.h"

namespace jostle::bench::contact_models {
namespace {

constexpr int rounds = 10;
constexpr double correction = 0.2;    // share of the overlap that is corrected per step
constexpr double allowed = 5e-4;      // m of overlap that remain, so that contacts persist
constexpr double margin = 0.05;       // m: contacts that may close within the step
constexpr double least_bounce = 0.5;  // m/s: slower approaches do not bounce

struct Row {
    Contact contact;
    double target = 0;  // m/s along the normal
    double friction = 0;
    double normal_impulse = 0;  // N s, sum over the iterations
    Vec3 friction_impulse;
};

class ImpulseModel final : public ContactModel {
public:
    void step(std::vector<Ball>& balls, double dt) override {
        std::vector<Row> rows = prepare(balls, dt);
        for (Ball& ball : balls) ball.velocity.z -= gravity * dt;
        for (const Row& row : rows)
            push(balls, row.contact,
                 row.contact.normal * row.normal_impulse + row.friction_impulse);
        for (int round = 0; round < rounds; round++)
            for (Row& row : rows) {
                solve_friction(balls, row);
                solve_normal(balls, row);
            }
        for (Ball& ball : balls) ball.position += ball.velocity * dt;
        last_ = std::move(rows);
    }

private:
    std::vector<Row> prepare(const std::vector<Ball>& balls, double dt) const {
        std::vector<Row> rows;
        for (const Contact& contact : find_contacts(balls, margin)) {
            Row row{.contact = contact, .friction = friction_of(balls, contact)};
            const double approach = -dot(relative_velocity(balls, contact), contact.normal);
            // A gap may close, but no further; an overlap is corrected by a share.
            row.target = contact.gap > 0 ? -contact.gap / dt
                                         : correction / dt * std::max(0.0, -contact.gap - allowed);
            const bool collides = contact.gap < approach * dt;
            if (collides && approach > least_bounce)
                row.target = std::max(row.target, restitution_of(balls, contact) * approach);
            if (const Row* previous = row_of_last_step(contact)) {
                row.normal_impulse = previous->normal_impulse;
                row.friction_impulse = previous->friction_impulse;
            }
            rows.push_back(row);
        }
        return rows;
    }

    const Row* row_of_last_step(const Contact& contact) const {
        for (const Row& row : last_)
            if (row.contact.a == contact.a && row.contact.b == contact.b) return &row;
        return nullptr;
    }

    // Clamps the accumulated impulse instead of the increment, so that later iterations may reduce
    // it.
    static void solve_normal(std::vector<Ball>& balls, Row& row) {
        const double speed = dot(relative_velocity(balls, row.contact), row.contact.normal);
        const double increment = (row.target - speed) / inverse_masses(row.contact);
        const double sum = std::max(0.0, row.normal_impulse + increment);
        push(balls, row.contact, row.contact.normal * (sum - row.normal_impulse));
        row.normal_impulse = sum;
    }

    // Clamps the length of the tangential impulse, so that friction is isotropic.
    static void solve_friction(std::vector<Ball>& balls, Row& row) {
        const Vec3 sliding = along_surface(relative_velocity(balls, row.contact), row.contact);
        Vec3 sum = row.friction_impulse - sliding * (1 / inverse_masses(row.contact));
        const double limit = row.friction * row.normal_impulse, size = length(sum);
        if (size > limit) sum = sum * (size > 0 ? limit / size : 0);
        push(balls, row.contact, sum - row.friction_impulse);
        row.friction_impulse = sum;
    }

    std::vector<Row> last_;
};

}  // namespace

std::unique_ptr<ContactModel> make_impulse_model() {
    return std::make_unique<ImpulseModel>();
}

}  // namespace jostle::bench::contact_models
