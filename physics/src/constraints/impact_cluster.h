// SPDX-License-Identifier: MIT
//
// Simultaneous impacts of touching bodies. In each round all points that close are reflected at
// once, as by the generalized reflections of Smith et al. ("Reflections on simultaneous impact",
// 2012): the impulses solve the linear complementarity problem of Newton's law of restitution, so
// the result depends neither on the order of the points nor on that of the bodies. A
// mirror-symmetric cluster therefore stays symmetric, and an impulse still travels along a row of
// balls to its end. Removes energy, never adds any.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/src/constraints/impact.h"

namespace jostle::physics {

// Two touching bodies of a cluster.
struct ClusterPair {
    std::uint32_t a = 0, b = 0;       // indices of bodies
    std::vector<ImpactPoint> points;  // normals from a to b
    double restitution = 0, friction = 0;
    HardestPoint hit;  // result: the highest approach speed, and the total impulses
};

class ImpactCluster {
public:
    std::uint32_t add_body(const ImpactBody& body);
    void add_pair(ClusterPair pair);

    // m/s: the highest closing speed of any point; 0 if none closes.
    double hardest() const;
    // Reflects the points that close faster than `least`. Those slower than `bounce_speed` stop.
    // Returns false if there are none.
    bool reflect(double least, double bounce_speed);
    // Stops all points that still close.
    void stop();

    const std::vector<ImpactBody>& bodies() const { return bodies_; }
    const std::vector<ClusterPair>& pairs() const { return pairs_; }
    // Returns the closing speed that two bodies have at points that are not part of the cluster.
    static double closing_speed(const ImpactBody& a, const ImpactBody& b,
                                const std::vector<ImpactPoint>& points);

private:
    struct Row {
        std::uint32_t pair, point;
        Vec3 arm_a, arm_b;                      // m, from the centres of mass
        double target = 0;                      // m/s along the normal after the impact
        double response_n = 0, response_t = 0;  // 1/kg
        double normal = 0;                      // N s
        Vec3 friction;                          // N s
    };

    Row row_of(std::uint32_t pair, std::uint32_t point) const;
    Vec3 relative(const Row& row) const;
    void push(const Row& row, Vec3 impulse);
    void solve_normals(double settled);
    void solve_friction(double settled);
    void record();

    std::vector<ImpactBody> bodies_;
    std::vector<ClusterPair> pairs_;
    std::vector<Row> rows_;  // of the current round
};

}  // namespace jostle::physics
