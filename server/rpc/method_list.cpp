// SPDX-License-Identifier: MIT
#include "rpc/method_list.h"

#include <google/protobuf/descriptor.h>

namespace jostle::server {

namespace {

std::vector<RpcMethod> methods_of(const std::vector<std::string>& services, bool streaming) {
    std::vector<RpcMethod> methods;
    for (const std::string& name : services) {
        const auto* service =
            google::protobuf::DescriptorPool::generated_pool()->FindServiceByName(name);
        for (int i = 0; service && i < service->method_count(); i++) {
            const auto* method = service->method(i);
            if ((method->client_streaming() || method->server_streaming()) == streaming)
                methods.push_back({name, method->name()});
        }
    }
    return methods;
}

}  // namespace

const std::vector<std::string>& served_services() {
    static const std::vector<std::string> names = {
        "grpc.health.v1.Health", "jostle.v1.AdminService", "jostle.v1.PlayService",
        "jostle.v1.QueryService", "jostle.v1.WorldService"};
    return names;
}

std::vector<RpcMethod> unary_methods_of(const std::vector<std::string>& services) {
    return methods_of(services, false);
}

std::vector<RpcMethod> streaming_methods_of(const std::vector<std::string>& services) {
    return methods_of(services, true);
}

}  // namespace jostle::server
