// SPDX-License-Identifier: MIT
#include "server/tls/tls_contexts.h"

#include <boost/asio/buffer.hpp>

#include "server/util/log.h"

namespace jostle::server {

namespace ssl = boost::asio::ssl;

namespace {

int choose_http2(SSL*, const unsigned char** chosen, unsigned char* size,
                 const unsigned char* offered, unsigned offered_size, void*) {
    static constexpr unsigned char h2[] = {2, 'h', '2'};
    // OpenSSL points into one of the two lists; both outlive the call.
    unsigned char* found = nullptr;
    const int outcome = SSL_select_next_proto(&found, size, h2, sizeof h2, offered, offered_size);
    *chosen = found;
    return outcome == OPENSSL_NPN_NEGOTIATED ? SSL_TLSEXT_ERR_OK : SSL_TLSEXT_ERR_ALERT_FATAL;
}

std::shared_ptr<ssl::context> context_of(const TlsMaterial& material,
                                         const TlsContexts::TlsRequirements& requirements) {
    auto context = std::make_shared<ssl::context>(ssl::context::tls_server);
    context->set_options(ssl::context::default_workarounds | ssl::context::no_tlsv1 |
                         ssl::context::no_tlsv1_1);
    context->use_certificate_chain(boost::asio::buffer(material.chain_pem));
    context->use_private_key(boost::asio::buffer(material.key_pem), ssl::context::pem);
    if (!material.client_ca_pem.empty()) {
        context->add_certificate_authority(boost::asio::buffer(material.client_ca_pem));
        context->set_verify_mode(
            ssl::verify_peer |
            (requirements.require_certificates ? ssl::verify_fail_if_no_peer_cert : 0));
        // TLS sessions may be resumed only on the listener that created them.
        static constexpr unsigned char listener[] = "jostle";
        SSL_CTX_set_session_id_context(context->native_handle(), listener, sizeof listener - 1);
    }
    if (requirements.only_http2)
        SSL_CTX_set_alpn_select_cb(context->native_handle(), choose_http2, nullptr);
    return context;
}

}  // namespace

std::shared_ptr<ssl::context> TlsContexts::current() {
    if (!store_) return nullptr;
    std::shared_ptr<const TlsMaterial> material = store_->material();
    if (material == material_) return context_;
    try {
        context_ = context_of(*material, requirements_);
        material_ = std::move(material);
    } catch (const std::exception& error) {
        // The store has validated the certificate; on any other failure the previous one stays in
        // use.
        log_error("cannot use the new certificate: {}", error.what());
    }
    return context_;
}

}  // namespace jostle::server
