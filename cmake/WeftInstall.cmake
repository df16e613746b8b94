# Defines the folder that `cmake --install BUILD --prefix DIR` makes. The folder can be moved. bin/ has the programs.
# lib/weft/ has the shared libraries that the programs need, except libc, libstdc++, the Vulkan loader and the window
# system. share/weft/ has the data files of the programs. include/ and lib/ are for embedders (docs/embedding.md).
include(CMakePackageConfigHelpers)

# The programs to install. Their shared libraries are copied, too.
set(WEFT_PROGRAMS weft weft-shader-worker)
# The libraries of the framework that embedders need. They are installed as one archive, libweft.a.
set(WEFT_EMBEDDED_LIBRARIES weft_graph weft_check weft_file weft_glsl weft_shader weft_load weft_scene weft_image weft_vulkan weft_render weft_passes)
# Debian packages whose code is compiled into the programs or linked statically. Their licences are copied, too.
set(WEFT_LINKED_PACKAGES glslang-dev spirv-tools libtinygltf-dev libglm-dev nlohmann-json3-dev libcli11-dev)

# Installs the programs. They search for shared libraries in lib/weft. This path is written as DT_RPATH and not as
# DT_RUNPATH, because only DT_RPATH is also used for the libraries that a shared library needs.
set_target_properties(${WEFT_PROGRAMS} PROPERTIES INSTALL_RPATH "$ORIGIN/../lib/weft")
set_property(TARGET ${WEFT_PROGRAMS} APPEND PROPERTY LINK_OPTIONS "LINKER:--disable-new-dtags")
install(TARGETS ${WEFT_PROGRAMS} RUNTIME DESTINATION bin)
set(program_files "")
foreach(program ${WEFT_PROGRAMS})
  list(APPEND program_files "$<TARGET_FILE:${program}>")
endforeach()
install(CODE "set(WEFT_PROGRAM_FILES \"${program_files}\")
set(WEFT_LINKED_PACKAGES \"${WEFT_LINKED_PACKAGES}\")")
install(SCRIPT ${CMAKE_CURRENT_LIST_DIR}/install_carried.cmake)

# Installs the data files of the programs: graphs, shaders, device profiles, and the pages about using Weft with their
# pictures and examples. The program reads docs/diagnostics.md, whose examples are in tests/diagnostics.
install(DIRECTORY graphs shaders DESTINATION share/weft)
install(DIRECTORY docs DESTINATION share/weft PATTERN *.sh EXCLUDE PATTERN architecture.md EXCLUDE
        PATTERN changing-weft.md EXCLUDE PATTERN projects.md EXCLUDE)
install(DIRECTORY tests/diagnostics DESTINATION share/weft/tests)
install(DIRECTORY framework/profiles/ DESTINATION share/weft/profiles)

# Installs the public headers without change.
install(DIRECTORY framework/include/weft DESTINATION include FILES_MATCHING PATTERN *.h)

# Installs the archive for embedders, and the files with which CMake and pkg-config find the archive and its
# dependencies.
add_library(weft_embedded STATIC)
foreach(library ${WEFT_EMBEDDED_LIBRARIES})
  target_sources(weft_embedded PRIVATE $<TARGET_OBJECTS:${library}>)
endforeach()
set_target_properties(weft_embedded PROPERTIES OUTPUT_NAME weft EXPORT_NAME weft LINKER_LANGUAGE CXX
                      ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)
# The headers in shaders/include/shared are both GLSL and C++.
target_include_directories(weft_embedded INTERFACE $<INSTALL_INTERFACE:include>
                           $<INSTALL_INTERFACE:share/weft/shaders/include>)
target_compile_features(weft_embedded INTERFACE cxx_std_20)
# The archive's dependencies. They are needed only in the installed package, because no target of this build links to
# the archive.
set(needs glm::glm glslang::SPIRV glslang::glslang glslang::glslang-default-resource-limits SPIRV-Tools-opt
  SPIRV-Tools-static Threads::Threads ${CMAKE_DL_LIBS} weft::carried)
target_link_libraries(weft_embedded INTERFACE "$<INSTALL_INTERFACE:${needs}>")
# A smaller archive for programs that only run cooked graphs. It needs no GLSL compiler.
add_library(weft_runtime STATIC)
foreach(library weft_graph weft_check weft_vulkan weft_passes)
  target_sources(weft_runtime PRIVATE $<TARGET_OBJECTS:${library}>)
endforeach()
set_target_properties(weft_runtime PROPERTIES EXPORT_NAME runtime LINKER_LANGUAGE CXX
                      ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)
target_include_directories(weft_runtime INTERFACE $<INSTALL_INTERFACE:include>)
target_compile_features(weft_runtime INTERFACE cxx_std_20)
set(needs glm::glm Threads::Threads ${CMAKE_DL_LIBS} weft::carried_by_runtime)
target_link_libraries(weft_runtime INTERFACE "$<INSTALL_INTERFACE:${needs}>")
install(TARGETS weft_embedded weft_runtime EXPORT weft ARCHIVE DESTINATION lib)
install(EXPORT weft FILE weftTargets.cmake NAMESPACE weft:: DESTINATION lib/cmake/weft)

# Finds the sonames of the shared libraries that the archive needs, such as libpng16.so.16.
find_library(TINYEXR_LIBRARY tinyexr REQUIRED)
set(WEFT_CARRIED "")
foreach(library ${XXHASH_LIBRARY} ${PNG_LIBRARY} ${JPEG_LIBRARY} ${TINYEXR_LIBRARY} ${WEFT_SPIRV_CROSS_LIBRARY})
  execute_process(COMMAND ${CMAKE_OBJDUMP} -p ${library} OUTPUT_VARIABLE header COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCH "SONAME +([^\n]+)" unused "${header}")
  list(APPEND WEFT_CARRIED ${CMAKE_MATCH_1})
endforeach()
list(GET WEFT_CARRIED 0 WEFT_CARRIED_BY_RUNTIME)  # The soname of xxhash.
list(TRANSFORM WEFT_CARRIED PREPEND "-l:" OUTPUT_VARIABLE WEFT_CARRIED_FLAGS)
list(JOIN WEFT_CARRIED_FLAGS " " WEFT_CARRIED_FLAGS)
configure_package_config_file(cmake/weftConfig.cmake.in ${PROJECT_BINARY_DIR}/weftConfig.cmake
  INSTALL_DESTINATION lib/cmake/weft)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/weftConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/weftConfig.cmake ${PROJECT_BINARY_DIR}/weftConfigVersion.cmake
  DESTINATION lib/cmake/weft)
configure_file(cmake/weft.pc.in ${PROJECT_BINARY_DIR}/weft.pc @ONLY)
configure_file(cmake/weft_runtime.pc.in ${PROJECT_BINARY_DIR}/weft_runtime.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/weft.pc ${PROJECT_BINARY_DIR}/weft_runtime.pc DESTINATION lib/pkgconfig)
