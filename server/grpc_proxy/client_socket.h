// SPDX-License-Identifier: MIT
//
// A client socket with or without TLS, read and written without blocking. Owns its descriptor. One
// thread at a time.
#pragma once

#include <openssl/ssl.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "server/util/free_with.h"

namespace jostle::server {

class ClientSocket {
public:
    enum class State {
        open,         // the call succeeded, at least partially
        wants_read,   // nothing was done; retry when the socket is readable
        wants_write,  // nothing was done; retry when the socket is writable
        closed,       // closed by the peer, or broken
    };
    struct IoResult {
        State state = State::open;
        std::size_t bytes = 0;
    };

    // The descriptor must be non-blocking. Null `tls`: plain TCP.
    ClientSocket(int descriptor, SSL_CTX* tls);
    ~ClientSocket();
    ClientSocket(const ClientSocket&) = delete;
    ClientSocket& operator=(const ClientSocket&) = delete;

    int descriptor() const { return descriptor_; }
    bool has_tls() const { return tls_ != nullptr; }

    // Repeat until the result is `open`; without TLS it is `open` at once.
    State handshake();
    // The OpenSSL reason of a failed handshake.
    const std::string& failure() const { return failure_; }
    // Subject of the client certificate that TLS verified; empty: none.
    std::string certificate() const;

    // `buffer` must hold at least 16 KiB (one TLS record), so that no decrypted data is left over.
    IoResult read(std::span<std::uint8_t> buffer);
    // The caller passes unwritten bytes again, at the start of the next call.
    IoResult write(std::span<const std::uint8_t> bytes);
    // Sends a last message that does not wait, without TLS, and closes the sending direction. Call
    // before the handshake. Received bytes are discarded, so that closing the socket does not
    // discard the message at the client.
    void reply_unencrypted(std::string_view message);
    // Closes the sending direction.
    void finish();

    std::uint64_t received() const;  // bytes received on the wire, including TLS overhead

    // Call first on every thread that uses sockets: OpenSSL writes with write(), which can raise
    // SIGPIPE.
    static void block_broken_pipe_signal();

private:
    State state_of(int result);

    const int descriptor_;
    const std::unique_ptr<SSL, FreeWith<SSL_free>> tls_;
    std::uint64_t received_ = 0;
    std::string failure_;
};

}  // namespace jostle::server
