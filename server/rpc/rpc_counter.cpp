// SPDX-License-Identifier: MIT
#include "rpc/rpc_counter.h"

#include <string_view>

#include "base/clock.h"

namespace jostle::server {

using grpc::experimental::InterceptionHookPoints;

namespace {

class CountCall final : public grpc::experimental::Interceptor {
public:
    CountCall(RpcMetrics& metrics, const char* path) : metrics_(metrics), path_(path) {}

    void Intercept(grpc::experimental::InterceptorBatchMethods* methods) override {
        if (methods->QueryInterceptionHookPoint(InterceptionHookPoints::PRE_SEND_STATUS)) {
            const double seconds = std::chrono::duration<double>(Clock::now() - begun_).count();
            metrics_.handled(path_, methods->GetSendStatus().error_code(), seconds);
        }
        methods->Proceed();
    }

private:
    RpcMetrics& metrics_;
    const std::string_view path_;  // the server's own; outlives the call
    const Clock::time_point begun_ = Clock::now();
};

class CountCalls final : public grpc::experimental::ServerInterceptorFactoryInterface {
public:
    explicit CountCalls(RpcMetrics& metrics) : metrics_(metrics) {}

    grpc::experimental::Interceptor* CreateServerInterceptor(
        grpc::experimental::ServerRpcInfo* info) override {
        if (info->type() == grpc::experimental::ServerRpcInfo::Type::BIDI_STREAMING) return nullptr;
        return new CountCall(metrics_, info->method());  // gRPC owns it
    }

private:
    RpcMetrics& metrics_;
};

}  // namespace

std::vector<std::unique_ptr<grpc::experimental::ServerInterceptorFactoryInterface>> rpc_counters(
    RpcMetrics& metrics) {
    std::vector<std::unique_ptr<grpc::experimental::ServerInterceptorFactoryInterface>> counters;
    counters.push_back(std::make_unique<CountCalls>(metrics));
    return counters;
}

}  // namespace jostle::server
