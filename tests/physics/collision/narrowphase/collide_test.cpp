// SPDX-License-Identifier: MIT
//
// The narrow phase against the slab oracle (support/convex_oracle.h), over seeded pairs of every
// two kinds: nothing is missed, no depth is wrong, no normal is worse than the best that a search
// over all directions finds.
#include <gtest/gtest.h>

#include <limits>

#include "physics/src/collision/narrowphase/collide.h"
#include "tests/support/convex_oracle.h"
#include "tests/support/distance_field.h"
#include "tests/support/random_shapes.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

constexpr double margin = 0.05;  // m

struct Pair {
    Geometry a, b;
    Transform pose_a, pose_b;
};

double size_of(const Geometry& g) {
    if (const auto* sphere = std::get_if<Sphere>(&g)) return sphere->radius;
    if (const auto* capsule = std::get_if<Capsule>(&g))
        return capsule->radius + capsule->half_length;
    if (const auto* box = std::get_if<Box>(&g)) return length(box->half_extents);
    if (const auto* cylinder = std::get_if<Cylinder>(&g))
        return std::hypot(cylinder->radius, cylinder->half_length);
    if (const auto* cone = std::get_if<Cone>(&g))
        return std::hypot(cone->radius, cone->half_length);
    if (const auto* hull = std::get_if<Hull>(&g))
        return length(hull->data->bounds.high - hull->data->bounds.low) / 2;
    return 1e300;
}

// b is moved along a random direction so that the signed distance is about what is wanted; exact
// touches included.
Pair random_pair(ShapeKind ka, ShapeKind kb, Random& random) {
    Pair p{random_geometry(ka, random),
           random_geometry(kb, random),
           {random.vector(5), random_rotation(random)},
           {random.vector(5), random_rotation(random)}};
    if (kb == ShapeKind::plane) {
        const Vec3 up = rotate(p.pose_b.rotation, std::get<Plane>(p.b).normal);
        const double lowest = -support(p.a, p.pose_a, -up) - dot(up, p.pose_b.position);
        const double wanted = random.in(-0.5, 0.1);
        p.pose_a.position += up * (wanted - lowest);
        return p;
    }
    if (random.below(20) == 0) {  // concentric
        p.pose_b.position = p.pose_a.position;
        return p;
    }
    const Vec3 n =
        random.below(2) == 0 ? random.direction() : rotate(p.pose_a.rotation, Vec3{0, 1, 0});
    const double smaller = std::min(size_of(p.a), size_of(p.b));
    const double choices[] = {0, 0.5 * margin, -0.02 * smaller, random.in(-0.8, 0.3) * smaller,
                              2 * margin};
    const double wanted = choices[random.below(5)];
    p.pose_b.position = p.pose_a.position + random.vector(0.3 * smaller);
    // Slabs along n are `wanted` apart: the distance is at least that, and often exactly that.
    p.pose_b.position += n * (wanted - slab_gap(p.a, p.pose_a, p.b, p.pose_b, n));
    return p;
}

// The gap that normal n leaves, whoever claims it.
double gap_along(const Pair& p, Vec3 n) {
    if (kind_of(p.b) != ShapeKind::plane) return slab_gap(p.a, p.pose_a, p.b, p.pose_b, n);
    return separation(p.a, p.pose_a, p.b, p.pose_b).distance;
}

struct Report {
    std::uint64_t touching = 0;
    double worst_depth = 0, worst_normal = 0, worst_point = 0;  // fractions of the size
};

