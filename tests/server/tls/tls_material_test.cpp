// SPDX-License-Identifier: MIT
#include "server/tls/tls_material.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/support/certificates.h"
#include "tests/support/temp_folder.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::make_authority;
using test::make_certificate;
using test::TestCertificate;

class TlsMaterialTest : public testing::Test {
protected:
    Result<TlsMaterial> read(const std::string& chain, const std::string& key,
                             const std::string& client_ca = {}) const {
        TlsSettings files{.certificate = folder.write("chain.pem", chain),
                          .key = folder.write("key.pem", key)};
        if (!client_ca.empty()) files.client_ca = folder.write("client_ca.pem", client_ca);
        return read_tls_material(files, now);
    }
    // The message without the folder; "" if the files are valid.
    std::string fault_of(const std::string& chain, const std::string& key,
                         const std::string& client_ca = {}) const {
        const Result<TlsMaterial> material = read(chain, key, client_ca);
        if (material.ok()) return "";
        std::string message = material.error().message;
        if (message.starts_with(folder / "")) message.erase(0, (folder / "").size());
        return message;
    }

    const test::TempFolder folder;
    const std::chrono::system_clock::time_point now = std::chrono::system_clock::now();
    const TestCertificate root = make_authority();
    const TestCertificate middle =
        make_certificate({.name = "Middle", .authority = true, .ends_in_s = 7200}, &root);
    const TestCertificate leaf = make_certificate({}, &middle);
};

TEST_F(TlsMaterialTest, returns_subject_and_expiry) {
    const Result<TlsMaterial> material =
        read(leaf.pem() + middle.pem(), leaf.key_pem(), root.pem());
    ASSERT_TRUE(material.ok()) << material.error().message;
    EXPECT_EQ(material->subject, "CN=localhost");
    EXPECT_NEAR(std::chrono::duration<double>(material->expires - now).count(), 7200, 5)
        << "the earliest expiry in the chain";
    EXPECT_EQ(material->chain_pem, leaf.pem() + middle.pem());
    EXPECT_EQ(material->client_ca_pem, root.pem());
    EXPECT_TRUE(material->warnings.empty());
}

TEST_F(TlsMaterialTest, accepts_partial_and_full_chains) {
    EXPECT_EQ(fault_of(leaf.pem(), leaf.key_pem()), "");
    EXPECT_EQ(fault_of(leaf.pem() + middle.pem() + root.pem(), leaf.key_pem()), "");
    const TestCertificate own = make_certificate({});
    EXPECT_EQ(fault_of(own.pem(), own.key_pem()), "")
        << "a self-signed certificate must be accepted";
    EXPECT_EQ(fault_of(leaf.key_pem() + leaf.pem(), leaf.key_pem() + leaf.pem()), "")
        << "other PEM blocks must be ignored";
}

TEST_F(TlsMaterialTest, rejects_a_mismatched_key) {
    EXPECT_EQ(fault_of(leaf.pem(), middle.key_pem()),
              "key.pem: the key does not match the certificate of CN=localhost in " +
                  folder / "chain.pem");
}

TEST_F(TlsMaterialTest, rejects_a_broken_chain) {
    const TestCertificate stranger = make_authority("Middle");
    EXPECT_EQ(
        fault_of(leaf.pem() + root.pem(), leaf.key_pem()),
        "chain.pem: the chain is broken: the certificate of CN=localhost was not issued by the "
        "next certificate");
    EXPECT_EQ(
        fault_of(leaf.pem() + stranger.pem(), leaf.key_pem()),
        "chain.pem: the chain is broken: the certificate of CN=localhost was not issued by the "
        "next certificate")
        << "a matching issuer name is not sufficient";
    const TestCertificate forged = make_certificate({.name = "evil"}, &leaf);
    EXPECT_EQ(fault_of(forged.pem() + leaf.pem(), forged.key_pem()),
              "chain.pem: the certificate of CN=localhost is not a CA certificate");
}

TEST_F(TlsMaterialTest, rejects_expired_and_not_yet_valid_certificates) {
    const TestCertificate old = make_certificate({.begins_in_s = -7200, .ends_in_s = -60}, &root),
                          early = make_certificate({.begins_in_s = 60}, &root),
                          old_middle = make_certificate(
                              {.name = "Old", .authority = true, .ends_in_s = -1}, &root),
                          under_old = make_certificate({}, &old_middle);
    EXPECT_EQ(fault_of(old.pem(), old.key_pem())
                  .find("chain.pem: the certificate of CN=localhost expired on 20"),
              0u);
    EXPECT_EQ(fault_of(early.pem(), early.key_pem())
                  .find("chain.pem: the certificate of CN=localhost is not valid before 20"),
              0u);
    EXPECT_EQ(fault_of(under_old.pem() + old_middle.pem(), under_old.key_pem())
                  .find("chain.pem: the certificate of CN=Old expired on 20"),
              0u);
}

