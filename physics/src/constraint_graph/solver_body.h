// SPDX-License-Identifier: MIT
//
// What the contact solver knows of a body. Float, relative to the pose at the start of the step:
// deltas are small, so float loses nothing; the pose itself is double and elsewhere. Rows of 32
// bytes, so that one row of eight bodies is one transposed load.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "jostle/physics/vec3.h"
#include "physics/src/constraint_graph/solver_tier.h"
#include "physics/src/foundation/check.h"

namespace jostle::physics {

struct alignas(64) SolverBody {
    // row 0: velocity; read and written by every contact pass
    float v[3];          // m/s
    float w[3];          // rad/s
    float inverse_mass;  // 1/kg; zero for what contacts cannot push
    float inverse_spin;  // 1/(kg m^2) when the inertia is isotropic; row 2 is then not read
    // row 1: motion since the start of the step; read by every contact pass, written once per
    // sub-step
    float dp[3];        // m
    float dr[3];        // rad, rotation vector
    float free_z;       // 0 when it cannot move along z, else 1
    float spins_along;  // 1: joints find w and inertia in axes that turn with it (SpinAxes::body)
    // row 2: inverse inertia in world axes, constant over the step (SpinAxes: solver_scratch.h)
    float inertia[6];  // xx yy zz xy xz yz
    float free_x, free_y;
    // row 3: velocity before any contact of this sub-step acted. v - free is what all contacts
    // together did, which is exactly what warm starting the next sub-step would add again: warm
    // starting costs one subtraction per body.
    float free[8];
};
static_assert(sizeof(SolverBody) == 128);

// The first three of a row.
inline Vec3 to_vec3(const float* row) {
    return {double{row[0]}, double{row[1]}, double{row[2]}};
}

// What changes a body apart from contacts, per sub-step: free = row 0 * keep + push. Lanes 6 and 7
// carry mass and spin through unchanged (keep 1, push 0). Touched by the body passes only.
struct alignas(64) ExternalChange {
    float retained[8];  // damping
    float push[8];      // gravity, forces and the gyroscopic change of spin, times the sub-step
};

// Hot records by hot index. [0] is nobody, whom joints may read: it stands still and cannot be
// pushed. Below it are bodies for unused lanes, which are read and written like all others: threads
// that work at the same time have each their own.
class SolverBodies {
public:
    static constexpr std::size_t spare = 2 * solved_set_count;

    // Unused lanes of the colour sets of one task, by its first, and of one of its two lists.
    static constexpr std::int32_t spare_index(std::size_t first_set, bool single) {
        return -1 - static_cast<std::int32_t>(2 * first_set + (single ? 1 : 0));
    }

    void resize(std::size_t count) {  // nobody included
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
