// SPDX-License-Identifier: MIT
#include "modules/destruction/src/bond_network.h"

#include <algorithm>

namespace jostle::modules::destruction_detail {

using namespace physics;

namespace {

// A pivot of this fraction of its diagonal is rounding error: no bond resists in that direction.
// Lower than the default, because a chunk can hang on a bond far weaker than its others.
constexpr double dependent_pivot = 1e-14;

// A spring with the elongation g_a . moved_a + g_b . moved_b.
struct Spring {
    Vec6 g_a, g_b;
    double stiffness = 0;
};

Vec6 joined(Vec3 along, Vec3 about) {
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

// Adds to the block of 6 x 6 values at `at`.
void add_outer(std::span<double> values, int at, const Vec6& x, const Vec6& y, double s) {
    const std::span<double> to = values.subspan(static_cast<std::size_t>(at), 36);
    for (std::size_t r = 0; r < 6; r++)
        for (std::size_t c = 0; c < 6; c++) to[6 * r + c] += s * x[r] * y[c];
}

double product(const Vec6& x, const Vec6& y) {
    double sum = 0;
    for (std::size_t k = 0; k < 6; k++) sum += x[k] * y[k];
    return sum;
}

}  // namespace

StiffnessFactor::StiffnessFactor(std::span<const Beam> beams, std::size_t unknowns,
                                 const BondMaterial& material) {
    std::vector<physics::BlockLdl::Edge> edges;
    for (const Beam& beam : beams)
        if (beam.a != fixed_unknown && beam.b != fixed_unknown)
            edges.emplace_back(static_cast<int>(beam.a), static_cast<int>(beam.b));
    ldl_.analyze(std::vector<int>(unknowns, 6), edges);
    const std::span<double> values = ldl_.values();
    for (const Beam& beam : beams) {
        const int a = static_cast<int>(beam.a), b = static_cast<int>(beam.b);
        const bool a_moves = beam.a != fixed_unknown, b_moves = beam.b != fixed_unknown;
        const bool both = a_moves && b_moves, a_is_later = both && ldl_.is_later(a, b);
        const int at_a = a_moves ? ldl_.block_at(a, a) : 0;
        const int at_b = b_moves ? ldl_.block_at(b, b) : 0;
        const int at_both = !both ? 0 : a_is_later ? ldl_.block_at(a, b) : ldl_.block_at(b, a);
        for (const Spring& s : springs_of(beam, material)) {
            if (a_moves) add_outer(values, at_a, s.g_a, s.g_a, s.stiffness);
            if (b_moves) add_outer(values, at_b, s.g_b, s.g_b, s.stiffness);
            if (both)
                add_outer(values, at_both, a_is_later ? s.g_a : s.g_b, a_is_later ? s.g_b : s.g_a,
                          s.stiffness);
        }
    }
    ldl_.factor(dependent_pivot);
}

void StiffnessFactor::solve(std::span<Vec6> x) const {
    std::vector<double> ordered(6 * x.size());
    for (std::size_t k = 0; k < x.size(); k++)
        std::copy(x[k].begin(), x[k].end(), ordered.begin() + ldl_.row_of(static_cast<int>(k)));
    ldl_.solve(ordered);
    for (std::size_t k = 0; k < x.size(); k++)
        std::copy_n(ordered.begin() + ldl_.row_of(static_cast<int>(k)), 6, x[k].begin());
}

std::uint64_t StiffnessFactor::work() const {
    std::uint64_t products = 0;
    for (int k = 0; k < ldl_.nodes(); k++)
        products += ldl_.below(k).size() + ldl_.updates(k).size() + 1;
    return products;
}

double load_of(const Beam& beam, const Vec6& moved_a, const Vec6& moved_b,
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