TEST_F(TlsMaterialTest, accepts_a_certificate_without_expiry) {
    const TestCertificate endless = make_certificate({.ends_in_s = 250'000'000'000}, &root);
    const Result<TlsMaterial> material = read(endless.pem(), endless.key_pem());
    ASSERT_TRUE(material.ok()) << material.error().message;
    EXPECT_EQ(material->expires, WallTime::max()) << "the certificate expires in the year 9948";
}

TEST_F(TlsMaterialTest, files_that_are_none_are_named) {
    EXPECT_EQ(fault_of("", leaf.key_pem()),
              "chain.pem: the file contains no certificate in PEM format");
    EXPECT_EQ(fault_of(leaf.pem(), ""), "key.pem: the file contains no private key in PEM format");
    EXPECT_EQ(fault_of(leaf.pem(), leaf.pem()),
              "key.pem: the file contains no private key in PEM format");
    std::string damaged = leaf.pem();
    damaged[damaged.size() / 2] ^= 0x11;
    EXPECT_NE(fault_of(damaged, leaf.key_pem()), "");
    EXPECT_EQ(fault_of(leaf.pem() + middle.pem().substr(0, 200), leaf.key_pem()),
              "chain.pem: a certificate is damaged")
        << "the certificate is truncated";
    std::string many;
    for (int i = 0; i < 11; ++i) many += leaf.pem();
    EXPECT_EQ(fault_of(many, leaf.key_pem()),
              "chain.pem: the file contains more than 10 certificates");
    EXPECT_NE(fault_of(std::string(2 << 20, 'a'), leaf.key_pem()), "");
    EXPECT_NE(read_tls_material({.certificate = folder / "none", .key = folder / "none"}, now)
                  .error()
                  .message.find("cannot read " + (folder / "none")),
              std::string::npos);
}

TEST_F(TlsMaterialTest, rejects_encrypted_keys_without_prompting) {
    EXPECT_EQ(fault_of(leaf.pem(), leaf.key_pem_with_passphrase("secret")),
              "key.pem: the key has a passphrase; use a key without one");
}

TEST_F(TlsMaterialTest, rejects_client_and_weak_certificates) {
    const TestCertificate client = make_certificate({.name = "anna", .usage = "clientAuth"}, &root);
    EXPECT_EQ(fault_of(client.pem(), client.key_pem()),
              "chain.pem: the certificate of CN=anna is not a server certificate");
    TestCertificate weak{.x509 = {X509_dup(leaf.x509.get()), X509_free},
                         .key = {EVP_RSA_gen(1024), EVP_PKEY_free}};
    X509_set_pubkey(weak.x509.get(), weak.key.get());
    X509_sign(weak.x509.get(), middle.key.get(), EVP_sha256());
    EXPECT_EQ(fault_of(weak.pem(), weak.key_pem()),
              "chain.pem: OpenSSL rejects it: ee key too small");
}

TEST_F(TlsMaterialTest, validates_client_authorities) {
    EXPECT_EQ(fault_of(leaf.pem(), leaf.key_pem(), root.pem() + middle.pem()), "");
    EXPECT_EQ(fault_of(leaf.pem(), leaf.key_pem(), leaf.pem()),
              "client_ca.pem: the certificate of CN=localhost is not a CA certificate");
    const TestCertificate old =
        make_certificate({.name = "Old", .authority = true, .ends_in_s = -1});
    EXPECT_EQ(fault_of(leaf.pem(), leaf.key_pem(), root.pem() + old.pem())
                  .find("client_ca.pem: the certificate of CN=Old expired"),
              0u);
}

TEST_F(TlsMaterialTest, warns_about_a_world_readable_key) {
    const TlsSettings files{.certificate = folder.write("chain.pem", leaf.pem()),
                            .key = folder.write("key.pem", leaf.key_pem())};
    chmod(files.key.c_str(), 0640);
    EXPECT_TRUE(read_tls_material(files, now)->warnings.empty()) << "a group may read the key";
    chmod(files.key.c_str(), 0644);
    const Result<TlsMaterial> material = read_tls_material(files, now);
    ASSERT_TRUE(material.ok());
    ASSERT_EQ(material->warnings.size(), 1u);
    EXPECT_EQ(material->warnings[0],
              files.key + " is readable by all users; restrict it with chmod o=");
}

}  // namespace
}  // namespace jostle::server
