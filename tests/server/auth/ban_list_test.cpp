// SPDX-License-Identifier: MIT
#include "server/auth/ban_list.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <thread>

#include "tests/support/error_of.h"
#include "tests/support/temp_folder.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::error_of;

const WallTime noon{1'790'000'000s};

Ban of_subject(std::string subject, WallTime expires = WallTime::max()) {
    return {.target = {std::move(subject), std::nullopt},
            .reason = "griefing",
            .by = "boss",
            .created = noon,
            .expires = expires};
}
Ban of_network(const char* network, WallTime expires = WallTime::max()) {
    return {.target = {{}, parse_network(network).value()},
            .reason = "",
            .by = "boss",
            .created = noon,
            .expires = expires};
}

TEST(BanList, finds_subjects_addresses_and_prefixes_until_they_expire) {
    const auto bans = *BanList::open("");
    EXPECT_FALSE(bans->is_persisted());
    for (const Ban& ban : {of_subject("eve", noon + 1h), of_network("192.0.2.0/24"),
                           of_network("198.51.100.7"), of_network("2001:db8::/48")})
        ASSERT_TRUE(bans->add(ban, noon).ok());
    const auto is_banned = [&](const char* subject, const char* address, WallTime now = noon) {
        return bans->find(subject, address, now).has_value();
    };
    EXPECT_TRUE(is_banned("eve", "203.0.113.1"));
    EXPECT_TRUE(is_banned("eve", "203.0.113.1", noon + 1h - 1s));
    EXPECT_FALSE(is_banned("eve", "203.0.113.1", noon + 1h));
    EXPECT_FALSE(is_banned("Eve", "203.0.113.1"));
    EXPECT_FALSE(is_banned("", "203.0.113.1"));
    EXPECT_TRUE(is_banned("", "192.0.2.255"));
    EXPECT_TRUE(is_banned("", "::ffff:192.0.2.255")) << "IPv4 mapped into IPv6";
    EXPECT_FALSE(is_banned("", "192.0.3.0"));
    EXPECT_TRUE(is_banned("", "198.51.100.7"));
    EXPECT_FALSE(is_banned("", "198.51.100.8"));
    EXPECT_TRUE(is_banned("", "2001:db8:0:ffff::1"));
    EXPECT_FALSE(is_banned("", "2001:db8:1::1"));
    EXPECT_FALSE(is_banned("", "not an address"));
    ASSERT_TRUE(bans->add(of_network("::/0"), noon).ok());
    EXPECT_TRUE(is_banned("", "2001:db8:1::1"));
    EXPECT_FALSE(is_banned("", "203.0.113.1")) << "a ban of IPv6 does not include IPv4";
}

TEST(BanList, replaces_lists_and_removes) {
    const auto bans = *BanList::open("");
    ASSERT_TRUE(bans->add(of_network("192.0.2.7"), noon).ok());
    ASSERT_TRUE(bans->add(of_subject("eve"), noon).ok());
    const std::uint64_t before = bans->revision();
    ASSERT_TRUE(bans->add(of_subject("eve", noon + 1h), noon).ok());
    EXPECT_GT(bans->revision(), before);
    ASSERT_EQ(bans->list(noon).size(), 2u);
    EXPECT_EQ(bans->list(noon)[0], of_subject("eve", noon + 1h));
    EXPECT_EQ(bans->list(noon + 1h).size(), 1u);
    EXPECT_EQ(error_of(bans->remove({"anna", {}}, noon)).message,
              "there is no ban of subject anna; ListBans lists them");
    EXPECT_TRUE(bans->remove({"eve", {}}, noon).ok());
    EXPECT_FALSE(bans->find("eve", "203.0.113.1", noon));
    EXPECT_EQ(refusal_text(of_subject("eve", noon)),
              "the subject of the token is banned until 2026-09-21T14:13:20.000Z: griefing");
    EXPECT_EQ(refusal_text(of_network("192.0.2.7")), "this network is banned");
}

TEST(BanList, rejects_invalid_bans) {
    const auto bans = *BanList::open("");
    Ban none, both = of_network("192.0.2.7"), reason = of_subject("eve"), lines = reason;
    both.target.subject = "eve";
    reason.reason = std::string(101, 'x');
    lines.reason = "a\nb";
    for (const Ban& ban : {none, both, reason, lines, of_subject("anonymous"),
                           of_subject(std::string(257, 'x')), of_subject("a\x1b")})
        EXPECT_EQ(error_of(bans->add(ban, noon)).code, ErrorCode::invalid_argument);
    EXPECT_TRUE(bans->list(noon).empty());
}

TEST(BanList, survives_a_restart) {
    const test::TempFolder folder;
    const std::string path = folder / "worlds.db.bans.json";
    const std::vector<Ban> all = {of_subject("\"eve\" J\xc3\xb8rn", noon + 1h), of_subject("max"),
                                  of_network("192.0.2.0/24"), of_network("2001:db8::/48")};
    {
        const auto bans = *BanList::open(path);
        EXPECT_TRUE(bans->is_persisted());
        for (const Ban& ban : all) ASSERT_TRUE(bans->add(ban, noon).ok());
    }
    struct stat s {};
    ASSERT_EQ(::stat(path.c_str(), &s), 0);
    EXPECT_EQ(s.st_mode & 0777, 0600u);
    const auto bans = *BanList::open(path);
    EXPECT_EQ(bans->list(noon), all);
    EXPECT_TRUE(bans->find("", "192.0.2.7", noon));
    EXPECT_TRUE(bans->find("max", "203.0.113.1", noon));
}

TEST(BanList, failed_write_changes_nothing) {
    const auto bans = *BanList::open("/no/such/folder/bans.json");
    const Error error = error_of(bans->add(of_subject("eve"), noon));
    EXPECT_EQ(error.code, ErrorCode::unavailable);
    EXPECT_NE(error.message.find("/no/such/folder/bans.json"), std::string::npos);
    EXPECT_FALSE(bans->find("eve", "203.0.113.1", noon));
}

TEST(BanList, damaged_file_is_an_error_and_is_not_changed) {
    const test::TempFolder folder;
    const std::string good = write_bans({of_subject("eve"), of_network("192.0.2.0/24")});
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        text.replace(text.find(from), from.size(), to);
        return text;
    };
    ASSERT_TRUE(read_bans(good).ok());
    for (const std::string& text :
         {std::string(), good.substr(0, good.size() / 2), good + "x",
          with("\"version\": 1", "\"version\": 2"), with("eve", ""), with("eve", "anonymous"),
          with("192.0.2.0/24", "192.0.2.7/24"), with("192.0.2.0/24", "here"),
          with("\"subject\"", "\"subjekt\""),
          with("\"created\": 1790000000", "\"created\": \"noon\""),
          with("\"created\": 1790000000", "\"created\": -1"),
          with("\"created\": 1790000000", "\"created\": 1790000000, \"expires\": 1e300"),
          write_bans({of_subject("eve"), of_subject("eve")}), std::string("[]"),
          std::string("{}")}) {
        const std::string path = folder.write("bans.json", text);
        const auto opened = BanList::open(path);
        ASSERT_FALSE(opened.ok()) << text;
        EXPECT_EQ(opened.error().code, ErrorCode::corrupt_data);
        EXPECT_NE(opened.error().message.find(path + " is damaged: "), std::string::npos);
        EXPECT_EQ(folder.read("bans.json"), text);
    }
    const auto named = read_bans(with("192.0.2.0/24", "here"));
    EXPECT_TRUE(named.error().message.starts_with("bans[1]: ")) << named.error().message;
}

TEST(BanList, supports_concurrent_changes_and_look_ups) {
    const auto bans = *BanList::open("");
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; t++)
        threads.emplace_back([&, t] {
            for (int i = 0; i < 50; i++) {
                const std::string subject = std::to_string(t) + "-" + std::to_string(i);
                EXPECT_TRUE(bans->add(of_subject(subject), noon).ok());
                EXPECT_TRUE(bans->find(subject, "192.0.2.7", noon));
            }
        });
    threads.clear();
    EXPECT_EQ(bans->list(noon).size(), 200u);
}

}  // namespace
}  // namespace jostle::server
