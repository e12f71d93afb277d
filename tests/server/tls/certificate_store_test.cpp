// SPDX-License-Identifier: MIT
#include "server/tls/certificate_store.h"

#include <gtest/gtest.h>

#include <thread>

#include "tests/support/certificates.h"
#include "tests/support/temp_folder.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::make_authority;
using test::make_certificate;
using test::TestCertificate;
using Change = CertificateStore::Change;
namespace fs = std::filesystem;

class CertificateStoreTest : public testing::Test {
protected:
    TestCertificate issue(const std::string& name) const {
        return make_certificate({.name = name}, &root);
    }
    void put(const TestCertificate& certificate) const { put(certificate, certificate); }
    void put(const TestCertificate& certificate, const TestCertificate& key) const {
        folder.write("key.pem", key.key_pem());
        folder.write("chain.pem", certificate.pem());
    }
    std::unique_ptr<CertificateStore> open(bool with_clients = false) const {
        TlsSettings files{.certificate = folder / "chain.pem", .key = folder / "key.pem"};
        if (with_clients) files.client_ca = folder / "client_ca.pem";
        return CertificateStore::open(files, now).value();
    }

    const test::TempFolder folder;
    const TestCertificate root = make_authority();
    std::chrono::system_clock::time_point now = std::chrono::system_clock::now();
};

TEST_F(CertificateStoreTest, loads_key_chain_and_client_authorities) {
    const TestCertificate leaf = issue("one");
    put(leaf);
    folder.write("client_ca.pem", root.pem());
    const auto store = open(true);
    EXPECT_EQ(store->material()->key_pem, leaf.key_pem());
    EXPECT_EQ(store->material()->chain_pem, leaf.pem());
    EXPECT_EQ(store->material()->client_ca_pem, root.pem());
    EXPECT_EQ(store->material()->subject, "CN=one");
    EXPECT_NEAR(std::chrono::duration<double>(store->expiry() - now).count(), 86400, 5);
    EXPECT_EQ(open()->material()->client_ca_pem, "");
}

TEST_F(CertificateStoreTest, requires_valid_files_at_startup) {
    put(issue("one"), issue("two"));
    const auto opened = CertificateStore::open(
        {.certificate = folder / "chain.pem", .key = folder / "key.pem"}, now);
    ASSERT_FALSE(opened.ok());
    EXPECT_NE(opened.error().message.find("the key does not match"), std::string::npos);
}

TEST_F(CertificateStoreTest, applies_a_new_pair_at_the_next_poll) {
    put(issue("one"));
    const auto store = open();
    const std::shared_ptr<const TlsMaterial> first = store->material();
    EXPECT_EQ(store->poll(now), Change::none);
    put(issue("two"));
    EXPECT_EQ(store->poll(now + 900ms), Change::none) << "the files are checked once per second";
    EXPECT_EQ(store->poll(now + 1s), Change::taken);
    EXPECT_EQ(store->material()->subject, "CN=two");
    EXPECT_EQ(first->subject, "CN=one") << "references to the old material must stay valid";
    put(issue("three"));
    EXPECT_EQ(store->reload(now + 1s), Change::taken) << "reload() must check at once";
    EXPECT_EQ(store->material()->subject, "CN=three");
}

TEST_F(CertificateStoreTest, rejects_an_invalid_pair_once_and_retains_the_old_one) {
    const TestCertificate one = issue("one");
    put(one);
    const auto store = open();
    put(issue("two"), one);
    EXPECT_EQ(store->poll(now += 1s), Change::refused);
    for (int i = 0; i < 120; ++i)
        EXPECT_EQ(store->poll(now += 1s), Change::none)
            << "the same error must not be reported again";
    EXPECT_EQ(store->reload(now), Change::refused) << "reload() must report the error";
    fs::remove(folder / "key.pem");
    EXPECT_EQ(store->poll(now += 1s), Change::refused);
    EXPECT_EQ(store->material()->subject, "CN=one");
    put(issue("three"));
    EXPECT_EQ(store->poll(now += 1s), Change::taken);
}

TEST_F(CertificateStoreTest, applies_a_certificate_when_it_becomes_valid) {
    put(issue("one"));
    const auto store = open();
    put(make_certificate({.name = "two", .begins_in_s = 3600, .ends_in_s = 90000}, &root));
    EXPECT_EQ(store->poll(now += 1s), Change::refused);
    EXPECT_EQ(store->poll(now += 59min), Change::none);
    EXPECT_EQ(store->poll(now += 2min), Change::taken);
    EXPECT_EQ(store->material()->subject, "CN=two");
}

TEST_F(CertificateStoreTest, polls_after_the_clock_is_set_back) {
    put(issue("one"));
    const auto store = open();
    EXPECT_EQ(store->poll(now), Change::none);
    put(issue("two"));
    EXPECT_EQ(store->poll(now - 30min), Change::taken);
}

// Kubernetes: the files of the server are links into "..data", which is itself a link that
// Kubernetes replaces.
TEST_F(CertificateStoreTest, detects_a_swapped_symlink) {
    const auto put_version = [&](const std::string& version, const TestCertificate& certificate) {
        fs::create_directory(folder / version);
        std::ofstream(folder / (version + "/chain.pem")) << certificate.pem();
        std::ofstream(folder / (version + "/key.pem")) << certificate.key_pem();
        fs::create_directory_symlink(version, folder / "..data_tmp");
        fs::rename(folder / "..data_tmp", folder / "..data");
    };
    put_version("..one", issue("one"));
    fs::create_symlink("..data/chain.pem", folder / "chain.pem");
    fs::create_symlink("..data/key.pem", folder / "key.pem");
    const auto store = open();
    put_version("..two", issue("two"));
    EXPECT_EQ(store->poll(now += 1s), Change::taken);
    EXPECT_EQ(store->material()->subject, "CN=two");
}

// Concurrent readers see only valid pairs over fifty rotations, ten of which are invalid.
TEST_F(CertificateStoreTest, retains_a_valid_pair_over_fifty_rotations) {
    TestCertificate last = issue("0");
    put(last);
    const auto store = open();
    std::atomic<bool> done = false;
    std::atomic<int> reads = 0, broken = 0;
    std::jthread reader([&] {
        const test::TempFolder own;
        while (!done) {
            // the certificate and key must belong together at any time
            const std::shared_ptr<const TlsMaterial> material = store->material();
            const std::string file = own.write("pair.pem", material->key_pem + material->chain_pem);
            if (!read_tls_material({.certificate = file, .key = file}, now).ok()) ++broken;
            ++reads;
        }
    });
    int refused = 0;
    for (int i = 1; i <= 50; ++i) {
        const TestCertificate next = issue(std::to_string(i));
        if (i % 5 != 0) {
            put(next);
            last = next;
        } else if (i % 10 == 0) {
            put(next, last);  // the key was not replaced
        } else {
            folder.write("chain.pem", next.pem().substr(0, 300));  // truncated
        }
        if (store->reload(now) == Change::refused) ++refused;
        EXPECT_EQ(store->material()->key_pem, last.key_pem()) << i;
        EXPECT_EQ(store->material()->chain_pem, last.pem()) << i;
    }
    done = true;
    reader.join();
    EXPECT_EQ(refused, 10);
    EXPECT_EQ(broken, 0);
    EXPECT_GT(reads, 10);
}

}  // namespace
}  // namespace jostle::server
