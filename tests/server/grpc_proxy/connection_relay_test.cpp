// SPDX-License-Identifier: MIT
//
// Tests with real sockets: a client at one end and the gRPC side at the other end, with and without
// TLS.
#include "server/grpc_proxy/connection_relay.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <condition_variable>
#include <mutex>
#include <string>
#include <utility>

#include "server/tls/tls_contexts.h"
#include "tests/support/certificates.h"
#include "tests/support/temp_folder.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

const std::string preface = "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n";

// A DATA frame of stream 1.
std::string data_frame(std::size_t length) {
    std::string out{static_cast<char>(length >> 16),
                    static_cast<char>(length >> 8),
                    static_cast<char>(length),
                    0,
                    0,
                    0,
                    0,
                    0,
                    1};
    return out + std::string(length, 'x');
}

// A file descriptor that closes itself.
struct Owned {
    int descriptor = -1;
    Owned() = default;
    explicit Owned(int d) : descriptor(d) {}
    Owned(Owned&& other) noexcept : descriptor(std::exchange(other.descriptor, -1)) {}
    Owned& operator=(Owned&& other) noexcept {
        std::swap(descriptor, other.descriptor);
        return *this;
    }
    ~Owned() { close(); }
    void close() {
        if (descriptor >= 0) ::close(std::exchange(descriptor, -1));
    }
    bool is_ready(short events, int ms = 5000) const {
        pollfd p{descriptor, events, 0};
        return poll(&p, 1, ms) == 1;
    }
    // Reads `count` bytes, or fewer if the peer closes first.
    std::string read(std::size_t count) const {
        std::string out, part(1 << 16, '\0');
        while (out.size() < count && is_ready(POLLIN)) {
            const ssize_t n =
                recv(descriptor, part.data(), std::min(part.size(), count - out.size()), 0);
            if (n <= 0) break;
            out.append(part.data(), static_cast<std::size_t>(n));
        }
        return out;
    }
    bool write(const std::string& bytes, int ms = 5000) const {
        for (std::size_t done = 0; done < bytes.size();) {
            if (!is_ready(POLLOUT, ms)) return false;
            const ssize_t n = send(descriptor, bytes.data() + done, bytes.size() - done,
                                   MSG_NOSIGNAL | MSG_DONTWAIT);
            if (n < 0 && errno == EAGAIN) continue;
            if (n <= 0) return false;
            done += static_cast<std::size_t>(n);
        }
        return true;
    }
    bool is_closed() const {
        char c = 0;
        return is_ready(POLLIN) && recv(descriptor, &c, 1, 0) <= 0;
    }
};

class ConnectionRelayTest : public testing::Test {
protected:
    void SetUp() override { start(relay); }
    void start(ConnectionRelay& which) {
        const Status started = which.start([this](int descriptor) {
            const std::lock_guard lock(mutex);
            accepted.emplace_back(descriptor);
            came.notify_all();
        });
        ASSERT_TRUE(started.ok());
    }
    // Returns the socket of the client; the relay owns the other end.
    Owned connect(SSL_CTX* tls = nullptr) {
        Owned listener(socket(AF_INET, SOCK_STREAM, 0));
        sockaddr_in any{.sin_family = AF_INET, .sin_addr = {htonl(INADDR_LOOPBACK)}};
        EXPECT_EQ(bind(listener.descriptor, reinterpret_cast<sockaddr*>(&any), sizeof any), 0);
        EXPECT_EQ(listen(listener.descriptor, 4), 0);
        sockaddr_storage address{};
        socklen_t size = sizeof address;
        getsockname(listener.descriptor, reinterpret_cast<sockaddr*>(&address), &size);
        Owned client(socket(AF_INET, SOCK_STREAM, 0));
        EXPECT_EQ(::connect(client.descriptor, reinterpret_cast<sockaddr*>(&address), size), 0);
        size = sizeof address;
        const int served = accept4(listener.descriptor, reinterpret_cast<sockaddr*>(&address),
                                   &size, SOCK_NONBLOCK);
        connection = table.admit(address);
        peer = address;
        auto socket_of_client = std::make_unique<ClientSocket>(served, tls);
        if (tls) return tls_handshake(std::move(client), std::move(socket_of_client));
        door->add(std::move(socket_of_client), connection);
        return client;
    }
    // Does the TLS handshake like the acceptor, with a client that accepts any certificate.
    Owned tls_handshake(Owned client, std::unique_ptr<ClientSocket> served) {
        client_context.reset(SSL_CTX_new(TLS_client_method()));
        client_tls.reset(SSL_new(client_context.get()));
        static constexpr unsigned char offered[] = {2, 'h', '2'};
        SSL_set_alpn_protos(client_tls.get(), offered, sizeof offered);
        SSL_set_fd(client_tls.get(), client.descriptor);
        std::jthread other([&] { EXPECT_EQ(SSL_connect(client_tls.get()), 1); });
        while (served->handshake() != ClientSocket::State::open) std::this_thread::sleep_for(1ms);
        other.join();
        relay.add(std::move(served), connection);
        return client;
    }
    Owned grpc_end() {
        std::unique_lock lock(mutex);
        if (!came.wait_for(lock, 5s, [&] { return !accepted.empty(); })) return {};
        Owned out = std::move(accepted.back());
        accepted.pop_back();
        return out;
    }
    bool nothing_was_accepted() {
        const std::lock_guard lock(mutex);
        return accepted.empty();
    }
    bool is_table_empty() const {
        for (const auto end = Clock::now() + 5s; Clock::now() < end;)
            if (table.size() == 0) return true;
        return false;
    }

