// SPDX-License-Identifier: MIT
#include "ctl/connection.h"

#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "status/grpc_status.h"

namespace jostle::ctl {

namespace {

constexpr int message_bytes_max = 128 << 20;  // an exported world, a trace
constexpr std::size_t file_bytes_max = 64u << 20;

bool is_this_machine(const std::string& server) {
    const std::string host = server.substr(0, server.rfind(':'));
    return host == "localhost" || host.starts_with("127.") || host == "[::1]";
}

// Without the line end that an editor leaves.
std::string trimmed(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r' || text.back() == ' '))
        text.pop_back();
    return text;
}

Error invalid(std::string message) {
    return {ErrorCode::invalid_argument, std::move(message)};
}

// Reads a PEM file into `out`; no path: nothing.
Status read_pem(const std::string& path, grpc::string& out) {
    if (path.empty()) return {};
    const auto text = read_file(path);
    if (!text.ok()) return text.error();
    if (text->find("-----BEGIN ") == std::string::npos)
        return invalid(path + " is no PEM file: it has no line -----BEGIN ...-----");
    out = *text;
    return {};
}

}  // namespace

Result<std::string> read_file(const std::string& path) {
    const auto failed = [&](const char* why) {
        return invalid("cannot read " + path + ": " + why);
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
                   : invalid("cannot write to standard output: nobody reads it any more");
    }
    std::ofstream out(path, std::ios::binary);
    out << content;
    out.close();
    if (out) return {};
    return invalid("cannot write " + path + ": the folder is not there or not yours, or full");
}

Result<Connection> Connection::open(const ConnectionFlags& flags) {
    Connection connection;
    connection.server_ = flags.server;
    const bool own_certificate = !flags.certificate.empty() || !flags.key.empty();
    if (own_certificate && (flags.certificate.empty() || flags.key.empty()))
        return invalid("--cert and --key go together: the certificate and its private key");
    connection.encrypted_ = flags.tls || own_certificate || !flags.ca.empty();
    if (!flags.token_file.empty()) {
        const auto token = read_file(flags.token_file);
        if (!token.ok()) return token.error();
        connection.token_ = trimmed(*token);
        if (connection.token_.empty()) return invalid(flags.token_file + " holds no token");
        if (!connection.encrypted_ && !is_this_machine(flags.server))
            return invalid(
                "without TLS everybody on the way could read the token; give --tls, or "
                "--ca FILE for an authority of your own");
    }
    std::shared_ptr<grpc::ChannelCredentials> credentials = grpc::InsecureChannelCredentials();
    if (connection.encrypted_) {
        grpc::SslCredentialsOptions options;
        if (Status s = read_pem(flags.ca, options.pem_root_certs); !s.ok()) return s.error();
        if (Status s = read_pem(flags.certificate, options.pem_cert_chain); !s.ok())
            return s.error();
        if (Status s = read_pem(flags.key, options.pem_private_key); !s.ok()) return s.error();
        credentials = grpc::SslCredentials(options);
    }
    grpc::ChannelArguments arguments;
    arguments.SetMaxReceiveMessageSize(message_bytes_max);
    const auto channel = grpc::CreateCustomChannel(flags.server, credentials, arguments);
    connection.admin_ = v1::AdminService::NewStub(channel);
    connection.worlds_ = v1::WorldService::NewStub(channel);
    return connection;
}

void Connection::prepare(grpc::ClientContext& context, std::chrono::seconds patience) const {
    context.set_deadline(std::chrono::system_clock::now() + patience);
    if (!token_.empty()) context.AddMetadata("authorization", "Bearer " + token_);
}

Error Connection::explained(const grpc::Status& status) const {
    const Error error = from_grpc(status).error();
    switch (status.error_code()) {
        case grpc::StatusCode::UNAVAILABLE:
            return {error.code,
                    "cannot reach " + server_ + ": " + error.message +
                        "\n  Is jostle-server running there, and is this its gRPC address "
                        "(--server HOST:PORT)?" +
                        (encrypted_ ? " Does it speak TLS, and does --ca know its authority?"
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
