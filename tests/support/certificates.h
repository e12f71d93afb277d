// SPDX-License-Identifier: MIT
//
// Certificates for tests: an authority, issued certificates and expired ones.
#pragma once

#include <openssl/bio.h>
#include <openssl/ec.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/rand.h>
#include <openssl/x509v3.h>

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

namespace jostle::test {

struct TestCertificate {
    std::shared_ptr<X509> x509;
    std::shared_ptr<EVP_PKEY> key;

    std::string pem() const {
        return written([&](BIO* out) { PEM_write_bio_X509(out, x509.get()); });
    }
    std::string key_pem() const {
        return written([&](BIO* out) {
            PEM_write_bio_PrivateKey(out, key.get(), nullptr, nullptr, 0, nullptr, nullptr);
        });
    }
    std::string key_pem_with_passphrase(std::string passphrase) const {
        return written([&](BIO* out) {
            PEM_write_bio_PrivateKey(out, key.get(), EVP_aes_256_cbc(),
                                     reinterpret_cast<unsigned char*>(passphrase.data()),
                                     static_cast<int>(passphrase.size()), nullptr, nullptr);
        });
    }

private:
    template <class Write>
    static std::string written(Write write) {
        const std::shared_ptr<BIO> out(BIO_new(BIO_s_mem()), BIO_free_all);
        write(out.get());
        char* data = nullptr;
        const long size = BIO_get_mem_data(out.get(), &data);
        return std::string(data, static_cast<std::size_t>(size));
    }
};

struct CertificateDef {
    // common name; server certificates are valid for localhost and 127.0.0.1
    std::string name = "localhost";
    bool authority = false;
    std::string usage = "serverAuth";  // clientAuth for client certificates
    std::int64_t begins_in_s = -3600, ends_in_s = 86400;
};

inline void add_extension(X509* certificate, X509* issuer, int kind, const std::string& value) {
    X509V3_CTX context;
    X509V3_set_ctx(&context, issuer, certificate, nullptr, nullptr, 0);
    const std::shared_ptr<X509_EXTENSION> extension(
        X509V3_EXT_conf_nid(nullptr, &context, kind, value.c_str()), X509_EXTENSION_free);
    if (!extension || X509_add_ext(certificate, extension.get(), -1) != 1)
        throw std::runtime_error("OpenSSL rejects the extension " + value);
}

// Signed by the issuer, or self-signed without one.
inline TestCertificate make_certificate(const CertificateDef& def,
                                        const TestCertificate* issuer = nullptr) {
    TestCertificate made{.x509 = {X509_new(), X509_free},
                         .key = {EVP_EC_gen("P-256"), EVP_PKEY_free}};
    X509* x = made.x509.get();
    if (!issuer) issuer = &made;
    std::uint32_t serial = 0;
    RAND_bytes(reinterpret_cast<unsigned char*>(&serial), sizeof serial);
    X509_set_version(x, X509_VERSION_3);
    ASN1_INTEGER_set_uint64(X509_get_serialNumber(x), serial);
    X509_gmtime_adj(X509_getm_notBefore(x), def.begins_in_s);
    X509_gmtime_adj(X509_getm_notAfter(x), def.ends_in_s);
    X509_set_pubkey(x, made.key.get());
    X509_NAME_add_entry_by_txt(X509_get_subject_name(x), "CN", MBSTRING_UTF8,
                               reinterpret_cast<const unsigned char*>(def.name.c_str()), -1, -1, 0);
    X509_set_issuer_name(x, X509_get_subject_name(issuer->x509.get()));
    X509* signer = issuer->x509.get();
    if (def.authority) {
        add_extension(x, signer, NID_basic_constraints, "critical,CA:TRUE");
        add_extension(x, signer, NID_key_usage, "critical,keyCertSign,cRLSign");
    } else {
        add_extension(x, signer, NID_basic_constraints, "critical,CA:FALSE");
        add_extension(x, signer, NID_ext_key_usage, def.usage);
        add_extension(x, signer, NID_subject_alt_name, "DNS:localhost,IP:127.0.0.1");
    }
    if (X509_sign(x, issuer->key.get(), EVP_sha256()) == 0)
        throw std::runtime_error("OpenSSL cannot sign the certificate");
    return made;
}

inline TestCertificate make_authority(const std::string& name = "Test authority") {
    return make_certificate({.name = name, .authority = true});
}

}  // namespace jostle::test
