// SPDX-License-Identifier: MIT
//
// gRPC-Web: the unary calls of gRPC services over HTTP/1.1, for pages that use generated gRPC-Web
// clients. A call has the same handler, authorization, limits and metrics as over gRPC.
//
// Streams are not offered. gRPC-Web has no client streaming, but the play stream needs it for
// acknowledgements and inputs; over WebSocket, /play carries the same messages. Any thread may call
// handle().
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "server/http/http_message.h"
#include "server/metrics/rpc_metrics.h"
#include "server/services/call_method.h"

namespace jostle::server {

class GrpcWebRoutes final : public HttpHandler {
public:
    // Only quick calls, queries and changes of worlds: other methods occupy a thread or stay open.
    // The authorizer and the metrics outlive the routes; null metrics: no counting.
    GrpcWebRoutes(std::vector<CallMethod> methods, Authorizer& authorizer, RpcMetrics* metrics);

    HttpResponse handle(const HttpRequest& request) const override;
    HttpWork work_of(const HttpRequest& request) const override;
    bool accepts_large_body(const HttpRequest& request) const override;
    bool accepts_players(const HttpRequest&) const override { return false; }
    // The routes that contain these check origins.
    std::optional<std::string> cross_origin_refusal(const HttpRequest&) const override {
        return std::nullopt;
    }
    HttpHeaders cors_headers(std::string_view, std::string_view) const override { return {}; }

private:
    const CallMethod* find(const HttpRequest& request) const;
    Status run(const CallMethod& method, const HttpRequest& request, std::string_view message,
               ResponseBytes& response) const;

    std::map<std::string, CallMethod, std::less<>> methods_;  // by path
    Authorizer& authorizer_;
    RpcMetrics* const metrics_;
};

}  // namespace jostle::server
