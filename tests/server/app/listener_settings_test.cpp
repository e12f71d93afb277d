// SPDX-License-Identifier: MIT
#include "server/app/listener_settings.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temp_folder.h"

namespace jostle::server {
namespace {

TEST(WebRoot, rejects_a_configured_folder_without_a_viewer) {
    const test::TempFolder folder;
    Config config;
    config.web_root = folder / "absent";
    const Status absent = check_web_root(config);
    ASSERT_FALSE(absent.ok());
    EXPECT_EQ(absent.error().message,
              "web_root: \"" + config.web_root +
                  "\" is not a directory; it must be a directory with the built viewer, such as "
                  "clients/web/dist");
    config.web_root = folder / "";
    const Status empty = check_web_root(config);
    ASSERT_FALSE(empty.ok());
    EXPECT_NE(empty.error().message.find("contains no index.html"), std::string::npos);
    std::ofstream(folder / "index.html") << "<title>viewer</title>";
    EXPECT_TRUE(check_web_root(config).ok());
}

TEST(WebRoot, accepts_the_default_without_a_viewer) {
    EXPECT_TRUE(check_web_root(Config{}).ok());
}

}  // namespace
}  // namespace jostle::server
