// SPDX-License-Identifier: MIT
//
// The unary calls: WorldClient and QueryClient.
#include "jostle/client/world_client.h"

#include <grpcpp/create_channel.h>

#include <chrono>

#include "clients/cpp/core/src/security.h"
#include "jostle/client/query_client.h"
#include "jostle/grpc_status/grpc_status.h"
#include "jostle/v1/query.grpc.pb.h"
#include "jostle/v1/world.grpc.pb.h"

namespace jostle::client {
namespace {

constexpr auto timeout = std::chrono::seconds(5);

template <class Stub, class Request, class Response>
Result<Response> call(Stub& stub,
                      grpc::Status (Stub::*method)(grpc::ClientContext*, const Request&, Response*),
                      const Request& request, const Security& security) {
    grpc::ClientContext context;
    attach_token(context, security);
    context.set_deadline(std::chrono::system_clock::now() + timeout);
    context.set_wait_for_ready(true);
    Response response;
    const Status status = from_grpc((stub.*method)(&context, request, &response));
    if (!status.ok()) return status.error();
    return response;
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
    to.set_include_triggers(from.triggers);
    to.set_include_deformables(from.deformables);
    to.set_ignore(from.ignore);
}

}  // namespace

struct WorldClient::Impl {
    std::unique_ptr<v1::WorldService::Stub> stub;
    Security security;

    template <class Request, class Response>
    Result<Response> invoke(grpc::Status (v1::WorldService::Stub::*method)(grpc::ClientContext*,
                                                                           const Request&,
                                                                           Response*),
                            const Request& request) {
        return call(*stub, method, request, security);
    }
};

WorldClient::WorldClient(const std::string& target, Security security)
    : impl_(std::make_unique<Impl>()) {
    impl_->stub =
        v1::WorldService::NewStub(grpc::CreateChannel(target, channel_credentials(security)));
    impl_->security = std::move(security);
}
WorldClient::~WorldClient() = default;

Result<v1::ListWorldsResponse> WorldClient::list(const v1::ListWorldsRequest& request) {
    return impl_->invoke(&v1::WorldService::Stub::ListWorlds, request);
}

Result<v1::CreateWorldResponse> WorldClient::create(const v1::CreateWorldRequest& request) {
    return impl_->invoke(&v1::WorldService::Stub::CreateWorld, request);
}

Status WorldClient::remove(const std::string& world) {
    v1::DeleteWorldRequest request;
    request.set_world(world);
    const auto removed = impl_->invoke(&v1::WorldService::Stub::DeleteWorld, request);
    return removed.ok() ? Status() : removed.error();
}

Result<v1::JoinWorldResponse> WorldClient::join(const std::string& world,
                                                const std::string& join_code) {
    v1::JoinWorldRequest request;
    request.set_world(world);
    request.set_join_code(join_code);
    return impl_->invoke(&v1::WorldService::Stub::JoinWorld, request);
}

Result<v1::JoinOrCreateWorldResponse> WorldClient::join_or_create(
    const v1::JoinOrCreateWorldRequest& request) {
    return impl_->invoke(&v1::WorldService::Stub::JoinOrCreateWorld, request);
}

struct QueryClient::Impl {
    std::unique_ptr<v1::QueryService::Stub> stub;
    std::string world;
    Security security;

    template <class Request, class Response>
    Result<Response> invoke(grpc::Status (v1::QueryService::Stub::*method)(grpc::ClientContext*,
                                                                           const Request&,
                                                                           Response*),
                            Request& request, const QueryOptions& options) {
        request.set_world(world);
        write(*request.mutable_filter(), options);
        if (options.view_time) *request.mutable_view_time() = *options.view_time;
        return call(*stub, method, request, security);
    }

    Result<v1::InspectResponse> inspect(v1::InspectRequest& request) {
        request.set_world(world);
        return call(*stub, &v1::QueryService::Stub::Inspect, request, security);
    }

