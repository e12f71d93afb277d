// SPDX-License-Identifier: MIT
#include "server/forwarding/forwarded_headers.h"

#include <gtest/gtest.h>

#include <string>

namespace jostle::server {
namespace {

// "a, b, -": "-" is an entry without an address.
std::string text_of(const ForwardedAddresses& addresses) {
    std::string text;
    for (const auto& address : addresses)
        text += (text.empty() ? "" : " ") + (address ? address_text(*address) : std::string("-"));
    return text;
}

TEST(XForwardedFor, lists_addresses_with_and_without_ports) {
    EXPECT_EQ(text_of(parse_x_forwarded_for("192.0.2.7")), "192.0.2.7");
    EXPECT_EQ(text_of(parse_x_forwarded_for("192.0.2.7, 2001:DB8::1,\t10.0.0.1 ")),
              "192.0.2.7 2001:db8::1 10.0.0.1");
    EXPECT_EQ(text_of(parse_x_forwarded_for("192.0.2.7:4711,[2001:db8::1]:80,[::1]")),
              "192.0.2.7 2001:db8::1 ::1");
    EXPECT_EQ(text_of(parse_x_forwarded_for("::ffff:192.0.2.7")), "192.0.2.7");
    EXPECT_EQ(text_of(parse_x_forwarded_for("")), "");
    EXPECT_EQ(text_of(parse_x_forwarded_for(" ,, ")), "");
}

TEST(XForwardedFor, entries_that_are_no_address_stay_as_empty_entries) {
    EXPECT_EQ(text_of(parse_x_forwarded_for("unknown, 192.0.2, 192.0.2.7:, 192.0.2.7:123456, "
                                            "[192.0.2.7], [::1, a b, 1.2.3.4")),
              "- - - - - - - 1.2.3.4");
}

TEST(Forwarded, reads_the_examples_of_rfc_7239) {
    for (const auto& [value, expected] :
         {std::pair("for=\"_gazonk\"", "-"),
          std::pair("For=\"[2001:db8:cafe::17]:4711\"", "2001:db8:cafe::17"),
          std::pair("for=192.0.2.60;proto=http;by=203.0.113.43", "192.0.2.60"),
          std::pair("for=192.0.2.43, for=198.51.100.17", "192.0.2.43 198.51.100.17"),
          std::pair("for=_hidden, for=_SEVKISEK", "- -"), std::pair("for=unknown", "-"),
          std::pair("for=192.0.2.43,for=\"[2001:db8:cafe::17]\",for=unknown",
                    "192.0.2.43 2001:db8:cafe::17 -"),
          std::pair("for=\"192.0.2.43:47011\"", "192.0.2.43"),
          std::pair("for=\"192.0.2.43:_port\"", "192.0.2.43")}) {
        const auto parsed = parse_forwarded(value);
        ASSERT_TRUE(parsed) << value;
        EXPECT_EQ(text_of(*parsed), expected) << value;
    }
}

TEST(Forwarded, quoted_strings_hide_commas_and_semicolons) {
    EXPECT_EQ(text_of(*parse_forwarded("by=\"a,for=6.6.6.6;for=\\\"7.7.7.7\\\"\";for=192.0.2.7")),
              "192.0.2.7");
    EXPECT_EQ(text_of(*parse_forwarded("proto=https, for=192.0.2.7;;, ,")), "- 192.0.2.7");
    EXPECT_EQ(text_of(*parse_forwarded("for=\"19\\2.0.2.7\"")), "192.0.2.7");
    // IPv6 needs brackets.
    EXPECT_EQ(text_of(*parse_forwarded("for=\"2001:db8::1\"")), "-");
}

TEST(Forwarded, rejects_headers_whose_entries_have_no_certain_end) {
    for (const char* value :
         {"for", "for=", "=192.0.2.7", "for=\"192.0.2.7", "for=\"a\\", "for=192.0.2.7 x",
          "for=192.0.2.7;for=192.0.2.8", "for=[2001:db8::1]", "for = 192.0.2.7", "\"for\"=a",
          "for=192.0.2.7;proto=http for=1.2.3.4"})
        EXPECT_FALSE(parse_forwarded(value)) << value;
    EXPECT_TRUE(parse_forwarded("")->empty());
}

}  // namespace
}  // namespace jostle::server
