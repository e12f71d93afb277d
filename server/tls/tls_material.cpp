// SPDX-License-Identifier: MIT
#include "server/tls/tls_material.h"

#include <openssl/bio.h>
#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/ssl.h>
#include <openssl/x509v3.h>

#include <algorithm>
#include <ctime>
#include <memory>

#include "server/util/free_with.h"
#include "server/util/watched_file.h"

namespace jostle::server {

namespace {

constexpr std::size_t file_bytes_max = 1 << 20;
constexpr std::size_t chain_max = 10;
constexpr std::size_t client_cas_max = 100;

using Bio = std::unique_ptr<BIO, FreeWith<BIO_free_all>>;
using Key = std::unique_ptr<EVP_PKEY, FreeWith<EVP_PKEY_free>>;
using Certificate = std::unique_ptr<X509, FreeWith<X509_free>>;
using Chain = std::vector<Certificate>;

// OpenSSL has an error queue per thread that other code reads.
struct FaultCleaner {
    ~FaultCleaner() { ERR_clear_error(); }
};

Error invalid(const std::string& path, const std::string& why) {
    return {ErrorCode::invalid_argument, path + ": " + why};
}

Bio reading(const std::string& text) {
    return Bio(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
}

std::string text_in(BIO* bio) {
    char* data = nullptr;
    const long size = BIO_get_mem_data(bio, &data);
    return size > 0 ? std::string(data, static_cast<std::size_t>(size)) : std::string();
}

std::string name_in(const X509_NAME* name) {
    const Bio out(BIO_new(BIO_s_mem()));
    X509_NAME_print_ex(out.get(), name, 0, XN_FLAG_RFC2253);
    return text_in(out.get());
}

std::string name_of(const Certificate& certificate) {
    return "the certificate of " + name_in(X509_get_subject_name(certificate.get()));
}

// There is no prompt for a passphrase.
int no_passphrase(char*, int, int, void* needs_passphrase) {
    *static_cast<bool*>(needs_passphrase) = true;
    return -1;
}

Result<Key> read_key(const std::string& path) {
    const Result<std::string> text = read_bounded(path, file_bytes_max);
    if (!text.ok()) return text.error();
    bool needs_passphrase = false;
    Key key(
        PEM_read_bio_PrivateKey(reading(*text).get(), nullptr, no_passphrase, &needs_passphrase));
    if (needs_passphrase) return invalid(path, "the key has a passphrase; use a key without one");
    if (!key) return invalid(path, "the file contains no private key in PEM format");
    return key;
}

// Reads all certificates of a file and ignores other content.
Result<Chain> read_certificates(const std::string& path, std::size_t count_max) {
    const Result<std::string> text = read_bounded(path, file_bytes_max);
    if (!text.ok()) return text.error();
    const Bio in = reading(*text);
    Chain chain;
    while (Certificate one{PEM_read_bio_X509(in.get(), nullptr, nullptr, nullptr)}) {
        if (chain.size() == count_max)
            return invalid(
                path, "the file contains more than " + std::to_string(count_max) + " certificates");
        chain.push_back(std::move(one));
    }
    const bool at_end = ERR_GET_REASON(ERR_peek_last_error()) == PEM_R_NO_START_LINE;
    ERR_clear_error();
    if (!at_end) return invalid(path, "a certificate is damaged");
    if (chain.empty()) return invalid(path, "the file contains no certificate in PEM format");
    return chain;
}

// Certificates without an expiry date are valid until the year 9999.
WallTime to_wall(const ASN1_TIME* time) {
    std::tm parts{};
    ASN1_TIME_to_tm(time, &parts);
    const std::time_t seconds = ::timegm(&parts);
    return seconds < wall_seconds_max ? std::chrono::system_clock::from_time_t(seconds)
                                      : WallTime::max();
}

Status check_times(const Chain& chain, const std::string& path, WallTime now) {
    for (const Certificate& one : chain) {
        const WallTime begins = to_wall(X509_get0_notBefore(one.get())),
                       ends = to_wall(X509_get0_notAfter(one.get()));
        if (now < begins)
            return invalid(path, name_of(one) + " is not valid before " + rfc3339(begins));
        if (now >= ends) return invalid(path, name_of(one) + " expired on " + rfc3339(ends));
    }
    return {};
}

// Each certificate must be signed by the next one.
Status check_links(const Chain& chain, const std::string& path) {
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
        X509* issuer = chain[i + 1].get();
        if (X509_check_issued(issuer, chain[i].get()) != X509_V_OK ||
            X509_verify(chain[i].get(), X509_get0_pubkey(issuer)) != 1)
            return invalid(path, "the chain is broken: " + name_of(chain[i]) +
                                     " was not issued by the next certificate");
        if (X509_check_ca(issuer) == 0)
            return invalid(path, name_of(chain[i + 1]) + " is not a CA certificate");
    }
    return {};
}

// Whether a handshake would accept the pair. OpenSSL also checks the strength of keys and
// signatures.
Status check_pair(const Chain& chain, const Key& key, const TlsSettings& files) {
    X509* own = chain.front().get();
    if (X509_check_private_key(own, key.get()) != 1)
        return invalid(files.key, "the key does not match " + name_of(chain.front()) + " in " +
                                      files.certificate);
    if (X509_check_purpose(own, X509_PURPOSE_SSL_SERVER, 0) != 1)
        return invalid(files.certificate, name_of(chain.front()) + " is not a server certificate");
    const std::unique_ptr<SSL_CTX, FreeWith<SSL_CTX_free>> trial(SSL_CTX_new(TLS_server_method()));
    bool accepted = trial && SSL_CTX_use_certificate(trial.get(), own) == 1 &&
                    SSL_CTX_use_PrivateKey(trial.get(), key.get()) == 1;
    for (std::size_t i = 1; accepted && i < chain.size(); ++i)
        accepted = SSL_CTX_add1_chain_cert(trial.get(), chain[i].get()) == 1;
    if (accepted) return {};
    const char* reason = ERR_reason_error_string(ERR_peek_last_error());
    return invalid(files.certificate,
                   std::string("OpenSSL rejects it: ") + (reason ? reason : "no reason given"));
}

Status check_authorities(const Chain& authorities, const std::string& path) {
    for (const Certificate& one : authorities)
        if (X509_check_ca(one.get()) == 0)
            return invalid(path, name_of(one) + " is not a CA certificate");
    return {};
}

std::string to_pem(const Chain& chain) {
    const Bio out(BIO_new(BIO_s_mem()));
    for (const Certificate& one : chain) PEM_write_bio_X509(out.get(), one.get());
    return text_in(out.get());
}

std::string to_pem(const Key& key) {
    const Bio out(BIO_new(BIO_s_mem()));
    PEM_write_bio_PKCS8PrivateKey(out.get(), key.get(), nullptr, nullptr, 0, nullptr, nullptr);
    return text_in(out.get());
}

WallTime earliest_expiry(const Chain& chain) {
    WallTime first = WallTime::max();
    for (const Certificate& one : chain)
        first = std::min(first, to_wall(X509_get0_notAfter(one.get())));
    return first;
}

}  // namespace

Result<TlsMaterial> read_tls_material(const TlsSettings& files, WallTime now) {
    const FaultCleaner cleaner;
    const Result<Chain> chain = read_certificates(files.certificate, chain_max);
    if (!chain.ok()) return chain.error();
    const Result<Key> key = read_key(files.key);
    if (!key.ok()) return key.error();
    if (Status s = check_times(*chain, files.certificate, now); !s.ok()) return s.error();
    if (Status s = check_links(*chain, files.certificate); !s.ok()) return s.error();
    if (Status s = check_pair(*chain, *key, files); !s.ok()) return s.error();
    TlsMaterial material{.key_pem = to_pem(*key),
                         .chain_pem = to_pem(*chain),
                         .subject = name_in(X509_get_subject_name(chain->front().get())),
                         .expires = earliest_expiry(*chain)};
    // Group access is not reported: containers and service managers grant access to the key by a
    // group.
    if ((stamp_of(files.key).mode & S_IRWXO) != 0)
        material.warnings.push_back(files.key +
                                    " is readable by all users; restrict it with chmod o=");
    if (files.client_ca.empty()) return material;
    const Result<Chain> authorities = read_certificates(files.client_ca, client_cas_max);
    if (!authorities.ok()) return authorities.error();
    if (Status s = check_times(*authorities, files.client_ca, now); !s.ok()) return s.error();
    if (Status s = check_authorities(*authorities, files.client_ca); !s.ok()) return s.error();
    material.client_ca_pem = to_pem(*authorities);
    return material;
}

}  // namespace jostle::server
