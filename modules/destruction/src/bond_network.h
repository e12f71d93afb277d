// SPDX-License-Identifier: MIT
//
// Rigid chunks connected by short beams (T. Kawai, "New discrete models and their application to
// seismic response analysis of structures", 1978): six unknowns per chunk, six springs per bond.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/modules/destruction.h"
#include "jostle/physics/block_ldl.h"

namespace jostle::modules::destruction_detail {

// Force and torque on a chunk, or its translation and rotation.
using Vec6 = std::array<double, 6>;

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

// The factorized stiffness matrix of beams. The order of elimination depends only on which chunks
// are connected, so equal beams give bit-identical results.
class StiffnessFactor {
public:
    StiffnessFactor(std::span<const Beam> beams, std::size_t unknowns,
                    const BondMaterial& material);
    // Loads in, displacements out. Displacements along directions without stiffness are 0.
    void solve(std::span<Vec6> x) const;
    // Number of block products of the factorization.
    std::uint64_t work() const;

private:
    physics::BlockLdl ldl_;
};

// Load of a beam for the displacements of its ends, as a fraction of the strength: the maximum of
// tension, compression (axial force over area, bending moments over section moduli) and shear.
double load_of(const Beam& beam, const Vec6& moved_a, const Vec6& moved_b,
               const BondMaterial& material);

}  // namespace jostle::modules::destruction_detail
