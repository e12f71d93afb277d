// SPDX-License-Identifier: MIT
#include "physics/src/constraints/impact_cluster.h"

#include <utility>

#include "jostle/base/check.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {
namespace {

// Speed changes below this fraction of the hardest approach end the sweeps of a round.
constexpr double settled_fraction = 1e-13;
constexpr int max_sweeps = 400;

// Velocity along d at an arm per unit impulse along d there, 1/kg.
double response(const ImpactBody& body, Vec3 arm, Vec3 d) {
    const Vec3 turned = cross(arm, d);
    return dot(d, scaled(body.inverse_mass, d)) + dot(turned, body.inverse_inertia * turned);
}

}  // namespace

std::uint32_t ImpactCluster::add_body(const ImpactBody& body) {
    bodies_.push_back(body);
    return static_cast<std::uint32_t>(bodies_.size() - 1);
}

void ImpactCluster::add_pair(ClusterPair pair) {
    ASSERT(pair.a < bodies_.size() && pair.b < bodies_.size() && pair.a != pair.b);
    ASSERT(pair.restitution >= 0 && pair.restitution <= 1 && pair.friction >= 0);
    pairs_.push_back(std::move(pair));
}

double ImpactCluster::closing_speed(const ImpactBody& a, const ImpactBody& b,
                                    const std::vector<ImpactPoint>& points) {
    double most = 0;
    for (const ImpactPoint& p : points) {
        const Vec3 va = a.v + cross(a.w, p.position - a.center),
                   vb = b.v + cross(b.w, p.position - b.center);
        most = maximum(most, -dot(vb - va, p.normal));
    }
    return most;
}

double ImpactCluster::hardest() const {
    double most = 0;
    for (const ClusterPair& pair : pairs_)
        most = maximum(most, closing_speed(bodies_[pair.a], bodies_[pair.b], pair.points));
    return most;
}

ImpactCluster::Row ImpactCluster::row_of(std::uint32_t pair_index, std::uint32_t point) const {
    const ClusterPair& pair = pairs_[pair_index];
    const ImpactPoint& p = pair.points[point];
    const ImpactBody &a = bodies_[pair.a], &b = bodies_[pair.b];
    ASSERT(is_unit(p.normal, 1e-4));
    Row row{.pair = pair_index,
            .point = point,
            .arm_a = p.position - a.center,
            .arm_b = p.position - b.center,
            .friction = {}};
    const auto along = [&](Vec3 d) {
        return response(a, row.arm_a, d) + response(b, row.arm_b, d);
    };
    row.response_n = along(p.normal);
    if (pair.friction > 0) {
        // Their sum bounds the response in any tangential direction.
        const Vec3 t =
            normalized(cross(p.normal, absolute(p.normal.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 0, 1}));
        const Vec3 u = cross(p.normal, t);
        const double rt = along(t), ru = along(u);
        const Vec3 both = (t + u) * square_root(0.5), other = (t - u) * square_root(0.5);
        row.response_t = maximum(maximum(rt, ru), maximum(along(both), along(other)));
        // The exact maximum exceeds that of the four directions by less than this.
        row.response_t = minimum(rt + ru, 1.25 * row.response_t);
        if (rt == ru && along(both) == rt) row.response_t = rt;
    }
    return row;
}

Vec3 ImpactCluster::relative(const Row& row) const {
    const ClusterPair& pair = pairs_[row.pair];
    const ImpactBody &a = bodies_[pair.a], &b = bodies_[pair.b];
    return (b.v + cross(b.w, row.arm_b)) - (a.v + cross(a.w, row.arm_a));
}

void ImpactCluster::push(const Row& row, Vec3 impulse) {
    const ClusterPair& pair = pairs_[row.pair];
    ImpactBody &a = bodies_[pair.a], &b = bodies_[pair.b];
    a.v -= scaled(a.inverse_mass, impulse);
    a.w -= a.inverse_inertia * cross(row.arm_a, impulse);
    b.v += scaled(b.inverse_mass, impulse);
    b.w += b.inverse_inertia * cross(row.arm_b, impulse);
}

// Projected Gauss-Seidel until nothing changes: the velocities after the impact are unique.
void ImpactCluster::solve_normals(double settled) {
    for (int sweep = 0; sweep < max_sweeps; sweep++) {
        double most = 0;  // m/s
        for (Row& row : rows_) {
            if (!(row.response_n > 0)) continue;
            const Vec3 n = pairs_[row.pair].points[row.point].normal;
            const double now =
                maximum(0, row.normal - (dot(relative(row), n) - row.target) / row.response_n);
            const double change = now - row.normal;
            if (change == 0) continue;
            row.normal = now;
            push(row, n * change);
            most = maximum(most, absolute(change) * row.response_n);
        }
        if (most <= settled) return;
    }
}

// The friction impulses within the discs of radius mu times the normal impulse that leave the least
// energy: projected gradients, which never add any.
void ImpactCluster::solve_friction(double settled) {
    for (int sweep = 0; sweep < max_sweeps; sweep++) {
        double most = 0;  // m/s
        for (Row& row : rows_) {
            const ClusterPair& pair = pairs_[row.pair];
            const double limit = pair.friction * row.normal;
            if (!(limit > 0) || !(row.response_t > 0)) continue;
            const Vec3 n = pair.points[row.point].normal, u = relative(row),
                       slip = u - n * dot(u, n);
            Vec3 now = row.friction - slip * (1 / row.response_t);
            if (const double size = length(now); size > limit) now = now * (limit / size);
            const Vec3 change = now - row.friction;
            if (change == Vec3{}) continue;
            row.friction = now;
            push(row, change);
            most = maximum(most, length(change) * row.response_t);
        }
        if (most <= settled) return;
    }
}

void ImpactCluster::record() {
    for (const Row& row : rows_) {
        HardestPoint& hit = pairs_[row.pair].hit;
        hit.normal_impulse += row.normal;
        hit.friction_impulse += length(row.friction);
    }
}

bool ImpactCluster::reflect(double least, double bounce_speed) {
    rows_.clear();
    double most = 0;
    for (std::uint32_t k = 0; k < pairs_.size(); k++) {
        ClusterPair& pair = pairs_[k];
        for (std::uint32_t i = 0; i < pair.points.size(); i++) {
            Row row = row_of(k, i);
            const double approach = -dot(relative(row), pair.points[i].normal);
            if (!(approach > least)) continue;
            if (approach > bounce_speed) row.target = pair.restitution * approach;
            rows_.push_back(row);
            most = maximum(most, approach);
            if (approach > pair.hit.approach) {
                pair.hit.approach = approach;
                pair.hit.point = pair.points[i];
            }
        }
    }
    if (rows_.empty()) return false;
    solve_normals(settled_fraction * most);
    solve_friction(settled_fraction * most);
    record();
    return true;
}

void ImpactCluster::stop() {
    rows_.clear();
    for (std::uint32_t k = 0; k < pairs_.size(); k++)
        for (std::uint32_t i = 0; i < pairs_[k].points.size(); i++) rows_.push_back(row_of(k, i));
    const double settled = settled_fraction * maximum(hardest(), 1e-3);
    solve_normals(settled);
    record();
}

}  // namespace jostle::physics
