# All compiler flags in one place; jostle_library() and jostle_program() apply them.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_SYSTEM_NAME STREQUAL WASI)
    set(CMAKE_POSITION_INDEPENDENT_CODE ON)
endif()

find_program(JOSTLE_CCACHE ccache)
if(JOSTLE_CCACHE)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${JOSTLE_CCACHE})
endif()

# GCC collects garbage whenever its heap has grown by a third; letting it grow to 1.5 GB per source saves a fifth of the
# compile time.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    add_compile_options("SHELL:--param ggc-min-expand=400" "SHELL:--param ggc-min-heapsize=1500000")
endif()

add_library(jostle_flags INTERFACE)

# Private headers are included by their path from the project folder, public ones as jostle/LIBRARY/NAME.h.
target_include_directories(jostle_flags INTERFACE ${PROJECT_SOURCE_DIR})

# Floating point must be bit-identical for every compiler, optimization level and CPU. Contraction would fuse a*b+c on
# some targets only; fast-math would reorder sums. errno of sqrt is never read; -fno-math-errno compiles sqrt to one
# instruction.
target_compile_options(jostle_flags INTERFACE -ffp-contract=off -fno-fast-math -fno-math-errno)
# GCC 12 fuses alternating sums and differences (vfmaddsub) despite -ffp-contract=off if CMAKE_CXX_FLAGS has
# -march=native or similar. The fused operations of the solver are explicit, in sources with their own flags
# (physics/CMakeLists.txt).
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    target_compile_options(jostle_flags INTERFACE -mno-fma -mno-fma4 -mno-avx512f)
endif()

target_compile_options(jostle_flags INTERFACE
    -Wall -Wextra $<$<BOOL:${PROJECT_IS_TOP_LEVEL}>:-Werror> -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Wold-style-cast
    -Woverloaded-virtual -Wunused -Wcast-align -Wdouble-promotion)
