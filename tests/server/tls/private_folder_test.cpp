// SPDX-License-Identifier: MIT
#include "tls/private_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

namespace jostle::server {
namespace {

struct stat status_of(const std::string& path) {
    struct stat s {};
    EXPECT_EQ(stat(path.c_str(), &s), 0) << path;
    return s;
}

TEST(PrivateFolder, is_closed_to_others_and_gone_at_the_end) {
    std::string path;
    {
        const auto folder = PrivateFolder::make().value();
        path = folder->path();
        EXPECT_EQ(status_of(path).st_mode & 0777u, 0700u);
        ASSERT_TRUE(folder->write("a.pem", "one").ok());
        EXPECT_EQ(status_of(path + "/a.pem").st_mode & 0777u, 0600u);
        EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path), {}), 1)
            << "nothing is left aside";
    }
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(PrivateFolder, each_write_has_a_second_of_its_own) {
    const auto folder = PrivateFolder::make().value();
    std::set<std::time_t> times;
    for (int i = 0; i < 20; ++i) {
        ASSERT_TRUE(folder->write("a.pem", std::to_string(i)).ok());
        times.insert(status_of(folder->path() + "/a.pem").st_mtim.tv_sec);
    }
    EXPECT_EQ(times.size(), 20u);
    std::ifstream in(folder->path() + "/a.pem");
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "19");
}

}  // namespace
}  // namespace jostle::server
