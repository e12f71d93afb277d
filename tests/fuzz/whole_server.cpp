// SPDX-License-Identifier: MIT
//
// A complete server with its threads: listeners for gRPC, HTTP, operators and datagrams, and worlds
// that are saved in a temporary database. An input is the traffic of up to four hostile connections
// over the loopback device, each from an address of its own. It leaves the server alive: two honest
// players, one per transport, keep receiving snapshots that they can decode.
//
// The server lives as long as the process and the connections of the last 600 inputs stay open, so
// a report can depend on earlier inputs. If JOSTLE_FUZZ_RECENT names a folder, the last 64 inputs
// are in it, to be replayed in order of time.
//
// An input is a list of records (reader.h). The kind is an action (modulo 8), and the connection
// that it concerns (the next two bits). Connections 0 and 1 go to the gRPC port, 2 and 3 to HTTP.
#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sanitizer/lsan_interface.h>
#include <spdlog/spdlog.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>

#include "jostle/http2/frame.h"
#include "jostle/v1/play.pb.h"
#include "server/app/server_app.h"
#include "tests/fuzz/mutate_message.h"
#include "tests/fuzz/reader.h"
#include "tests/fuzz/target.h"
#include "tests/system/player.h"

namespace jostle::fuzz {

namespace {

using namespace std::chrono_literals;
using SteadyClock = std::chrono::steady_clock;

constexpr std::uint8_t kinds = 8;
constexpr std::size_t connections_max = 4, records_max = 64;
// Inputs whose connections are open, up to four each. At 100 inputs per second they stay open for
// longer than the server waits for the end of a connection.
constexpr std::size_t attacks_max = 600;
constexpr std::size_t recent_max = 64;
// Honest players wait for a snapshot at most this long. The server sends at least four per second,
// and the machine may be busy.
constexpr auto patience = 10s;
// How often, in inputs, the players acknowledge and are checked.
constexpr std::uint64_t check_period = 8;

constexpr std::array<std::string_view, 9> methods = {
    "/jostle.v1.WorldService/ListWorlds",    "/jostle.v1.WorldService/GetWorld",
    "/jostle.v1.WorldService/CreateWorld",   "/jostle.v1.WorldService/JoinWorld",
    "/jostle.v1.QueryService/CastRays",      "/jostle.v1.QueryService/Overlap",
    "/jostle.v1.QueryService/ClosestPoints", "/jostle.v1.AdminService/ListClients",
    "/grpc.health.v1.Health/Check"};
constexpr std::array<std::string_view, 6> routes = {
    "GET /api/worlds",         "POST /api/worlds",      "POST /api/query/CastRays",
    "POST /api/query/Overlap", "POST /api/worlds/join", "GET /healthz"};

server::Config server_config(const std::string& database) {
    server::Config config;
    config.listen = config.http = config.admin = config.datagrams.listen = "127.0.0.1:0";
    config.web_root = WEB_ROOT;
    config.scenes = {"stack"};
    config.auth.anonymous_role = "player";
    config.auth.audit_log = "/dev/null";
    config.persistence.database = database;
    config.persistence.durability = "process";
    config.persistence.checkpoint_interval_seconds = 5;
    config.world.bodies_max = 200;
    config.client.resume_timeout_seconds = 1;
    // Hostile clients acknowledge nothing, and hundreds of them are connected.
    config.stream.ack_window_max_ms = 200;
    // The instrumented solver is slow, and other programs may run.
    config.tick.step_seconds_max = 30;
    expect(server::check(config).ok(), "the configuration is valid");
    return config;
}

// One server for all inputs, with two honest players.
class Victim {
public:
    Victim() {
        spdlog::set_level(spdlog::level::off);
        std::string folder = std::filesystem::temp_directory_path() / "jostle-fuzz-XXXXXX";
        expect(mkdtemp(folder.data()) != nullptr, "a temporary folder can be made");
        folder_ = folder;
        auto app = server::ServerApp::start(server_config(folder_ / "worlds.db"),
                                            {.version = "fuzz", .handle_signals = false});
        expect(app.ok(), app.ok() ? "" : app.error().message);
        app_ = *std::move(app);
        players_ = {test::grpc_player("127.0.0.1:" + std::to_string(ports().grpc)),
                    test::websocket_player(ports().http)};
        for (const auto& player : players_) {
            player->hello();
            expect(
                player->wait_until([](const test::PlayState& s) { return s.snapshots > 0; }, 60s),
                "an honest player receives a snapshot");
        }
        served_.fill({.at = SteadyClock::now()});
    }

