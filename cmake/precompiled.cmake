# Headers that most sources read are compiled once: a quarter to a half of the time of a small source. Our own headers
# are not among them, so an edit rebuilds what includes them and no more. Release builds go without, and so find a source that
# forgot an include. Of what GCC 12 inlines from a precompiled header it warns as if it were our own code, with a sanitizer
# without reason: warnings are for the other builds.
option(JOSTLE_PRECOMPILE "Compile the standard headers once for all sources of a debug build" ON)
if(NOT JOSTLE_PRECOMPILE OR NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
    function(jostle_precompiled)
    endfunction()
    return()
endif()

# ccache must be told that what a precompiled header defines is part of it.
if(JOSTLE_CCACHE)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${JOSTLE_CCACHE})
endif()

# jostle_precompile(NAME LINK libs... HEADERS <a>...)
function(jostle_precompile name)
    cmake_parse_arguments(arg "" "" "LINK;HEADERS" ${ARGN})
    file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/${name}.cpp CONTENT "")
    add_library(${name} OBJECT ${CMAKE_BINARY_DIR}/${name}.cpp)
    target_link_libraries(${name} PRIVATE ${arg_LINK} jostle_flags)
    target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
endfunction()

set(standard_headers <algorithm> <array> <chrono> <cmath> <cstdint> <cstring> <functional> <limits> <memory> <optional>
    <span> <sstream> <string> <string_view> <unordered_map> <vector>)
jostle_precompile(jostle_precompiled_libraries HEADERS ${standard_headers})
if(JOSTLE_TESTS)
    jostle_precompile(jostle_precompiled_tests LINK GTest::gtest HEADERS ${standard_headers} <gtest/gtest.h>)
    # As programs are compiled; libraries are compiled with -fPIC, and the compiler takes no header that was not.
    set_target_properties(jostle_precompiled_tests PROPERTIES POSITION_INDEPENDENT_CODE OFF)
    target_compile_options(jostle_precompiled_tests PRIVATE -fPIE)
endif()

# jostle_precompiled(TARGET libraries|tests)
function(jostle_precompiled target which)
    target_precompile_headers(${target} REUSE_FROM jostle_precompiled_${which})
endfunction()
