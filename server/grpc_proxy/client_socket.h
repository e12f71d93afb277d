// SPDX-License-Identifier: MIT
//
// The socket of a client, with TLS or without, as bytes that are read and written without waiting.
// Owns its descriptor. One thread at a time.
#pragma once

#include <openssl/ssl.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "server/util/free_with.h"

namespace jostle::server {

class ClientSocket {
public:
    enum class State {
        open,         // what was asked for was done, in part at least
        wants_read,   // nothing could be done until there is something to read
        wants_write,  // likewise, to write
        closed,       // by the peer, or broken
    };
    struct IoResult {
        State state = State::open;
        std::size_t bytes = 0;
    };

    // The descriptor does not block. Null `tls`: without.
    ClientSocket(int descriptor, SSL_CTX* tls);
    ~ClientSocket();
    ClientSocket(const ClientSocket&) = delete;
    ClientSocket& operator=(const ClientSocket&) = delete;

    int descriptor() const { return descriptor_; }

    // Until `open`; not needed without TLS, and then open at once.
    State handshake();
    // Why the handshake failed, in OpenSSL's words.
    const std::string& failure() const { return failure_; }
    // Subject of the certificate that the client has shown and TLS verified; empty: none.
    std::string certificate() const;

    // At least 16 KiB of room, so that nothing that was decrypted stays behind.
    IoResult read(std::span<std::uint8_t> room);
    // What was not written is to be given again, at the beginning of the next call.
    IoResult write(std::span<const std::uint8_t> bytes);
    // Tells the peer that nothing more comes.
    void finish();

    std::uint64_t received() const;  // bytes off the line, TLS's own included

    // OpenSSL writes to sockets by write(): who uses these on a thread of its own calls this first.
    static void block_broken_pipe_signal();

private:
    State state_of(int result);

    const int descriptor_;
    const std::unique_ptr<SSL, FreeWith<SSL_free>> tls_;
    std::uint64_t received_ = 0;
    std::string failure_;
};

}  // namespace jostle::server
