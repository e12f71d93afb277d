// SPDX-License-Identifier: MIT
#include "gateway/tls_contexts.h"

#include <boost/asio/buffer.hpp>

#include "base/log.h"

namespace jostle::server {

namespace ssl = boost::asio::ssl;

namespace {

std::shared_ptr<ssl::context> context_of(const Material& material, bool require_certificates) {
    auto context = std::make_shared<ssl::context>(ssl::context::tls_server);
    context->set_options(ssl::context::default_workarounds | ssl::context::no_tlsv1 |
                         ssl::context::no_tlsv1_1);
    context->use_certificate_chain(boost::asio::buffer(material.chain_pem));
    context->use_private_key(boost::asio::buffer(material.key_pem), ssl::context::pem);
    if (!material.client_ca_pem.empty()) {
        context->add_certificate_authority(boost::asio::buffer(material.client_ca_pem));
        context->set_verify_mode(ssl::verify_peer |
                                 (require_certificates ? ssl::verify_fail_if_no_peer_cert : 0));
    }
    return context;
}

}  // namespace

std::shared_ptr<ssl::context> TlsContexts::present() {
    if (!store_) return nullptr;
    std::shared_ptr<const Material> material = store_->material();
    if (material == material_) return context_;
    try {
        context_ = context_of(*material, require_certificates_);
        material_ = std::move(material);
    } catch (const std::exception& error) {
        // The store has checked it; whatever it is, the old one still works.
        log_error("http: the new certificate cannot be used: {}", error.what());
    }
    return context_;
}

}  // namespace jostle::server
