// SPDX-License-Identifier: MIT
//
// Rigid chunks connected by short beams (T. Kawai, "New discrete models and their application to
// seismic response analysis of structures", 1978): six unknowns per chunk, six springs per bond.
#pragma once

#include <span>
#include <vector>

#include "jostle/modules/destruction.h"
#include "modules/destruction/src/block_ldl.h"

namespace jostle::modules::destruction_detail {

// A part of a destructible: chunks and the bonds between them, both ascending.
struct Group {
    std::vector<std::uint32_t> chunks, bonds;
};

// A bond as a beam: its two ends and the geometry of the six springs.
struct Beam {
    const FractureBond* face = nullptr;
    std::uint32_t a = 0, b = 0;  // indices of unknowns; fixed_unknown if held
    physics::Vec3 arm_a, arm_b;  // from the centres of mass to the face
    double length = 0;           // m, between the centres of mass along the normal
};
inline constexpr std::uint32_t fixed_unknown = 0xffffffff;

BlockMatrix stiffness_of(std::span<const Beam> beams, std::size_t unknowns,
                         const BondMaterial& material);

// Load of a beam for the displacements of its ends, as a fraction of the strength: the maximum of
// tension, compression (axial force over area, bending moments over section moduli) and shear.
double load_of(const Beam& beam, const Block6& moved_a, const Block6& moved_b,
               const BondMaterial& material);

}  // namespace jostle::modules::destruction_detail
