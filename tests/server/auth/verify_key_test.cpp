// SPDX-License-Identifier: MIT
#include "server/auth/verify_key.h"

#include <gtest/gtest.h>

#include "jostle/base/base64.h"
#include "tests/support/tokens.h"

namespace jostle::server {
namespace {

std::string bytes_of(const char* base64url) {
    return decode_base64<std::string>(base64url, Base64::url).value();
}

// The key, text and signature of RFC 7515, appendix A.3.
TEST(VerifyKey, verifies_the_rfc_test_vector) {
    const auto key = VerifyKey::from_point(bytes_of("f83OJ3D2xF1Bg8vub9tLe1gHMzV76e8Tus9uPHvRVEU"),
                                           bytes_of("x_FEzRu9m36HLN_tue659LNpXW6pCyStikYjKIWI5a0"));
    ASSERT_TRUE(key);
    const std::string text =
        "eyJhbGciOiJFUzI1NiJ9.eyJpc3MiOiJqb2UiLA0KICJleHAiOjEzMDA4MTkzODAsDQogImh0dHA6Ly9leGFt"
        "cGxlLmNvbS9pc19yb290Ijp0cnVlfQ";
    std::string signature = bytes_of(
        "DtEhU3ljbEg8L38VWAfUAqOyKAM6-Xx-F4GawxaepmXFCgfTjDxw5djxLa8ISlSApmWQxfKTUJqPP3-Kg6NU1Q");
    EXPECT_TRUE(key->verifies(text, signature));
    EXPECT_FALSE(key->verifies(text + " ", signature));
    signature[40] ^= 1;
    EXPECT_FALSE(key->verifies(text, signature));
    EXPECT_FALSE(key->verifies(text, signature.substr(1)));
    EXPECT_FALSE(key->verifies(text, ""));
}

TEST(VerifyKey, rejects_points_off_the_curve) {
    const test::Json point = test::SigningKey().public_key("k");
    const std::string x = bytes_of(point["x"].get<std::string>().c_str()),
                      y = bytes_of(point["y"].get<std::string>().c_str());
    EXPECT_TRUE(VerifyKey::from_point(x, y));
    EXPECT_FALSE(VerifyKey::from_point(y, x));
    EXPECT_FALSE(VerifyKey::from_point(std::string(32, '\0'), std::string(32, '\0')));
    EXPECT_FALSE(VerifyKey::from_point(std::string(32, '\xff'), y));
    EXPECT_FALSE(VerifyKey::from_point(x.substr(1), y));
    EXPECT_FALSE(VerifyKey::from_point("", ""));
}

}  // namespace
}  // namespace jostle::server
