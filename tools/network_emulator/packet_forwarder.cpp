// SPDX-License-Identifier: MIT
#include "tools/network_emulator/packet_forwarder.h"

#include <fcntl.h>
#include <linux/if.h>
#include <linux/if_tun.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace jostle::network_emulator {

namespace {

constexpr auto longest_wait = std::chrono::milliseconds(50);
constexpr std::size_t packet_bytes_max = 65'536;

Result<int> make_device(const std::string& name) {
    const auto failed = [&](const char* what) {
        return Error{ErrorCode::unavailable, "cannot create the network device " + name + ": " +
                                                 what + ": " + std::strerror(errno) +
                                                 "; root privileges are required"};
    };
    if (name.empty() || name.size() >= IFNAMSIZ)
        return invalid_argument(
            "\"" + name +
            "\" is not a valid name of a network device; must have 1 to 15 characters");
    const int device = open("/dev/net/tun", O_RDWR | O_NONBLOCK | O_CLOEXEC);
    if (device < 0) return failed("/dev/net/tun");
    ifreq request{};
    name.copy(request.ifr_name, IFNAMSIZ - 1);
    request.ifr_flags = IFF_TUN | IFF_NO_PI;
    if (ioctl(device, TUNSETIFF, &request) == 0) return device;
    const Error error = failed("TUNSETIFF");
    close(device);
    return error;
}

}  // namespace

PacketForwarder::~PacketForwarder() {
    for (const int device : devices_)
        if (device >= 0) close(device);
}

Status PacketForwarder::open() {
    for (std::size_t k = 0; k < devices_.size(); k++) {
        const auto device = make_device(settings_.devices[k]);
        if (!device.ok()) return device.error();
        devices_[k] = *device;
    }
    return {};
}

void PacketForwarder::read(Direction& direction, Clock::time_point now) {
    std::array<char, packet_bytes_max> bytes;
    for (;;) {
        const ssize_t size = ::read(direction.from, bytes.data(), bytes.size());
        if (size <= 0) return;
        std::string packet(bytes.data(), static_cast<std::size_t>(size));
        if (!direction.packets.push(std::move(packet), now)) lost_++;
    }
}

void PacketForwarder::write_due(Direction& direction, Clock::time_point now) {
    while (const auto packet = direction.packets.take(now))
        if (write(direction.to, packet->data(), packet->size()) >= 0) forwarded_++;
}

void PacketForwarder::run(const std::atomic<bool>& stop) {
    const auto packets = [&](std::uint32_t path) {
        return NetworkQueue<std::string>(settings_.conditions, path, Delivery::datagrams);
    };
    std::array<Direction, 2> directions{Direction{devices_[0], devices_[1], packets(0)},
                                        Direction{devices_[1], devices_[0], packets(1)}};
    std::array<pollfd, 2> watched{};
    while (!stop) {
        Clock::time_point next = Clock::now() + longest_wait;
        for (std::size_t k = 0; k < directions.size(); k++) {
            watched[k] = {.fd = directions[k].from, .events = POLLIN, .revents = 0};
            if (!directions[k].packets.empty())
                next = std::min(next, directions[k].packets.next_arrival());
        }
        // ppoll() has a resolution of microseconds; poll() only milliseconds.
        const auto wait = std::max(Clock::duration::zero(), next - Clock::now());
        const timespec timeout{.tv_sec = 0, .tv_nsec = static_cast<long>(wait.count())};
        ppoll(watched.data(), watched.size(), &timeout, nullptr);
        const Clock::time_point now = Clock::now();
        for (Direction& direction : directions) {
            read(direction, now);
            write_due(direction, now);
        }
    }
}

}  // namespace jostle::network_emulator
