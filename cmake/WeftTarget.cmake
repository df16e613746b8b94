# Defines the compiler options and the functions for all targets of Weft: warnings, sanitizers, libraries, tests.

add_library(weft_options INTERFACE)
target_compile_options(weft_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wcast-qual -Woverloaded-virtual
  # Initialisers may leave out members, which are then zero. This is usual for Vulkan structs.
  -Wno-missing-field-initializers
  -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 warns of overlaps in operator+ of std::string that do not exist (GCC bug 105329).
  target_compile_options(weft_options INTERFACE -Wno-restrict)
  if(NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
    # g++ exempts system headers from warnings, but not if they are in a precompiled header. This causes more false
    # warnings (GCC bug 105651).
    target_compile_options(weft_options INTERFACE -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
  endif()
endif()
if(WEFT_SANITIZE)
  # UBSan's check `vptr` is off: it needs RTTI, and glslang and SPIRV-Tools are built without RTTI.
  target_compile_options(weft_options INTERFACE
    -fsanitize=${WEFT_SANITIZE} -fno-sanitize=vptr -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(weft_options INTERFACE -fsanitize=${WEFT_SANITIZE} -fno-sanitize=vptr)
endif()

# Most code of tests runs only once after it is compiled, so that optimisation costs more time than it saves. The tests
# that compute reference pictures are optimised.
foreach(level 0 1)
  add_library(weft_test_options_${level} INTERFACE)
  target_link_libraries(weft_test_options_${level} INTERFACE weft_options)
  target_compile_options(weft_test_options_${level} INTERFACE $<$<CONFIG:Release>:-O${level}>)
endforeach()
# Precompiles the headers of the standard library, which take half of the time to compile a source. Weft's own headers
# are not precompiled, because then a change of one header would compile all sources again. To find a source in which
# an #include is missing, build with -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON.
set(WEFT_PRECOMPILED <algorithm> <array> <cmath> <cstdint> <cstring> <functional> <map> <memory> <numeric> <optional>
    <set> <span> <string> <string_view> <tuple> <utility> <vector>)
add_library(weft_precompiled OBJECT ${CMAKE_CURRENT_LIST_DIR}/precompiled.cpp)
target_link_libraries(weft_precompiled PRIVATE weft_options)
target_precompile_headers(weft_precompiled PRIVATE ${WEFT_PRECOMPILED})
if(WEFT_TESTS)
  foreach(level 0 1)
    add_library(weft_precompiled_tests_${level} OBJECT ${CMAKE_CURRENT_LIST_DIR}/precompiled.cpp)
    target_link_libraries(weft_precompiled_tests_${level} PRIVATE weft_test_options_${level} GTest::gtest)
    target_precompile_headers(weft_precompiled_tests_${level} PRIVATE ${WEFT_PRECOMPILED} <filesystem> <fstream>
      <random> <sstream> <thread> <glm/glm.hpp> <vulkan/vulkan_core.h> <gtest/gtest.h>)
  endforeach()
endif()

# With WEFT_UNITY, all sources of a folder are compiled as one source, so that the headers that they include are
# compiled only once. For this, names in unnamed namespaces are unique within a folder. After an edit the whole folder
# is compiled again, so the preset `debug` compiles sources one by one.
option(WEFT_UNITY "Compile the sources of a folder as one" OFF)
function(weft_unity name)
  set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${name} SOURCES)
  foreach(source ${sources})
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
    cmake_path(GET source PARENT_PATH folder)
    file(RELATIVE_PATH group ${PROJECT_SOURCE_DIR} ${folder})
    string(MAKE_C_IDENTIFIER "${group}" group)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
  endforeach()
endfunction()

# weft_library(NAME SOURCES...) adds a static library with the include folders and compiler options of Weft.
function(weft_library name)
  add_library(${name} STATIC ${ARGN})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR}/framework/include ${PROJECT_SOURCE_DIR}/framework)
  target_link_libraries(${name} PRIVATE weft_options)
  target_precompile_headers(${name} REUSE_FROM weft_precompiled)
  if(WEFT_UNITY)
    weft_unity(${name})
  endif()
endfunction()

# A test that runs longer than this number of seconds fails, because it probably hangs. The time is much longer than
# any test takes on a busy machine, so that results do not depend on time.
set(WEFT_HANG_S 1800)

# weft_test(NAME [OPTIMISED] LIBS lib... [LABELS label...] SOURCES file...) adds a test program that uses GoogleTest.
# OPTIMISED compiles the program with -O1: for tests that compute reference pictures. The program is asked for its tests
# when the tests are run, not during the build. So a program that hangs cannot hang the build.
function(weft_test name)
  cmake_parse_arguments(ARG "OPTIMISED" "" "LIBS;LABELS;SOURCES" ${ARGN})
  set(level 0)
  if(ARG_OPTIMISED)
    set(level 1)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/framework ${PROJECT_SOURCE_DIR})
  target_compile_definitions(${name} PRIVATE WEFT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE weft_test_options_${level} ${ARG_LIBS} GTest::gtest_main)
  target_precompile_headers(${name} REUSE_FROM weft_precompiled_tests_${level})
  if(WEFT_UNITY)
    weft_unity(${name})
  endif()
  set(script ${CMAKE_CURRENT_BINARY_DIR}/${name}_suites.cmake)
  file(GENERATE OUTPUT ${script} CONTENT "
    set(name ${name})
    set(program $<TARGET_FILE:${name}>)
    set(folder ${CMAKE_CURRENT_BINARY_DIR})
    set(results ${PROJECT_BINARY_DIR}/results)
    set(timeout_s ${WEFT_HANG_S})
    set(labels ${ARG_LABELS})
    include(${PROJECT_SOURCE_DIR}/cmake/AddTestSuites.cmake)
  ")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${script})
endfunction()
