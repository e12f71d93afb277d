// SPDX-License-Identifier: MIT
#include "server/http/socket_stream.h"

#include "server/tls/certificate_store.h"

namespace jostle::server {

SocketStream::SocketStream(boost::asio::ip::tcp::socket socket,
                           std::shared_ptr<boost::asio::ssl::context> tls)
    : context_(std::move(tls)),
      tcp_(std::make_unique<boost::beast::tcp_stream>(std::move(socket))) {
    if (context_) tls_ = std::make_unique<Tls>(*tcp_, *context_);
}

std::string SocketStream::certificate() const {
    return tls_ ? verified_subject(tls_->native_handle()) : std::string();
}

void SocketStream::read_some(const Pieces<boost::asio::mutable_buffer>& pieces, Done done) {
    if (tls_) return tls_->async_read_some(pieces, std::move(done));
    tcp_->async_read_some(pieces, std::move(done));
}

void SocketStream::write_some(const Pieces<boost::asio::const_buffer>& pieces, Done done) {
    if (tls_) return tls_->async_write_some(pieces, std::move(done));
    tcp_->async_write_some(pieces, std::move(done));
}

void SocketStream::end(boost::beast::role_type role,
                       std::function<void(boost::beast::error_code)> done) {
    using boost::beast::websocket::async_teardown;
    if (tls_) return async_teardown(role, *tls_, std::move(done));
    async_teardown(role, tcp_->socket(), std::move(done));
}

void teardown(boost::beast::role_type role, SocketStream& stream, boost::beast::error_code& error) {
    boost::beast::websocket::teardown(role, stream.tcp().socket(), error);
}

}  // namespace jostle::server
