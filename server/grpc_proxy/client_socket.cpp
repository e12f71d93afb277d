// SPDX-License-Identifier: MIT
#include "server/grpc_proxy/client_socket.h"

#include <openssl/err.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <new>

#include "jostle/base/check.h"
#include "server/tls/certificate_store.h"

namespace jostle::server {

namespace {

SSL* tls_on(int descriptor, SSL_CTX* context) {
    if (!context) return nullptr;
    SSL* tls = SSL_new(context);
    if (!tls || SSL_set_fd(tls, descriptor) != 1) {
        SSL_free(tls);
        ::close(descriptor);
        throw std::bad_alloc();
    }
    SSL_set_accept_state(tls);
    SSL_set_options(tls, SSL_OP_NO_RENEGOTIATION);
    // Release the buffers of idle connections.
    SSL_set_mode(tls, SSL_MODE_ENABLE_PARTIAL_WRITE | SSL_MODE_ACCEPT_MOVING_WRITE_BUFFER |
                          SSL_MODE_RELEASE_BUFFERS);
    return tls;
}

ClientSocket::State state_of_errno(ClientSocket::State retry_state) {
    const bool retry = errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
    return retry ? retry_state : ClientSocket::State::closed;
}

}  // namespace

ClientSocket::ClientSocket(int descriptor, SSL_CTX* tls)
    : descriptor_(descriptor), tls_(tls_on(descriptor, tls)) {
    ASSERT(descriptor >= 0);
}

ClientSocket::~ClientSocket() {
    ::close(descriptor_);
}

void ClientSocket::block_broken_pipe_signal() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
}

ClientSocket::State ClientSocket::state_of(int result) {
    ASSERT(tls_);
    switch (SSL_get_error(tls_.get(), result)) {
        case SSL_ERROR_NONE:
            return State::open;
        case SSL_ERROR_WANT_READ:
            return State::wants_read;
        case SSL_ERROR_WANT_WRITE:
            return State::wants_write;
        default:
            return State::closed;
    }
}

ClientSocket::State ClientSocket::handshake() {
    if (!tls_) return State::open;
    ERR_clear_error();
    const State state = state_of(SSL_do_handshake(tls_.get()));
    if (state == State::closed) {
        const char* reason = ERR_reason_error_string(ERR_peek_error());
        failure_ = reason ? reason : "the connection was closed";
    }
    return state;
}

std::string ClientSocket::certificate() const {
    return tls_ ? verified_subject(tls_.get()) : std::string();
}

ClientSocket::IoResult ClientSocket::read(std::span<std::uint8_t> buffer) {
    if (tls_) {
        ERR_clear_error();
        std::size_t count = 0;
        const int result = SSL_read_ex(tls_.get(), buffer.data(), buffer.size(), &count);
        return {result == 1 ? State::open : state_of(result), count};
    }
    ASSERT(!buffer.empty());
    const ssize_t count = ::recv(descriptor_, buffer.data(), buffer.size(), 0);
    if (count < 0) return {state_of_errno(State::wants_read), 0};
    received_ += static_cast<std::uint64_t>(count);
    return {count == 0 ? State::closed : State::open, static_cast<std::size_t>(count)};
}

ClientSocket::IoResult ClientSocket::write(std::span<const std::uint8_t> bytes) {
    if (tls_) {
        ERR_clear_error();
        std::size_t count = 0;
        const int result = SSL_write_ex(tls_.get(), bytes.data(), bytes.size(), &count);
        return {result == 1 ? State::open : state_of(result), count};
    }
    const ssize_t count = ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count < 0) return {state_of_errno(State::wants_write), 0};
    return {State::open, static_cast<std::size_t>(count)};
}

void ClientSocket::reply_unencrypted(std::string_view message) {
    std::array<char, 4096> received;
    for (int i = 0; i < 16 && ::recv(descriptor_, received.data(), received.size(), 0) > 0; i++) {
    }
    // A full buffer of a new connection is impossible; a lost hint would be harmless.
    static_cast<void>(::send(descriptor_, message.data(), message.size(), MSG_NOSIGNAL));
    ::shutdown(descriptor_, SHUT_WR);
}

void ClientSocket::finish() {
    if (tls_ && SSL_is_init_finished(tls_.get())) {
        ERR_clear_error();
        SSL_shutdown(tls_.get());
    }
    ::shutdown(descriptor_, SHUT_WR);
}

std::uint64_t ClientSocket::received() const {
    return tls_ ? BIO_number_read(SSL_get_rbio(tls_.get())) : received_;
}

}  // namespace jostle::server
