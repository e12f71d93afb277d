// SPDX-License-Identifier: MIT
//
// The linear system of one Newton step of a strand: nodes in a row, a length constraint with a
// multiplier per link, and optionally bending, which couples each node with the next two. Solved
// directly by block elimination along the strand, in a time proportional to its number of nodes.
//
// Unknowns are the displacements d_i of the nodes (m) and the multipliers u_i of the links (kg):
//
//     D_i d_i + N_i d_{i+1} + N_{i-1}^T d_{i-1} + s_i d_{i+2} + s_{i-2} d_{i-2}
//                                          - e_i u_i + e_{i-1} u_{i-1} = r_i       per node
//     e_i . (d_{i+1} - d_i) - c_i u_i = g_i                                        per link
//
// where N_i = n_i I + C_i. The matrix is symmetric and quasi-definite (R. Vanderbei, "Symmetric
// quasidefinite matrices", SIAM J. Optim. 5, 1995), so elimination in this order needs no pivots.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "modules/rope/src/symmetric3.h"

namespace jostle::modules::rope_detail {

struct NodeRow {
    Symmetric3 diagonal = {};  // D, kg
    physics::Vec3 right = {};  // r, kg m
    bool fixed = false;        // d is 0
};

struct LinkRow {
    physics::Vec3 direction = {};  // e, m
    double compliance = 0;         // c, m^2/kg, >= 0
    double right = 0;              // g, m^2
    double next = 0;               // n, kg
    double skip = 0;  // s, kg, couples the node before the link with the node after the next
};

// The coupling C of a link, kg.
struct CrossBlock {
    bool any = false;
    Symmetric3 block = {};
};

// Reused memory of the elimination.
struct StrandElimination {
    struct Step {
        Symmetric3 inverse = {};  // of the node's block after elimination of those before
        physics::Vec3 right = {}, row = {};  // r and f
        double inverse_pivot = 0, target = 0;
    };
    // Rods only.
    struct RodStep {
        physics::Vec3 weighted = {};                        // w
        physics::Mat3 next = physics::diagonal({0, 0, 0});  // N after elimination
    };
    std::vector<Step> steps;
    std::vector<RodStep> rod_steps;
};

// Solves a system without bending: all LinkRow::skip are 0. There are one more nodes than links.
// `cross` is empty, or has one item per link. Writes the displacements of the nodes and the changes
// of the multipliers.
void solve_chain(std::span<const NodeRow> nodes, std::span<const LinkRow> links,
                 std::span<const CrossBlock> cross, StrandElimination& memory,
                 std::span<physics::Vec3> displacements, std::span<double> multipliers);
// Same with bending.
void solve_rod(std::span<const NodeRow> nodes, std::span<const LinkRow> links,
               std::span<const CrossBlock> cross, StrandElimination& memory,
               std::span<physics::Vec3> displacements, std::span<double> multipliers);

}  // namespace jostle::modules::rope_detail
