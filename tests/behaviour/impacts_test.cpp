// SPDX-License-Identifier: MIT
//
// Impacts whose outcome is known on paper: rows of balls, billiards, a box of elastic balls,
// apexes, and what bounces comes to rest. At several rates, since an impact knows nothing of steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/support/near.h"
#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

constexpr double radius = 0.1;
constexpr double rates[] = {30, 60, 120, 480};

struct RowBall {
    double at;         // m, of its centre
    double speed = 0;  // m/s
    double density = 1000;
};

// Balls without friction and without loss on a line, in empty space: their speeds 1.2 s later.
std::vector<double> speeds_of_row(const std::vector<RowBall>& row, double hz) {
    World world = make_world({.gravity = {}, .sleeping = false});
    const Vec3 line = normalized(Vec3{0.8, 0.1, 0.6});
    std::vector<BodyId> balls;
    for (const RowBall& ball : row)
        balls.push_back(add(world, {.geometry = Sphere{radius},
                                    .position = line * ball.at,
                                    .velocity = line * ball.speed,
                                    .friction = 0,
                                    .restitution = 1,
                                    .density = ball.density}));
    run(world, 1.2, hz);
    std::vector<double> speeds;
    for (const BodyId ball : balls) {
        const Vec3 v = velocity_of(world, ball);
        EXPECT_TRUE(near(v, line * dot(v, line), 1e-3)) << "it left the line";
        speeds.push_back(dot(v, line));
    }
    return speeds;
}

void expect_speeds(const std::vector<RowBall>& row, const std::vector<double>& expected,
                   double tolerance = 1e-3) {
    for (const double hz : rates) {
        const std::vector<double> found = speeds_of_row(row, hz);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t k = 0; k < found.size(); k++)
            EXPECT_NEAR(found[k], expected[k], tolerance) << "ball " << k << " at " << hz << " Hz";
    }
}

// --- Newton's cradle ---

TEST(Cradle, one_ball_in_yields_one_ball_out) {
    expect_speeds({{-0.5, 1}, {0}, {0.2}, {0.4}, {0.6}}, {0, 0, 0, 0, 1});
}

TEST(Cradle, two_balls_in_yield_two_balls_out) {
    expect_speeds({{-0.7, 1}, {-0.5, 1}, {0}, {0.2}, {0.4}}, {0, 0, 0, 1, 1});
}

TEST(Cradle, gaps_delay_the_impulse_without_loss) {
    expect_speeds({{-0.5, 1}, {0}, {0.203}, {0.41}, {0.63}}, {0, 0, 0, 0, 1});
}

// Two come from either side: each sends the one at the other end back.
TEST(Cradle, balls_from_both_sides_bounce_back) {
    expect_speeds({{-0.5, 1}, {0}, {0.2}, {0.4}, {0.9, -1}}, {-1, 0, 0, 0, 1});
}

// Each hands 2 m / (m + M) of its speed on to the next: 1 to 2, 2 to 4 kg.
TEST(Cradle, unequal_masses_match_pairwise_impacts) {
    const double first = 1.0 - 4.0 / 3, second = 2.0 / 3 * (1 - 4.0 / 3), last = 4.0 / 9;
    expect_speeds({{-0.5, 1, 1000}, {0, 0, 2000}, {0.2, 0, 4000}}, {first, second, last});
}

// On threads of a metre, two to a ball as in the toy: the first comes down from 8 degrees and
// strikes at the bottom. Its height is that of the other side afterwards, and the others hang
// still.
TEST(Cradle, last_suspended_ball_rises_as_high_as_the_first) {
    for (const double hz : {60.0, 120.0, 240.0}) {
        World world = make_world({.sleeping = false});
        const BodyId frame =
            add_static(world, {.geometry = Box{{1, 0.01, 1}}, .position = {0, 3, 0}});
        std::vector<BodyId> balls;
        const double angle = 8 * pi / 180;
        for (int k = 0; k < 5; k++) {
            const Vec3 hook{0.2 * k, 1, 0};
            const SinCos a = sin_cos(k == 0 ? angle : 0);
            const Vec3 place = hook + Vec3{-a.sin, -a.cos, 0};
            balls.push_back(add(
                world,
                {.geometry = Sphere{radius}, .position = place, .friction = 0, .restitution = 1}));
            for (const double side : {-0.5, 0.5}) {
                const Vec3 end = hook + Vec3{0, 0, side};
                const double thread = length(end - place);
                must(world.create_joint(
                    {.body_a = frame,
                     .body_b = balls.back(),
                     .frame_a = {end - Vec3{0, 3, 0}},
                     .kind = DistanceJoint{.min_length = 0, .max_length = thread}}));
            }
        }
        double highest = 0, others = 0;
        for (int step = 0; step < 0.95 * hz; step++) {
            must(world.step(1 / hz));
            highest = maximum(highest, position_of(world, balls[4]).y);
            for (int k = 0; k < 4; k++)
                if (step > 0.6 * hz) others = maximum(others, length(velocity_of(world, balls[k])));
        }
        const double rise = 1 - sin_cos(angle).cos;
        EXPECT_NEAR(highest / rise, 1, 0.1) << hz << " Hz";
        EXPECT_LT(others, 0.05) << hz << " Hz";
    }
}

