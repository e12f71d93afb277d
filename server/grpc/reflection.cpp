// SPDX-License-Identifier: MIT
#include "server/grpc/server_methods.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <grpcpp/support/status.h>

#include <set>

#include "grpc/reflection/v1/reflection.pb.h"

namespace jostle::server {

namespace reflection = grpc::reflection::v1;
using google::protobuf::DescriptorPool;
using google::protobuf::FileDescriptor;

namespace {

constexpr std::size_t reflection_request_bytes_max = 4096;

void add_with_imports(const FileDescriptor& file, std::set<const FileDescriptor*>& added,
                      reflection::FileDescriptorResponse& out) {
    if (!added.insert(&file).second) return;
    google::protobuf::FileDescriptorProto description;
    file.CopyTo(&description);
    out.add_file_descriptor_proto(description.SerializeAsString());
    for (int i = 0; i < file.dependency_count(); i++)
        add_with_imports(*file.dependency(i), added, out);
}

void respond_with_file(const FileDescriptor* file, reflection::ServerReflectionResponse& response) {
    if (file == nullptr) {
        response.mutable_error_response()->set_error_code(grpc::StatusCode::NOT_FOUND);
        response.mutable_error_response()->set_error_message("there is no such file or symbol");
        return;
    }
    std::set<const FileDescriptor*> added;
    add_with_imports(*file, added, *response.mutable_file_descriptor_response());
}

void respond(const reflection::ServerReflectionRequest& request,
             const std::vector<std::string>& services,
             reflection::ServerReflectionResponse& response) {
    using Request = reflection::ServerReflectionRequest;
    const DescriptorPool& pool = *DescriptorPool::generated_pool();
    switch (request.message_request_case()) {
        case Request::kFileByFilename:
            return respond_with_file(pool.FindFileByName(request.file_by_filename()), response);
        case Request::kFileContainingSymbol:
            return respond_with_file(
                pool.FindFileContainingSymbol(request.file_containing_symbol()), response);
        case Request::kListServices:
            for (const std::string& name : services)
                response.mutable_list_services_response()->add_service()->set_name(name);
            return;
        case Request::kAllExtensionNumbersOfType:  // the server defines no extensions
        case Request::kFileContainingExtension:
        case Request::MESSAGE_REQUEST_NOT_SET:
            return respond_with_file(nullptr, response);
    }
}

}  // namespace

std::vector<CallMethod> reflection_methods(std::vector<std::string> services) {
    const auto run = [services = std::move(services)](
                         const CallContext&, const reflection::ServerReflectionRequest& request,
                         reflection::ServerReflectionResponse& response) -> Status {
        response.set_valid_host(request.host());
        *response.mutable_original_request() = request;
        respond(request, services, response);
        return {};
    };
    std::vector<CallMethod> methods;
    for (const char* version : {"v1", "v1alpha"})
        methods.push_back(
            unary_method<reflection::ServerReflectionRequest, reflection::ServerReflectionResponse>(
                std::string("/grpc.reflection.") + version +
                    ".ServerReflection/ServerReflectionInfo",
                CallWork::stream, reflection_request_bytes_max, run));
    return methods;
}

}  // namespace jostle::server
