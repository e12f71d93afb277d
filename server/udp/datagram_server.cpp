// SPDX-License-Identifier: MIT
#include "server/udp/datagram_server.h"

#include <poll.h>
#include <spdlog/fmt/fmt.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <exception>
#include <utility>
#include <vector>

#include "jostle/base/check.h"
#include "server/util/log.h"
#include "server/util/socket.h"

namespace jostle::server {

namespace {

constexpr std::size_t receive_batch_size = 64;
// Holds the snapshots of one tick to a thousand clients, and the packets they send meanwhile.
constexpr int buffer_bytes = 4 << 20;

}  // namespace

DatagramServer::~DatagramServer() {
    stop();
    if (wake_ >= 0) ::close(wake_);
    if (socket_ >= 0) ::close(socket_);
}

Status DatagramServer::start() {
    const auto failed = [&](const std::string& why) {
        return Error{ErrorCode::unavailable,
                     fmt::format("cannot listen for datagrams on {}:{}: {}; choose another with "
                                 "--datagrams HOST:PORT",
                                 settings_.host, settings_.port, why)};
    };
    const Result<int> bound = open_bound_socket(settings_.host, settings_.port, SOCK_DGRAM);
    if (!bound.ok()) return failed(bound.error().message);
    socket_ = *bound;
    set_socket_option(socket_, SOL_SOCKET, SO_RCVBUF, buffer_bytes);
    set_socket_option(socket_, SOL_SOCKET, SO_SNDBUF, buffer_bytes);
    wake_ = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
    if (wake_ < 0) return failed(std::strerror(errno));
    port_ = port_of(socket_);
    ASSERT(port_ != 0 && !thread_.joinable());
    thread_ = std::thread([this] { run(); });
    return {};
}

void DatagramServer::stop() {
    stopping_ = true;
    if (wake_ >= 0) eventfd_write(wake_, 1);
    if (thread_.joinable()) thread_.join();
}

Result<std::shared_ptr<DatagramConnection>> DatagramServer::open(
    std::function<void(std::string_view)> on_message) {
    ASSERT(on_message);
    datagram::Credentials credentials;
    if (getentropy(&credentials.id, sizeof credentials.id) != 0 ||
        getentropy(credentials.key.data(), credentials.key.size()) != 0)
        return Error{ErrorCode::internal, "the operating system returned no random bytes"};
    auto cipher = datagram::PacketCipher::make(credentials, datagram::Side::server);
    if (!cipher.ok()) return cipher.error();
    auto connection = std::make_shared<DatagramConnection>(
        *std::move(cipher), socket_, std::move(on_message), settings_.metrics);
    const std::lock_guard lock(mutex_);
    if (!connections_.try_emplace(credentials.id, connection).second)
        return Error{ErrorCode::internal, "duplicate datagram session id"};
    return connection;
}

void DatagramServer::close(const DatagramConnection& connection) {
    const std::lock_guard lock(mutex_);
    connections_.erase(connection.credentials().id);
}

std::size_t DatagramServer::connections() const {
    const std::lock_guard lock(mutex_);
    return connections_.size();
}

std::shared_ptr<DatagramConnection> DatagramServer::find(std::uint64_t credentials) const {
    const std::lock_guard lock(mutex_);
    const auto at = connections_.find(credentials);
    return at == connections_.end() ? nullptr : at->second;
}

void DatagramServer::run() {
    ASSERT(socket_ >= 0 && wake_ >= 0);
    std::array<pollfd, 2> watched{pollfd{.fd = socket_, .events = POLLIN, .revents = 0},
                                  pollfd{.fd = wake_, .events = POLLIN, .revents = 0}};
    while (!stopping_) {
        poll(watched.data(), watched.size(), -1);
        try {
            receive_packets();
        } catch (const std::exception& error) {
            // Out of memory: these packets are lost.
            log_error("datagrams: {}", error.what());
        }
    }
}

// Receives all pending packets.
void DatagramServer::receive_packets() {
    // One byte more than the maximum packet size, so that a truncated packet is detected as too
    // long.
    static thread_local std::array<std::array<char, datagram::packet_bytes_max + 1>,
                                   receive_batch_size>
        bytes;
    std::array<DatagramAddress, receive_batch_size> from;
    std::array<iovec, receive_batch_size> pieces{};
    std::array<mmsghdr, receive_batch_size> messages{};
    for (std::size_t count = receive_batch_size; count == receive_batch_size && !stopping_;) {
        for (std::size_t k = 0; k < receive_batch_size; k++) {
            pieces[k] = {bytes[k].data(), bytes[k].size()};
            messages[k].msg_hdr = {.msg_name = &from[k].bytes,
                                   .msg_namelen = sizeof from[k].bytes,
                                   .msg_iov = &pieces[k],
                                   .msg_iovlen = 1};
        }
        const int taken =
            recvmmsg(socket_, messages.data(), receive_batch_size, MSG_DONTWAIT, nullptr);
        if (taken <= 0) return;
        count = static_cast<std::size_t>(taken);
        ASSERT(count <= receive_batch_size);
        const Clock::time_point now = Clock::now();
        for (std::size_t k = 0; k < count; k++) {
            ASSERT(messages[k].msg_len <= bytes[k].size());
            const std::string_view packet(bytes[k].data(), messages[k].msg_len);
            from[k].size = messages[k].msg_hdr.msg_namelen;
            const auto credentials = datagram::session_id_of(packet);
            const auto connection = credentials ? find(*credentials) : nullptr;
            if (connection)
                connection->receive(packet, from[k], now);
            else if (settings_.metrics)
                settings_.metrics->datagrams_refused.Increment();
        }
    }
}

}  // namespace jostle::server
