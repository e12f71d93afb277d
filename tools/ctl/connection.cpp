// SPDX-License-Identifier: MIT
#include "tools/ctl/connection.h"

#include <grpcpp/create_channel.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "clients/cpp/core/src/credentials.h"
#include "jostle/grpc_status/grpc_status.h"

namespace jostle::ctl {

namespace {

constexpr int message_bytes_max = 128 << 20;  // an exported world, a trace
constexpr std::size_t file_bytes_max = 64u << 20;

}  // namespace

Result<std::string> read_file(const std::string& path) {
    const auto failed = [&](const char* why) {
        return invalid_argument("cannot read " + path + ": " + why);
    };
    std::error_code ignored;
    std::ifstream file;
    if (path != "-") {
        file.open(path, std::ios::binary);
        if (!file || std::filesystem::is_directory(path, ignored))
            return failed("it is not there, or not yours to read");
        if (std::filesystem::is_regular_file(path, ignored) &&
            std::filesystem::file_size(path, ignored) > file_bytes_max)
            return failed("it has more than 64 MiB");
    }
    std::istream& in = path == "-" ? std::cin : file;
    std::string text((std::istreambuf_iterator<char>(in)), {});
    if (in.bad()) return failed("reading ended in the middle");
    return text;
}

Status write_file(const std::string& path, const std::string& content) {
    if (path == "-") {
        const bool good = std::fwrite(content.data(), 1, content.size(), stdout) == content.size();
        return good && std::fflush(stdout) == 0
                   ? Status()
                   : invalid_argument("cannot write to standard output: nobody reads it any more");
    }
    std::ofstream out(path, std::ios::binary);
    out << content;
    out.close();
    if (out) return {};
    return invalid_argument("cannot write " + path +
                            ": the folder is not there or not yours, or full");
}

Result<Connection> Connection::open(const ConnectionFlags& flags) {
    Connection connection;
    connection.server_ = flags.server;
    auto security = client::read_security(flags.files, flags.server);
    if (!security.ok()) return security.error();
    connection.security_ = *std::move(security);
    grpc::ChannelArguments arguments;
    arguments.SetMaxReceiveMessageSize(message_bytes_max);
    const auto channel = grpc::CreateCustomChannel(
        flags.server, client::channel_credentials(connection.security_), arguments);
    connection.admin_ = v1::AdminService::NewStub(channel);
    connection.worlds_ = v1::WorldService::NewStub(channel);
    return connection;
}

void Connection::prepare(grpc::ClientContext& context, std::chrono::seconds timeout) const {
    context.set_deadline(std::chrono::system_clock::now() + timeout);
    client::attach_token(context, security_);
}

Error Connection::describe_error(const grpc::Status& status) const {
    const Error error = from_grpc(status).error();
    switch (status.error_code()) {
        case grpc::StatusCode::UNAVAILABLE:
            return {error.code,
                    "cannot reach " + server_ + ": " + error.message +
                        "\n  Is jostle-server running there, and is this its gRPC address "
                        "(--server HOST:PORT)?" +
                        (security_.tls ? " Does it speak TLS, and does --ca know its authority?"
                                       : " If it speaks TLS, give --tls or --ca FILE.")};
        case grpc::StatusCode::UNAUTHENTICATED:
            return {error.code,
                    error.message + "\n  Give --token-file FILE with an admin's token."};
        case grpc::StatusCode::UNIMPLEMENTED:
            return {error.code, server_ +
                                    " does not know this call: it is an older server, or no "
                                    "jostle-server at all"};
        case grpc::StatusCode::DEADLINE_EXCEEDED:
            return {error.code, server_ + " did not answer in time: " + error.message};
        default:
            return error;
    }
}

}  // namespace jostle::ctl