# Designated initializers name only the fields that differ from the defaults; the others are omitted on purpose.
target_compile_options(jostle_flags INTERFACE -Wno-missing-field-initializers)
# GCC 12 reports overlapping copies in std::string's operator+ where there are none (GCC bug 105651).
target_compile_options(jostle_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# With optimization, it also reports reads of inactive variant members (GCC bug 105562). Sanitizer builds find real
# ones.
target_compile_options(jostle_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
# Clang warns about intended conversions from float to double, for example of solver lanes to a Vec3; GCC does not.
target_compile_options(jostle_flags INTERFACE $<$<CXX_COMPILER_ID:Clang>:-Wno-double-promotion>)
# The eight-wide vector type is passed between inline functions only, so its calling convention does not matter.
target_compile_options(jostle_flags INTERFACE -Wno-psabi)

# Some linked libraries require -pthread; a precompiled header is usable only if all sources use the same flags.
if(NOT CMAKE_SYSTEM_NAME STREQUAL WASI)  # no threads
    target_compile_options(jostle_flags INTERFACE -pthread)
endif()

# Unity builds: most of the compile time is headers, so the sources of a target are compiled in groups. Therefore no two
# sources of a target may use the same name for different entities; targets that cannot comply use SEPARATE_SOURCES. In
# a group, constants of one source can shadow those of another, and unnamed namespaces appear to be in a header.
# scripts/determinism-check compiles the solver's sources one by one, and scripts/tidy all others, and both detect
# missing includes.
set(JOSTLE_UNITY_BATCH 24 CACHE STRING "Sources in a group of a unity build: more for few processors, fewer for many")
if(JOSTLE_UNITY_BUILD)
    target_compile_options(jostle_flags INTERFACE -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()
function(jostle_unity_build target)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ${JOSTLE_UNITY_BUILD} UNITY_BUILD_BATCH_SIZE ${JOSTLE_UNITY_BATCH})
endfunction()

# Every test program links all the libraries below it; mold takes a tenth of the time of the default linker.
find_program(JOSTLE_MOLD mold)
if(JOSTLE_MOLD AND PROJECT_IS_TOP_LEVEL AND NOT CMAKE_CROSSCOMPILING)
    add_link_options(-fuse-ld=mold)
endif()

if(JOSTLE_ASSERT)
    target_compile_definitions(jostle_flags INTERFACE JOSTLE_ASSERT=1)
endif()

if(JOSTLE_SANITIZE)
    set(sanitize -fsanitize=${JOSTLE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    add_compile_options(${sanitize})
    target_compile_options(jostle_flags INTERFACE -Wno-error)  # see precompiled.cmake
    add_link_options(${sanitize})
    if(JOSTLE_SANITIZE MATCHES thread)
        # The thread sanitizer does not support fences; Asio's locks order all shared data without them.
        add_compile_definitions(BOOST_ASIO_DISABLE_FENCED_BLOCK)
    endif()
endif()

# Hardening against memory errors: docs/design/security_model.md explains the flags, tests/deploy/check_hardening.py checks
# the built programs. _FORTIFY_SOURCE needs an optimized build, and sanitizers replace it.
if(PROJECT_IS_TOP_LEVEL AND CMAKE_BUILD_TYPE MATCHES "^(Release|RelWithDebInfo|MinSizeRel)$" AND NOT JOSTLE_SANITIZE
        AND NOT JOSTLE_SOLVER_ONLY)
    set(hardened_by_default ON)
else()
    set(hardened_by_default OFF)
endif()
option(JOSTLE_HARDENED "Harden programs against memory errors: checked library calls, stack protectors, full RELRO"
    ${hardened_by_default})
if(JOSTLE_HARDENED)
    if(JOSTLE_SANITIZE)
        message(FATAL_ERROR "JOSTLE_HARDENED cannot be combined with JOSTLE_SANITIZE: configure with -DJOSTLE_HARDENED=OFF")
    endif()
    add_compile_options(-fstack-protector-strong -fstack-clash-protection)
    if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
        add_compile_options(-fcf-protection=full)
    elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "aarch64|arm64")
        add_compile_options(-mbranch-protection=standard)
    endif()
    # A distribution's compiler may define it already, and a second definition is a warning.
    add_compile_options(-U_FORTIFY_SOURCE $<$<NOT:$<CONFIG:Debug>>:-D_FORTIFY_SOURCE=3>)
    add_compile_definitions($<$<NOT:$<BOOL:$<TARGET_PROPERTY:JOSTLE_UNASSERTED>>>:_GLIBCXX_ASSERTIONS>)
    add_link_options(LINKER:-z,relro,-z,now,-z,noexecstack)
    include(CheckPIESupported)
    check_pie_supported()  # CMake passes -pie to the linker only after this check
endif()

# An optimized address sanitizer build takes twice as long to compile, and its tests are not limited by run time.
function(jostle_unoptimised_when_sanitized)
    if(JOSTLE_SANITIZE MATCHES address)
        foreach(target ${ARGN})
            target_compile_options(${target} PRIVATE -O0)
        endforeach()
    endif()
endfunction()

# Folders whose code mostly calls libraries set JOSTLE_UNOPTIMISED: compiling it without optimisation takes two thirds of
# the time, and a debug build runs as fast.
function(jostle_optimisation target)
    if(JOSTLE_UNOPTIMISED AND CMAKE_BUILD_TYPE STREQUAL "Debug" AND NOT JOSTLE_SANITIZE)
        target_compile_options(${target} PRIVATE -O0)
    endif()
endfunction()

# Static library: jostle_library(NAME SOURCES a.cpp ... [PUBLIC libs...] [PRIVATE libs...] [INCLUDE folder of public
# headers])
function(jostle_library name)
    cmake_parse_arguments(arg "" "" "SOURCES;PUBLIC;PRIVATE;INCLUDE" ${ARGN})
    add_library(${name} STATIC ${arg_SOURCES})
    if(arg_INCLUDE)
        target_include_directories(${name} PUBLIC "$<BUILD_INTERFACE:${arg_INCLUDE}>" $<INSTALL_INTERFACE:include>)
    endif()
    target_compile_features(${name} PUBLIC cxx_std_20)
    target_link_libraries(${name} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE} $<BUILD_INTERFACE:jostle_flags>)
    jostle_optimisation(${name})
    jostle_precompiled(${name} libraries)
    jostle_unity_build(${name})
endfunction()

# Program: jostle_program(NAME [SEPARATE_SOURCES] SOURCES main.cpp ... LINK libs...)
function(jostle_program name)
    cmake_parse_arguments(arg "SEPARATE_SOURCES" "" "SOURCES;LINK" ${ARGN})
    add_executable(${name} ${arg_SOURCES})
    target_link_libraries(${name} PRIVATE ${arg_LINK} jostle_flags)
    jostle_optimisation(${name})
    if(NOT "GTest::gtest_main" IN_LIST arg_LINK)  # for base/command_line; tests share a precompiled header
        target_compile_definitions(${name} PRIVATE JOSTLE_VERSION="${PROJECT_VERSION}")
    endif()
    if(NOT arg_SEPARATE_SOURCES)
        jostle_unity_build(${name})
    endif()
endfunction()

# GoogleTest program, one ctest test: jostle_test(NAME [SEPARATE_SOURCES] SOURCES a_test.cpp ... LINK libs... [LABELS l...]
# [TIMEOUT s])
function(jostle_test name)
    cmake_parse_arguments(arg "SEPARATE_SOURCES" "TIMEOUT" "SOURCES;LINK;LABELS" ${ARGN})
    if(arg_SEPARATE_SOURCES)
        set(separate SEPARATE_SOURCES)
    endif()
    jostle_program(${name} ${separate} SOURCES ${arg_SOURCES} LINK ${arg_LINK} GTest::gtest_main GTest::gmock)
    jostle_precompiled(${name} tests)
    add_test(NAME ${name} COMMAND ${name})
    if(NOT arg_TIMEOUT)
        set(arg_TIMEOUT 120)
    endif()
    set_tests_properties(${name} PROPERTIES TIMEOUT ${arg_TIMEOUT} LABELS "${arg_LABELS}")
endfunction()