// --- billiards ---

// The normal is that of the moment when they meet: 30 degrees off the way of the first.
TEST(Billiard, struck_ball_moves_along_the_line_of_centers) {
    const Vec3 along = normalized(Vec3{0.8, 0, 0.6}), aside{-along.z, 0, along.x};
    const Vec3 normal = along * square_root(0.75) + aside * 0.5;
    double worst = 0;
    for (const double hz : {30.0, 60.0, 120.0, 240.0})
        for (int phase = 0; phase < 8; phase++) {
            World world = make_world({.gravity = {}});
            const BuiltBody ball{.geometry = Sphere{radius}, .friction = 0, .restitution = 1};
            BuiltBody first = ball, second = ball;
            first.velocity = along * 5;
            first.position = along * (-2 + 5 * phase / (8 * hz));
            second.position = aside * radius;
            const BodyId a = add(world, first), b = add(world, second);
            run(world, 1, hz);
            const Vec3 of_b = normal * (5 * square_root(0.75));
            worst = maximum(worst, length(velocity_of(world, b) - of_b) / 5);
            worst = maximum(worst, length(velocity_of(world, a) - (along * 5 - of_b)) / 5);
        }
    RecordProperty("worst_relative_error", std::to_string(worst));
    EXPECT_LT(worst, 1e-3);
}

// Fifteen balls that touch, struck by a sixteenth: whoever goes where, nothing is lost, and no ball
// spins much, as nothing rubs. What is too slow to bounce is left to the
// contact solver, whose normals are those of the step. (With continuous = false it has all impacts:
// balls spin at up to 17 rad/s, and a sixth of the energy is gone at 60 Hz.)
TEST(Billiard, break_conserves_energy_and_momentum) {
    for (const double hz : rates) {
        World world = make_world({.gravity = {}, .sleeping = false});
        const BuiltBody ball{.geometry = Sphere{radius}, .friction = 0, .restitution = 1};
        std::vector<BodyId> balls;
        for (int row = 0; row < 5; row++)
            for (int k = 0; k <= row; k++) {
                BuiltBody p = ball;
                p.position = {0.2 * square_root(0.75) * row, 0, 0.2 * k - 0.1 * row};
                balls.push_back(add(world, p));
            }
        BuiltBody cue = ball;
        cue.position = {-0.7, 0, 0.01};
        cue.velocity = {6, 0, 0};
        balls.push_back(add(world, cue));
        const WorldSummary before = world.summary();
        run(world, 1, hz);
        const WorldSummary after = world.summary();
        EXPECT_NEAR(after.kinetic_energy / before.kinetic_energy, 1, 0.01) << hz << " Hz";
        EXPECT_TRUE(near(after.linear_momentum, before.linear_momentum,
                         1e-6 * length(before.linear_momentum)));
        for (const BodyId b : balls)
            EXPECT_TRUE(near(state_of(world, b).angular_velocity, {}, 0.1)) << hz << " Hz";
    }
}

