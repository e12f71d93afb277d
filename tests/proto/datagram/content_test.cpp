// SPDX-License-Identifier: MIT
#include "jostle/datagram/content.h"

#include <gtest/gtest.h>

#include "tests/support/error_of.h"

namespace jostle::datagram {
namespace {

std::vector<std::string> encode_one(std::string_view message, std::uint32_t number = 1) {
    return encode_message(std::span(&message, 1), number);
}

}  // namespace

TEST(Content, path_challenges_and_responses_have_9_bytes) {
    const std::string question = encode(PathChallenge{0x1122334455667788}),
                      answer = encode(PathResponse{9});
    EXPECT_EQ(question.size(), 9u);
    EXPECT_EQ(std::get<PathChallenge>(*decode_content(question)).token, 0x1122334455667788u);
    EXPECT_EQ(std::get<PathResponse>(*decode_content(answer)).token, 9u);
}

TEST(Content, splits_messages_larger_than_1167_bytes) {
    const auto one = encode_one(std::string(message_bytes_max, 'x'));
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(one[0].size(), content_bytes_max);
    EXPECT_EQ(std::get<Message>(*decode_content(one[0])).bytes.size(), 1167u);
    const auto two = encode_one(std::string(message_bytes_max + 1, 'x'), 77);
    ASSERT_EQ(two.size(), 2u);
    const auto last = std::get<Fragment>(*decode_content(two[1]));
    EXPECT_EQ(last.message, 77u);
    EXPECT_EQ(last.index, 1);
    EXPECT_EQ(last.count, 2);
    EXPECT_EQ(last.bytes.size(), message_bytes_max + 1 - fragment_bytes);
}

TEST(Content, concatenates_pieces_before_fragmenting) {
    const std::string_view pieces[] = {"head ", "", "shared by all"};
    const auto contents = encode_message(pieces, 1);
    ASSERT_EQ(contents.size(), 1u);
    EXPECT_EQ(std::get<Message>(*decode_content(contents[0])).bytes, "head shared by all");
}

TEST(Content, rejects_messages_over_64_fragments) {
    EXPECT_EQ(encode_one(std::string(fragments_max * fragment_bytes, 'x')).size(), 64u);
    EXPECT_TRUE(encode_one(std::string(fragments_max * fragment_bytes + 1, 'x')).empty());
}

TEST(Content, rejects_malformed_content_with_a_reason) {
    const auto why = [](std::string content) {
        return test::error_of(decode_content(content)).message;
    };
    EXPECT_NE(why("").find("empty"), std::string::npos);
    EXPECT_NE(why("\x09xyz").find("kind 9"), std::string::npos);
    EXPECT_NE(why("\x03short").find("5 bytes"), std::string::npos);
    auto parts = encode_one(std::string(2000, 'x'));
    EXPECT_NE(why(parts[0].substr(0, 100)).find("93 bytes"), std::string::npos)
        << "every fragment but the last is full";
    EXPECT_NE(why(parts[1].substr(0, 7)).find("0 bytes"), std::string::npos);
    std::string past = parts[1];
    past[5] = 2;
    EXPECT_NE(why(past).find("fragment 2 of 2"), std::string::npos);
    past[6] = 65;
    EXPECT_NE(why(past).find("of 65"), std::string::npos);
}

}  // namespace jostle::datagram
