// SPDX-License-Identifier: MIT
//
// What the operators' port answers: metrics, health, and profiles. Knows nothing of sockets. Any
// thread may call answer(); a profile holds it up for as long as it was asked to last, so the port
// calls that on its worker.
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "server/http/http_handler.h"
#include "server/metrics/metrics.h"
#include "server/services/admin_control.h"

namespace jostle::server {

struct AdminRouteSettings {
    std::vector<std::string> allowed_hosts;  // names of this server, for what is more than to read
    std::function<std::optional<std::string>()> not_ready_reason;  // nothing: it is
    // What is wrong with the server; nothing: it is well.
    std::function<std::optional<std::string>()> failure_reason;
    // Before metrics are read: brings what is counted elsewhere up to date. May be empty.
    std::function<void()> refresh;
};

class AdminRoutes final : public HttpHandler {
public:
    // Both outlive the routes.
    AdminRoutes(AdminControl& control, Metrics& metrics, AdminRouteSettings settings)
        : control_(control), metrics_(metrics), settings_(std::move(settings)) {}

    HttpResponse handle(const HttpRequest& request) const override;
    HttpWork work_of(const HttpRequest& request) const override;
    bool accepts_large_body(const HttpRequest&) const override { return false; }
    bool accepts_players(const HttpRequest&) const override { return false; }
    std::optional<std::string> cross_origin_refusal(const HttpRequest& request) const override;

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
