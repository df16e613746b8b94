cmake_minimum_required(VERSION 3.25)
# Copies the shared libraries that the programs in WEFT_PROGRAM_FILES need, and the licences of all installed code.
# libstdc++ and libgcc_s are not copied, because they belong to the compiler; the Vulkan loader and the window system
# are not copied, because they belong to the machine.
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES ${WEFT_PROGRAM_FILES}
  RESOLVED_DEPENDENCIES_VAR carried UNRESOLVED_DEPENDENCIES_VAR missing
  PRE_EXCLUDE_REGEXES "^ld-linux" "^lib(c|m|dl|rt|pthread|stdc\\+\\+|gcc_s)\\.so" "^libvulkan\\.so"
    "^lib(X[A-Za-z0-9]*|xcb|wayland|xkbcommon|GL|EGL|drm)[-a-z0-9]*\\.so")
if(missing)
  message(FATAL_ERROR "shared libraries that are nowhere: ${missing}")
endif()
set(packages ${WEFT_LINKED_PACKAGES})
foreach(library ${carried})
  file(INSTALL ${library} DESTINATION ${CMAKE_INSTALL_PREFIX}/lib/weft FOLLOW_SYMLINK_CHAIN)
  file(REAL_PATH ${library} real)
  get_filename_component(name ${real} NAME)
  # Search for the package by the name of the library without its folder: dpkg may list it in /lib or in /usr/lib,
  # because one of these folders is a link to the other.
  execute_process(COMMAND dpkg-query -S "*/${name}" OUTPUT_VARIABLE owner ERROR_QUIET)
  if(owner MATCHES "^([^:,\n]+)")
    list(APPEND packages ${CMAKE_MATCH_1})
  endif()
endforeach()
list(REMOVE_DUPLICATES packages)
foreach(package ${packages})
  if(EXISTS /usr/share/doc/${package}/copyright)
    file(INSTALL /usr/share/doc/${package}/copyright DESTINATION ${CMAKE_INSTALL_PREFIX}/share/doc/weft/licences
      RENAME ${package})
  else()
    message(WARNING "the licence of ${package} is not at /usr/share/doc/${package}/copyright: add it by hand")
  endif()
endforeach()
