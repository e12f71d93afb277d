// SPDX-License-Identifier: MIT
#include <grpcpp/create_channel.h>

#include <atomic>
#include <thread>

#include "jostle/v1/play.grpc.pb.h"
#include "tests/system/player.h"

namespace jostle::test {

namespace {

// Each player has its own connection, like players on different machines.
std::shared_ptr<grpc::Channel> connect(const std::string& address) {
    grpc::ChannelArguments arguments;
    arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
    arguments.SetMaxReceiveMessageSize(-1);
    return grpc::CreateCustomChannel(address, grpc::InsecureChannelCredentials(), arguments);
}

class GrpcPlayer final : public Player {
public:
    explicit GrpcPlayer(const std::string& address)
        : stub_(v1::PlayService::NewStub(connect(address))), stream_(stub_->Play(&context_)) {
        reader_ = std::thread([this] { read(); });
    }
    ~GrpcPlayer() override {
        stalled_ = false;
        context_.TryCancel();
        reader_.join();
    }

    void send(const v1::ClientMessage& message) override { stream_->Write(message); }
    void stall() override { stalled_ = true; }

private:
    void read() {
        v1::ServerMessage message;
        while (stream_->Read(&message)) {
            take(message);
            while (stalled_) std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        const grpc::Status status = stream_->Finish();
        ended(status.ok() ? "OK"
                          : std::to_string(status.error_code()) + ": " + status.error_message());
    }

    grpc::ClientContext context_;
    std::unique_ptr<v1::PlayService::Stub> stub_;
    std::unique_ptr<grpc::ClientReaderWriter<v1::ClientMessage, v1::ServerMessage>> stream_;
    std::atomic<bool> stalled_{false};
    std::thread reader_;
};

}  // namespace

std::unique_ptr<Player> grpc_player(const std::string& address) {
    return std::make_unique<GrpcPlayer>(address);
}

}  // namespace jostle::test
