// SPDX-License-Identifier: MIT
//
// Rigid chunks joined by short beams (Kawai, "New discrete models and their application to seismic
// response analysis of structures", 1978): six unknowns for each chunk, six springs for each bond.
#pragma once

#include <span>
#include <vector>

#include "jostle/modules/destruction.h"
#include "modules/destruction/src/block_ldl.h"

namespace jostle::modules::destruction_detail {

// A part of a whole: chunks, and bonds between them, both ascending.
struct Group {
    std::vector<std::uint32_t> chunks, bonds;
};

// How the two ends of a bond lie apart, and the six springs in between.
struct Beam {
    const FractureBond* face = nullptr;
    std::uint32_t a = 0, b = 0;  // unknowns; fixed_unknown: held
    physics::Vec3 arm_a, arm_b;  // from the centres to the face
    double length = 0;           // m, between the centres along the normal
};
inline constexpr std::uint32_t fixed_unknown = 0xffffffff;

BlockMatrix stiffness_of(std::span<const Beam> beams, std::size_t unknowns,
                         const BondMaterial& material);

// What a beam bears when its ends moved so, as a share of the strength: the greatest of tension,
// compression (axial force over area and bending moments over section moduli) and shear.
double load_of(const Beam& beam, const Block6& moved_a, const Block6& moved_b,
               const BondMaterial& material);

}  // namespace jostle::modules::destruction_detail
