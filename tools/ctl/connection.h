// SPDX-License-Identifier: MIT
//
// jostlectl's connection to a server: without TLS on loopback, with TLS elsewhere, with an optional
// token and client certificate. One thread.
#pragma once

#include <grpcpp/client_context.h>

#include <chrono>
#include <memory>
#include <string>

#include "jostle/base/result.h"
#include "jostle/client/security.h"
#include "jostle/v1/admin.grpc.pb.h"
#include "jostle/v1/query.grpc.pb.h"
#include "jostle/v1/world.grpc.pb.h"

namespace jostle::ctl {

// Values of the flags.
struct ConnectionFlags {
    std::string server = "127.0.0.1:50051";
    client::SecurityFiles files;
};

class Connection {
public:
    // Reads the certificate and token files. Nothing is sent before the first call.
    static Result<Connection> open(const ConnectionFlags& flags);

    // Calls a method with a deadline: `Response response = *connection.call(...)`. Errors include
    // the remedy.
    template <class Stub, class Request, class Response>
    Result<Response> call(grpc::Status (Stub::*method)(grpc::ClientContext*, const Request&,
                                                       Response*),
                          const Request& request, std::chrono::seconds timeout = default_timeout) {
        grpc::ClientContext context;
        prepare(context, timeout);
        Response response;
        const grpc::Status status = (stub<Stub>().*method)(&context, request, &response);
        if (!status.ok()) return describe_error(status, role_of<Request>());
        return response;
    }
    static constexpr auto default_timeout = std::chrono::seconds(10);

private:
    void prepare(grpc::ClientContext& context, std::chrono::seconds timeout) const;
    // Role that a call requires (server/auth/access_table.cpp).
    template <class Request>
    static constexpr const char* role_of() {
        if (std::is_same_v<Request, v1::ListWorldsRequest> ||
            std::is_same_v<Request, v1::InspectRequest>)
            return "a viewer";
        if (std::is_same_v<Request, v1::CreateWorldRequest> ||
            std::is_same_v<Request, v1::DeleteWorldRequest>)
            return "a director";
        return "an admin";
    }
    Error describe_error(const grpc::Status& status, const char* role) const;
    template <class Stub>
    Stub& stub() const;

    std::string server_;
    client::Security security_;
    std::shared_ptr<v1::AdminService::Stub> admin_;
    std::shared_ptr<v1::WorldService::Stub> worlds_;
    std::shared_ptr<v1::QueryService::Stub> queries_;
};

template <>
inline v1::AdminService::Stub& Connection::stub() const {
    return *admin_;
}
template <>
inline v1::WorldService::Stub& Connection::stub() const {
    return *worlds_;
}

template <>
inline v1::QueryService::Stub& Connection::stub() const {
    return *queries_;
}

// Reads or writes a file; "-" is standard input or output. Errors name the file.
Result<std::string> read_file(const std::string& path);
Status write_file(const std::string& path, const std::string& content);

}  // namespace jostle::ctl
