// SPDX-License-Identifier: MIT
#include "physics/src/constraint_graph/effective_mass.h"

#include "jostle/base/check.h"
#include "jostle/physics/scalar.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {

void write_effective_mass(const ContactLaneRef& lane_ref, const ContactFrame& frame,
                          const InverseMass& a, const InverseMass& b) {
    ContactConstraintWide& block = *lane_ref.block;
    const int lane = lane_ref.lane;
    const auto [n, t1, arm_a, arm_b] = frame;
    ASSERT(is_unit(n, 1e-4) && absolute(dot(n, t1)) < 1e-4);
    const Vec3 t2 = cross(n, t1);
    const auto both = [&](Vec3 ja, Vec3 jb, Vec3 ka, Vec3 kb) {
        return dot(ja, a.angular * ka) + dot(jb, b.angular * kb);
    };
    const Vec3 mass = a.linear + b.linear;
    ASSERT(mass.x >= 0 && mass.y >= 0 && mass.z >= 0);
    const auto along = [&](Vec3 u, Vec3 v) { return dot(scaled(mass, u), v); };
    // Rows of the normals: (arm x n), t1, t2. Rows of friction: arm x t. Row of torsion: n.
    const Vec3 na = cross(arm_a, n), nb = cross(arm_b, n);
    block.g[0][lane] = as_float(maximum(along(n, n) + both(na, nb, na, nb), 1e-30));
    block.g[1][lane] = as_float(both(na, nb, t1, t1));
    block.g[2][lane] = as_float(both(na, nb, t2, t2));
    block.g[3][lane] = as_float(both(t1, t1, t1, t1));
    block.g[4][lane] = as_float(both(t1, t1, t2, t2));
    block.g[5][lane] = as_float(both(t2, t2, t2, t2));
    const Vec3 pa = cross(arm_a, t1), pb = cross(arm_b, t1);
    const Vec3 qa = cross(arm_a, t2), qb = cross(arm_b, t2);
    const double f00 = along(t1, t1) + both(pa, pb, pa, pb);
    const double f01 = along(t1, t2) + both(pa, pb, qa, qb);
    const double f11 = along(t2, t2) + both(qa, qb, qa, qb), det = f00 * f11 - f01 * f01;
    if (det > 1e-12 * f00 * f11) {
        block.friction_mass[0][lane] = as_float(f11 / det);
        block.friction_mass[1][lane] = as_float(-f01 / det);
        block.friction_mass[2][lane] = as_float(f00 / det);
    } else {
        // Locked axes leave one sliding direction or none.
        const double trace = f00 + f11, scale = trace > 0 ? 1 / (trace * trace) : 0;
        block.friction_mass[0][lane] = as_float(f00 * scale);
        block.friction_mass[1][lane] = as_float(f01 * scale);
        block.friction_mass[2][lane] = as_float(f11 * scale);
    }
    const double k = both(n, n, n, n);
    block.torsion_mass[lane] = k > 0 ? as_float(1 / k) : 0;
}

void rewrite_effective_mass(const ContactLaneRef& lane_ref, const InverseMass& a,
                            const InverseMass& b) {
    ContactConstraintWide& block = *lane_ref.block;
    const int lane = lane_ref.lane;
    const float old_mass = block.g[0][lane];
    write_effective_mass(lane_ref,
                         {get_lane(block.normal, lane), get_lane(block.tangent, lane),
                          get_lane(block.arm_a, lane), get_lane(block.arm_b, lane)},
                         a, b);
    // Contact stiffness is proportional to the mass of the bodies. The part of the impulse beyond
    // the mean would jump with the mass, so the mean is adjusted to preserve the load.
    const float stiffer = old_mass / block.g[0][lane];
    ASSERT(stiffer > 0);
    for (int k = 0; k < 4; k++)
        block.mean_impulse[k][lane] =
            block.lambda[k][lane] - stiffer * (block.lambda[k][lane] - block.mean_impulse[k][lane]);
}

}  // namespace jostle::physics
