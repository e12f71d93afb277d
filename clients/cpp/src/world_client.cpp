// SPDX-License-Identifier: MIT
//
// The unary calls: WorldClient and QueryClient.
#include "jostle/client/world_client.h"

#include <grpcpp/create_channel.h>

#include <chrono>

#include "jostle/client/query_client.h"
#include "jostle/v1/query.grpc.pb.h"
#include "jostle/v1/world.grpc.pb.h"

namespace jostle::client {
namespace {

constexpr auto patience = std::chrono::seconds(5);

// Nothing on success, otherwise the server's words.
template <class Stub, class Request, class Response>
std::optional<std::string> call(Stub& stub,
                                grpc::Status (Stub::*method)(grpc::ClientContext*, const Request&,
                                                             Response*),
                                const Request& request, Response& response) {
    grpc::ClientContext context;
    context.set_deadline(std::chrono::system_clock::now() + patience);
    context.set_wait_for_ready(true);
    const grpc::Status status = (stub.*method)(&context, request, &response);
    if (status.ok()) return std::nullopt;
    return status.error_message();
}

void write(v1::Vec3& to, const Point& from) {
    to.set_x(from[0]);
    to.set_y(from[1]);
    to.set_z(from[2]);
}

Point read(const v1::Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

void write(v1::QueryFilter& to, const QueryOptions& from) {
    to.set_categories(from.categories);
    to.set_triggers(from.triggers);
    to.set_ignore(from.ignore);
}

}  // namespace

struct WorldClient::Impl {
    std::unique_ptr<v1::WorldService::Stub> stub;
};

WorldClient::WorldClient(const std::string& target) : impl_(std::make_unique<Impl>()) {
    impl_->stub =
        v1::WorldService::NewStub(grpc::CreateChannel(target, grpc::InsecureChannelCredentials()));
}
WorldClient::~WorldClient() = default;

std::optional<std::string> WorldClient::list(v1::ListWorldsResponse& response) {
    return call(*impl_->stub, &v1::WorldService::Stub::ListWorlds, v1::ListWorldsRequest(),
                response);
}

std::optional<std::string> WorldClient::create(const v1::CreateWorldRequest& request,
                                               v1::CreateWorldResponse& response) {
    return call(*impl_->stub, &v1::WorldService::Stub::CreateWorld, request, response);
}

std::optional<std::string> WorldClient::remove(const std::string& world) {
    v1::DeleteWorldRequest request;
    request.set_world(world);
    v1::DeleteWorldResponse response;
    return call(*impl_->stub, &v1::WorldService::Stub::DeleteWorld, request, response);
}

std::optional<std::string> WorldClient::join(const std::string& world,
                                             v1::JoinWorldResponse& response) {
    v1::JoinWorldRequest request;
    request.set_world(world);
    return call(*impl_->stub, &v1::WorldService::Stub::JoinWorld, request, response);
}

struct QueryClient::Impl {
    std::unique_ptr<v1::QueryService::Stub> stub;
    std::string world;

    // The error, empty on success.
    template <class Request, class Response>
    std::string ask(grpc::Status (v1::QueryService::Stub::*method)(grpc::ClientContext*,
                                                                   const Request&, Response*),
                    Request& request, const QueryOptions& options, Response& response) {
        request.set_world(world);
        write(*request.mutable_filter(), options);
        const std::optional<std::string> error = call(*stub, method, request, response);
        if (!error) return {};
        return error->empty() ? "the server gave no reason" : *error;
    }

    QueryAnswer<std::vector<std::uint32_t>> overlap(v1::OverlapRequest& request,
                                                    const QueryOptions& options) {
        v1::OverlapResponse response;
        QueryAnswer<std::vector<std::uint32_t>> answer;
        answer.error = ask(&v1::QueryService::Stub::Overlap, request, options, response);
        answer.tick = response.tick();
        answer.value.assign(response.entities().begin(), response.entities().end());
        return answer;
    }
};

QueryClient::QueryClient(const std::string& target, std::string world)
    : impl_(std::make_unique<Impl>()) {
    impl_->stub =
        v1::QueryService::NewStub(grpc::CreateChannel(target, grpc::InsecureChannelCredentials()));
    impl_->world = std::move(world);
}
QueryClient::~QueryClient() = default;

QueryAnswer<std::optional<RayHit>> QueryClient::cast_ray(Point origin, Point motion,
                                                         const QueryOptions& options) {
    v1::CastRaysRequest request;
    v1::Ray& ray = *request.add_rays();
    write(*ray.mutable_origin(), origin);
    write(*ray.mutable_motion(), motion);
    v1::CastRaysResponse response;
    QueryAnswer<std::optional<RayHit>> answer;
    answer.error = impl_->ask(&v1::QueryService::Stub::CastRays, request, options, response);
    answer.tick = response.tick();
    if (!answer.ok() || response.rays_size() == 0 || response.rays(0).hits_size() == 0)
        return answer;
    const v1::Hit& hit = response.rays(0).hits(0);
    answer.value = RayHit{.entity = hit.entity(),
                          .shape = hit.shape(),
                          .fraction = hit.fraction(),
                          .point = read(hit.point()),
                          .normal = read(hit.normal())};
    return answer;
}

QueryAnswer<std::vector<std::uint32_t>> QueryClient::overlap(const v1::Shape& shape,
                                                             const QueryOptions& options) {
    v1::OverlapRequest request;
    *request.mutable_shape() = shape;
    return impl_->overlap(request, options);
}

QueryAnswer<std::vector<std::uint32_t>> QueryClient::overlap(Point point,
                                                             const QueryOptions& options) {
    v1::OverlapRequest request;
    write(*request.mutable_point(), point);
    return impl_->overlap(request, options);
}

QueryAnswer<std::optional<Nearest>> QueryClient::closest_point(Point point, double max_distance,
                                                               const QueryOptions& options) {
    v1::ClosestPointsRequest request;
    write(*request.add_points(), point);
    request.set_max_distance(max_distance);
    v1::ClosestPointsResponse response;
    QueryAnswer<std::optional<Nearest>> answer;
    answer.error = impl_->ask(&v1::QueryService::Stub::ClosestPoints, request, options, response);
    answer.tick = response.tick();
    if (!answer.ok() || response.points_size() == 0 || response.points(0).entity() == 0)
        return answer;
    const v1::ClosestPoint& nearest = response.points(0);
    answer.value = Nearest{.entity = nearest.entity(),
                           .distance = nearest.distance(),
                           .point = read(nearest.point()),
                           .normal = read(nearest.normal())};
    return answer;
}

}  // namespace jostle::client
