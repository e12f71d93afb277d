// SPDX-License-Identifier: MIT
#include "jostle/client/security.h"

#include <gtest/gtest.h>

#include "tests/support/error_of.h"
#include "tests/support/temp_folder.h"

namespace jostle::client {
namespace {

using test::error_of;

class SecurityTest : public testing::Test {
protected:
    std::string fault_of(const SecurityFiles& files, const std::string& target = "localhost:1") {
        std::string message = error_of(read_security(files, target)).message;
        const std::string place = folder / "";
        for (std::size_t at; (at = message.find(place)) != message.npos;)
            message.erase(at, place.size());
        return message;
    }

    const test::TempFolder folder;
    const std::string pem = "-----BEGIN CERTIFICATE-----\n";
};

TEST_F(SecurityTest, defaults_to_plaintext_without_credentials) {
    const auto read = read_security({}, "example.org:50051");
    ASSERT_TRUE(read.ok());
    EXPECT_FALSE(read->tls);
    EXPECT_EQ(read->token, "");
}

TEST_F(SecurityTest, enables_tls_when_a_ca_or_certificate_is_given) {
    const std::string file = folder.write("a.pem", pem);
    EXPECT_TRUE(read_security({.root_certificates = file}, "h:1")->tls);
    const auto own = read_security({.certificate = file, .key = file}, "h:1");
    ASSERT_TRUE(own.ok());
    EXPECT_TRUE(own->tls);
    EXPECT_EQ(own->certificate_pem, pem);
}

TEST_F(SecurityTest, trims_the_token_and_sends_it_only_over_tls_or_loopback) {
    const SecurityFiles files{.token = folder.write("token", "abc.def.ghi\n")};
    EXPECT_EQ(read_security(files, "localhost:50051")->token, "abc.def.ghi");
    EXPECT_EQ(read_security(files, "127.0.0.1:50051")->token, "abc.def.ghi");
    EXPECT_EQ(read_security({.tls = true, .token = files.token}, "example.org:1")->token,
              "abc.def.ghi");
    EXPECT_EQ(
        fault_of(files, "example.org:50051"),
        "a token requires TLS unless the server is on loopback; use --tls, or --ca FILE for a "
        "private CA");
    // Names that only look like loopback.
    EXPECT_NE(fault_of(files, "localhost.example.org:50051"), "");
    EXPECT_NE(fault_of(files, "127.example.org:50051"), "");
}

TEST_F(SecurityTest, errors_name_the_file) {
    EXPECT_EQ(fault_of({.root_certificates = folder / "none"}),
              "cannot read none: the file does not exist or is not readable");
    EXPECT_EQ(fault_of({.root_certificates = folder.write("text", "hello")}),
              "text is not a PEM file: it has no -----BEGIN ...----- line");
    EXPECT_EQ(fault_of({.token = folder.write("empty", "\n")}), "empty contains no token");
    EXPECT_EQ(fault_of({.root_certificates = folder.write("big", std::string(2'000'000, 'x'))}),
              "big is too large; at most 1 MiB is accepted");
    EXPECT_EQ(fault_of({.certificate = folder / "a"}), "--cert and --key must be given together");
}

}  // namespace
}  // namespace jostle::client