void check(const Pair& p, Report& report) {
    PairCache cache;
    const Manifold m =
        collide(transformed_shape(p.a, p.pose_a), transformed_shape(p.b, p.pose_b), margin, cache);
    OracleGap truth = separation(p.a, p.pose_a, p.b, p.pose_b);
    // A search may miss the top of a ridge. Every slab gap is a lower bound of the distance, so a
    // better one that somebody claims is taken, after it was measured.
    if (m.count > 0 && kind_of(p.b) != ShapeKind::plane)
        truth.distance = std::max(truth.distance, gap_along(p, m.normal));
    const double size = std::min(size_of(p.a), size_of(p.b));
    const double tolerance = 1e-4 * size + 1e-6;
    // The search finds a lower bound, the walk an upper one; the truth is between.
    const double at_most = kind_of(p.b) == ShapeKind::plane || truth.distance < 0
                               ? truth.distance
                               : distance_at_most(p.a, p.pose_a, p.b, p.pose_b);
    ASSERT_LE(truth.distance, at_most + tolerance) << "the oracle contradicts itself";
    ASSERT_GE(m.count, 0);
    ASSERT_LE(m.count, 4);
    if (m.count == 0) {
        EXPECT_GT(at_most, margin - tolerance) << "missed";
        EXPECT_LE(m.distance, at_most + tolerance) << "the bound must be below the distance";
        EXPECT_NEAR(length(m.normal), 1, 1e-9);
        EXPECT_GE(gap_along(p, m.normal), m.distance - tolerance) << "not that far along it";
        return;
    }
    ASSERT_NEAR(length(m.normal), 1, 1e-9);
    double deepest = m.gap[0];
    for (int i = 0; i < m.count; i++) {
        ASSERT_TRUE(is_finite(m.point[i]) && is_finite(m.gap[i]));
        EXPECT_LE(m.gap[i], margin + tolerance);
        deepest = std::min(deepest, m.gap[i]);
        // Half way between the surfaces: no further from either than half the gap or the overlap.
        // (A small shape deep in a large one is another matter: half way out of the large is beyond
        // the small.)
        if (truth.distance < -0.2 * size) continue;
        const double outside = std::max(signed_distance(p.a, p.pose_a, m.point[i]),
                                        signed_distance(p.b, p.pose_b, m.point[i]));
        const double excess = outside - std::fabs(m.gap[i]) / 2;
        report.worst_point = std::max(report.worst_point, excess / size);
        EXPECT_LT(excess, 0.06 * size) << "a point that is on neither shape";
    }
    EXPECT_LE(deepest, at_most + tolerance) << "shapes are nearer than the manifold says";
    if (truth.distance >= 0) {
        EXPECT_GE(deepest, truth.distance - tolerance) << "separate shapes do not overlap";
        return;
    }
    report.touching++;
    report.worst_depth = std::max(report.worst_depth, std::fabs(deepest - truth.distance) / size);
    EXPECT_NEAR(deepest, truth.distance, tolerance);
    // The normal is as good as the best: it leaves the same depth.
    const double worse = truth.distance - gap_along(p, m.normal);
    report.worst_normal = std::max(report.worst_normal, worse / size);
    EXPECT_LE(worse, tolerance);
}

// How many pairs of each two kinds: few in every run of the tests, 100,000 with
// JOSTLE_ORACLE_PAIRS=100000. JOSTLE_ORACLE_FIRST=n begins with seed n.
std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
    const char* text = std::getenv(name);
    return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

class CollideOracle : public testing::TestWithParam<std::pair<ShapeKind, ShapeKind>> {};

TEST_P(CollideOracle, matches_a_search_over_all_directions) {
    const auto [ka, kb] = GetParam();
    Report report;
    const std::uint64_t first = from_environment("JOSTLE_ORACLE_FIRST", 0),
                        pairs = from_environment("JOSTLE_ORACLE_PAIRS", 150);
    for (std::uint64_t seed = first; seed < first + pairs && !HasFailure(); seed++) {
        Random random(seed * 256 + static_cast<std::uint64_t>(ka) * 16 +
                      static_cast<std::uint64_t>(kb));
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        check(random_pair(ka, kb, random), report);
    }
    RecordProperty("touching", std::to_string(report.touching));
    RecordProperty("worst_depth", std::to_string(report.worst_depth));
    RecordProperty("worst_normal", std::to_string(report.worst_normal));
    RecordProperty("worst_point", std::to_string(report.worst_point));
    EXPECT_GE(report.touching, pairs / 15);
}

