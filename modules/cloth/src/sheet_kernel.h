// SPDX-License-Identifier: MIT
//
// The kernels of a sheet: one pass over its constraints in a sub-step. Compiled once per
// instruction set (kernel_*.cpp), with the same results.
#pragma once

#include <cstddef>
#include <cstdint>

#include "modules/cloth/src/sheet_node.h"

namespace jostle::modules::cloth_detail {

// Eight chains in lockstep: `links` links from index `first` of the arrays of links, their nodes
// from `first_node`, each times eight.
struct ChainBlock {
    std::uint32_t first = 0, first_node = 0, links = 0;
};

// Arrays of a sheet, by lane: index 8 k + lane.
struct SheetArrays {
    SheetNode* nodes = nullptr;

    const ChainBlock* chains = nullptr;
    std::size_t chain_count = 0;
    const std::uint32_t* chain_nodes = nullptr;
    const float* rest_lengths = nullptr;        // m
    const float* stretch_compliance = nullptr;  // m/N
    float* tensions = nullptr;                  // N, of the last sub-step
    float* scratch = nullptr;                   // 72 floats per link of the longest chain
    // Per node 4 floats, or null: q and the pull of the threads along q in the sub-step, kg^1/2 m.
    // The inverse mass of a node along q is less by q^2, because it presses against a body.
    float* pressed = nullptr;

    std::size_t cell_count = 0;                 // blocks of eight
    const std::uint32_t* cell_nodes = nullptr;  // 4 x 8 per block
    const float* cell_scale_u = nullptr;        // 1/m, 1 / (2 rest length)
    const float* cell_scale_v = nullptr;
    const float* cell_compliance = nullptr;  // 1/(N m)

    std::size_t hinge_count = 0;                 // blocks of eight
    const std::uint32_t* hinge_nodes = nullptr;  // 4 x 8 per block
    const float* hinge_weights = nullptr;        // 4 x 8 per block
    const float* hinge_compliance = nullptr;
};

struct SheetKernel {
    // Solves the links of each chain together. Returns the largest transverse rate by the tension,
    // 2 T / l (1/m_a + 1/m_b), 1/s^2.
    float (*solve_chains)(const SheetArrays& sheet, float h);
    void (*solve_cells)(const SheetArrays& sheet, float h);
    void (*solve_hinges)(const SheetArrays& sheet, float h);
};

extern const SheetKernel baseline_kernel, avx2_kernel;

// The kernel for the current instruction set (physics/instruction_set.h).
const SheetKernel& sheet_kernel();

}  // namespace jostle::modules::cloth_detail
