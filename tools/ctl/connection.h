// SPDX-License-Identifier: MIT
//
// How jostlectl reaches a server: in the clear on this machine, by TLS elsewhere, with a token and
// a certificate of its own where those are wanted. One thread.
#pragma once

#include <grpcpp/client_context.h>

#include <chrono>
#include <memory>
#include <string>

#include "jostle/base/result.h"
#include "jostle/client/security.h"
#include "jostle/v1/admin.grpc.pb.h"
#include "jostle/v1/world.grpc.pb.h"

namespace jostle::ctl {

// As the flags say.
struct ConnectionFlags {
    std::string server = "127.0.0.1:50051";
    client::SecurityFiles files;
};

class Connection {
public:
    // Reads the files. Nothing is sent before the first call.
    static Result<Connection> open(const ConnectionFlags& flags);

    // One call and its deadline: `Answer answer = *connection.ask(...)`. An error says what to do.
    template <class Stub, class Request, class Response>
    Result<Response> call(grpc::Status (Stub::*method)(grpc::ClientContext*, const Request&,
                                                       Response*),
                          const Request& request, std::chrono::seconds timeout = default_timeout) {
        grpc::ClientContext context;
        prepare(context, timeout);
        Response response;
        const grpc::Status status = (stub<Stub>().*method)(&context, request, &response);
        if (!status.ok()) return describe_error(status);
        return response;
    }
    static constexpr auto default_timeout = std::chrono::seconds(10);

private:
    void prepare(grpc::ClientContext& context, std::chrono::seconds timeout) const;
    Error describe_error(const grpc::Status& status) const;
    template <class Stub>
    Stub& stub() const;

    std::string server_;
    client::Security security_;
    std::shared_ptr<v1::AdminService::Stub> admin_;
    std::shared_ptr<v1::WorldService::Stub> worlds_;
};

template <>
inline v1::AdminService::Stub& Connection::stub() const {
    return *admin_;
}
template <>
inline v1::WorldService::Stub& Connection::stub() const {
    return *worlds_;
}

// A file as it is; "-" is standard input or output. Errors name the file.
Result<std::string> read_file(const std::string& path);
Status write_file(const std::string& path, const std::string& content);

}  // namespace jostle::ctl
