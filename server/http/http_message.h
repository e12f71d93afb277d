// SPDX-License-Identifier: MIT
//
// An HTTP request and its response as plain data, so that routes can be tested without sockets, and
// only http_server depends on the HTTP library.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace jostle::server {

struct HttpRequest {
    std::string method;  // "GET", "POST", ...
    // Path and query as sent, not decoded; "*" in OPTIONS requests about the server. The scheme and
    // authority of an absolute URI are removed.
    std::string target;
    std::string host;    // the Host header, or the authority of an absolute URI
    std::string origin;  // the Origin header; empty if the request is not from a browser page
    std::string content_type;
    std::string if_none_match;
    std::string accept_encoding;
    std::string authorization;
    std::string grpc_timeout;      // of gRPC-Web: "5S", "100m"
    std::string requested_method;  // Access-Control-Request-Method: this is a preflight request
    std::string address;           // of the client, without the port
    std::string certificate;       // subject of a client certificate verified by TLS; empty: none
    std::string body;
};

using HttpHeaders = std::vector<std::pair<std::string, std::string>>;

struct HttpResponse {
    int status = 200;
    std::string content_type = "text/plain; charset=utf-8";
    HttpHeaders headers;
    std::string body;
};

// A text response that must not be cached.
inline HttpResponse plain_text(int status, std::string body) {
    return {.status = status, .headers = {{"Cache-Control", "no-store"}}, .body = std::move(body)};
}

// Response of /healthz and /readyz. The functions return why the server is not healthy or not
// ready.
inline HttpResponse health_response(
    std::string_view path, const std::function<std::optional<std::string>()>& failure_reason,
    const std::function<std::optional<std::string>()>& not_ready_reason) {
    if (const auto failure = failure_reason()) return plain_text(503, *failure + "\n");
    if (path == "/healthz") return plain_text(200, "ok\n");
    const auto not_ready = not_ready_reason();
    return not_ready ? plain_text(503, *not_ready + "\n") : plain_text(200, "ready\n");
}

// The part of a target before the '?'.
inline std::string_view path_of(std::string_view target) {
    return target.substr(0, target.find_first_of("?#"));
}

// The thread that handles a request: the port's own thread, or a worker for queries or for changes
// of worlds.
enum class HttpWork { immediate, query, mutation };

// The request handler of an HTTP port. The port reads and frames requests and is independent of
// paths: the viewer port uses HttpRoutes, the admin port AdminRoutes.
class HttpHandler {
public:
    virtual ~HttpHandler() = default;

    // Any thread; may block while a world is built or a profile is recorded.
    virtual HttpResponse handle(const HttpRequest& request) const = 0;
    virtual HttpWork work_of(const HttpRequest& request) const = 0;
    // Whether the request may have a body as large as a scene.
    virtual bool accepts_large_body(const HttpRequest& request) const = 0;
    // Whether a WebSocket upgrade with this request may become a play session.
    virtual bool accepts_players(const HttpRequest& request) const = 0;
    // Why a browser page may not send this request; empty: it is allowed, or not from a browser
    // page.
    virtual std::optional<std::string> cross_origin_refusal(const HttpRequest& request) const = 0;
    // Headers of every response to a page of this origin (CORS), also of errors; `origin` may be
    // empty.
    virtual HttpHeaders cors_headers(std::string_view origin, std::string_view host) const = 0;
};

}  // namespace jostle::server
