// SPDX-License-Identifier: MIT
#include "server/tls/peer_certificate.h"

#include <openssl/bio.h>
#include <openssl/x509.h>

#include <memory>

#include "server/util/free_with.h"

namespace jostle::server {

std::string verified_subject(const SSL* connection) {
    if (SSL_get_verify_result(connection) != X509_V_OK) return {};
    const std::unique_ptr<X509, FreeWith<X509_free>> certificate(
        SSL_get1_peer_certificate(connection));
    if (!certificate) return {};
    const std::unique_ptr<BIO, FreeWith<BIO_free>> text(BIO_new(BIO_s_mem()));
    X509_NAME_print_ex(text.get(), X509_get_subject_name(certificate.get()), 0, XN_FLAG_RFC2253);
    char* data = nullptr;
    const long size = BIO_get_mem_data(text.get(), &data);
    return size > 0 ? std::string(data, static_cast<std::size_t>(size)) : std::string{};
}

}  // namespace jostle::server
