// SPDX-License-Identifier: MIT
//
// The paths of the admin port: metrics, health and profiles. Independent of sockets. Any thread may
// call handle(); a profile blocks for its duration, so the port runs it on a worker thread.
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "server/http/http_message.h"
#include "server/metrics/metrics.h"
#include "server/services/admin_control.h"

namespace jostle::server {

struct AdminRouteSettings {
    std::vector<std::string> allowed_hosts;  // host names of this server, checked for profiles
    std::function<std::optional<std::string>()> not_ready_reason;  // empty: ready
    // The fault of the server; empty: healthy.
    std::function<std::optional<std::string>()> failure_reason;
    // Called before metrics are read, to update values counted elsewhere. May be empty.
    std::function<void()> refresh;
};

class AdminRoutes final : public HttpHandler {
public:
    // Both must outlive the routes.
    AdminRoutes(AdminControl& control, Metrics& metrics, AdminRouteSettings settings)
        : control_(control), metrics_(metrics), settings_(std::move(settings)) {}

    HttpResponse handle(const HttpRequest& request) const override;
    HttpWork work_of(const HttpRequest& request) const override;
    bool accepts_large_body(const HttpRequest&) const override { return false; }
    bool accepts_players(const HttpRequest&) const override { return false; }
    std::optional<std::string> cross_origin_refusal(const HttpRequest& request) const override;
    HttpHeaders cors_headers(std::string_view, std::string_view) const override { return {}; }

private:
    HttpResponse health(std::string_view path) const;
    HttpResponse metrics() const;
    Status authorize(const HttpRequest& request, const std::string& world) const;
    HttpResponse profile(const HttpRequest& request) const;

    AdminControl& control_;
    Metrics& metrics_;
    AdminRouteSettings settings_;
    mutable std::mutex metrics_mutex_;
};

}  // namespace jostle::server