std::vector<std::pair<ShapeKind, ShapeKind>> convex_pairs() {
    std::vector<std::pair<ShapeKind, ShapeKind>> pairs;
    for (int a = 0; a < shape_kinds; a++)
        for (int b = 0; b < shape_kinds; b++) {
            const auto ka = static_cast<ShapeKind>(a), kb = static_cast<ShapeKind>(b);
            if (is_convex(ka) && (is_convex(kb) || kb == ShapeKind::plane))
                pairs.emplace_back(ka, kb);
        }
    return pairs;
}
INSTANTIATE_TEST_SUITE_P(every_pair, CollideOracle, testing::ValuesIn(convex_pairs()),
                         [](const auto& pair) {
                             return std::string(kind_name(pair.param.first)) + "_" +
                                    kind_name(pair.param.second);
                         });

// Where the normal is unique it is known exactly.
TEST(Collide, normals_of_simple_cases_are_exact) {
    const auto normal = [](const Geometry& a, Vec3 pa, const Geometry& b, Vec3 pb) {
        PairCache cache;
        const Manifold m =
            collide(transformed_shape(a, {pa, {}}), transformed_shape(b, {pb, {}}), margin, cache);
        EXPECT_GT(m.count, 0);
        return m.normal;
    };
    const Vec3 n = normalized(Vec3{1, 2, 2});
    EXPECT_GT(dot(normal(Sphere{1}, {}, Sphere{1}, n * 1.5), n), 1 - 1e-12);
    EXPECT_EQ(normal(Box{}, {}, Box{}, {0, 0.99, 0}), (Vec3{0, 1, 0}));
    EXPECT_EQ(normal(Box{}, {0, 0.45, 0}, Plane{}, {}), (Vec3{0, -1, 0}));
    EXPECT_GT(dot(normal(Capsule{0.3, 1}, {}, Capsule{0.3, 1}, {0.5, 0, 0}), {1, 0, 0}), 1 - 1e-12);
}

// A face on a face is held at its four corners.
TEST(Collide, resting_box_has_four_points) {
    PairCache cache;
    const Geometry box_geometry = Box{}, ground = Box{{5, 1, 5}};
    const Manifold m = collide(transformed_shape(box_geometry, {{0.3, 0.5, 0.2}, {}}),
                               transformed_shape(ground, {{0, -1, 0}, {}}), margin, cache);
    ASSERT_EQ(m.count, 4);
    for (int i = 0; i < 4; i++) {
        EXPECT_NEAR(m.gap[i], 0, 1e-12);
        EXPECT_NEAR(std::fabs(m.point[i].x - 0.3), 0.5, 1e-9);
        EXPECT_NEAR(std::fabs(m.point[i].z - 0.2), 0.5, 1e-9);
    }
}

TEST(Collide, lying_capsule_has_two_points) {
    PairCache cache;
    const Geometry lying = Capsule{0.25, 0.5}, ground = Plane{};
    const Quat along_x = from_rotation_vector({0, 0, pi / 2});
    const Manifold m = collide(transformed_shape(lying, {{0, 0.25, 0}, along_x}),
                               transformed_shape(ground, {}), margin, cache);
    ASSERT_EQ(m.count, 2);
    EXPECT_NEAR(std::fabs(m.point[0].x - m.point[1].x), 1, 1e-9);
}

// Within a step a body may be nowhere: it is put back when the step ends. Until then nothing is
// read that is not there (what the address sanitizer sees).
TEST(Collide, non_finite_shapes_do_not_overrun_arrays) {
    const double nowhere = std::numeric_limits<double>::quiet_NaN();
    for (const Geometry& a : {Geometry(Box{}), Geometry(Sphere{}), Geometry(Capsule{})})
        for (const Geometry& b : {Geometry(Box{}), Geometry(Cylinder{}), Geometry(Capsule{})})
            for (const Vec3 at : {Vec3{nowhere, 0, 0}, Vec3{nowhere, nowhere, nowhere}}) {
                PairCache cache;
                const Manifold m = collide(transformed_shape(a, {{}, {}}),
                                           transformed_shape(b, {at, {}}), margin, cache);
                EXPECT_LE(m.count, 4);
            }
}

}  // namespace
}  // namespace jostle::test
