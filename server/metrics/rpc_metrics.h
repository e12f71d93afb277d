// SPDX-License-Identifier: MIT
//
// Counts gRPC calls by service, method and code. Only methods that were added get
// series of their own: a stranger may call what there is not, and must not make a series of it.
// Any thread.
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <string_view>

#include "server/metrics/metrics.h"

namespace jostle::server {

class RpcMetrics {
public:
    explicit RpcMetrics(Metrics& metrics);

    // A method that is served, by its path: "/jostle.v1.WorldService/ListWorlds". Of streams the
    // time is not measured: they last as long as a client stays.
    enum class Kind { unary, streaming };
    void add(const std::string& path, Kind kind);

    // `path` as gRPC gives it; `code`: gRPC's number; `seconds` of a unary call.
    void handled(std::string_view path, int code, double seconds);

private:
    struct Method {
        std::string service, name;
        prometheus::Histogram* seconds = nullptr;
        std::map<int, prometheus::Counter*> by_code;
    };

    prometheus::Counter& counter_of(Method& method, int code);

    Metrics& metrics_;
    std::mutex mutex_;
    std::map<std::string, Method, std::less<>> methods_;  // by path; "": all unknown ones
};

}  // namespace jostle::server
