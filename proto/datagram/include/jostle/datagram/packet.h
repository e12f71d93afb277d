// SPDX-License-Identifier: MIT
//
// A packet of the datagram way (WIRE.md, "Datagrams"): ticket, number, and a content that only who
// has the ticket's key can read or make. One Seal at each end of a way: it seals what goes out,
// numbering it from 0, and opens what comes in, each number once.
//
// ChaCha20-Poly1305 (RFC 8439) by OpenSSL: quick also where a processor has no AES. Each direction
// has a key of its own (HKDF-SHA-256), so the number alone is a nonce that never comes twice.
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

// Below what every path of today's Internet carries whole, as QUIC takes it.
inline constexpr std::size_t packet_bytes_max = 1200;
inline constexpr std::size_t header_bytes = 16, tag_bytes = 16;
inline constexpr std::size_t content_bytes_max = packet_bytes_max - header_bytes - tag_bytes;

struct Credentials {
    std::uint64_t id = 0;  // random; says whose packet it is
    std::array<std::uint8_t, 32> key{};
};

enum class Side { server, client };

// The ticket's id of a packet, authentic or not; nothing: it is too short or too long to be one.
std::optional<std::uint64_t> session_id_of(std::string_view packet);

class PacketCipher {
public:
    // internal: OpenSSL refuses, as when memory runs out.
    static Result<std::unique_ptr<PacketCipher>> make(const Credentials& credentials, Side side);
    ~PacketCipher();
    PacketCipher(const PacketCipher&) = delete;
    PacketCipher& operator=(const PacketCipher&) = delete;

    // At most content_bytes_max bytes; as a packet. Empty: OpenSSL refused.
    std::string encrypt(std::string_view content);

    struct DecryptedPacket {
        std::string content;
        bool newest = false;  // no packet with a higher number has come
    };
    // Nothing: it is none of this ticket's, was changed on its way, or came before.
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
