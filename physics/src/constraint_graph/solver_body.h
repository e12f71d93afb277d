// SPDX-License-Identifier: MIT
//
// Contact solver data of a body. Floats are relative to the pose at the start of the step: deltas
// are small, so float loses no precision. The pose itself is stored elsewhere in double. Rows are
// 32 bytes, so that one row of eight bodies is one transposed load.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "jostle/base/check.h"
#include "jostle/physics/vec3.h"
#include "physics/src/constraint_graph/solver_tier.h"

namespace jostle::physics {

struct alignas(64) SolverBody {
    // Row 0: velocity. Read and written by every contact pass.
    float v[3];          // m/s
    float w[3];          // rad/s
    float inverse_mass;  // 1/kg; zero for bodies that contacts cannot push
    float inverse_spin;  // 1/(kg m^2) for isotropic inertia; row 2 is then not read
    // Row 1: motion since the start of the step. Read by every contact pass, written once per
    // sub-step.
    float dp[3];        // m
    float dr[3];        // rad, rotation vector
    float free_z;       // 0 if the body cannot move along z, else 1
    float spins_along;  // 1: joints read w and inertia in body-fixed axes (SpinAxes::body)
    // Row 2: inverse inertia in world axes, constant over the step (SpinAxes: solver_scratch.h).
    float inertia[6];  // xx yy zz xy xz yz
    float free_x, free_y;
    // Row 3: velocity before any contact of this sub-step acted. v - free is the total effect of
    // all contacts, which is exactly what warm starting adds in the next sub-step. Warm starting
    // therefore costs one subtraction per body.
    float free[8];
};
static_assert(sizeof(SolverBody) == 128);

// The first three elements of a row.
inline Vec3 to_vec3(const float* row) {
    return {double{row[0]}, double{row[1]}, double{row[2]}};
}

// Velocity change per sub-step from all sources except contacts: free = row 0 * retained + push.
// Lanes 6 and 7 pass mass and spin through unchanged (retained 1, push 0). Only the body passes use
// it.
struct alignas(64) ExternalChange {
    float retained[8];  // damping
    float push[8];      // gravity, forces and gyroscopic spin change, times the sub-step
};

// Hot records by hot index. Index 0 is a dummy body that joints may read: immovable and at rest.
// Negative indices are dummy bodies for unused lanes, which are read and written like all others.
// Concurrent threads use different dummy bodies.
class SolverBodies {
public:
    static constexpr std::size_t spare = 2 * solved_set_count;

    // The dummy body for unused lanes of a task's colour sets, given its first set and one of its
    // two lists.
    static constexpr std::int32_t spare_index(std::size_t first_set, bool single) {
        return -1 - static_cast<std::int32_t>(2 * first_set + (single ? 1 : 0));
    }

    void resize(std::size_t count) {  // includes the dummy body 0
        ASSERT(count > 0);
        all_.resize(spare + count);
        std::fill(all_.begin(), all_.begin() + spare + 1, SolverBody{});
    }
    std::size_t size() const { return all_.size() - spare; }
    SolverBody* data() { return all_.data() + spare; }
    SolverBody& operator[](std::size_t index) {
        ASSERT(spare + index < all_.size());
        return all_[spare + index];
    }
    const SolverBody& operator[](std::size_t index) const {
        ASSERT(spare + index < all_.size());
        return all_[spare + index];
    }

private:
    std::vector<SolverBody> all_;
};

}  // namespace jostle::physics
