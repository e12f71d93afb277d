// SPDX-License-Identifier: MIT
//
// Who simulates is told what it drives: springs, gears, feet on the ground. So a car or a character
// is in the picture where the server comes to have it, over a link of 100 ms there and back.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "jostle/client/predictor.h"
#include "jostle/scenes/catalog.h"
#include "server/world/module_channels.h"
#include "tests/server/session/session_harness.h"

namespace jostle::server {
namespace {

using physics::Vec3;
using test::SessionHarness;
using test::TestServer;

struct Driver {
    TestServer server;
    std::shared_ptr<WorldHost> world;
    SessionHarness session;
    client::Predictor predictor;
    EntityId own = 0;
    std::map<std::uint32_t, Vec3> truth;  // by tick
    struct RenderedPose {
        double position;  // in ticks
        Vec3 shown, interpolated;
    };
    std::vector<RenderedPose> pictures;
    std::set<std::uint32_t> held;  // ticks in which the controls become others
    std::size_t driven_bytes = 0;
    double kbit() const { return 8e-3 * static_cast<double>(driven_bytes); }

    Driver(const scenes::SceneDescription& scene, const char* name, bool told = true)
        : world(server.host(scene)),
          session(server,
                  {.channels =
                       told ? std::vector<std::string>{motion_kind} : std::vector<std::string>{}},
                  {.latency_ms = 50, .jitter_ms = 10, .seed = 7}) {
        session.tamper = [this](std::string& bytes) {
            v1::ServerMessage message;
            if (!message.ParseFromString(bytes)) return;
            if (message.has_welcome()) predictor.begin(message.welcome());
            if (message.snapshot().has_controlled_entity())
                driven_bytes += message.snapshot().controlled_entity().ByteSizeLong();
        };
        run(60);
        for (const auto& [id, entity] : session.conversation.view().entities())
            if (entity.name() == name) own = id;
        v1::Input possess;
        possess.mutable_possess()->set_entity(own);
        send(possess);
        predictor.follow(own);
        run(60);
    }
    void send(v1::Input input) {
        input.set_tick(session.conversation.input_clock().tick(now_us()));
        held.insert(input.tick());
        predictor.add_input(session.conversation.send(input), input);
    }
    void hold(double right, double ahead, std::uint32_t buttons = 0, double looks = 0) {
        v1::Input input;
        for (const double axis : {right, ahead, 0.0, looks})
            input.mutable_control()->add_axes(static_cast<int>(std::lround(1000 * axis)));
        input.mutable_control()->set_buttons(buttons);
        send(input);
    }
    std::int64_t now_us() const { return static_cast<std::int64_t>(client::to_us(server.now)); }
    void run(int ticks) {
        test::play(server, *world, {&session}, ticks, [this](int) { look(); });
    }
    void look() {
        const FramePtr frame = world->frame();
        if (own != 0)
            truth[frame->tick] =
                std::ranges::find(frame->entities, own, &EntityPose::id)->pose.position;
        predictor.on_results(session.conversation.take_results());
        predictor.on_frame(session.conversation.view());
        const auto poses = session.draw();
        const double position = session.conversation.input_clock().position(now_us());
        RenderedPose picture{.position = position};
        for (const client::SmoothPose& pose : poses)
            if (pose.entity == own) picture.interpolated = at(pose);
        bool drawn = false;
        for (const client::SmoothPose& pose : predictor.sample(position, now_us(), poses))
            if (pose.entity == own) picture.shown = at(pose), drawn = true;
        if (drawn) pictures.push_back(picture);
    }
    static Vec3 at(const client::SmoothPose& pose) {
        return {pose.pose.position[0], pose.pose.position[1], pose.pose.position[2]};
    }
    // mm, of the pictures from then on: from where the server came to have it.
    struct Off {
        double median = 0, worst = 0, interpolated = 0;
        double from_path = 0;  // worst, from where the server has it within a tick
    };
    // From the nearest of the points at which the server has it from a tick before to a tick after.
    double from_path(const RenderedPose& picture, std::uint32_t tick) const {
        double nearest = 1e9;
        for (std::uint32_t at = tick - 1; at <= tick + 1; at++) {
            if (!truth.contains(at) || !truth.contains(at + 1)) continue;
            const Vec3 from = truth.at(at), way = truth.at(at + 1) - from;
            const double along = dot(picture.shown - from, way) / std::max(dot(way, way), 1e-12);
            const Vec3 point = from + way * std::clamp(along, 0.0, 1.0);
            nearest = std::min(nearest, 1000 * length(picture.shown - point));
        }
        return nearest;
    }
    Off off(std::size_t first) const {
        std::vector<double> all;
        Off off;
        for (std::size_t k = first; k < pictures.size(); k++) {
            const auto tick = static_cast<std::uint32_t>(pictures[k].position);
            if (!truth.contains(tick + 1)) continue;
            if (held.contains(tick + 1)) continue;  // half of it was seen before the key
            const double t = pictures[k].position - tick;
            const Vec3 right = truth.at(tick) * (1 - t) + truth.at(tick + 1) * t;
            all.push_back(1000 * length(pictures[k].shown - right));
            off.from_path = std::max(off.from_path, from_path(pictures[k], tick));
            off.interpolated =
                std::max(off.interpolated, 1000 * length(pictures[k].interpolated - right));
        }
        std::ranges::sort(all);
        if (!all.empty()) off.median = all[all.size() / 2], off.worst = all.back();
        return off;
    }
    double top_speed() const {  // m/s
        double most = 0;
        for (auto now = truth.begin(); std::next(now) != truth.end(); ++now)
            most = std::max(most, 60 * length(std::next(now)->second - now->second));
        return most;
    }
    Vec3 place_of(const char* name) const {
        for (const auto& [id, entity] : session.conversation.view().entities())
            if (entity.name() == name) {
                const auto pose = session.conversation.view().pose_of(id);
                return {pose->position[0], pose->position[1], pose->position[2]};
            }
        return {};
    }
    // The furthest step between two pictures, mm, beyond what a speed explains.
    double step_mm(std::size_t first, double speed) const {
        double worst = 0;
        for (std::size_t k = first + 1; k < pictures.size(); k++)
            worst = std::max(worst, 1000 * (length(pictures[k].shown - pictures[k - 1].shown) -
                                            1.1 * speed / 60));
        return worst;
    }
};

void record(const char* what, double value) {
    testing::Test::RecordProperty(what, std::to_string(value));
}
Driver::Off recorded(const Driver::Off& off) {
    record("off_median_mm", off.median);
    record("off_worst_mm", off.worst);
    record("interpolated_mm", off.interpolated);
    record("off_path_mm", off.from_path);
    return off;
}

TEST(ToldDriven, predicted_car_matches_the_server_position) {
    Driver driver(*scenes::find_scene("race_track"), "car");
    const std::size_t first = driver.pictures.size();
    for (int k = 0; k < 6; k++) {
        driver.hold(k % 2 == 0 ? 0.4 : -0.5, k < 4 ? 1 : -1);
        driver.run(60);
    }
    const auto stats = driver.predictor.stats();
    const Driver::Off off = recorded(driver.off(first));
    record("kbit_a_second", driver.kbit() / 6);
    record("top_speed", driver.top_speed());
    EXPECT_GT(driver.top_speed(), 10);
    EXPECT_GT(off.interpolated, 1500) << "a fifth of a second ago";
    EXPECT_LT(off.median, 2);
    EXPECT_LT(off.worst, 20) << "steered and braked, over hilly land";
    EXPECT_GT(stats.control_updates, 80u);
    EXPECT_LE(stats.control_corrections, 2u);
    record("step_mm", driver.step_mm(first, driver.top_speed()));
    EXPECT_LT(driver.step_mm(first, driver.top_speed()), 20);
    EXPECT_LT(driver.kbit() / 6, 60) << "kbit/s";
}

// A yard with stairs, crates and a raft that slides and turns, for one who sweeps and one who is
// rigid.
scenes::SceneDescription yard(physics::BodyType type) {
    using namespace physics;
    scenes::SceneDescription scene{.name = "yard"};
    const auto add = [&](const char* name, BodyType of, Vec3 at, Geometry geometry) {
        scenes::SceneBody body{.name = name};
        body.body.type = of;
        body.body.pose.position = at;
        body.shapes.push_back({.geometry = geometry, .density = 100});
        scene.bodies.push_back(body);
    };
    add("floor", BodyType::static_body, {0, -0.5, 0}, Box{{60, 0.5, 60}});
    for (int k = 1; k < 6; k++)
        add("stair", BodyType::static_body, {0, 0.1 * k, -6.0 - 0.6 * k}, Box{{2, 0.1 * k, 0.3}});
    for (int k = 0; k < 6; k++)
        add(("crate " + std::to_string(k + 1)).c_str(), BodyType::dynamic, {-3.0 + k, 0.3, -3},
            Box{{0.3, 0.3, 0.3}});
    add("raft", BodyType::kinematic, {6, 0.1, 4.5}, Box{{2, 0.1, 2}});
    scene.bodies.back().body.linear_velocity = {0, 0, -1.5};
    scene.bodies.back().body.angular_velocity = {0, 0.4, 0};
    add("hero", type, {0.2, 0.91, 0}, Capsule{0.28, 0.6});
    if (type == BodyType::dynamic) scene.bodies.back().shapes[0].mass = 80;
    scenes::SceneModule walkers{.tag = "character", .settings = {}, .bodies = {}, .state = {}};
    walkers.bodies["hero"] = scene.bodies.size() - 1;
    scene.modules.push_back(walkers);
    return scene;
}

TEST(ToldDriven, predicts_character_movement_in_the_frame_of_the_input) {
    for (const auto type : {physics::BodyType::kinematic, physics::BodyType::dynamic}) {
        SCOPED_TRACE(static_cast<int>(type));
        Driver driver(yard(type), "hero");
        const std::size_t first = driver.pictures.size();
        // Among the crates, up the stairs, down again, and about.
        const Vec3 crate = driver.place_of("crate 4"), began = driver.truth.rbegin()->second;
        double furthest = 0;
        constexpr double ways[][2] = {{0, 1}, {0.1, 1}, {0, 1}, {-1, 0.2}, {0.3, -1}, {1, 1}};
        for (int k = 0; k < 6; k++) {
            driver.hold(ways[k][0], ways[k][1], k % 2);
            driver.run(45);
            furthest = std::max(furthest, began.z - driver.truth.rbegin()->second.z);
        }
        EXPECT_GT(furthest, 7) << "at the stairs, and up";
        EXPECT_GT(length(driver.place_of("crate 4") - crate), 0.2) << "which was in the way";
        const auto stats = driver.predictor.stats();
        const Driver::Off off = recorded(driver.off(first));
        record("control_corrections", static_cast<double>(stats.control_corrections));
        record("kbit_a_second", driver.kbit() / 4.5);
        EXPECT_GT(off.interpolated, 500);
        EXPECT_LT(off.median, 2);
        // A stair that is taken a tick too early or too late is 75 mm for a tick (4.5 m/s).
        EXPECT_LT(off.from_path, 50);
        EXPECT_LT(off.worst, 80);
        EXPECT_GT(stats.control_updates, 50u);
    }
}

TEST(ToldDriven, predicts_a_character_on_a_moving_platform) {
    Driver driver(yard(physics::BodyType::kinematic), "hero");
    driver.hold(1, 0, 1);  // onto the raft
    driver.run(75);
    driver.hold(0, 0);
    driver.run(30);
    const std::size_t first = driver.pictures.size();
    driver.run(120);
    const Driver::Off off = recorded(driver.off(first));
    EXPECT_GT(off.interpolated, 150);
    EXPECT_LT(off.median, 4);
    EXPECT_LT(off.worst, 8);
}

TEST(ToldDriven, prediction_converges_among_other_characters) {
    Driver driver(*scenes::find_scene("parkour"), "walker2");
    const std::size_t first = driver.pictures.size();
    for (int k = 0; k < 6; k++) {
        driver.hold(k % 2 == 0 ? 0.4 : -0.5, 1, k % 2);
        driver.run(30);
    }
    const Driver::Off off = recorded(driver.off(first));
    EXPECT_LT(off.median, 2);
    EXPECT_LT(off.worst, 400) << "it met another one, who gave way";
    EXPECT_LE(driver.predictor.stats().control_corrections, 2u);
}

TEST(ToldDriven, is_sent_only_to_predicting_clients) {
    Driver driver(*scenes::find_scene("race_track"), "car", false);
    driver.hold(0, 1);
    driver.run(60);
    EXPECT_EQ(driver.driven_bytes, 0u);
    EXPECT_EQ(driver.predictor.bodies(), 0u) << "a chassis without wheels is no car";
}

}  // namespace
}  // namespace jostle::server
