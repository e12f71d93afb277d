// SPDX-License-Identifier: MIT
//
// Hulls of any points: refused with a reason, or closed, convex and with a volume. What was built
// is put together again from its parts, as a saved world does it.
#include <algorithm>
#include <cmath>

#include "jostle/physics/hull.h"
#include "physics/src/geometry/hull_builder.h"
#include "tests/fuzz/mutate_numbers.h"
#include "tests/fuzz/points.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

namespace {

using namespace physics;

void check(const ConvexHull& hull, std::span<const Vec3> points) {
    expect(hull.vertices.size() + hull.faces.size() == hull.edges.size() + 2, "Euler's formula");
    expect(hull.volume > 0 && std::isfinite(hull.volume), "a hull has a volume");
    expect(hull.inner_radius >= 0 && std::isfinite(hull.inner_radius), "and an inner radius");
    double size = 0;
    for (const Vec3 p : points)
        size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    for (const HullFace& face : hull.faces) {
        expect(face.count >= 3 && face.count <= max_face_vertices,
               "a face has three corners or more");
        expect(std::abs(length(face.normal) - 1) < 1e-9, "a normal has unit length");
        for (const Vec3 p : points)
            expect(dot(face.normal, p) - face.offset <= 1e-4 * size, "no point lies outside");
    }
}

}  // namespace

void run(Bytes input) {
    Reader in(input);
    const PointKind kind = take_point_kind(in);
    const std::vector<Vec3> points = take_points(in, kind, 512);
    const auto hull = build_hull(points);
    if (!hull.ok()) return expect(!hull.error().message.empty(), "a refusal has a reason");
    check(**hull, points);
    std::vector<std::vector<std::uint16_t>> faces;
    for (const HullFace& face : (*hull)->faces) {
        const auto corners = (*hull)->vertices_of(face);
        faces.emplace_back(corners.begin(), corners.end());
    }
    const auto again = assemble_hull((*hull)->vertices, faces);
    expect(again.ok(), again.ok() ? "" : "its parts are refused: " + again.error().message);
    expect((*again)->content_hash == (*hull)->content_hash, "its parts give the same hull");
}

}  // namespace jostle::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t size_max, unsigned seed) {
    return jostle::fuzz::mutate_numbers(data, size, size_max, seed);
}
