// SPDX-License-Identifier: MIT
//
// gRPC clients connected to a server in this process whose methods belong to the test.
#include "server/grpc/unary_dispatcher.h"

#include <google/rpc/error_details.pb.h>
#include <google/rpc/status.pb.h>
#include <grpc/health/v1/health.grpc.pb.h>
#include <grpc/reflection/v1/reflection.grpc.pb.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/generic/generic_stub.h>
#include <gtest/gtest.h>

#include <future>
#include <thread>

#include "jostle/v1/world.grpc.pb.h"
#include "server/grpc/grpc_server.h"
#include "server/limits/session_directory.h"
#include "server/world/world_directory.h"
#include "tests/server/server_parts.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

class UnaryDispatcherTest : public testing::Test, protected ServerParts {
protected:
    UnaryDispatcherTest() : ServerParts(4, 4) {}
    void SetUp() override {
        ASSERT_TRUE(server.start().ok());
        channel = grpc::CreateChannel("127.0.0.1:" + std::to_string(server.port()),
                                      grpc::InsecureChannelCredentials());
        worlds_stub = v1::WorldService::NewStub(channel);
    }
    void TearDown() override {
        go_on.set_value();
        context.closing = true;
        server.drain({});
        server.stop();
    }
    // List succeeds, Get fails with an error, Create blocks until the test continues.
    std::vector<CallMethod> methods() {
        const std::string service = "/jostle.v1.WorldService/";
        return {unary_method<v1::ListWorldsRequest, v1::ListWorldsResponse>(
                    service + "ListWorlds", CallWork::quick, 64,
                    [](const CallContext&, const auto&, auto& response) -> Status {
                        response.add_worlds()->set_name("one");
                        return {};
                    }),
                unary_method<v1::GetWorldRequest, v1::GetWorldResponse>(
                    service + "GetWorld", CallWork::query, 64,
                    [](const CallContext&, const auto& request, auto&) -> Status {
                        if (request.world() == "throw") throw std::bad_alloc();
                        if (request.world().empty())
                            return Error{ErrorCode::invalid_argument, "world is empty; name one"};
                        return Error{ErrorCode::resource_exhausted, "no room"};
                    }),
                unary_method<v1::CreateWorldRequest, v1::CreateWorldResponse>(
                    service + "CreateWorld", CallWork::control, 1 << 20,
                    [this](const CallContext&, const auto&, auto&) -> Status {
                        waiting++;
                        opened.wait();
                        return {};
                    })};
    }
    grpc::Status get(const std::string& world) {
        grpc::ClientContext call;
        v1::GetWorldRequest request;
        request.set_world(world);
        v1::GetWorldResponse response;
        return worlds_stub->GetWorld(&call, request, &response);
    }

    std::promise<void> go_on;
    std::shared_future<void> opened = go_on.get_future().share();
    std::atomic<int> waiting{0};
    std::atomic<bool> healthy{true};
    GrpcServer server{context, methods(), [this] { return healthy.load(); }, {.port = 0}};
    std::shared_ptr<grpc::Channel> channel;
    std::unique_ptr<v1::WorldService::Stub> worlds_stub;
};

