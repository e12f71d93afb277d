// SPDX-License-Identifier: MIT
#include "server/auth/key_set.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/support/error_of.h"
#include "tests/support/temp_folder.h"
#include "tests/support/tokens.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::Json;
using test::SigningKey;

std::string fault_of(const std::string& text) {
    const auto read = read_key_set(text);
    return read.ok() ? "" : read.error().message;
}

TEST(KeySet, skips_unsupported_keys_with_a_warning) {
    Json for_encryption = SigningKey().public_key("e"), of_p384 = SigningKey().public_key("p"),
         without_id = SigningKey().public_key(""), secret = SigningKey().public_key("s"),
         off_curve = SigningKey().public_key("o"), other_algorithm = SigningKey().public_key("a");
    for_encryption["use"] = "enc";
    of_p384["crv"] = "P-384";
    secret["d"] = "AAAA";
    off_curve["y"] = off_curve["x"];
    other_algorithm["alg"] = "ES384";
    const Json rsa = {{"kty", "RSA"}, {"kid", "r"}, {"n", "AQAB"}, {"e", "AQAB"}};
    const auto read = read_key_set(
        test::key_set(Json::array({rsa, SigningKey().public_key("good"), for_encryption, of_p384,
                                   without_id, secret, off_curve, other_algorithm, 7})));
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(read->keys.size(), 1u);
    EXPECT_TRUE(read->keys.contains("good"));
    ASSERT_EQ(read->warnings.size(), 8u);
    EXPECT_EQ(read->warnings[0], "key 1 is skipped: it is not an EC key on the curve P-256");
    EXPECT_EQ(read->warnings[4],
              "key 6 is skipped: it is a private key; only the issuer may hold it");
}

TEST(KeySet, rejects_malformed_key_sets) {
    EXPECT_EQ(fault_of("{"), "it cannot be parsed: it is not valid JSON");
    EXPECT_EQ(fault_of("[]"), "it is not a JSON object with an array \"keys\"");
    EXPECT_EQ(fault_of("{\"keys\": {}}"), "it is not a JSON object with an array \"keys\"");
    EXPECT_EQ(fault_of("{\"keys\": []}"), "it contains no EC key on P-256 with a kid");
    EXPECT_EQ(fault_of(test::key_set(Json(std::vector<int>(101)))),
              "it contains more than 100 keys");
    EXPECT_EQ(fault_of(test::key_set(
                  Json::array({SigningKey().public_key("a"), SigningKey().public_key("a")}))),
              "key 2 has the kid of an earlier key");
}

TEST(KeySet, requires_a_valid_file_at_startup) {
    const test::TempFolder folder;
    EXPECT_NE(KeySet::open(folder / "missing.json").error().message.find("missing.json"),
              std::string::npos);
    EXPECT_FALSE(KeySet::open(folder.write("broken.json", "{")).ok());
    EXPECT_FALSE(KeySet::open(folder.write("huge.json", std::string(1 << 20, ' '))).ok());
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_FALSE(KeySet::open(folder / "pipe").ok()) << "open() must not wait for a writer";
}

TEST(KeySet, applies_valid_files_and_ignores_broken_ones) {
    const test::TempFolder folder;
    const auto put = [&](const std::string& text) { folder.write("keys.json", text); };
    const auto set_of = [](const char* id) {
        return test::key_set(Json::array({SigningKey().public_key(id)}));
    };
    put(set_of("a"));
    const auto keys = KeySet::open(folder / "keys.json").value();
    const auto in_force = [&] { return keys->keys()->begin()->first; };
    Clock::time_point now{};
    EXPECT_TRUE(keys->poll(now));
    put(set_of("b"));
    EXPECT_TRUE(keys->poll(now + 900ms));
    EXPECT_EQ(in_force(), "a") << "the file is checked once per second";
    EXPECT_TRUE(keys->poll(now += 1s));
    EXPECT_EQ(in_force(), "b");
    put("{\"keys\": [");
    EXPECT_FALSE(keys->poll(now += 1s));
    EXPECT_TRUE(keys->poll(now += 1s)) << "the error is reported once";
    EXPECT_EQ(in_force(), "b");
    EXPECT_FALSE(keys->reload()) << "reload() reports the error again";
    std::filesystem::remove(folder / "keys.json");
    EXPECT_FALSE(keys->poll(now += 1s));
    EXPECT_EQ(in_force(), "b");
    put(set_of("c"));
    EXPECT_TRUE(keys->reload());
    EXPECT_EQ(in_force(), "c");
}

// Fifty rotations with a concurrent reader, which only ever sees complete key sets.
TEST(KeySet, retains_last_valid_key_set_over_fifty_rotations) {
    const test::TempFolder folder;
    folder.write("keys.json", test::key_set(Json::array({SigningKey().public_key("0")})));
    const auto keys = KeySet::open(folder / "keys.json").value();
    std::string expected = "0";
    int refused = 0;
    Clock::time_point now{};
    for (int i = 1; i <= 50; ++i) {
        const std::string id = std::to_string(i);
        std::string text = test::key_set(Json::array({SigningKey().public_key(id)}));
        if (i % 5 == 0) {
            text.resize(text.size() / 2);
        } else {
            expected = id;
        }
        folder.write("keys.json", text);
        if (!keys->poll(now += 1s)) ++refused;
        ASSERT_EQ(keys->keys()->size(), 1u);
        ASSERT_TRUE(keys->keys()->contains(expected)) << i;
    }
    EXPECT_EQ(refused, 10);
}

}  // namespace
}  // namespace jostle::server