// The largest difference between a ball's velocity and the mirror image of its partner's, m/s, 0.5
// s after a break at 6 m/s. The rack is turned by an angle; its balls are `gap` metres apart.
struct Break {
    double radius, gap, restitution, friction, gravity;
};
double asymmetry_of(const Break& setup, double angle, double hz) {
    const double r = setup.radius, pitch = 2 * r + setup.gap;
    World world = make_world({.gravity = {0, -setup.gravity, 0}, .sleeping = false});
    if (setup.gravity > 0) add_floor(world, setup.friction);
    const SinCos a = sin_cos(angle);
    const auto turned = [&](double x, double z) {
        return Vec3{a.cos * x - a.sin * z, setup.gravity > 0 ? r : 0, a.sin * x + a.cos * z};
    };
    BuiltBody ball{
        .geometry = Sphere{r}, .friction = setup.friction, .restitution = setup.restitution};
    std::vector<std::vector<BodyId>> rows(5);
    for (int row = 0; row < 5; row++)
        for (int k = 0; k <= row; k++) {
            ball.position = turned(pitch * square_root(0.75) * row, pitch * (k - 0.5 * row));
            rows[static_cast<std::size_t>(row)].push_back(add(world, ball));
        }
    ball.position = turned(-2 * r - 0.3, 0);
    ball.velocity = Vec3{a.cos, 0, a.sin} * 6;
    add(world, ball);
    const double energy = world.summary().kinetic_energy;
    run(world, 0.5, hz);
    EXPECT_LE(world.summary().kinetic_energy, energy * (1 + 1e-6));
    const auto local = [&](BodyId body) {
        const Vec3 v = velocity_of(world, body);
        return Vec3{a.cos * v.x + a.sin * v.z, v.y, a.cos * v.z - a.sin * v.x};
    };
    double worst = 0;
    for (const auto& row : rows)
        for (std::size_t k = 0; k < row.size(); k++) {
            const Vec3 v = local(row[k]), m = local(row[row.size() - 1 - k]);
            worst = maximum(worst, length(v - Vec3{m.x, m.y, -m.z}));
        }
    return worst;
}

// One impact after the other differed by 2.6 m/s from its mirror image.
TEST(Billiard, break_is_mirror_symmetric) {
    const double r = 0.0286;
    for (const Break& setup :
         {Break{0.1, 0, 1, 0, 0}, Break{0.1, 1e-6, 1, 0, 0}, Break{r, 0, 0.95, 0.1, 9.81},
          Break{r, 1e-6, 0.95, 0.1, 9.81}, Break{r, 0, 0.8, 0.1, 9.81}, Break{0.1, 0, 0.8, 0, 0}})
        for (const double angle : {0.0, 0.3, 1.0, 2.2, 4.0})
            for (const double hz : {60.0, 240.0})
                EXPECT_LT(asymmetry_of(setup, angle, hz), 1e-3)
                    << "radius " << setup.radius << ", gap " << setup.gap << ", restitution "
                    << setup.restitution << ", angle " << angle << ", " << hz << " Hz";
}

// --- energy ---

// A gas of balls in a box that takes nothing, for three seconds.
TEST(Impacts, elastic_balls_in_a_box_conserve_energy) {
    for (const double hz : rates) {
        World world = make_world({.sleeping = false});
        const auto wall = [&](Vec3 at, Vec3 half) {
            add_static(world,
                       {.geometry = Box{half}, .position = at, .friction = 0, .restitution = 1});
        };
        wall({0, -0.5, 0}, {2, 0.5, 2});
        wall({0, 2.5, 0}, {2, 0.5, 2});
        for (const double side : {-1.0, 1.0}) {
            wall({1.5 * side, 1, 0}, {0.5, 1, 2});
            wall({0, 1, 1.5 * side}, {2, 1, 0.5});
        }
        Random random(5);
        for (int k = 0; k < 27; k++)
            add(world, {.geometry = Sphere{radius},
                        .position =
                            Vec3{k % 3 - 1.0, k / 3 % 3 + 0.5, k / 9 - 1.0} * 0.6 + Vec3{0, 0.2, 0},
                        .velocity = random.vector(3),
                        .friction = 0,
                        .restitution = 1});
        const WorldSummary before = world.summary();
        const double start = before.kinetic_energy + before.potential_energy;
        run(world, 3, hz);
        const WorldSummary after = world.summary();
        EXPECT_NEAR((after.kinetic_energy + after.potential_energy) / start, 1, 0.02)
            << hz << " Hz";
    }
}

// --- apexes ---