TEST_F(UnaryDispatcherTest, returns_responses_field_violations_and_retry_info) {
    grpc::ClientContext call;
    v1::ListWorldsResponse response;
    ASSERT_TRUE(worlds_stub->ListWorlds(&call, {}, &response).ok());
    EXPECT_EQ(response.worlds(0).name(), "one");

    const grpc::Status wrong = get("");
    EXPECT_EQ(wrong.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
    google::rpc::Status rich;
    ASSERT_TRUE(rich.ParseFromString(wrong.error_details()));
    google::rpc::ErrorInfo info;
    google::rpc::BadRequest field;
    ASSERT_TRUE(rich.details(0).UnpackTo(&info) && rich.details(1).UnpackTo(&field));
    EXPECT_EQ(info.reason(), "INVALID_ARGUMENT");
    EXPECT_EQ(field.field_violations(0).field(), "world");

    const grpc::Status full = get("any");
    EXPECT_EQ(full.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
    google::rpc::RetryInfo retry;
    ASSERT_TRUE(rich.ParseFromString(full.error_details()) && rich.details(1).UnpackTo(&retry));
    EXPECT_EQ(retry.retry_delay().seconds(), 1);
}

TEST_F(UnaryDispatcherTest, exceptions_oversized_and_unknown_calls_fail_independently) {
    EXPECT_EQ(get("throw").error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
    const grpc::Status big = get(std::string(100, 'x'));
    EXPECT_EQ(big.error_message(), "the request has 102 bytes; at most 64 are allowed");
    grpc::ClientContext call;
    v1::DeleteWorldResponse nothing;
    EXPECT_EQ(worlds_stub->DeleteWorld(&call, {}, &nothing).error_code(),
              grpc::StatusCode::UNIMPLEMENTED);
    EXPECT_EQ(get("any").error_message(), "no room")
        << "the dispatcher must continue after an error";
}

TEST_F(UnaryDispatcherTest, slow_calls_fill_only_their_own_queue) {
    std::vector<std::future<grpc::Status>> creates;
    // One call runs and 31 wait: the maximum number of open calls per connection.
    for (int i = 0; i < 40; i++)
        creates.push_back(std::async(std::launch::async, [&] {
            grpc::ClientContext call;
            v1::CreateWorldResponse response;
            return worlds_stub->CreateWorld(&call, {}, &response);
        }));
    int refused = 0;
    for (const auto until = Clock::now() + 10s;
         (refused < 8 || waiting < 1) && Clock::now() < until;) {
        refused = 0;
        for (auto& create : creates)
            refused += create.wait_for(0s) == std::future_status::ready ? 1 : 0;
        std::this_thread::sleep_for(5ms);
    }
    EXPECT_EQ(refused, 8);
    EXPECT_EQ(waiting, 1);
    const auto other = v1::WorldService::NewStub(grpc::CreateCustomChannel(
        "127.0.0.1:" + std::to_string(server.port()), grpc::InsecureChannelCredentials(), [] {
            grpc::ChannelArguments own;
            own.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
            return own;
        }()));
    grpc::ClientContext call;
    call.set_deadline(std::chrono::system_clock::now() + 2s);
    v1::ListWorldsResponse response;
    EXPECT_TRUE(other->ListWorlds(&call, {}, &response).ok());
    go_on.set_value();
    int done = 0;
    for (auto& create : creates) done += create.get().ok() ? 1 : 0;
    EXPECT_EQ(done, 32);
    go_on = {};
}

TEST_F(UnaryDispatcherTest, serves_health_check_and_watch) {
    const auto health = grpc::health::v1::Health::NewStub(channel);
    grpc::ClientContext watch_call;
    grpc::health::v1::HealthCheckResponse seen;
    const auto watch = health->Watch(&watch_call, {});
    ASSERT_TRUE(watch->Read(&seen));
    EXPECT_EQ(seen.status(), grpc::health::v1::HealthCheckResponse::SERVING);
    healthy = false;
    ASSERT_TRUE(watch->Read(&seen));
    EXPECT_EQ(seen.status(), grpc::health::v1::HealthCheckResponse::NOT_SERVING);
    grpc::ClientContext check_call, unknown_call;
    grpc::health::v1::HealthCheckRequest of_play, unknown;
    of_play.set_service("jostle.v1.PlayService");
    unknown.set_service("jostle.v1.Nothing");
    EXPECT_TRUE(health->Check(&check_call, of_play, &seen).ok());
    EXPECT_EQ(seen.status(), grpc::health::v1::HealthCheckResponse::NOT_SERVING);
    EXPECT_EQ(health->Check(&unknown_call, unknown, &seen).error_code(),
              grpc::StatusCode::NOT_FOUND);
    watch_call.TryCancel();
}

TEST_F(UnaryDispatcherTest, reflection_lists_services_and_messages) {
    const auto stub = grpc::reflection::v1::ServerReflection::NewStub(channel);
    grpc::ClientContext call;
    const auto stream = stub->ServerReflectionInfo(&call);
    grpc::reflection::v1::ServerReflectionRequest request;
    grpc::reflection::v1::ServerReflectionResponse response;
    request.set_list_services("");
    ASSERT_TRUE(stream->Write(request) && stream->Read(&response));
    std::vector<std::string> names;
    for (const auto& service : response.list_services_response().service())
        names.push_back(service.name());
    EXPECT_NE(std::ranges::find(names, "jostle.v1.PlayService"), names.end());
    EXPECT_NE(std::ranges::find(names, "jostle.v1.WorldService"), names.end());
    request.set_file_containing_symbol("jostle.v1.WorldService");
    ASSERT_TRUE(stream->Write(request) && stream->Read(&response));
    EXPECT_GE(response.file_descriptor_response().file_descriptor_proto_size(), 3)
        << "world.proto and its imports";
    request.set_file_by_filename("no/such.proto");
    ASSERT_TRUE(stream->Write(request) && stream->Read(&response));
    EXPECT_EQ(response.error_response().error_code(), grpc::StatusCode::NOT_FOUND);
    stream->WritesDone();
    EXPECT_TRUE(stream->Finish().ok());
}

}  // namespace
}  // namespace jostle::server
