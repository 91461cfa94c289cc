# Installs the library, its headers, its licence, and the files with which CMake and pkg-config find it.

include(CMakePackageConfigHelpers)
set(waywright_config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/waywright)

install(TARGETS waywright EXPORT waywright_targets)
install(
  DIRECTORY ${PROJECT_SOURCE_DIR}/include/waywright
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING
  PATTERN "*.hpp")
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/waywright)

install(
  EXPORT waywright_targets
  NAMESPACE waywright::
  FILE waywright-targets.cmake
  DESTINATION ${waywright_config_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/waywright-config.cmake.in
                              ${PROJECT_BINARY_DIR}/waywright-config.cmake INSTALL_DESTINATION ${waywright_config_dir})
# Before 1.0, a minor version may break promises of the version before.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/waywright-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/waywright-config.cmake ${PROJECT_BINARY_DIR}/waywright-config-version.cmake
        DESTINATION ${waywright_config_dir})

# Paths in waywright.pc are relative to that file, so that an installed tree can be moved. If the library's folder was
# given as an absolute path, they are absolute.
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}" OR IS_ABSOLUTE "${CMAKE_INSTALL_INCLUDEDIR}")
  set(waywright_pc_prefix ${CMAKE_INSTALL_PREFIX})
  set(waywright_pc_libdir ${CMAKE_INSTALL_FULL_LIBDIR})
  set(waywright_pc_includedir ${CMAKE_INSTALL_FULL_INCLUDEDIR})
else()
  file(RELATIVE_PATH waywright_pc_up /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
  string(REGEX REPLACE "/$" "" waywright_pc_up "${waywright_pc_up}")
  set(waywright_pc_prefix "\${pcfiledir}/${waywright_pc_up}")
  set(waywright_pc_libdir "\${prefix}/${CMAKE_INSTALL_LIBDIR}")
  set(waywright_pc_includedir "\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}")
endif()
set(waywright_pc_cflags "")
if(waywright_is_shared)
  set(waywright_pc_cflags " -DWAYWRIGHT_SHARED")
endif()
set(waywright_pc_threads "${CMAKE_THREAD_LIBS_INIT}")
if(NOT waywright_pc_threads AND UNIX)
  set(waywright_pc_threads -pthread)  # no effect if the C library contains threads
endif()
configure_file(${PROJECT_SOURCE_DIR}/cmake/waywright.pc.in ${PROJECT_BINARY_DIR}/waywright.pc @ONLY)
if(WAYWRIGHT_BUILD_C)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/waywright_c.pc.in ${PROJECT_BINARY_DIR}/waywright_c.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/waywright_c.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()
install(FILES ${PROJECT_BINARY_DIR}/waywright.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
