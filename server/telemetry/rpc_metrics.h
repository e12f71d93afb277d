// SPDX-License-Identifier: MIT
//
// Counts gRPC calls by service, method and code. Only methods that were named at the start get
// series of their own: a stranger may call what there is not, and must not make a series of it.
// Any thread.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "telemetry/metrics.h"

namespace jostle::server {

// "/jostle.v1.WorldService/ListWorlds" in its two parts.
struct RpcMethod {
    std::string service, method;
};

class RpcMetrics {
public:
    // `unary` and `streaming`: all methods that are served. Of streams the time is not measured:
    // they last as long as a client stays.
    RpcMetrics(Metrics& metrics, const std::vector<RpcMethod>& unary,
               const std::vector<RpcMethod>& streaming);

    // `path` as gRPC gives it; `code`: gRPC's number; `seconds` of a unary call.
    void handled(std::string_view path, int code, double seconds);

private:
    struct Method {
        RpcMethod name;
        prometheus::Histogram* seconds = nullptr;
        std::map<int, prometheus::Counter*> by_code;
    };

    void add(const RpcMethod& name, bool unary);
    prometheus::Counter& counter_of(Method& method, int code);

    Metrics& metrics_;
    std::mutex mutex_;
    std::map<std::string, Method, std::less<>> methods_;  // by path; "": all unknown ones
};

}  // namespace jostle::server
