# Debian 12 packages, found where they are installed; scripts/setup installs them. Nothing is downloaded at build time.
find_package(Threads REQUIRED)
if(JOSTLE_TESTS)
    find_package(GTest REQUIRED)
endif()
find_package(Boost 1.74 REQUIRED)         # headers only: Asio (ticks, gateway) and Beast (HTTP, WebSocket)
find_package(spdlog REQUIRED)
find_package(tomlplusplus REQUIRED)
if(JOSTLE_RPC)
    find_package(Protobuf 3.21 REQUIRED)  # MODULE mode: Debian ships no CONFIG for it
    find_package(gRPC CONFIG REQUIRED)
    find_package(CLI11 REQUIRED)
    find_package(nlohmann_json REQUIRED)
endif()
