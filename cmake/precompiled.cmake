# Standard headers are precompiled once, which saves a quarter to a half of the compile time of a small source.
# Project headers are not precompiled, so an edit rebuilds only their users. Release builds do not precompile, and
# therefore detect missing includes. GCC 12 reports warnings for code inlined from a precompiled header as if it were
# project code, and false ones with a sanitizer; only builds without sanitizers treat warnings as errors.
option(JOSTLE_PRECOMPILE "Compile the standard headers once for all sources of a debug build" ON)
if(NOT JOSTLE_PRECOMPILE OR NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
    function(jostle_precompiled)
    endfunction()
    return()
endif()

# ccache must treat the macros defined by a precompiled header as part of the header.
if(JOSTLE_CCACHE)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${JOSTLE_CCACHE})
endif()

# jostle_precompile(NAME LINK libs... OPTIONS flags... HEADERS <a>...)
function(jostle_precompile name)
    cmake_parse_arguments(arg "" "" "LINK;OPTIONS;HEADERS" ${ARGN})
    file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/${name}.cpp CONTENT "")
    add_library(${name} OBJECT EXCLUDE_FROM_ALL ${CMAKE_BINARY_DIR}/${name}.cpp)
    target_link_libraries(${name} PRIVATE ${arg_LINK} jostle_flags)
    target_compile_options(${name} PRIVATE ${arg_OPTIONS})
    target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
endfunction()

set(standard_headers <algorithm> <array> <chrono> <cmath> <cstdint> <cstring> <functional> <limits> <memory> <optional>
    <span> <sstream> <string> <string_view> <unordered_map> <vector>)
# A precompiled header is only usable with the same flags, so there is one for each combination.
set(flags "")
set(flags_unoptimised -O0)
foreach(optimisation "" _unoptimised)
    set(flag ${flags${optimisation}})
    jostle_precompile(jostle_precompiled_libraries${optimisation} OPTIONS ${flag} HEADERS ${standard_headers})
    if(JOSTLE_TESTS)
        jostle_precompile(jostle_precompiled_tests${optimisation} LINK GTest::gtest OPTIONS -fPIE ${flag}
            HEADERS ${standard_headers} <gtest/gtest.h>)
        # Compiled like programs; libraries are compiled with -fPIC.
        set_target_properties(jostle_precompiled_tests${optimisation} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
    endif()
endforeach()

# jostle_precompiled(TARGET libraries|tests)
function(jostle_precompiled target which)
    if(JOSTLE_UNOPTIMISED AND NOT JOSTLE_SANITIZE)
        string(APPEND which _unoptimised)
    endif()
    target_precompile_headers(${target} REUSE_FROM jostle_precompiled_${which})
endfunction()