TEST(Impacts, bounce_height_decays_by_e_squared_at_every_step_rate) {
    double worst = 0;
    for (const double hz : rates)
        for (int phase = 0; phase < 4; phase++) {
            World world = make_world();
            add_floor(world, 0, 0.8);
            const double height = 1 + 0.013 * phase;
            const BodyId ball = add(world, {.geometry = Sphere{radius},
                                            .position = {0, radius + height, 0},
                                            .friction = 0,
                                            .restitution = 0.8});
            double expected = height;
            int apexes = 0;
            Vec3 last;
            for (int step = 0; step < 10 * hz && apexes < 5; step++) {
                must(world.step(1 / hz));
                const BodyState s = state_of(world, ball);
                // Higher than it goes by what is left of its speed, whatever the phase of the step.
                if (last.y > 0 && s.linear_velocity.y <= 0) {
                    apexes++;
                    expected *= 0.64;
                    const double apex = s.center.y - radius +
                                        s.linear_velocity.y * s.linear_velocity.y / (2 * 9.81);
                    worst = maximum(worst, absolute(apex / expected - 1));
                }
                last = s.linear_velocity;
            }
            EXPECT_EQ(apexes, 5) << hz << " Hz";
        }
    RecordProperty("worst_relative_error", std::to_string(worst));
    EXPECT_LT(worst, 0.01);
}

// --- momentum ---

// Balls that rub and bounce fly into each other in empty space. Impulses come in pairs at one
// point.
TEST(Impacts, colliding_balls_conserve_angular_momentum) {
    for (const double hz : rates) {
        World world = make_world({.gravity = {}, .sleeping = false});
        Random random(9);
        double sizes = 0;
        for (int k = 0; k < 27; k++) {
            const Vec3 place{k % 3 - 1.0, k / 3 % 3 - 1.0, k / 9 - 1.0};
            const BodyId ball = add(world, {.geometry = Sphere{random.in(0.1, 0.2)},
                                            .position = place + random.vector(0.1),
                                            .velocity = place * -2 + random.vector(0.5),
                                            .spin = random.vector(3),
                                            .friction = 0.5,
                                            .restitution = 0.5});
            const BodyState s = state_of(world, ball);
            sizes += length(cross(s.center, s.linear_velocity * s.mass) +
                            s.inertia * s.angular_velocity);
        }
        const Vec3 before = world.summary().angular_momentum;
        run(world, 2, hz);
        EXPECT_LT(length(world.summary().angular_momentum - before) / sizes, 1e-3) << hz << " Hz";
    }
}

// --- rest ---

// What bounces comes to rest all the same, and sleeps: a stack that is dropped, and a heap.
TEST(Impacts, bouncy_boxes_settle_and_sleep) {
    World world = make_world();
    add_floor(world, 0.5, 0.5);
    std::vector<BodyId> boxes;
    for (int k = 0; k < 5; k++)
        boxes.push_back(add(world, {.position = {0, 0.6 + 1.1 * k, 0}, .restitution = 0.5}));
    Random random(2);
    for (int k = 0; k < 20; k++)
        boxes.push_back(
            add(world, {.geometry = Box{{0.3, 0.2, 0.25}},
                        .position = {6 + random.in(-0.5, 0.5), 1 + 0.6 * k, random.in(-0.5, 0.5)},
                        .rotation = random.rotation(),
                        .restitution = 0.6}));
    run(world, 15);
    for (const BodyId box : boxes) EXPECT_FALSE(state_of(world, box).awake);
    for (int k = 0; k < 5; k++)
        EXPECT_TRUE(
            near(position_of(world, boxes[static_cast<std::size_t>(k)]), {0, 0.5 + k, 0}, 0.02));
}

// Nine columns of ten boxes fall on the floor, from gaps of 5 cm. One impact after the other, 117
// at more than 1 m/s in the worst step, they slept after 2.0 s; as crowds they have 36 and sleep
// after 1.2.
TEST(Impacts, columns_of_bouncy_boxes_come_to_rest_upright) {
    World world = make_world();
    add_floor(world, 0.5, 0.8);
    std::vector<BodyId> boxes;
    for (int column = 0; column < 9; column++)
        for (int k = 0; k < 10; k++)
            boxes.push_back(
                add(world, {.position = {3.0 * (column % 3), 0.6 + 1.05 * k, 3.0 * (column / 3)},
                            .restitution = 0.8}));
    std::size_t most = 0;  // impacts in a step
    for (int step = 0; step < 90; step++) {
        must(world.step(1.0 / 60));
        most = std::max(most, world.events().hits.size());
    }
    EXPECT_LE(most, boxes.size() / 2);
    for (std::size_t k = 0; k < boxes.size(); k++) {
        EXPECT_FALSE(state_of(world, boxes[k]).awake) << k;
        EXPECT_NEAR(position_of(world, boxes[k]).y, 0.5 + static_cast<double>(k % 10), 0.02) << k;
    }
}

}  // namespace
}  // namespace jostle::test
