// SPDX-License-Identifier: MIT
//
// Wakes the listeners when a world has published a frame. Worlds publish before the listeners exist
// and while they close, so they wake the listeners through this object. Any thread.
#pragma once

#include <mutex>

#include "server/grpc/grpc_server.h"
#include "server/http/http_server.h"

namespace jostle::server {

class FrameNotifier {
public:
    // wake() skips a null listener. Returns after a running wake() has ended.
    void set_listeners(GrpcServer* grpc, HttpServer* http) {
        const std::lock_guard lock(mutex_);
        grpc_ = grpc;
        http_ = http;
    }
    void wake() {
        const std::lock_guard lock(mutex_);
        if (grpc_) grpc_->wake();
        if (http_) http_->wake();
    }

private:
    std::mutex mutex_;
    GrpcServer* grpc_ = nullptr;
    HttpServer* http_ = nullptr;
};

}  // namespace jostle::server