    const server::Ports& ports() const { return app_->ports(); }
    const std::filesystem::path& folder() const { return folder_; }

    // Acknowledges and checks the snapshots of the honest players.
    void check_players() {
        for (std::size_t i = 0; i < players_.size(); i++) {
            test::Player& player = *players_[i];
            if (const auto how = player.end())
                expect(false, "the stream of an honest player ended: " + *how);
            const auto [snapshots, frame, violations, first] =
                player.with_state([](const test::PlayState& s) {
                    return std::tuple(s.snapshots, s.newest_frame, s.violations, s.first_violation);
                });
            expect(violations == 0, first);
            v1::ClientMessage ack;
            ack.mutable_ack()->set_frame(frame);
            player.send(ack);
            if (snapshots != served_[i].snapshots) served_[i] = {snapshots, SteadyClock::now()};
            expect(SteadyClock::now() - served_[i].at < patience,
                   "an honest player receives snapshots");
        }
    }

private:
    struct Served {
        int snapshots = 0;
        SteadyClock::time_point at;
    };

    std::filesystem::path folder_;
    std::unique_ptr<server::ServerApp> app_;
    std::array<std::unique_ptr<test::Player>, 2> players_;
    std::array<Served, 2> served_;
};

// Never destroyed: the process ends while the threads of the server run.
Victim& victim() {
    static Victim& instance = *new Victim;
    return instance;
}

// Each connection has an address of its own, because the server penalizes addresses.
in_addr next_address() {
    static std::uint32_t next = static_cast<std::uint32_t>(getpid()) * 7919;
    next = (next + 1) % 0xfffff0;
    return {.s_addr = htonl(0x7f000000u + 0x10 + next)};
}

void append_literal(std::string& block, std::string_view name, std::string_view value) {
    block.push_back(0);
    block.push_back(static_cast<char>(name.size()));
    block += name;
    block.push_back(static_cast<char>(value.size()));
    block += value;
}

void append_frame(std::string& out, http2::FrameType type, std::uint8_t flags, std::uint32_t stream,
                  std::string_view payload) {
    http2::put_frame_header(out, {.length = static_cast<std::uint32_t>(payload.size()),
                                  .type = type,
                                  .flags = flags,
                                  .stream = stream});
    out += payload;
}

class HostileConnection {
public:
    explicit HostileConnection(bool grpc) : grpc_(grpc) {
        socket_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
        expect(socket_ >= 0, "a socket can be opened");
        sockaddr_in from{.sin_family = AF_INET, .sin_port = 0, .sin_addr = next_address()};
        const int on = 1;
        setsockopt(socket_, IPPROTO_IP, IP_BIND_ADDRESS_NO_PORT, &on, sizeof on);
        setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
        bind(socket_, reinterpret_cast<const sockaddr*>(&from), sizeof from);
        const auto& ports = victim().ports();
        connect(static_cast<std::uint16_t>(grpc ? ports.grpc : ports.http));
    }
    ~HostileConnection() { close(); }
    HostileConnection(const HostileConnection&) = delete;
    HostileConnection& operator=(const HostileConnection&) = delete;

    int descriptor() const { return socket_; }

    void send_message(std::string_view message) {
        if (!grpc_) {
            begin_websocket();
            return send_websocket(0x82, message);
        }
        begin_http2();
        std::string out;
        if (!playing_)
            append_call(out, "/jostle.v1.PlayService/Play", play_stream_ = next_stream());
        playing_ = true;
        append_data(out, play_stream_, message, false);
        queue(out);
    }
    void call(std::uint8_t number, std::string_view body) {
        if (!grpc_) {
            const std::string_view route = routes[number % routes.size()];
            return queue(std::string(route) + " HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Type: " +
                         "application/json\r\nContent-Length: " + std::to_string(body.size()) +
                         "\r\n\r\n" + std::string(body));
        }
        begin_http2();
        std::string out;
        const std::uint32_t stream = next_stream();
        append_call(out, methods[number % methods.size()], stream);
        append_data(out, stream, body, true);
        queue(out);
    }
    // A frame with a valid length: of HTTP/2 type, flags, stream, payload; of WebSocket opcode.
    void send_frame(Bytes bytes) {
        Reader in(bytes);
        if (!grpc_) {
            begin_websocket();
            const auto opcode = in.number<std::uint8_t>();
            return send_websocket(opcode, text_of(in.rest()));
        }
        begin_http2();
        const auto type = http2::FrameType{in.number<std::uint8_t>()};
        const auto flags = in.number<std::uint8_t>();
        const std::uint32_t stream = in.number<std::uint8_t>();
        std::string out;
        append_frame(out, type, flags, stream, text_of(in.rest()));
        queue(out);
    }
    void queue(std::string_view bytes) { outgoing_ += bytes; }

