// SPDX-License-Identifier: MIT
#include "modules/destruction/src/destruction_checks.h"

#include <string>

namespace jostle::modules::destruction_detail {

using namespace physics;

namespace {

struct Range {
    const char* name;
    double value, low, high;
};

template <std::size_t n>
Status within(const Range (&ranges)[n]) {
    for (const Range& r : ranges)
        if (!(r.value >= r.low && r.value <= r.high))
            return invalid_argument(std::string(r.name) + " is " + std::to_string(r.value) +
                                    "; it is out of range");
    return {};
}

bool is_near(Vec3 at) {
    return is_finite(at) && length_squared(at) <= coordinate_max * coordinate_max;
}

bool is_unit(Vec3 v) {
    return absolute(length_squared(v) - 1) < 1e-6;
}

Status check_bond(const FractureBond& bond, std::size_t chunks) {
    if (!(bond.a < bond.b && bond.b < chunks))
        return invalid_argument("a and b must be indices of chunks with a < b");
    if (!is_near(bond.center) || !is_unit(bond.normal) || !is_unit(bond.axis) ||
        absolute(dot(bond.normal, bond.axis)) > 1e-6)
        return invalid_argument(
            "center must be finite, and normal and axis must be perpendicular unit "
            "vectors");
    return within({{"area", bond.area, area_min, area_max},
                   {"moment_u", bond.moment_u, second_moment_min, second_moment_max},
                   {"moment_v", bond.moment_v, second_moment_min, second_moment_max},
                   {"reach_u", bond.reach_u, 0, coordinate_max},
                   {"reach_v", bond.reach_v, 0, coordinate_max}});
}

}  // namespace

Status check_limits(const DestructionLimits& limits) {
    return within({{"rounds", static_cast<double>(limits.rounds), 1, 64},
                   {"pieces_per_step", static_cast<double>(limits.pieces_per_step), 1, 1e6},
                   {"work_per_step", static_cast<double>(limits.work_per_step), 1, 1e12},
                   {"debris_life", limits.debris_life, 0, 1e6},
                   {"debris_volume", limits.debris_volume, 0, 1e12},
                   {"passing_volume", limits.passing_volume, 0, 1e12}});
}

Status check_shape(const FracturedShape& shape) {
    if (shape.chunks.empty() || shape.chunks.size() > chunks_max)
        return invalid_argument("chunks has " + std::to_string(shape.chunks.size()) +
                                " elements; it must have 1 to " + std::to_string(chunks_max));
    if (shape.bonds.size() > bonds_max)
        return invalid_argument("bonds has more than " + std::to_string(bonds_max) + " elements");
    for (std::size_t k = 0; k < shape.chunks.size(); k++) {
        const FractureChunk& chunk = shape.chunks[k];
        if (!is_convex(kind_of(chunk.geometry)) || !is_near(chunk.center) ||
            !(chunk.volume > 0 && chunk.volume < 1e12))
            return invalid_argument("chunks[" + std::to_string(k) +
                                    "] must be a convex solid with a finite position and a volume");
    }
    for (std::size_t k = 0; k < shape.bonds.size(); k++)
        if (Status s = check_bond(shape.bonds[k], shape.chunks.size()); !s.ok())
            return invalid_argument("bonds[" + std::to_string(k) + "]: " + s.error().message);
    return {};
}

Status check_def(const DestructibleDef& def) {
    const BondMaterial& m = def.bonds;
    return within({{"density", def.density, 1e-3, 1e6},
                   {"young", m.young, 1, 1e13},
                   {"poisson", m.poisson, 0, 0.5},
                   {"tensile", m.tensile, 1, 1e13},
                   {"shear", m.shear, 1, 1e13},
                   {"compressive", m.compressive, 1, 1e13},
                   {"fracture_energy", m.fracture_energy, 0, 1e9},
                   {"contact_time", m.contact_time, 1e-5, 1}});
}

}  // namespace jostle::modules::destruction_detail
