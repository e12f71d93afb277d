// SPDX-License-Identifier: MIT
//
// SettingsReader checks the ranges of settings, and its errors name the setting.
#include "jostle/modules/settings.h"

#include <gtest/gtest.h>

namespace jostle::modules {
namespace {

using physics::BodyId;
using physics::ModuleSettings;
using physics::Status;

struct Craft {
    double height = 1.2, speed = 8;
    bool lights = false;
    BodyId hull;

    Status configure(const ModuleSettings& given) {
        SettingsReader settings(given);
        settings.number("height", height, 0.3, 3);
        settings.number("speed", speed, 0, 20);
        settings.flag("lights", lights);
        settings.body("hull", hull);
        return settings.finish();
    }
    std::string error_of(const ModuleSettings& given) {
        const Status status = configure(given);
        return status.ok() ? "" : status.error().message;
    }
};

TEST(Settings, reads_given_settings_and_keeps_defaults) {
    Craft craft;
    ASSERT_TRUE(craft
                    .configure({.numbers = {{"height", 2.5}, {"lights", 1}},
                                .bodies = {{"hull", BodyId{7, 1}}}})
                    .ok());
    EXPECT_EQ(craft.height, 2.5);
    EXPECT_EQ(craft.speed, 8);
    EXPECT_TRUE(craft.lights);
    EXPECT_EQ(craft.hull, (BodyId{7, 1}));
}

TEST(Settings, errors_name_the_setting_and_its_accepted_range) {
    Craft craft;
    EXPECT_EQ(craft.error_of({.numbers = {{"height", 4}}}),
              "height is 4; it must be from 0.3 to 3");
    EXPECT_EQ(craft.error_of({.numbers = {{"lights", 0.5}}}), "lights is 0.5; it must be 0 or 1");
    EXPECT_EQ(craft.error_of({.numbers = {{"hieght", 1}}}),
              "unknown setting hieght; must be one of: height, speed, lights; did you mean "
              "\"height\"?");
    EXPECT_EQ(craft.error_of({.numbers = {{"mass", 1}}}),
              "unknown setting mass; must be one of: height, speed, lights");
    EXPECT_EQ(craft.error_of({.bodies = {{"craft", BodyId{7, 1}}}}),
              "unknown body setting craft; must be one of: hull");
    EXPECT_EQ(craft.error_of({.numbers = {{"speed", 21}, {"height", 9}}}),
              "height is 9; it must be from 0.3 to 3")
        << "reports one error, in the order in which the module reads";
}

}  // namespace
}  // namespace jostle::modules
