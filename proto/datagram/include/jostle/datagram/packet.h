// SPDX-License-Identifier: MIT
//
// Packets of the datagram transport (WIRE.md, "Datagrams"): session id, number, and a content that
// only the owner of the session key can read or create. Each end of a connection has one
// PacketCipher. It encrypts outgoing packets, numbered from 0, and decrypts incoming packets, each
// number once.
//
// ChaCha20-Poly1305 (RFC 8439) by OpenSSL: fast also on processors without AES instructions. Each
// direction has its own key (HKDF-SHA-256), so the packet number alone is a nonce that never
// repeats.
//
// Thread rule: one thread at a time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "jostle/base/result.h"
#include "jostle/datagram/replay_window.h"

struct evp_cipher_ctx_st;

namespace jostle::datagram {

/// Maximum packet size. Internet paths carry packets of this size without fragmentation; QUIC uses
/// the same size.
inline constexpr std::size_t packet_bytes_max = 1200;
inline constexpr std::size_t header_bytes = 16, tag_bytes = 16;
inline constexpr std::size_t content_bytes_max = packet_bytes_max - header_bytes - tag_bytes;

struct Credentials {
    std::uint64_t id = 0;  ///< random; identifies the session of a packet
    std::array<std::uint8_t, 32> key{};
};

enum class Side { server, client };

/// Returns the session id of a packet, which may be forged. Returns nothing if the size of the
/// packet is invalid.
std::optional<std::uint64_t> session_id_of(std::string_view packet);

class PacketCipher {
public:
    /// Returns internal if OpenSSL fails, for example for lack of memory.
    static Result<std::unique_ptr<PacketCipher>> make(const Credentials& credentials, Side side);
    ~PacketCipher();
    PacketCipher(const PacketCipher&) = delete;
    PacketCipher& operator=(const PacketCipher&) = delete;

    /// Encrypts at most content_bytes_max bytes and returns the packet. Returns an empty string if
    /// OpenSSL fails.
    std::string encrypt(std::string_view content);

    struct DecryptedPacket {
        std::string content;
        bool newest = false;  ///< no packet with a higher number was received
    };
    /// Returns nothing if the packet belongs to another session, was modified in transit or was
    /// already received.
    std::optional<DecryptedPacket> decrypt(std::string_view packet);

    const Credentials& credentials() const { return ticket_; }

private:
    explicit PacketCipher(const Credentials& credentials) : ticket_(credentials) {}

    const Credentials ticket_;
    evp_cipher_ctx_st *out_ = nullptr, *in_ = nullptr;
    std::uint64_t next_ = 0;
    ReplayWindow window_;
};

}  // namespace jostle::datagram
