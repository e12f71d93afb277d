// SPDX-License-Identifier: MIT
#include "server/config/config_loader.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace jostle::server {
namespace {

std::string error_of(const std::string& text) {
    Config config;
    const auto loaded = load_config_text(config, text, "test.toml");
    return loaded.ok() ? "" : loaded.error().message;
}

TEST(ConfigLoader, file_overrides_only_the_keys_it_contains) {
    Config config;
    ASSERT_TRUE(load_config_text(config,
                                 "drain_timeout_seconds = 2.5\n"
                                 "scenes = [\"pile\", \"wall\"]\n"
                                 "[client]\nbodies_owned_max = 3\n",
                                 "test.toml")
                    .ok());
    EXPECT_EQ(config.drain_timeout_seconds, 2.5);
    EXPECT_EQ(config.scenes, (std::vector<std::string>{"pile", "wall"}));
    EXPECT_EQ(config.client.bodies_owned_max, 3);
    EXPECT_EQ(config.client.inputs_per_second, Config{}.client.inputs_per_second);
    EXPECT_TRUE(check(config).ok());
}

TEST(ConfigLoader, admin_port_is_empty_or_an_address) {
    EXPECT_EQ(error_of("admin = \"\"\n"), "");
    EXPECT_EQ(error_of("admin = \"0.0.0.0:9000\"\n"), "");
    const std::string wrong = error_of("admin = \"here\"\n");
    EXPECT_NE(wrong.find("admin: \"here\" is not HOST:PORT"), std::string::npos) << wrong;
}

TEST(ConfigLoader, errors_name_file_and_key) {
    const std::string unknown = error_of("[client]\nbodies_max = 3\n");
    EXPECT_NE(unknown.find("test.toml"), std::string::npos) << unknown;
    EXPECT_NE(unknown.find("bodies_max"), std::string::npos) << unknown;
    const std::string type = error_of("drain_timeout_seconds = \"soon\"\n");
    EXPECT_NE(type.find("drain_timeout_seconds"), std::string::npos) << type;
    EXPECT_FALSE(error_of("drain_timeout_seconds = \n").empty());
    Config config;
    EXPECT_FALSE(load_config(config, "/no/such/file.toml").ok());
}

TEST(ConfigLoader, suggests_the_nearest_setting_and_section) {
    EXPECT_NE(error_of("[tick]\ncatch_up_tick_max = 3\n")
                  .find("did you mean \"tick.catch_up_ticks_max\"?"),
              std::string::npos)
        << error_of("[tick]\ncatch_up_tick_max = 3\n");
    EXPECT_NE(
        error_of("[persistance]\n")
            .find("test.toml:1: unknown section [persistance]; did you mean \"persistence\"?"),
        std::string::npos)
        << error_of("[persistance]\n");
    EXPECT_NE(error_of("htpp = \"x\"\n").find("did you mean \"http\"?"), std::string::npos);
}

TEST(ConfigLoader, unreadable_files_return_an_error) {
    Config config;
    EXPECT_FALSE(load_config(config, "/no/such/file.toml").ok());
    EXPECT_FALSE(load_config(config, testing::TempDir()).ok()) << "a directory is not a file";
}

TEST(ConfigLoader, invalid_file_leaves_config_unchanged) {
    Config config;
    EXPECT_FALSE(load_config_text(config, "drain_timeout_seconds = 1\nnonsense = 2\n", "t").ok());
    EXPECT_EQ(config.drain_timeout_seconds, Config{}.drain_timeout_seconds);
}

TEST(Config, validation_errors_name_key_and_range) {
    Config config;
    config.client.inputs_per_batch_max = 0;
    const auto checked = check(config);
    ASSERT_FALSE(checked.ok());
    EXPECT_NE(checked.error().message.find("client.inputs_per_batch_max is 0"), std::string::npos);
    for (const char* address :
         {"nowhere", ":80", "host:", "host:65536", "host:-1", "1:2:3", "host:8x"}) {
        EXPECT_FALSE(parse_host_port(address).ok()) << address;
    }
    EXPECT_EQ(parse_host_port("[::1]:80")->host, "::1");
    EXPECT_EQ(parse_host_port("localhost:0")->port, 0);
}

// The example file documents the settings for operators and must contain the defaults. Loading it
// must restore the defaults.
TEST(Config, example_file_contains_the_defaults) {
    Config config;
    config.drain_timeout_seconds = 99;  // the file must restore it
    config.client.bodies_owned_max = 99;
    config.world.clients_max = 99;
    config.stream.client_timeout_seconds = 99;
    config.insecure = true;
    config.tls = {"a", "b", "c"};
    config.auth = {"a", "b", "c", "viewer", 99, "d"};
    config.quota = {99, 99, 99, 99, 99, 99, 999};
    const auto loaded = load_config(config, EXAMPLE_CONFIG);
    ASSERT_TRUE(loaded.ok()) << loaded.error().message;
    const Config expected;
    EXPECT_EQ(config.listen, expected.listen);
    EXPECT_EQ(config.http, expected.http);
    EXPECT_EQ(config.scenes, expected.scenes);
    EXPECT_EQ(config.drain_timeout_seconds, expected.drain_timeout_seconds);
    EXPECT_EQ(config.client.bodies_owned_max, expected.client.bodies_owned_max);
    EXPECT_EQ(config.client.messages_per_second, expected.client.messages_per_second);
    EXPECT_EQ(config.world.clients_max, expected.world.clients_max);
    EXPECT_EQ(config.tick.catch_up_ticks_max, expected.tick.catch_up_ticks_max);
    EXPECT_EQ(config.stream.client_timeout_seconds, expected.stream.client_timeout_seconds);
    EXPECT_EQ(config.stream.ack_window_max_ms, expected.stream.ack_window_max_ms);
    EXPECT_EQ(config.insecure, expected.insecure);
    EXPECT_EQ(config.tls, expected.tls);
    EXPECT_EQ(config.auth, expected.auth);
    EXPECT_EQ(config.quota, expected.quota);
}

}  // namespace
}  // namespace jostle::server
