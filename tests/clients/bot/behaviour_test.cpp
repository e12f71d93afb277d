// SPDX-License-Identifier: MIT
//
// Driving bots without a server: a scene of the catalogue steps, sends snapshots to the bot and
// applies its inputs.
#include "clients/bot/behaviour.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "jostle/physics/module.h"
#include "jostle/scenes/catalog.h"

namespace jostle::bot {
namespace {

using namespace physics;

constexpr double dt = 1.0 / 60;

class Drive {
public:
    Drive(const char* scene, const std::string& script, std::uint32_t seed)
        : scene_(*scenes::find_scene(scene)),
          built_(std::move(*scenes::build_scene(scene_))),
          bot_(parse_script(script, "test")->front(), seed) {
        v1::Welcome welcome;
        welcome.mutable_quant()->set_units_per_meter(512);
        welcome.mutable_quant()->set_rotation_component(511);
        view_.begin(welcome);
        v1::EntityUpdate entity_update;
        for (std::uint32_t k = 0; k < built_.bodies.size(); k++) {
            v1::Entity& entity = *entity_update.add_added();
            entity.set_id(k + 1);
            entity.set_name(scene_.bodies[k].name);
            entity.set_controllable(module_of(k + 1) != nullptr);
        }
        EXPECT_TRUE(view_.apply(entity_update).ok());
    }

    void run(double seconds) {
        for (const double end = time_ + seconds; time_ < end; time_ += dt) {
            show();
            for (const v1::Input& input : bot_.act(time_, view_, 1)) obey(input);
            ASSERT_TRUE(built_.world.step(dt).ok());
        }
    }
    const Behaviour& bot() const { return bot_; }
    const std::string& driven() const { return scene_.bodies.at(driven_ - 1).name; }
    BodyState state() const { return *built_.world.body(built_.bodies.at(driven_ - 1)); }

private:
    Module* module_of(std::uint32_t entity) {
        for (const std::string& tag : built_.world.modules())
            if (Module* module = built_.world.module(tag);
                module->is_controllable(built_.bodies[entity - 1]))
                return module;
        return nullptr;
    }
    void show() {
        snapshot::QuantizedFrame frame{.frame = ++frame_};
        for (std::uint32_t k = 0; k < built_.bodies.size(); k++) {
            const Transform pose = built_.world.body(built_.bodies[k])->pose;
            const auto& [p, q] = pose;
            frame.entities.push_back(
                snapshot::quantize(k + 1, {{p.x, p.y, p.z}, {q.x, q.y, q.z, q.w}}, false, {}));
        }
        const auto packed = snapshot::encode_frame(frame, {}, {});
        v1::Snapshot snapshot;
        snapshot.set_frame(frame_);
        snapshot.set_packed(packed.data(), packed.size());
        snapshot.set_crc(snapshot::frame_crc(frame));
        ASSERT_TRUE(view_.apply(snapshot).ok());
    }
    void obey(const v1::Input& input) {
        if (input.has_possess()) driven_ = input.possess().entity();
        if (!input.has_control() || driven_ == 0) return;
        Controls controls;
        for (int k = 0; k < input.control().axes_size(); k++)
            controls.axes[static_cast<std::size_t>(k)] = input.control().axes(k) / 1000.0;
        controls.buttons = input.control().buttons();
        module_of(driven_)->control(built_.world, built_.bodies[driven_ - 1], controls);
    }

    scenes::SceneDescription scene_;
    scenes::BuiltScene built_;
    Behaviour bot_;
    client::WorldView view_;
    std::uint32_t frame_ = 0, driven_ = 0;
    double time_ = 0;
};

// The track is 37 to 53 m from the centre. A lap at 45 m and 16 m/s takes 17.7 s, the first one
// slightly more.
TEST(Behaviour, drives_two_laps_on_the_race_track) {
    Drive race("race_track", "race", 3);
    race.run(45);
    const std::vector<Lap>& laps = race.bot().laps();
    ASSERT_GE(laps.size(), 2u);
    EXPECT_NEAR(laps[0].seconds, 20, 2);
    EXPECT_NEAR(laps[1].seconds, 17.7, 1);
    for (const Lap& lap : laps) {
        EXPECT_GT(lap.nearest, 38);
        EXPECT_LT(lap.furthest, 52);
    }
    RecordProperty("first_lap_s", std::to_string(laps[0].seconds));
    RecordProperty("second_lap_s", std::to_string(laps[1].seconds));
}

TEST(Behaviour, drives_every_controllable_entity) {
    struct Case {
        const char *scene, *script;
    };
    for (const Case& c :
         {Case{"race_track", "drive"}, Case{"harbour", "drive"}, Case{"demolition", "drive"},
          Case{"hovercraft", "drive"}, Case{"parkour", "walk"}, Case{"ragdoll_stairs", "walk"}}) {
        Drive drive(c.scene, c.script, 1);
        drive.run(0.5);
        const Vec3 began = drive.state().center;
        double furthest = 0;
        for (int second = 0; second < 6; second++) {
            drive.run(1);
            furthest = std::max(furthest, length(drive.state().center - began));
        }
        EXPECT_GT(furthest, 2) << c.scene << ": " << drive.driven();
    }
}

TEST(LapCounter, counts_laps_in_both_directions) {
    for (const double way : {-1.0, 1.0}) {
        LapCounter counter;
        for (int k = 0; k <= 25; k++) {
            const double angle = way * 2 * pi * k / 10;
            counter.add_position(0.5 * k, 10 * std::cos(angle), 12 * std::sin(angle));
        }
        ASSERT_EQ(counter.laps().size(), 2u);
        EXPECT_NEAR(counter.laps()[1].seconds, 5, 1e-9);
        EXPECT_NEAR(counter.laps()[1].furthest, 12, 0.5);
        EXPECT_NEAR(counter.laps()[1].nearest, 10, 1e-9);
    }
}

}  // namespace
}  // namespace jostle::bot
