// SPDX-License-Identifier: MIT
#include "modules/destruction/src/bond_network.h"

namespace jostle::modules::destruction_detail {

using namespace physics;

namespace {

// A spring with the elongation g_a . moved_a + g_b . moved_b.
struct Spring {
    Block6 g_a, g_b;
    double stiffness = 0;
};

Block6 joined(Vec3 along, Vec3 about) {
    return {along.x, along.y, along.z, about.x, about.y, about.z};
}

// Elongation along a direction d at the face: d . (u_b + t_b x r_b - u_a - t_a x r_a).
Spring stretching(const Beam& beam, Vec3 d, double stiffness) {
    return {joined(-d, -cross(beam.arm_a, d)), joined(d, cross(beam.arm_b, d)), stiffness};
}
Spring turning(Vec3 d, double stiffness) {
    return {joined({}, -d), joined({}, d), stiffness};
}

// Axial, two shear, one torsion and two bending springs: E A / l, G A / l, G J / l, E I / l.
std::array<Spring, 6> springs_of(const Beam& beam, const BondMaterial& material) {
    const FractureBond& face = *beam.face;
    const double e = material.young / beam.length, g = e / (2 * (1 + material.poisson));
    const Vec3 n = face.normal, u = face.axis, v = cross(n, u);
    return {stretching(beam, n, e * face.area), stretching(beam, u, g * face.area),
            stretching(beam, v, g * face.area), turning(n, g * (face.moment_u + face.moment_v)),
            turning(u, e * face.moment_u),      turning(v, e * face.moment_v)};
}

void add_outer(Block& to, const Block6& x, const Block6& y, double s) {
    for (std::size_t r = 0; r < 6; r++)
        for (std::size_t c = 0; c < 6; c++) to[6 * r + c] += s * x[r] * y[c];
}

double product(const Block6& x, const Block6& y) {
    double sum = 0;
    for (std::size_t k = 0; k < 6; k++) sum += x[k] * y[k];
    return sum;
}

}  // namespace

BlockMatrix stiffness_of(std::span<const Beam> beams, std::size_t unknowns,
                         const BondMaterial& material) {
    BlockMatrix matrix;
    matrix.diagonal.assign(unknowns, Block{});
    for (const Beam& beam : beams) {
        const bool a_is_row = beam.a > beam.b;
        BlockMatrix::OffDiagonalBlock link{.row = a_is_row ? beam.a : beam.b,
                                           .column = a_is_row ? beam.b : beam.a};
        const bool both = beam.a != fixed_unknown && beam.b != fixed_unknown;
        for (const Spring& s : springs_of(beam, material)) {
            if (beam.a != fixed_unknown)
                add_outer(matrix.diagonal[beam.a], s.g_a, s.g_a, s.stiffness);
            if (beam.b != fixed_unknown)
                add_outer(matrix.diagonal[beam.b], s.g_b, s.g_b, s.stiffness);
            if (both)
                add_outer(link.block, a_is_row ? s.g_a : s.g_b, a_is_row ? s.g_b : s.g_a,
                          s.stiffness);
        }
        if (both) matrix.off_diagonal.push_back(link);
    }
    return matrix;
}

double load_of(const Beam& beam, const Block6& moved_a, const Block6& moved_b,
               const BondMaterial& material) {
    const FractureBond& face = *beam.face;
    double force[6];
    const std::array<Spring, 6> springs = springs_of(beam, material);
    for (std::size_t k = 0; k < 6; k++)
        force[k] = springs[k].stiffness *
                   (product(springs[k].g_a, moved_a) + product(springs[k].g_b, moved_b));
    const double axial = force[0] / face.area;
    const double bending = absolute(force[4]) * face.reach_u / face.moment_u +
                           absolute(force[5]) * face.reach_v / face.moment_v;
    const double corner = square_root(face.reach_u * face.reach_u + face.reach_v * face.reach_v);
    const double shear = square_root(force[1] * force[1] + force[2] * force[2]) / face.area +
                         absolute(force[3]) * corner / (face.moment_u + face.moment_v);
    return maximum(
        maximum((axial + bending) / material.tensile, (bending - axial) / material.compressive),
        shear / material.shear);
}

}  // namespace jostle::modules::destruction_detail
