// SPDX-License-Identifier: MIT
#include "gateway/socket_stream.h"

#include <openssl/bio.h>
#include <openssl/x509.h>

#include "base/free_with.h"

namespace jostle::server {

SocketStream::SocketStream(boost::asio::ip::tcp::socket socket,
                           std::shared_ptr<boost::asio::ssl::context> tls)
    : context_(std::move(tls)),
      tcp_(std::make_unique<boost::beast::tcp_stream>(std::move(socket))) {
    if (context_) tls_ = std::make_unique<Tls>(*tcp_, *context_);
}

std::string SocketStream::certificate() const {
    if (!tls_ || SSL_get_verify_result(tls_->native_handle()) != X509_V_OK) return {};
    const std::unique_ptr<X509, FreeWith<X509_free>> shown(
        SSL_get1_peer_certificate(tls_->native_handle()));
    if (!shown) return {};
    const std::unique_ptr<BIO, FreeWith<BIO_free>> text(BIO_new(BIO_s_mem()));
    // As gRPC writes it.
    X509_NAME_print_ex(text.get(), X509_get_subject_name(shown.get()), 0, XN_FLAG_RFC2253);
    char* data = nullptr;
    const long size = BIO_get_mem_data(text.get(), &data);
    return size > 0 ? std::string(data, static_cast<std::size_t>(size)) : std::string{};
}

void teardown(boost::beast::role_type role, SocketStream& stream, boost::beast::error_code& error) {
    boost::beast::websocket::teardown(role, stream.tcp().socket(), error);
}

}  // namespace jostle::server
