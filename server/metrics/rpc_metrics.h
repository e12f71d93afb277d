// SPDX-License-Identifier: MIT
//
// Counts gRPC calls by service, method and code. Only methods that were added have their own
// series: a call of an unknown method must not create a series. Any thread.
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

    // Adds a served method by its path: "/jostle.v1.WorldService/ListWorlds". The duration of
    // streams is not measured: a stream lasts as long as its client stays.
    enum class Kind { unary, streaming };
    void add(const std::string& path, Kind kind);

    // `path` as gRPC passes it; `code`: gRPC status number; `seconds` of a unary call.
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
    std::map<std::string, Method, std::less<>> methods_;  // by path; "": all unknown methods
};

}  // namespace jostle::server