    Result<QueryResult<Overlaps>> overlap(v1::OverlapRequest& request,
                                          const QueryOptions& options) {
        const auto response = invoke(&v1::QueryService::Stub::Overlap, request, options);
        if (!response.ok()) return response.error();
        QueryResult<Overlaps> result{.tick = response->tick(),
                                     .view_time_clamped = response->view_time_clamped()};
        result.value.entities.assign(response->entities().begin(), response->entities().end());
        result.value.objects.assign(response->objects().begin(), response->objects().end());
        return result;
    }
};

QueryClient::QueryClient(const std::string& target, std::string world, Security security)
    : impl_(std::make_unique<Impl>()) {
    impl_->stub =
        v1::QueryService::NewStub(grpc::CreateChannel(target, channel_credentials(security)));
    impl_->world = std::move(world);
    impl_->security = std::move(security);
}
QueryClient::~QueryClient() = default;

Result<QueryResult<std::optional<RayHit>>> QueryClient::cast_ray(Point origin, Point motion,
                                                                 const QueryOptions& options) {
    v1::CastRaysRequest request;
    v1::Ray& ray = *request.add_rays();
    write(*ray.mutable_origin(), origin);
    write(*ray.mutable_motion(), motion);
    const auto response = impl_->invoke(&v1::QueryService::Stub::CastRays, request, options);
    if (!response.ok()) return response.error();
    QueryResult<std::optional<RayHit>> result{.tick = response->tick(),
                                              .view_time_clamped = response->view_time_clamped()};
    if (response->rays_size() == 0 || response->rays(0).hits_size() == 0) return result;
    const v1::Hit& hit = response->rays(0).hits(0);
    result.value = RayHit{.entity = hit.entity(),
                          .object = hit.object(),
                          .shape = hit.shape(),
                          .fraction = hit.fraction(),
                          .point = read(hit.point()),
                          .normal = read(hit.normal())};
    return result;
}

Result<QueryResult<Overlaps>> QueryClient::overlap(const v1::Shape& shape,
                                                   const QueryOptions& options) {
    v1::OverlapRequest request;
    *request.mutable_shape() = shape;
    return impl_->overlap(request, options);
}

Result<QueryResult<Overlaps>> QueryClient::overlap(Point point, const QueryOptions& options) {
    v1::OverlapRequest request;
    write(*request.mutable_point(), point);
    return impl_->overlap(request, options);
}

Result<QueryResult<std::optional<ClosestPointHit>>> QueryClient::closest_point(
    Point point, double max_distance, const QueryOptions& options) {
    v1::ClosestPointsRequest request;
    write(*request.add_points(), point);
    request.set_max_distance(max_distance);
    const auto response = impl_->invoke(&v1::QueryService::Stub::ClosestPoints, request, options);
    if (!response.ok()) return response.error();
    QueryResult<std::optional<ClosestPointHit>> result{
        .tick = response->tick(), .view_time_clamped = response->view_time_clamped()};
    if (response->points_size() == 0) return result;
    const v1::ClosestPoint& closest = response->points(0);
    if (closest.entity() == 0 && closest.object() == 0) return result;
    result.value = ClosestPointHit{.entity = closest.entity(),
                                   .object = closest.object(),
                                   .distance = closest.distance(),
                                   .point = read(closest.point()),
                                   .normal = read(closest.normal())};
    return result;
}

Result<QueryResult<v1::InspectedBody>> QueryClient::inspect_entity(std::uint32_t entity) {
    v1::InspectRequest request;
    request.set_entity(entity);
    auto response = impl_->inspect(request);
    if (!response.ok()) return response.error();
    return QueryResult<v1::InspectedBody>{.value = std::move(*response->mutable_body()),
                                          .tick = response->tick()};
}

Result<QueryResult<v1::InspectedJoint>> QueryClient::inspect_joint(std::uint32_t joint) {
    v1::InspectRequest request;
    request.set_joint(joint);
    auto response = impl_->inspect(request);
    if (!response.ok()) return response.error();
    return QueryResult<v1::InspectedJoint>{.value = std::move(*response->mutable_joint()),
                                           .tick = response->tick()};
}

}  // namespace jostle::client
