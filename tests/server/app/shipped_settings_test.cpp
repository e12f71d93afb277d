// SPDX-License-Identifier: MIT
//
// The settings files that images, compose and Kubernetes start a server with: each loads, and says
// on purpose who can reach the server.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/config/config_loader.h"
#include "server/config/exposure.h"

namespace jostle::server {
namespace {

using testing::HasSubstr;

Config shipped(const std::string& file) {
    Config config;
    const Status loaded = load_config(config, JOSTLE_ROOT "/" + file);
    EXPECT_TRUE(loaded.ok()) << loaded.error().message;
    const Status checked = check(config);
    EXPECT_TRUE(checked.ok()) << file << ": " << checked.error().message;
    return config;
}

// Whoever publishes a port of the image has to decide first who may come in.
TEST(ShippedSettings, docker_image_config_rejects_unauthenticated_access) {
    const Status exposed = check_exposure(shipped("docker/jostle-server.toml"));
    ASSERT_FALSE(exposed.ok());
    EXPECT_THAT(exposed.error().message, HasSubstr("insecure"));
}

// Compose publishes on loopback, and the base of Kubernetes stands behind a gateway.
TEST(ShippedSettings, configs_behind_other_protection_set_insecure) {
    for (const char* file :
         {"docker/compose-server.toml", "deploy/kubernetes/base/jostle-server.toml"}) {
        const Config config = shipped(file);
        EXPECT_TRUE(config.insecure) << file;
        EXPECT_TRUE(check_exposure(config).ok()) << file;
    }
}

TEST(ShippedSettings, public_configs_have_tls_and_tokens) {
    const Config config = shipped("deploy/kubernetes/tls/jostle-server.toml");
    EXPECT_FALSE(config.insecure);
    const Status exposed = check_exposure(config);
    EXPECT_TRUE(exposed.ok()) << exposed.error().message;
}

}  // namespace
}  // namespace jostle::server
