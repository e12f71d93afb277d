// SPDX-License-Identifier: MIT
#include "physics/src/constraints/impact.h"

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {
namespace {

// Speed changes below this fraction of the approach speed are rounding.
constexpr double settled = 1e-14;

struct Load {
    double target = 0;  // m/s along the normal after the impact
    double normal = 0;  // N s
    Vec3 friction;
};

// All points simultaneously: the closing velocity of each point, and the response of all points to
// an impulse at one. The bodies receive the sum at the end.
class Impulses {
public:
    Impulses(ImpactBody& a, ImpactBody& b, std::span<const ImpactPoint> points)
        : a_(a), b_(b), points_(points), states_(points.size()) {
        for (std::size_t k = 0; k < points.size(); k++) {
            PointState& s = states_[k];
            ASSERT(is_unit(points[k].normal, 1e-4));
            s.arm_a = points[k].position - a.center;
            s.arm_b = points[k].position - b.center;
            s.speed = (b.v + cross(b.w, s.arm_b)) - (a.v + cross(a.w, s.arm_a));
        }
        // Column by column: the velocity change at j from a unit impulse at k.
        responses_.resize(points.size() * points.size());
        ASSERT(!points.empty());
        const Vec3 mass = a.inverse_mass + b.inverse_mass, unit[3]{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        for (std::size_t k = 0; k < points.size(); k++)
            for (int i = 0; i < 3; i++) {
                const Vec3 wa = a.inverse_inertia * cross(states_[k].arm_a, unit[i]),
                           wb = b.inverse_inertia * cross(states_[k].arm_b, unit[i]);
                for (std::size_t j = 0; j < points.size(); j++)
                    responses_[k * points.size() + j].column[i] = scaled(mass, unit[i]) +
                                                                  cross(wb, states_[j].arm_b) +
                                                                  cross(wa, states_[j].arm_a);
            }
    }

    Vec3 relative(std::size_t k) const { return states_[k].speed; }

    // Solves the normal impulse, whose sum is never negative, then friction within its cone.
    // Returns the change of the point's velocity, m/s.
    double relax(std::size_t k, Load& load, double friction) {
        const Vec3 n = points_[k].normal, before_all = states_[k].speed;
        const double response_n = response(k, n);
        if (!(response_n > 0)) return 0;
        const double old_impulse = load.normal;
        load.normal = maximum(0, old_impulse - (dot(relative(k), n) - load.target) / response_n);
        push(k, n * (load.normal - old_impulse));
        ASSERT(load.normal >= 0);
        rub(k, load, friction * load.normal);
        return length(states_[k].speed - before_all);
    }

    // Applies the accumulated point impulses to the bodies.
    void apply() {
        for (const PointState& s : states_) {
            a_.v -= scaled(a_.inverse_mass, s.impulse);
            a_.w -= a_.inverse_inertia * cross(s.arm_a, s.impulse);
            b_.v += scaled(b_.inverse_mass, s.impulse);
            b_.w += b_.inverse_inertia * cross(s.arm_b, s.impulse);
        }
    }

private:
    struct PointState {
        Vec3 arm_a, arm_b;  // m, from the centres of mass
        Vec3 speed;         // m/s: of b relative to a
        Vec3 impulse;       // N s, accumulated
    };
    struct Response {
        Vec3 column[3];  // 1/kg

        Vec3 operator*(Vec3 p) const { return column[0] * p.x + column[1] * p.y + column[2] * p.z; }
    };

    void rub(std::size_t k, Load& load, double most) {
        const Vec3 n = points_[k].normal, u = relative(k), slip = u - n * dot(u, n);
        const double speed = length(slip);
        ASSERT(most >= 0);
        if (speed < 1e-12) return;
        const Vec3 along = slip * (1 / speed);
        const double response_t = response(k, along);
        if (!(response_t > 0)) return;
        Vec3 desired = load.friction - along * (speed / response_t);
        if (const double size = length(desired); size > most)
            desired = desired * (size > 0 ? most / size : 0);
        // The projection onto the cone changes the impulse in a direction other than the slip.
        // Apply it only as far as it removes energy; the rest would spin up a thin rod.
        const Vec3 change = desired - load.friction;
        if (!(length(change) > 1e-12 * most)) return;
        const double energy_limit = -dot(u, change) / response(k, change);
        const Vec3 impulse = change * clamp(energy_limit, 0, 1);
        load.friction += impulse;
        push(k, impulse);
    }

    void push(std::size_t k, Vec3 impulse) {
        if (impulse == Vec3{}) return;
        states_[k].impulse += impulse;
        for (std::size_t j = 0; j < states_.size(); j++)
            states_[j].speed += responses_[k * states_.size() + j] * impulse;
    }
    // Velocity along d per impulse along d, times the squared length of d, 1/kg.
    double response(std::size_t k, Vec3 d) const {
        return dot(d, responses_[k * states_.size() + k] * d);
    }

    ImpactBody &a_, &b_;
    std::span<const ImpactPoint> points_;
    std::vector<PointState> states_;
    std::vector<Response> responses_;  // [k * points + j]: velocity at j per impulse at k
};

}  // namespace

HardestPoint resolve_impact(ImpactBody& a, ImpactBody& b, std::span<const ImpactPoint> points,
                            double restitution, double friction, double bounce_speed) {
    Impulses impulses(a, b, points);
    ASSERT(restitution >= 0 && restitution <= 1 && friction >= 0);
    std::vector<Load> loads(points.size());
    HardestPoint hardest;
    for (std::size_t k = 0; k < points.size(); k++) {
        const double approach = -dot(impulses.relative(k), points[k].normal);
        if (approach > bounce_speed) loads[k].target = restitution * approach;
        if (approach > hardest.approach) hardest = {approach, points[k]};
    }
    for (int sweep = 0; sweep < tuning::impact_sweeps; sweep++) {
        double most = 0;  // m/s
        for (std::size_t k = 0; k < points.size(); k++)
            most = maximum(most, impulses.relax(k, loads[k], friction));
        if (most <= settled * hardest.approach) break;
    }
    impulses.apply();
    Vec3 rubbed;
    for (const Load& load : loads) {
        hardest.normal_impulse += load.normal;
        rubbed += load.friction;
    }
    hardest.friction_impulse = length(rubbed);
    ASSERT(hardest.normal_impulse >= 0);
    return hardest;
}

}  // namespace jostle::physics
