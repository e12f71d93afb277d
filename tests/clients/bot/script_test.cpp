// SPDX-License-Identifier: MIT
#include "clients/bot/script.h"

#include <gtest/gtest.h>

namespace jostle::bot {

TEST(Script, example_script_has_all_five_active_behaviours) {
    const auto script = load_script(SCRIPTS "/sandbox.bots");
    ASSERT_TRUE(script.ok()) << script.error().message;
    EXPECT_EQ(script->size(), 5u);
}

TEST(Script, assigns_bots_to_lines_by_weight) {
    const Script script = *parse_script("push weight=3\nidle # rests\n", "s");
    int pushing = 0;
    for (int i = 0; i < 1000; i++) pushing += line_for(script, i).behaviour == "push" ? 1 : 0;
    EXPECT_NEAR(pushing, 750, 5);
}

TEST(Script, errors_name_file_line_and_word) {
    const struct {
        const char *text, *message;
    } cases[] = {
        {"push\n\nfly", "s:3: unknown behaviour \"fly\""},
        {"push speed=3", "s:1: push: unknown key \"speed\""},
        {"push strength", "s:1: \"strength\" is not of the form key=value"},
        {"push strength=ten", "s:1: \"strength=ten\": the value must be a number"},
        {"push period=0", "s:1: period must be at least 0.05 s"},
        {"# nothing", "s: no behaviours"},
        {"push weight=0", "s: all weights are zero"},
    };
    for (const auto& c : cases) {
        const auto script = parse_script(c.text, "s");
        ASSERT_FALSE(script.ok()) << c.text;
        EXPECT_EQ(script.error().message.substr(0, std::string(c.message).size()), c.message);
    }
}

}  // namespace jostle::bot
