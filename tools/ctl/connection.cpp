// SPDX-License-Identifier: MIT
#include "tools/ctl/connection.h"

#include <grpcpp/create_channel.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "clients/cpp/core/src/security.h"
#include "jostle/grpc_status/grpc_status.h"

namespace jostle::ctl {

namespace {

constexpr int message_bytes_max = 128 << 20;  // for exported worlds and traces
constexpr std::size_t file_bytes_max = 64u << 20;

}  // namespace

Result<std::string> read_file(const std::string& path) {
    const auto failed = [&](const char* reason) {
        return invalid_argument("cannot read " + path + ": " + reason);
    };
    std::error_code ignored;
    std::ifstream file;
    if (path != "-") {
        file.open(path, std::ios::binary);
        if (!file || std::filesystem::is_directory(path, ignored))
            return failed("the file does not exist or is not readable");
        if (std::filesystem::is_regular_file(path, ignored) &&
            std::filesystem::file_size(path, ignored) > file_bytes_max)
            return failed("the file is larger than 64 MiB");
    }
    std::istream& in = path == "-" ? std::cin : file;
    std::string text((std::istreambuf_iterator<char>(in)), {});
    if (in.bad()) return failed("read error");
    return text;
}

Status write_file(const std::string& path, const std::string& content) {
    if (path == "-") {
        const bool good = std::fwrite(content.data(), 1, content.size(), stdout) == content.size();
        return good && std::fflush(stdout) == 0
                   ? Status()
                   : invalid_argument("cannot write to standard output: the reader has closed it");
    }
    std::ofstream out(path, std::ios::binary);
    out << content;
    out.close();
    if (out) return {};
    return invalid_argument("cannot write " + path +
                            ": check that the directory exists, is writable and has free space");
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
    connection.queries_ = v1::QueryService::NewStub(channel);
    return connection;
}

void Connection::prepare(grpc::ClientContext& context, std::chrono::seconds timeout) const {
    context.set_deadline(std::chrono::system_clock::now() + timeout);
    client::attach_token(context, security_);
}

Error Connection::describe_error(const grpc::Status& status, const char* role) const {
    const Error error = from_grpc(status).error();
    switch (status.error_code()) {
        case grpc::StatusCode::UNAVAILABLE:
            return {error.code,
                    "cannot reach " + server_ + ": " + error.message +
                        "\n  Check that jostle-server is running and that --server is its gRPC "
                        "address." +
                        (security_.tls
                             ? " Check that the server uses TLS and that --ca contains its CA."
                             : " If the server uses TLS, use --tls or --ca FILE.")};
        case grpc::StatusCode::RESOURCE_EXHAUSTED:
            if (error.message.find("larger than max") == std::string::npos) return error;
            return {error.code,
                    error.message + "\n  Raise the setting scene.request_bytes_max of the server."};
        case grpc::StatusCode::UNAUTHENTICATED:
            return {error.code, error.message + "\n  Use --token-file FILE with the token of " +
                                    role + " or of a higher role."};
        case grpc::StatusCode::UNIMPLEMENTED:
            return {error.code, server_ +
                                    " does not support this method: it is an older server or not "
                                    "a jostle-server"};
        case grpc::StatusCode::DEADLINE_EXCEEDED:
            return {error.code, server_ + " did not respond in time: " + error.message};
        default:
            return error;
    }
}

}  // namespace jostle::ctl
