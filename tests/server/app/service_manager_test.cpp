// SPDX-License-Identifier: MIT
//
// A socket stands in for systemd's: what arrives there is what `man sd_notify` asks for.
#include "server/app/service_manager.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

// The manager's end: a datagram socket under a path, or under an abstract name ("@..."), and the
// environment that tells the server of it.
class Manager {
public:
    explicit Manager(const std::string& name) : name_(name) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::memcpy(address.sun_path, name.data(), name.size());
        if (name[0] == '@') address.sun_path[0] = '\0';
        EXPECT_EQ(bind(socket_, reinterpret_cast<const sockaddr*>(&address),
                       static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size())),
                  0);
        setenv("NOTIFY_SOCKET", name.c_str(), 1);
    }
    ~Manager() {
        unsetenv("NOTIFY_SOCKET");
        close(socket_);
        if (name_[0] == '/') std::filesystem::remove(name_);
    }
    Manager(const Manager&) = delete;
    Manager& operator=(const Manager&) = delete;

    // The next datagram; empty if none has arrived.
    std::string heard() const {
        char bytes[4096];
        const ssize_t size = recv(socket_, bytes, sizeof bytes, MSG_DONTWAIT);
        return size < 0 ? "" : std::string(bytes, static_cast<std::size_t>(size));
    }

private:
    const std::string name_;
    const int socket_ = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
};

std::string of_this_process(const std::string& name) {
    return name + std::to_string(getpid());
}

TEST(ServiceManager, sends_one_datagram_per_call_to_a_path_socket) {
    const Manager manager(
        (std::filesystem::temp_directory_path() / of_this_process("jostle-notify-")).string());
    EXPECT_TRUE(notify_ready("2 worlds"));
    EXPECT_TRUE(notify_watchdog());
    EXPECT_TRUE(notify_stopping());
    EXPECT_EQ(manager.heard(), "READY=1\nSTATUS=2 worlds");
    EXPECT_EQ(manager.heard(), "WATCHDOG=1");
    EXPECT_EQ(manager.heard(), "STOPPING=1\nSTATUS=shutting down");
    EXPECT_EQ(manager.heard(), "");
}

TEST(ServiceManager, sends_to_an_abstract_socket) {
    const Manager manager(of_this_process("@jostle-notify-"));
    EXPECT_TRUE(notify_ready("ready"));
    EXPECT_EQ(manager.heard(), "READY=1\nSTATUS=ready");
}

TEST(ServiceManager, multiline_status_sets_no_second_variable) {
    const Manager manager(of_this_process("@jostle-notify-"));
    EXPECT_TRUE(notify_ready("a\nMAINPID=1\rb"));
    EXPECT_EQ(manager.heard(), "READY=1\nSTATUS=a MAINPID=1 b");
}

TEST(ServiceManager, sends_nothing_without_a_notify_socket) {
    unsetenv("NOTIFY_SOCKET");
    EXPECT_FALSE(notify_ready("ready"));
    EXPECT_FALSE(notify_watchdog());
    EXPECT_FALSE(notify_stopping());
}

// A name that is too long, one without a name, one of another family, and one without a listener.
TEST(ServiceManager, ignores_an_unreachable_manager) {
    const std::string too_long = "/" + std::string(200, 'x');
    for (const char* name : {too_long.c_str(), "@", "vsock:2:1234", "/nobody/here"}) {
        setenv("NOTIFY_SOCKET", name, 1);
        EXPECT_FALSE(notify_watchdog()) << name;
    }
    unsetenv("NOTIFY_SOCKET");
}

// A manager that hangs with a full queue (about 10 datagrams) does not block the caller.
TEST(ServiceManager, does_not_block_on_a_full_socket) {
    const Manager manager(of_this_process("@jostle-notify-"));
    bool sent = true;
    for (int i = 0; i < 10'000 && sent; i++) sent = notify_watchdog();
    EXPECT_FALSE(sent);
}

struct Watchdog {
    const char* usec;
    const char* pid;
    std::optional<std::chrono::microseconds> period;
};

TEST(ServiceManager, watchdog_period_is_half_of_the_timeout) {
    const std::string own = std::to_string(getpid()), other = std::to_string(getpid() + 1);
    for (const Watchdog& w :
         {Watchdog{"10000000", nullptr, 5s}, Watchdog{"10000000", own.c_str(), 5s},
          Watchdog{"10000000", other.c_str(), std::nullopt},
          Watchdog{"10000000", "me", std::nullopt}, Watchdog{nullptr, nullptr, std::nullopt},
          Watchdog{"", nullptr, std::nullopt}, Watchdog{"0", nullptr, std::nullopt},
          Watchdog{"-5", nullptr, std::nullopt}, Watchdog{"10s", nullptr, std::nullopt},
          Watchdog{"99999999999999999999", nullptr, std::nullopt}}) {
        unsetenv("WATCHDOG_USEC");
        unsetenv("WATCHDOG_PID");
        if (w.usec) setenv("WATCHDOG_USEC", w.usec, 1);
        if (w.pid) setenv("WATCHDOG_PID", w.pid, 1);
        EXPECT_EQ(watchdog_period(), w.period) << (w.usec ? w.usec : "(unset)");
    }
    unsetenv("WATCHDOG_USEC");
    unsetenv("WATCHDOG_PID");
}

}  // namespace
}  // namespace jostle::server
