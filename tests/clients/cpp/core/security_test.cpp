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
    EXPECT_EQ(fault_of(files, "example.org:50051"),
              "without TLS everybody on the way could read the token; give --tls, or --ca FILE for "
              "an authority of your own");
    // Names that only look like this machine.
    EXPECT_NE(fault_of(files, "localhost.example.org:50051"), "");
    EXPECT_NE(fault_of(files, "127.example.org:50051"), "");
}

TEST_F(SecurityTest, errors_name_the_file) {
    EXPECT_EQ(fault_of({.root_certificates = folder / "none"}),
              "cannot read none: it is not there, or not yours to read");
    EXPECT_EQ(fault_of({.root_certificates = folder.write("text", "hello")}),
              "text is no PEM file: it has no line -----BEGIN ...-----");
    EXPECT_EQ(fault_of({.token = folder.write("empty", "\n")}), "empty holds no token");
    EXPECT_EQ(fault_of({.root_certificates = folder.write("big", std::string(2'000'000, 'x'))}),
              "big has more than 1 MiB");
    EXPECT_EQ(fault_of({.certificate = folder / "a"}),
              "--cert and --key go together: the certificate and its private key");
}

}  // namespace
}  // namespace jostle::client