    // Sends what fits into the buffers; a hostile client does not wait for room.
    void flush() {
        if (socket_ >= 0 && !outgoing_.empty()) {
            static_cast<void>(
                ::send(socket_, outgoing_.data(), outgoing_.size(), MSG_NOSIGNAL | MSG_DONTWAIT));
        }
        outgoing_.clear();
    }
    // Returns false at the end of the stream.
    bool read() {
        std::array<char, 65536> bytes;
        const ssize_t got = recv(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT);
        return got > 0 || (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK));
    }
    void half_close() {
        flush();
        if (socket_ >= 0) shutdown(socket_, SHUT_WR);
    }
    void reset() {
        flush();
        const linger now{.l_onoff = 1, .l_linger = 0};
        if (socket_ >= 0) setsockopt(socket_, SOL_SOCKET, SO_LINGER, &now, sizeof now);
        close();
    }
    void close() {
        if (socket_ >= 0) ::close(socket_);
        socket_ = -1;
    }

private:
    void connect(std::uint16_t port) {
        sockaddr_in to{
            .sin_family = AF_INET, .sin_port = htons(port), .sin_addr = {htonl(0x7f000001)}};
        if (::connect(socket_, reinterpret_cast<const sockaddr*>(&to), sizeof to) != 0) close();
    }
    std::uint32_t next_stream() { return std::exchange(next_stream_, next_stream_ + 2); }
    void begin_http2() {
        if (std::exchange(begun_, true)) return;
        queue(http2::preface);
        std::string out;
        append_frame(out, http2::FrameType::settings, 0, 0, {});
        queue(out);
    }
    void begin_websocket() {
        if (std::exchange(begun_, true)) return;
        queue(
            "GET /play HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
            "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n");
        flush();
        // Browsers wait for the response.
        if (pollfd waiting{.fd = socket_, .events = POLLIN, .revents = 0}; socket_ >= 0)
            poll(&waiting, 1, 200);
    }
    void append_call(std::string& out, std::string_view path, std::uint32_t stream) {
        std::string block;
        append_literal(block, ":method", "POST");
        append_literal(block, ":scheme", "http");
        append_literal(block, ":path", path);
        append_literal(block, ":authority", "127.0.0.1");
        append_literal(block, "content-type", "application/grpc");
        append_literal(block, "te", "trailers");
        append_frame(out, http2::FrameType::headers, http2::flags::end_headers, stream, block);
    }
    void append_data(std::string& out, std::uint32_t stream, std::string_view message, bool end) {
        std::string data;
        data.push_back(0);
        http2::put_big_endian(data, message.size(), 4);
        data += message;
        for (std::string_view rest = data; !rest.empty();) {
            const std::string_view piece = rest.substr(0, http2::frame_bytes_max);
            rest.remove_prefix(piece.size());
            append_frame(out, http2::FrameType::data,
                         end && rest.empty() ? http2::flags::end_stream : 0, stream, piece);
        }
    }
    // Masked with zeros, which changes no byte.
    void send_websocket(std::uint8_t opcode, std::string_view payload) {
        std::string out(1, static_cast<char>(opcode));
        if (payload.size() < 126) {
            out.push_back(static_cast<char>(0x80 | payload.size()));
        } else {
            out.push_back(static_cast<char>(0x80 | 126));
            http2::put_big_endian(out, payload.size(), 2);
        }
        out.append(4, '\0');
        out += payload;
        queue(out);
    }

