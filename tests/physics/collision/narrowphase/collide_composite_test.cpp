// SPDX-License-Identifier: MIT
//
// Meshes, height fields and compounds against every kind, part by part, with the slab oracle
// (support/convex_oracle.h): no part that touches is missed, none that is apart is reported, and
// the gap is that of the nearest part.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "jostle/physics/compound.h"
#include "jostle/physics/height_field.h"
#include "jostle/physics/mesh.h"
#include "physics/src/collision/narrowphase/collide.h"
#include "physics/src/collision/narrowphase/collide_composite.h"
#include "tests/support/convex_oracle.h"
#include "tests/support/random_shapes.h"

namespace jostle::test {
namespace {
using namespace physics;

constexpr double look_ahead = 0.05;  // m

// The largest n.x over one convex part, in the world.
using Part = std::function<double(Vec3 n)>;

Part triangle_part(const Transform& pose, Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 p = apply(pose, a), q = apply(pose, b), r = apply(pose, c);
    return [=](Vec3 n) { return std::max({dot(p, n), dot(q, n), dot(r, n)}); };
}

std::vector<Part> parts_of(const Geometry& geometry, const Transform& pose) {
    std::vector<Part> parts;
    if (const auto* mesh = std::get_if<Mesh>(&geometry)) {
        for (const auto& t : mesh->data->triangles)
            parts.push_back(triangle_part(pose, mesh->data->vertices[t[0]],
                                          mesh->data->vertices[t[1]], mesh->data->vertices[t[2]]));
    } else if (const auto* field = std::get_if<HeightField>(&geometry)) {
        const auto& grid = *field->data;
        const auto at = [&](std::uint32_t c, std::uint32_t r) {
            return Vec3{(c - (grid.columns - 1) / 2.0) * grid.spacing_x,
                        grid.heights[r * grid.columns + c],
                        (r - (grid.rows - 1) / 2.0) * grid.spacing_z};
        };
        for (std::uint32_t r = 0; r + 1 < grid.rows; r++)
            for (std::uint32_t c = 0; c + 1 < grid.columns; c++) {
                if (!grid.holes.empty() && grid.holes[r * (grid.columns - 1) + c] != 0) continue;
                for (const Vec3 third : {at(c + 1, r), at(c, r + 1)})
                    parts.push_back(triangle_part(pose, at(c, r), third, at(c + 1, r + 1)));
            }
    } else if (const auto* compound = std::get_if<Compound>(&geometry)) {
        for (const CompoundChild& child : compound->data->children)
            parts.push_back([&child, at = compose(pose, child.pose)](Vec3 n) {
                return support(child.geometry, at, n);
            });
    } else {
        parts.push_back([&geometry, pose](Vec3 n) { return support(geometry, pose, n); });
    }
    return parts;
}

// Signed distance of the two nearest parts. The search may end on a ridge below the widest gap;
// `claimed` normals, from a to b, that show a wider one are taken after they were measured.
double nearest(const std::vector<Part>& a, const std::vector<Part>& b,
               const std::vector<Vec3>& claimed) {
    double least = 1e300;
    for (const Part& pa : a)
        for (const Part& pb : b) {
            const auto gap = [&](Vec3 n) { return -pb(-n) - pa(n); };
            double widest_gap = widest(gap).distance;
            for (const Vec3 n : claimed) widest_gap = std::max(widest_gap, gap(n));
            least = std::min(least, widest_gap);
        }
    return least;
}

Geometry random_composite(ShapeKind kind, Random& random) {
    if (kind == ShapeKind::mesh) {
        std::vector<Vec3> vertices;
        for (int i = 0; i < 6; i++) vertices.push_back(random.vector(1.5));
        const std::vector<std::array<std::uint32_t, 3>> two = {{0, 1, 2}, {2, 1, 3}};
        const std::vector<std::array<std::uint32_t, 3>> apart = {{0, 1, 2}, {3, 4, 5}};
        return Mesh{must(build_mesh(vertices, random.below(2) == 0 ? two : apart))};
    }
    if (kind == ShapeKind::height_field) {
        HeightGrid grid{.columns = 3,
                        .rows = 2,
                        .spacing_x = random.in(0.5, 2),
                        .spacing_z = random.in(0.5, 2),
                        .heights = {}};
        const bool flat = random.below(3) == 0;
        for (int i = 0; i < 6; i++) grid.heights.push_back(flat ? 0.25 : random.in(-0.5, 0.5));
        if (random.below(3) == 0) grid.holes = {0, 1};
        return HeightField{must(build_height_field(grid))};
    }
    std::vector<CompoundChild> children;
    for (int i = 0; i < 3; i++) {
        static constexpr ShapeKind convex[] = {ShapeKind::sphere, ShapeKind::capsule,
                                               ShapeKind::box,    ShapeKind::cylinder,
                                               ShapeKind::cone,   ShapeKind::hull};
        children.push_back({random_geometry(convex[random.below(6)], random),
                            {random.vector(1), random_rotation(random)}});
    }
    return Compound{must(build_compound(children))};
}

Geometry any_geometry(ShapeKind kind, Random& random) {
    return is_composite(kind) ? random_composite(kind, random) : random_geometry(kind, random);
}

// Few in every run of the tests; JOSTLE_ORACLE_PAIRS=100000 for a long one.
std::uint64_t pairs_of_each() {
    const char* text = std::getenv("JOSTLE_ORACLE_PAIRS");
    return text != nullptr ? std::strtoull(text, nullptr, 10) : 40;
}

class CompositeOracle : public testing::TestWithParam<std::pair<ShapeKind, ShapeKind>> {};

TEST_P(CompositeOracle, matches_a_search_over_all_directions) {
    const auto [ka, kb] = GetParam();
    // Triangles have no inside: out of one is either way, and the seams choose which.
    const bool solid = ka == ShapeKind::compound && (is_convex(kb) || kb == ShapeKind::compound);
    int touching = 0;
    for (std::uint64_t seed = 0; seed < pairs_of_each() && !HasFailure(); seed++) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Random random(7000000 + seed * 256 + static_cast<std::uint64_t>(ka) * 16 +
                      static_cast<std::uint64_t>(kb));
        const Geometry a = any_geometry(ka, random), b = any_geometry(kb, random);
        const Transform pose_a{random.vector(3), random_rotation(random)};
        const Transform pose_b{pose_a.position + random.vector(2), random_rotation(random)};
        const TransformedShape pa = transformed_shape(a, pose_a), pb = transformed_shape(b, pose_b);
        std::vector<ChildManifold> manifolds, turned;
        collide_composite(pa, pb, look_ahead, manifolds);
        collide_composite(pb, pa, look_ahead, turned);
        std::vector<Vec3> normals;
        for (const ChildManifold& part : manifolds) normals.push_back(part.manifold.normal);
        for (const ChildManifold& part : turned) normals.push_back(-part.manifold.normal);
        const double truth = nearest(parts_of(a, pose_a), parts_of(b, pose_b), normals);
        if (std::fabs(truth) < 1e-4 || std::fabs(truth - look_ahead) < 1e-4) continue;
        EXPECT_EQ(shapes_overlap(pa, pb), truth < 0) << truth;
        EXPECT_EQ(shapes_overlap(pb, pa), truth < 0) << truth;
        EXPECT_EQ(manifolds.empty(), turned.empty());
        double least = 1e300;
        for (const ChildManifold& part : manifolds) {
            ASSERT_GT(part.manifold.count, 0);
            ASSERT_LE(part.manifold.count, 4);
            ASSERT_NEAR(length(part.manifold.normal), 1, 1e-9);
            for (int k = 0; k < part.manifold.count; k++) {
                ASSERT_TRUE(is_finite(part.manifold.point[k]));
                least = std::min(least, part.manifold.gap[k]);
            }
        }
        if (truth > look_ahead) {
            EXPECT_TRUE(manifolds.empty()) << truth;
            continue;
        }
        ASSERT_FALSE(manifolds.empty()) << "missed at " << truth;
        // The search finds a lower bound of the distance, and ends on ridges a little below it.
        EXPECT_GT(least, (truth > 0 || solid ? truth : -1e300) - 2e-4);
        // Deep in a folded sheet there are several ways out, and one is enough.
        EXPECT_LT(least, truth > 0      ? truth + 2e-3
                         : solid        ? truth + 5e-3
                         : truth > -0.1 ? 0.5 * truth + 2e-3
                                        : 0);
        touching += truth < 0 ? 1 : 0;
    }
    EXPECT_GT(touching, 0);
}

// An edge of a box that lies in the plane of a triangle, or nearly so, across one of its edges: out
// of the triangle is either way, and only the box tells which of them is meant.
TEST(CompositeOracle, finds_contacts_of_boxes_lying_on_a_flat_height_field) {
    const HeightGrid grid{
        .columns = 2, .rows = 2, .spacing_x = 1.5, .spacing_z = 1.2, .heights = {0, 0, 0, 0}};
    const Geometry field = HeightField{must(build_height_field(grid))};
    Random random(1294);
    int touching = 0;
    for (int round = 0; round < 2000; round++) {
        const Geometry box = Box{{random.in(0.1, 1), random.in(0.1, 1), random.in(0.1, 1)}};
        // Turned about the upright and then about one of its own level edges.
        const double tilts[] = {0, 1e-12, 1e-9, 1e-6};
        const Quat yaw = from_rotation_vector({0, random.in(-3, 3), 0});
        const Quat roll = from_rotation_vector({random.in(-3, 3), 0, tilts[random.below(4)]});
        const Transform pose{{random.in(-1, 1), random.in(-0.5, 0.5), random.in(-1, 1)},
                             yaw * roll};
        const TransformedShape ground = transformed_shape(field, {}),
                               lying = transformed_shape(box, pose);
        if (!shapes_overlap(ground, lying)) continue;
        touching++;
        std::vector<ChildManifold> manifolds;
        collide_composite(ground, lying, look_ahead, manifolds);
        EXPECT_FALSE(manifolds.empty()) << "round " << round;
    }
    EXPECT_GT(touching, 500);
}

std::vector<std::pair<ShapeKind, ShapeKind>> composite_pairs() {
    std::vector<std::pair<ShapeKind, ShapeKind>> pairs;
    for (const ShapeKind a : {ShapeKind::mesh, ShapeKind::height_field, ShapeKind::compound})
        for (int k = 0; k < shape_kinds; k++) {
            const auto b = static_cast<ShapeKind>(k);
            if (is_convex(b) || b == ShapeKind::compound) pairs.emplace_back(a, b);
        }
    return pairs;
}
INSTANTIATE_TEST_SUITE_P(every_pair, CompositeOracle, testing::ValuesIn(composite_pairs()),
                         [](const auto& pair) {
                             std::string name = std::string(kind_name(pair.param.first)) + "_" +
                                                kind_name(pair.param.second);
                             std::replace(name.begin(), name.end(), ' ', '_');
                             return name;
                         });

}  // namespace
}  // namespace jostle::test