    std::mutex mutex;
    std::condition_variable came;
    std::vector<Owned> accepted;
    ConnectionTable table{{}};
    ConnectionRelay relay{
        table, {.buffered_bytes_max = 1e6, .preface_timeout = 300ms, .close_timeout = 300ms}};
    ConnectionRelay* door = &relay;
    std::shared_ptr<Connection> connection;
    sockaddr_storage peer{};
    std::unique_ptr<SSL_CTX, FreeWith<SSL_CTX_free>> client_context;
    std::unique_ptr<SSL, FreeWith<SSL_free>> client_tls;
};

TEST_F(ConnectionRelayTest, relays_bytes_both_ways_with_peer_identity) {
    const Owned client = connect();
    ASSERT_TRUE(client.write(preface));
    const Owned grpc = grpc_end();
    EXPECT_EQ(grpc.read(preface.size()), preface);
    sockaddr_un name{};
    socklen_t size = sizeof name;
    getpeername(grpc.descriptor, reinterpret_cast<sockaddr*>(&name), &size);
    const std::string given(name.sun_path + 1, size - offsetof(sockaddr_un, sun_path) - 1);
    EXPECT_EQ(table.of("unix-abstract:" + given), connection);

    // more data than all buffers hold, while the client reads slowly
    std::string payload(6'000'000, 'a');
    for (std::size_t i = 0; i < payload.size(); i++) payload[i] = static_cast<char>(i * 7919 >> 5);
    std::jthread writer([&] { EXPECT_TRUE(grpc.write(payload)); });
    std::this_thread::sleep_for(100ms);
    EXPECT_EQ(client.read(payload.size()), payload);
}

TEST_F(ConnectionRelayTest, rejects_non_http2_clients_before_grpc) {
    const Owned silent = connect();
    EXPECT_TRUE(silent.is_closed()) << "a silent client must be disconnected after 0.3 s";
    const Owned browser = connect();
    browser.write("GET / HTTP/1.1\r\n\r\n");
    EXPECT_NE(browser.read(1000).find("this is the gRPC port"), std::string::npos);
    EXPECT_TRUE(browser.is_closed()) << "a client of another protocol must be disconnected at once";
    EXPECT_FALSE(table.refusal_for(peer, Clock::now()))
        << "a wrong protocol must not cause a penalty";
    EXPECT_EQ(accepted.size(), 0u);
    EXPECT_TRUE(is_table_empty());
}

