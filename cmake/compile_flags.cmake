# Every flag that decides what our sources mean, in one place. jostle_library() and jostle_program() apply them.

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

add_library(jostle_flags INTERFACE)

# Private headers are included by their path from the project folder, public ones by jostle/LIBRARY/NAME.h.
target_include_directories(jostle_flags INTERFACE ${PROJECT_SOURCE_DIR})

# Floating point: the same bits from every compiler, optimisation level and CPU. Contraction would fuse a*b+c on some
# targets only; fast-math would reorder sums. errno from sqrt is never read, and leaving it out lets sqrt be one instruction.
target_compile_options(jostle_flags INTERFACE -ffp-contract=off -fno-fast-math -fno-math-errno)
# GCC 12 fuses alternating sums and differences (vfmaddsub) whatever -ffp-contract says, if CMAKE_CXX_FLAGS has -march=native or so. What
# the solver fuses is written out, in sources with flags of their own (physics/CMakeLists.txt).
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    target_compile_options(jostle_flags INTERFACE -mno-fma -mno-fma4 -mno-avx512f)
endif()

target_compile_options(jostle_flags INTERFACE
    -Wall -Wextra $<$<BOOL:${PROJECT_IS_TOP_LEVEL}>:-Werror> -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Wold-style-cast
    -Woverloaded-virtual -Wunused -Wcast-align -Wdouble-promotion)
# Designated initialisers name what differs from the defaults; the fields left out are meant to be left out.
target_compile_options(jostle_flags INTERFACE -Wno-missing-field-initializers)
# GCC 12 sees overlapping copies in std::string's operator+ where there are none (GCC bug 105651).
target_compile_options(jostle_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# ... and, optimising, members of a variant read that it does not hold (GCC bug 105562). The sanitizers' builds look for real ones.
target_compile_options(jostle_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
# Clang warns of a float that fills a double on purpose, as where the solver's lanes become a Vec3; GCC does not.
target_compile_options(jostle_flags INTERFACE $<$<CXX_COMPILER_ID:Clang>:-Wno-double-promotion>)
# The eight-wide vector type is passed between our own inline functions only, so its calling convention does not matter.
target_compile_options(jostle_flags INTERFACE -Wno-psabi)

# Some of what we link asks for it; a precompiled header fits only where all sources agree.
if(NOT CMAKE_SYSTEM_NAME STREQUAL WASI)  # has no threads
    target_compile_options(jostle_flags INTERFACE -pthread)
endif()

# Builds that are made once and thrown away take less time when the sources of a target are compiled eight together: most of what the
# compiler reads is headers. So no two sources of a target use one name for different things; where they must, the target says APART.
# One source's constant is then another's shadow, and what is in an unnamed namespace looks as if it were in a header's.
if(JOSTLE_TOGETHER)
    target_compile_options(jostle_flags INTERFACE -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()
function(jostle_together target)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ${JOSTLE_TOGETHER} UNITY_BUILD_BATCH_SIZE 8)
endfunction()

if(JOSTLE_ASSERT)
    target_compile_definitions(jostle_flags INTERFACE JOSTLE_ASSERT=1)
endif()

if(JOSTLE_SANITIZE)
    set(sanitize -fsanitize=${JOSTLE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    add_compile_options(${sanitize})
    target_compile_options(jostle_flags INTERFACE -Wno-error)  # see precompiled.cmake
    add_link_options(${sanitize})
    if(JOSTLE_SANITIZE MATCHES thread)
        # The thread sanitizer does not understand fences; Asio's locks order everything we hand over without them.
        add_compile_definitions(BOOST_ASIO_DISABLE_FENCED_BLOCK)
    endif()
endif()

# Sanitized by address it takes twice as long to compile when it is optimised, and what is tested so does not wait for it.
function(jostle_unoptimised_when_sanitized)
    if(JOSTLE_SANITIZE MATCHES address)
        foreach(target ${ARGN})
            target_compile_options(${target} PRIVATE -O0)
        endforeach()
    endif()
endfunction()

# A static library of ours: jostle_library(NAME SOURCES a.cpp ... [PUBLIC libs...] [PRIVATE libs...] [INCLUDE folder of public headers])
function(jostle_library name)
    cmake_parse_arguments(arg "" "" "SOURCES;PUBLIC;PRIVATE;INCLUDE" ${ARGN})
    add_library(${name} STATIC ${arg_SOURCES})
    if(arg_INCLUDE)
        target_include_directories(${name} PUBLIC "$<BUILD_INTERFACE:${arg_INCLUDE}>" $<INSTALL_INTERFACE:include>)
    endif()
    target_compile_features(${name} PUBLIC cxx_std_20)
    target_link_libraries(${name} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE} $<BUILD_INTERFACE:jostle_flags>)
    jostle_precompiled(${name} libraries)
    jostle_together(${name})
endfunction()

# A program of ours: jostle_program(NAME [APART] SOURCES main.cpp ... LINK libs...)
function(jostle_program name)
    cmake_parse_arguments(arg "APART" "" "SOURCES;LINK" ${ARGN})
    add_executable(${name} ${arg_SOURCES})
    target_link_libraries(${name} PRIVATE ${arg_LINK} jostle_flags)
    if(NOT arg_APART)
        jostle_together(${name})
    endif()
endfunction()

# A GoogleTest program that ctest runs whole: jostle_test(NAME [APART] SOURCES a_test.cpp ... LINK libs... [LABELS l...] [TIMEOUT s])
function(jostle_test name)
    cmake_parse_arguments(arg "APART" "TIMEOUT" "SOURCES;LINK;LABELS" ${ARGN})
    if(arg_APART)
        set(apart APART)
    endif()
    jostle_program(${name} ${apart} SOURCES ${arg_SOURCES} LINK ${arg_LINK} GTest::gtest_main GTest::gmock)
    jostle_precompiled(${name} tests)
    add_test(NAME ${name} COMMAND ${name})
    if(NOT arg_TIMEOUT)
        set(arg_TIMEOUT 120)
    endif()
    set_tests_properties(${name} PROPERTIES TIMEOUT ${arg_TIMEOUT} LABELS "${arg_LABELS}")
endfunction()
