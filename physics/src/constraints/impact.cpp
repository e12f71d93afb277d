// SPDX-License-Identifier: MIT
#include "constraints/impact.h"

#include "foundation/tuning.h"

namespace jostle::physics {
namespace {

struct Load {
    double target = 0;  // m/s along the normal, afterwards
    double normal = 0;  // N s
    Vec3 friction;
};

class Impulses {
public:
    Impulses(ImpactBody& a, ImpactBody& b) : a_(a), b_(b) {}

    Vec3 relative(const ImpactPoint& p) const {
        return (b_.v + cross(b_.w, p.position - b_.center)) -
               (a_.v + cross(a_.w, p.position - a_.center));
    }

    // First the normal impulse, never below zero in sum, then friction within the cone it opens.
    void relax(const ImpactPoint& p, Load& load, double friction) {
        const double response_n = response(p, p.normal);
        if (!(response_n > 0)) return;
        const double before = load.normal;
        load.normal = maximum(0, before - (dot(relative(p), p.normal) - load.target) / response_n);
        push(p, p.normal * (load.normal - before));
        rub(p, load, friction * load.normal);
    }

private:
    void rub(const ImpactPoint& p, Load& load, double most) {
        const Vec3 u = relative(p), slip = u - p.normal * dot(u, p.normal);
        const double speed = length(slip);
        if (speed < 1e-12) return;
        const Vec3 along = slip * (1 / speed);
        const double response_t = response(p, along);
        if (!(response_t > 0)) return;
        Vec3 wished = load.friction - along * (speed / response_t);
        if (const double size = length(wished); size > most)
            wished = wished * (size > 0 ? most / size : 0);
        // Back into the cone is another way than along the slip: only as far as it takes energy. On
        // a thin rod the rest would spin it up.
        const Vec3 change = wished - load.friction;
        const double size = length(change);
        if (!(size > 1e-12 * most)) return;
        const double takes = -dot(u, change) / (size * size * response(p, change * (1 / size)));
        const Vec3 impulse = change * clamp(takes, 0, 1);
        load.friction += impulse;
        push(p, impulse);
    }

    void push(const ImpactPoint& p, Vec3 impulse) {
        a_.v -= scaled(a_.inverse_mass, impulse);
        a_.w -= a_.inverse_inertia * cross(p.position - a_.center, impulse);
        b_.v += scaled(b_.inverse_mass, impulse);
        b_.w += b_.inverse_inertia * cross(p.position - b_.center, impulse);
    }
    // Velocity along d per impulse along d, 1/kg.
    double response(const ImpactPoint& p, Vec3 d) const {
        const Vec3 ta = cross(p.position - a_.center, d), tb = cross(p.position - b_.center, d);
        return dot(scaled(a_.inverse_mass + b_.inverse_mass, d), d) +
               dot(ta, a_.inverse_inertia * ta) + dot(tb, b_.inverse_inertia * tb);
    }

    ImpactBody &a_, &b_;
};

}  // namespace

HardestPoint resolve_impact(ImpactBody& a, ImpactBody& b, std::span<const ImpactPoint> points,
                            double restitution, double friction) {
    Impulses impulses(a, b);
    std::vector<Load> loads(points.size());
    HardestPoint hardest;
    for (std::size_t k = 0; k < points.size(); k++) {
        const double approach = -dot(impulses.relative(points[k]), points[k].normal);
        if (approach > tuning::restitution_speed) loads[k].target = restitution * approach;
        if (approach > hardest.approach) hardest = {approach, points[k]};
    }
    for (int sweep = 0; sweep < tuning::impact_sweeps; sweep++)
        for (std::size_t k = 0; k < points.size(); k++)
            impulses.relax(points[k], loads[k], friction);
    return hardest;
}

}  // namespace jostle::physics