    const bool grpc_;
    int socket_ = -1;
    bool begun_ = false, playing_ = false;
    std::uint32_t next_stream_ = 1, play_stream_ = 0;
    std::string outgoing_;
};

class Attack {
public:
    void handle(const Record& record) {
        const std::size_t number = record.kind / kinds % connections_max;
        Reader in(record.bytes);
        switch (record.kind % kinds) {
            case 0:
                return connection(number).send_message(text_of(record.bytes));
            case 1:
                return connection(number).queue(text_of(record.bytes));
            case 2:
                return pump(std::chrono::milliseconds(1 + in.number<std::uint8_t>() % 4));
            case 3: {
                const auto method = in.number<std::uint8_t>();
                return connection(number).call(method, text_of(in.rest()));
            }
            case 4:
                return connection(number).send_frame(record.bytes);
            case 5:
                return send_datagram(record.bytes);
            case 6:
                return connection(number).half_close();
            case 7:
                if (connections_[number]) connections_[number]->reset();
                connections_[number].reset();
                return;
        }
    }

    // Sends the rest and reads until the server is silent, which shows that it has taken the bytes.
    void end() { pump(1ms); }

private:
    HostileConnection& connection(std::size_t number) {
        if (!connections_[number]) connections_[number].emplace(number < connections_max / 2);
        return *connections_[number];
    }

    // Sends, and reads until nothing has arrived for `silence`, at most ten times.
    void pump(std::chrono::milliseconds silence) {
        std::array<pollfd, connections_max> polled{};
        for (std::size_t i = 0; i < connections_max; i++) {
            if (connections_[i]) connections_[i]->flush();
            polled[i] = {.fd = connections_[i] ? connections_[i]->descriptor() : -1,
                         .events = POLLIN,
                         .revents = 0};
        }
        for (int round = 0; round < 10; round++) {
            if (poll(polled.data(), polled.size(), static_cast<int>(silence.count())) <= 0) return;
            bool open = false;
            for (std::size_t i = 0; i < connections_max; i++) {
                if (polled[i].revents == 0) continue;
                if (connections_[i]->read())
                    open = true;
                else
                    polled[i].fd = -1;
            }
            if (!open) return;
        }
    }

    static void send_datagram(Bytes bytes) {
        static const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
        const sockaddr_in to{
            .sin_family = AF_INET,
            .sin_port = htons(static_cast<std::uint16_t>(victim().ports().datagrams)),
            .sin_addr = {htonl(0x7f000001)}};
        static_cast<void>(sendto(socket, bytes.data(), bytes.size(), MSG_DONTWAIT,
                                 reinterpret_cast<const sockaddr*>(&to), sizeof to));
    }

    std::array<std::optional<HostileConnection>, connections_max> connections_;
};

void keep_recent(Bytes input, std::uint64_t number) {
    static const char* const folder = std::getenv("JOSTLE_FUZZ_RECENT");
    if (folder == nullptr) return;
    std::ofstream(std::filesystem::path(folder) / std::to_string(number % recent_max),
                  std::ios::binary)
        .write(reinterpret_cast<const char*>(input.data()),
               static_cast<std::streamsize>(input.size()));
}

// Looks for leaks and ends the process without destroying what the threads of the server use.
void end_process() {
    std::error_code ignored;
    std::filesystem::remove_all(victim().folder(), ignored);
    _exit(__lsan_do_recoverable_leak_check() != 0 ? 1 : 0);
}

}  // namespace

void run(Bytes input) {
    static std::uint64_t number = 0;
    if (number == 0) {
        victim();
        expect(std::atexit(end_process) == 0, "a function for the end can be registered");
    }
    keep_recent(input, number);
    // The connections stay open during later inputs, so that the server has many at once.
    static std::array<std::unique_ptr<Attack>, attacks_max> attacks;
    std::unique_ptr<Attack>& attack = attacks[number % attacks_max];
    attack = std::make_unique<Attack>();
    std::size_t records = 0;
    for (Reader in(input); !in.done() && records < records_max; records++)
        attack->handle(take_record(in));
    attack->end();
    if (number++ % check_period == 0) victim().check_players();
}

}  // namespace jostle::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t size_max, unsigned seed) {
    static jostle::v1::ClientMessage message;
    return jostle::fuzz::mutate_records(message, 0, jostle::fuzz::kinds, data, size, size_max,
                                        seed);
}
