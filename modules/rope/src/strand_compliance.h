// SPDX-License-Identifier: MIT
//
// How far some nodes of a strand move per force on others of them, in the system that solve_rod()
// has factorised: blocks of the inverse of its matrix.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "modules/rope/src/strand_system.h"

namespace jostle::modules::rope_detail {

class StrandCompliance {
public:
    // `nodes` are sorted. Takes a time proportional to the number of nodes after the first of them,
    // and to the sum of their distances from it.
    void compute(std::span<const LinkRow> links, const StrandElimination& solved,
                 std::span<const std::uint32_t> nodes);
    // 1/kg: displacement of nodes[to] per right side of nodes[from].
    const physics::Mat3& block(std::size_t to, std::size_t from) const {
        return blocks_[from * count_ + to];
    }

private:
    std::size_t count_ = 0;
    std::vector<physics::Mat3> blocks_;
    // Per node from the first one: d_i = A d_{i+1} + B d_{i+2}, and W_ii and W_{i,i+1}.
    std::vector<physics::Mat3> once_, twice_, own_, next_;
};

}  // namespace jostle::modules::rope_detail
