// SPDX-License-Identifier: MIT
#include "clients/cpp/core/src/datagram_socket.h"

#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>

namespace jostle::client {

namespace {

constexpr int buffer_bytes = 1 << 20;

// Extracts the host: "192.0.2.7" from "ipv4:192.0.2.7:50051", "::1" from "ipv6:[::1]:50051" or
// "ipv6:%5B::1%5D:50051".
std::optional<std::string> host_of(const std::string& peer) {
    const std::size_t scheme = peer.find(':'), port = peer.rfind(':');
    if (scheme == port) return std::nullopt;
    const std::string kind = peer.substr(0, scheme);
    std::string host = peer.substr(scheme + 1, port - scheme - 1);
    if (kind == "ipv4") return host;
    if (kind != "ipv6") return std::nullopt;
    for (const std::string_view bracket : {"%5B", "%5D", "[", "]"})
        if (const std::size_t at = host.find(bracket); at != std::string::npos)
            host.erase(at, bracket.size());
    return host;
}

Error no_datagrams(const std::string& reason) {
    return {ErrorCode::unavailable, "datagrams are unavailable, using the stream: " + reason};
}

}  // namespace

Result<std::unique_ptr<DatagramSocket>> DatagramSocket::open(const v1::DatagramCredentials& granted,
                                                             const std::string& peer,
                                                             Clock::time_point now) {
    datagram::Credentials ticket{.id = granted.id()};
    if (granted.key().size() != ticket.key.size() || granted.port() == 0 || granted.port() > 65535)
        return no_datagrams("invalid credentials: key of " + std::to_string(granted.key().size()) +
                            " bytes, port " + std::to_string(granted.port()));
    std::memcpy(ticket.key.data(), granted.key().data(), ticket.key.size());
    const auto host = host_of(peer);
    if (!host) return no_datagrams("peer " + peer + " of the stream is not an IP address");
    addrinfo hints{}, *found = nullptr;
    hints.ai_socktype = SOCK_DGRAM;
    hints.ai_flags = AI_NUMERICHOST | AI_NUMERICSERV;
    if (const int error =
            getaddrinfo(host->c_str(), std::to_string(granted.port()).c_str(), &hints, &found);
        error != 0)
        return no_datagrams(*host + ": " + gai_strerror(error));
    const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> owned(found, freeaddrinfo);
    auto cipher = datagram::PacketCipher::make(ticket, datagram::Side::client);
    if (!cipher.ok()) return cipher.error();
    const int descriptor = socket(found->ai_family, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (descriptor < 0) return no_datagrams(std::strerror(errno));
    std::unique_ptr<DatagramSocket> made(new DatagramSocket(descriptor, *std::move(cipher), now));
    setsockopt(descriptor, SOL_SOCKET, SO_RCVBUF, &buffer_bytes, sizeof buffer_bytes);
    if (connect(descriptor, found->ai_addr, found->ai_addrlen) != 0)
        return no_datagrams(*host + ": " + std::strerror(errno));
    return made;
}

DatagramSocket::~DatagramSocket() {
    close(descriptor_);
}

std::optional<std::string> DatagramSocket::receive(Clock::time_point now) {
    for (;;) {
        std::array<char, datagram::packet_bytes_max + 1> bytes;
        const ssize_t size = recv(descriptor_, bytes.data(), bytes.size(), 0);
        if (size < 0 && (errno == ECONNREFUSED || errno == EINTR)) continue;  // reported once
        if (size < 0) return std::nullopt;
        const auto opened = cipher_->decrypt({bytes.data(), static_cast<std::size_t>(size)});
        if (!opened) continue;
        last_received_ = now;
        if (auto message = take(opened->content)) return message;
    }
}

// Returns the message that the packet contains or completes.
std::optional<std::string> DatagramSocket::take(const std::string& bytes) {
    const auto content = datagram::decode_content(bytes);
    if (!content.ok()) return std::nullopt;  // sent by a newer server; ignored
    if (const auto* question = std::get_if<datagram::PathChallenge>(&*content))
        transmit(datagram::encode(datagram::PathResponse{question->token}));
    if (const auto* message = std::get_if<datagram::Message>(&*content))
        return std::string(message->bytes);
    if (const auto* part = std::get_if<datagram::Fragment>(&*content))
        return reassembly_.add(*part);
    return std::nullopt;
}

void DatagramSocket::send(const std::string& message) {
    if (message.size() > datagram::message_bytes_max) return;
    const std::string_view piece = message;
    for (const std::string& content : datagram::encode_message(std::span(&piece, 1), 0))
        transmit(content);
}

// A packet that the system rejects counts as lost.
void DatagramSocket::transmit(const std::string& content) {
    const std::string packet = cipher_->encrypt(content);
    ::send(descriptor_, packet.data(), packet.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
}

}  // namespace jostle::client
