# cmake --install, find_package(jostle) in other projects, and Debian packages.
#   find_package(jostle REQUIRED COMPONENTS physics)          jostle::physics: the solver, without dependencies
#   find_package(jostle REQUIRED COMPONENTS client)           jostle::client: the C++ client, with protobuf and gRPC
# Two packages: `jostle` contains the programs and the viewer, `jostle-dev` the libraries and headers.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# jostle_build_before_install(COMPONENT TARGET...): the target installed_COMPONENT, which cmake --install builds first if
# files are missing, because scripts/run builds the server and the bots before everything else.
function(jostle_build_before_install component)
    add_custom_target(installed_${component} DEPENDS ${ARGN})
    set(files "")
    foreach(target ${ARGN})
        string(APPEND files " \"$<TARGET_FILE:${target}>\"")
    endforeach()
    install(CODE "
        foreach(file ${files})
            if(NOT EXISTS \"\${file}\")
                message(STATUS \"Building what is not built yet\")
                execute_process(COMMAND \"${CMAKE_COMMAND}\" --build \"${PROJECT_BINARY_DIR}\"
                    --config \"\${CMAKE_INSTALL_CONFIG_NAME}\" --target installed_${component} COMMAND_ERROR_IS_FATAL ANY)
                break()
            endif()
        endforeach()" COMPONENT ${component})
endfunction()

set(jostle_client_libraries jostle_snapshot jostle_datagram jostle_proto jostle_rpc jostle_client)
set(jostle_programs jostle-server jostlectl jostle-bot jostle-load jostle-record jostle-replay jostle-sim jostle-mesh jostle-bench)
if(JOSTLE_RPC)
    jostle_build_before_install(dev jostle_physics ${jostle_modules} ${jostle_client_libraries})
    if(JOSTLE_SERVER)
        jostle_build_before_install(programs ${jostle_programs})
    endif()
else()
    jostle_build_before_install(dev jostle_physics ${jostle_modules})
endif()

set(jostle_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/jostle)

# jostle_install(SET TARGET... ): installs the libraries of one export set under their names without "jostle_".
function(jostle_install set)
    foreach(target ${ARGN})
        string(REPLACE jostle_ "" name ${target})
        set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
    endforeach()
    install(TARGETS ${ARGN} EXPORT jostle_${set} COMPONENT dev)
    install(EXPORT jostle_${set} FILE jostle_${set}.cmake NAMESPACE jostle:: DESTINATION ${jostle_cmake_dir} COMPONENT dev)
endfunction()

jostle_install(physics jostle_base jostle_physics)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/base/include/ ${PROJECT_SOURCE_DIR}/physics/include/
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)

jostle_install(modules ${jostle_modules})
foreach(module ${jostle_modules})
    get_target_property(headers ${module} JOSTLE_PUBLIC_HEADERS)
    install(DIRECTORY ${headers}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
endforeach()

if(JOSTLE_RPC)
    jostle_install(client ${jostle_client_libraries})
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/clients/cpp/core/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/proto/snapshot/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
    install(DIRECTORY ${PROJECT_BINARY_DIR}/proto/jostle DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev
        FILES_MATCHING PATTERN "*.pb.h")
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/proto/jostle DESTINATION ${CMAKE_INSTALL_DATADIR}/jostle/proto COMPONENT dev
        FILES_MATCHING PATTERN "*.proto")
endif()

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/jostleConfig.cmake.in ${PROJECT_BINARY_DIR}/jostleConfig.cmake
    INSTALL_DESTINATION ${jostle_cmake_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/jostleConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/jostleConfig.cmake ${PROJECT_BINARY_DIR}/jostleConfigVersion.cmake
    DESTINATION ${jostle_cmake_dir} COMPONENT dev)

if(JOSTLE_SERVER AND JOSTLE_RPC)
    install(TARGETS ${jostle_programs} COMPONENT programs)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT programs
        FILES_MATCHING PATTERN "*.1")
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/clients/web/dist/ DESTINATION ${CMAKE_INSTALL_DATADIR}/jostle/web COMPONENT programs)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/clients/bot/scripts DESTINATION ${CMAKE_INSTALL_DATADIR}/jostle COMPONENT programs)
    install(FILES ${PROJECT_SOURCE_DIR}/server/jostle-server.toml ${PROJECT_SOURCE_DIR}/deploy/systemd/jostle-server.default
        DESTINATION ${CMAKE_INSTALL_DATADIR}/jostle COMPONENT programs)
    install(FILES ${PROJECT_SOURCE_DIR}/deploy/systemd/jostle-server.service DESTINATION lib/systemd/system COMPONENT programs)
    install(FILES ${PROJECT_SOURCE_DIR}/deploy/systemd/jostle-sysusers.conf DESTINATION lib/sysusers.d RENAME jostle.conf
        COMPONENT programs)
endif()
# The software bill of materials names the installed versions of Debian's packages, so only Debian has one. It is made
# from the installed programs, because CPack strips them.
find_program(JOSTLE_DPKG_QUERY dpkg-query)
find_package(Python3 COMPONENTS Interpreter)
if(JOSTLE_SERVER AND JOSTLE_RPC AND JOSTLE_DPKG_QUERY AND Python3_FOUND)
    string(JOIN " " programs ${jostle_programs})
    # The install script compares names of components with if(), which would expand a variable named like one.
    install(CODE "
        set(jostle_programs ${programs})
        list(TRANSFORM jostle_programs PREPEND \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_BINDIR}/\")
        execute_process(COMMAND \"${Python3_EXECUTABLE}\" \"${PROJECT_SOURCE_DIR}/scripts/sbom\"
            -o \"${PROJECT_BINARY_DIR}/sbom.spdx.json\" \${jostle_programs} COMMAND_ERROR_IS_FATAL ANY)" COMPONENT programs)
    install(FILES ${PROJECT_BINARY_DIR}/sbom.spdx.json DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT programs)
endif()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md
    DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT programs)

# Run cpack -G DEB in the build folder.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME jostle)
set(CPACK_PACKAGE_VENDOR "The Jostle developers")
set(CPACK_PACKAGE_CONTACT "The Jostle developers <jostle@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "An authoritative physics server with thin clients")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL programs dev)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION net)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME jostle)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_DEV_PACKAGE_NAME jostle-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS "libgrpc++-dev, libprotobuf-dev")
include(CPack)
