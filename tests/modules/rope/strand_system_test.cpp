// SPDX-License-Identifier: MIT
//
// The elimination against the residual of the equations that the header states.
#include "modules/rope/src/strand_system.h"

#include <gtest/gtest.h>

#include "modules/rope/src/strand_compliance.h"

namespace jostle::modules::rope_detail {
namespace {

using physics::Mat3;
using physics::Vec3;

struct System {
    std::vector<NodeRow> nodes;
    std::vector<LinkRow> links;
    std::vector<CrossBlock> cross;
};

// Numbers between -1 and 1.
struct Numbers {
    std::uint32_t state = 1;
    double next() {
        state = state * 1664525u + 1013904223u;
        return (state >> 8) / 8388608.0 - 1;
    }
    Vec3 vector() { return {next(), next(), next()}; }
};

System random_system(std::size_t links, bool bends, bool contacts) {
    Numbers random;
    System s;
    for (std::size_t i = 0; i <= links; i++)
        s.nodes.push_back({.diagonal = scalar_matrix(4) + outer(random.vector(), 1),
                           .right = random.vector(),
                           .fixed = i == 0 || i == links / 2});
    for (std::size_t k = 0; k < links; k++) {
        LinkRow link{.direction = random.vector(),
                     .compliance = 0.1 + 0.05 * random.next(),
                     .right = random.next(),
                     .next = -0.5 + 0.2 * random.next(),
                     .skip = bends && k + 1 < links ? 0.3 * random.next() : 0};
        if (contacts)
            s.cross.push_back(k % 3 == 1 ? CrossBlock{true, outer(random.vector(), 0.5)}
                                         : CrossBlock{});
        s.links.push_back(link);
    }
    return s;
}

// Largest residual of all equations.
double residual(const System& s, std::span<const Vec3> d, std::span<const double> u) {
    const auto coupling = [&](std::size_t k) {
        const double n = s.links[k].next;
        const Symmetric3 c = s.cross.empty() ? Symmetric3{} : s.cross[k].block;
        return scalar_matrix(n) + c;
    };
    double most = 0;
    for (std::size_t i = 0; i < s.nodes.size(); i++) {
        if (s.nodes[i].fixed) {
            most = std::max(most, length(d[i]));
            continue;
        }
        Vec3 left = s.nodes[i].diagonal * d[i];
        if (i < s.links.size()) {
            left += coupling(i) * d[i + 1] - s.links[i].direction * u[i];
            if (i + 2 < s.nodes.size()) left += d[i + 2] * s.links[i].skip;
        }
        if (i > 0) left += coupling(i - 1) * d[i - 1] + s.links[i - 1].direction * u[i - 1];
        if (i > 1) left += d[i - 2] * s.links[i - 2].skip;
        most = std::max(most, length(left - s.nodes[i].right));
    }
    for (std::size_t k = 0; k < s.links.size(); k++)
        most = std::max(most, std::abs(dot(s.links[k].direction, d[k + 1] - d[k]) -
                                       s.links[k].compliance * u[k] - s.links[k].right));
    return most;
}

TEST(StrandSystem, solves_chains_with_contacts_and_fixed_nodes) {
    for (const std::size_t links : {1u, 2u, 7u, 40u})
        for (const bool contacts : {false, true}) {
            const System s = random_system(links, false, contacts);
            StrandElimination memory;
            std::vector<Vec3> d(s.nodes.size());
            std::vector<double> u(s.links.size());
            solve_chain(s.nodes, s.links, s.cross, memory, d, u);
            EXPECT_LT(residual(s, d, u), 1e-11);
        }
}

TEST(StrandSystem, solves_rods_with_contacts_and_fixed_nodes) {
    for (const std::size_t links : {1u, 2u, 7u, 40u})
        for (const bool contacts : {false, true}) {
            const System s = random_system(links, true, contacts);
            StrandElimination memory;
            std::vector<Vec3> d(s.nodes.size());
            std::vector<double> u(s.links.size());
            solve_rod(s.nodes, s.links, s.cross, memory, d, u);
            EXPECT_LT(residual(s, d, u), 1e-11);
        }
}

TEST(StrandSystem, compliance_is_the_motion_of_nodes_by_forces_on_others) {
    for (const bool bends : {false, true}) {
        System s = random_system(24, bends, true);
        StrandElimination memory;
        std::vector<Vec3> d(s.nodes.size()), before(s.nodes.size());
        std::vector<double> u(s.links.size());
        solve_rod(s.nodes, s.links, s.cross, memory, before, u);
        const std::vector<std::uint32_t> nodes{3, 4, 9, 15, 23, 24};
        StrandCompliance compliance;
        compliance.compute(s.links, memory, nodes);
        const Vec3 force{0.3, -0.7, 0.4};
        for (std::size_t from = 0; from < nodes.size(); from++) {
            System pushed = s;
            pushed.nodes[nodes[from]].right += force;
            solve_rod(pushed.nodes, pushed.links, pushed.cross, memory, d, u);
            for (std::size_t to = 0; to < nodes.size(); to++)
                EXPECT_LT(
                    length(before[nodes[to]] + compliance.block(to, from) * force - d[nodes[to]]),
                    1e-11);
        }
    }
}

TEST(StrandSystem, gives_the_same_solution_of_a_chain_by_both_eliminations) {
    const System s = random_system(20, false, true);
    StrandElimination memory;
    std::vector<Vec3> d(s.nodes.size()), rod(s.nodes.size());
    std::vector<double> u(s.links.size());
    solve_chain(s.nodes, s.links, s.cross, memory, d, u);
    solve_rod(s.nodes, s.links, s.cross, memory, rod, u);
    for (std::size_t i = 0; i < d.size(); i++) EXPECT_LT(length(d[i] - rod[i]), 1e-12);
}

}  // namespace
}  // namespace jostle::modules::rope_detail