TEST_F(ConnectionRelayTest, delivers_final_grpc_bytes_before_close) {
    const Owned client = connect();
    client.write(preface);
    Owned grpc = grpc_end();
    ASSERT_TRUE(grpc.write(std::string(150'000, 'z')));
    grpc.close();
    client.write(data_frame(100));  // the data is not read and grants no window
    EXPECT_EQ(client.read(200'000).size(), 150'000u);
    EXPECT_TRUE(client.is_closed());
    EXPECT_TRUE(is_table_empty())
        << "the connection must be removed after 0.3 s although the client stays connected";
}

TEST_F(ConnectionRelayTest, half_closed_client_still_receives_the_response) {
    const Owned client = connect();
    client.write(preface);
    const Owned grpc = grpc_end();
    shutdown(client.descriptor, SHUT_WR);
    EXPECT_EQ(grpc.read(1000), preface);
    EXPECT_TRUE(grpc.is_closed());
    ASSERT_TRUE(grpc.write("the answer"));
    EXPECT_EQ(client.read(10), "the answer");
}

TEST_F(ConnectionRelayTest, client_disconnect_closes_the_grpc_side) {
    Owned client = connect();
    client.write(preface);
    const Owned grpc = grpc_end();
    grpc.read(preface.size());
    const linger at_once{.l_onoff = 1, .l_linger = 0};
    setsockopt(client.descriptor, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
    client.close();
    EXPECT_TRUE(grpc.is_closed());
    EXPECT_TRUE(is_table_empty());
}

TEST_F(ConnectionRelayTest, drops_and_penalizes_clients_exceeding_the_buffer_limit) {
    const Owned client = connect();
    client.write(preface);
    const Owned grpc = grpc_end();
    std::jthread reader([&] { grpc.read(1u << 30); });
    int frames = 0;
    while (frames < 2000 && client.write(data_frame(16'384))) frames++;
    EXPECT_LT(frames, 2000) << "the relay must stop a client that floods frames of 16 KiB";
    EXPECT_EQ(relay.dropped(), 1u);
    EXPECT_EQ(table.refusal_for(peer, Clock::now()), ConnectionTable::Refusal::address_penalized);
}

TEST_F(ConnectionRelayTest, complete_messages_do_not_count_against_the_buffer_limit) {
    const Owned client = connect();
    client.write(preface);
    const Owned grpc = grpc_end();
    std::jthread reader([&] {
        for (std::size_t n = 1; n > 0;) {
            n = grpc.read(16'384).size();
            connection->consumed += n;
        }
    });
    for (int i = 0; i < 1000; i++) ASSERT_TRUE(client.write(data_frame(16'384)));
    EXPECT_EQ(relay.dropped(), 0u);
    shutdown(client.descriptor, SHUT_WR);
}

TEST_F(ConnectionRelayTest, closed_pending_connections_never_reach_grpc) {
    ConnectionRelay slow(table, {.openings_per_second = 2});
    start(slow);
    door = &slow;
    const auto connect_client = [&] {
        Owned client = connect();
        client.write(preface);
        return client;
    };
    const Owned first = connect_client(), first_grpc = grpc_end();
    const Owned second = connect_client(), second_grpc = grpc_end();
    Owned third = connect_client();
    const Owned fourth = connect_client();
    third.close();                         // before its turn
    const Owned fourth_grpc = grpc_end();  // after 0.5 s
    EXPECT_EQ(fourth_grpc.read(preface.size()), preface);
    EXPECT_EQ(table.size(), 3u);
    std::this_thread::sleep_for(600ms);
    EXPECT_TRUE(nothing_was_accepted()) << "the third connection must not reach gRPC";
    slow.stop({});
}

TEST_F(ConnectionRelayTest, terminates_tls) {
    const test::TempFolder folder;
    const auto authority = test::make_authority();
    const auto leaf = test::make_certificate({}, &authority);
    folder.write("key.pem", leaf.key_pem());
    folder.write("chain.pem", leaf.pem());
    const auto store =
        CertificateStore::open({.certificate = folder / "chain.pem", .key = folder / "key.pem"},
                               std::chrono::system_clock::now())
            .value();
    TlsContexts contexts(store.get(), {.only_http2 = true});
    const Owned client = connect(contexts.current()->native_handle());
    ASSERT_EQ(SSL_write(client_tls.get(), preface.data(), static_cast<int>(preface.size())), 24);
    const Owned grpc = grpc_end();
    EXPECT_EQ(grpc.read(preface.size()), preface);
    const std::string payload(3'000'000, 'q');
    std::jthread writer([&] { EXPECT_TRUE(grpc.write(payload)); });
    std::string got, part(1 << 16, '\0');
    while (got.size() < payload.size()) {
        const int n = SSL_read(client_tls.get(), part.data(), static_cast<int>(part.size()));
        ASSERT_GT(n, 0);
        got.append(part.data(), static_cast<std::size_t>(n));
    }
    EXPECT_EQ(got, payload);
}

TEST_F(ConnectionRelayTest, stop_closes_all_connections) {
    const Owned client = connect();
    client.write(preface);
    const Owned grpc = grpc_end();
    relay.stop(50ms);
    EXPECT_TRUE(client.is_closed());
    grpc.read(preface.size());
    EXPECT_TRUE(grpc.is_closed());
    EXPECT_EQ(table.size(), 0u);
}

}  // namespace
}  // namespace jostle::server
