# What is installed, in components, all of them where none is named; of a part of another project's tree only with
# CONTDYN_INSTALL=ON:
#
#   cmake --install build --component contdyn_runtime    the shared library, under the name that programs load
#   ...                             contdyn_development  headers, archive, what linkers, pkg-config and CMake look for
#   ...                             contdyn_cpp          the C++ header
#   cmake --build build --target uninstall               removes what the last cmake --install of this build installed

# Whatever is built, all can be installed: the archive is of the objects that the shared library is linked from.
add_dependencies(contdyn contdyn_archive)

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME contdyn_development)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/contdyn)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/contdyn DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.h")
install(TARGETS ${user_targets} EXPORT contdynTargets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT contdyn_runtime NAMELINK_COMPONENT contdyn_development
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT contdyn_runtime
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS contdyn_archive ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT contdynTargets NAMESPACE contdyn:: DESTINATION ${package_dir})

include(CMakePackageConfigHelpers)
configure_file(contdynConfig.cmake.in contdynConfig.cmake @ONLY)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/contdynConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/contdynConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/contdynConfigVersion.cmake
  DESTINATION ${package_dir})

# Paths in contdyn.pc start from where the file lies, so that the installed tree can be moved.
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}" OR IS_ABSOLUTE "${CMAKE_INSTALL_INCLUDEDIR}")
  set(pc_prefix ${CMAKE_INSTALL_PREFIX})
  set(pc_libdir ${CMAKE_INSTALL_FULL_LIBDIR})
  set(pc_includedir ${CMAKE_INSTALL_FULL_INCLUDEDIR})
else()
  file(RELATIVE_PATH up /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
  string(REGEX REPLACE "/$" "" up "${up}")
  set(pc_prefix "\${pcfiledir}/${up}")
  set(pc_libdir "\${prefix}/${CMAKE_INSTALL_LIBDIR}")
  set(pc_includedir "\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}")
endif()
set(pc_more)
if(CONTDYN_URL)
  string(APPEND pc_more "URL: ${CONTDYN_URL}\n")
endif()
if(WIN32)
  string(APPEND pc_more "Cflags.private: -DCD_STATIC\n")
endif()
if(libm)
  string(APPEND pc_more "Libs.private: -lm\n")
endif()
configure_file(${PROJECT_SOURCE_DIR}/pkgconfig/contdyn.pc.in contdyn.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/contdyn.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

if(at_top_level)
  add_custom_target(uninstall
    COMMAND ${CMAKE_COMMAND} -D BUILD=${PROJECT_BINARY_DIR} -P ${CMAKE_CURRENT_SOURCE_DIR}/uninstall.cmake VERBATIM)
endif()
