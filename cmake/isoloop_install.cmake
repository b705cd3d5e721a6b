# Two export sets, so that a program that wants isoloop::core alone needs nothing else of volumes.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(isoloop_package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/isoloop")
foreach(name core volume)
  install(TARGETS isoloop_${name} EXPORT isoloop_${name}
    COMPONENT development INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
  install(EXPORT isoloop_${name} NAMESPACE isoloop:: FILE ${name}Targets.cmake
    DESTINATION "${isoloop_package_folder}" COMPONENT development)
endforeach()
install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/isoloop"
  DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT development FILES_MATCHING PATTERN "*.h")
if(ISOLOOP_TOOLS)
  install(TARGETS isoloop COMPONENT command)
endif()

get_target_property(type isoloop_core TYPE)
set(isoloop_is_static OFF)
if(type STREQUAL STATIC_LIBRARY)
  set(isoloop_is_static ON)
endif()
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/isoloopConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/isoloopConfig.cmake" INSTALL_DESTINATION "${isoloop_package_folder}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/isoloopConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/isoloopConfig.cmake"
  "${PROJECT_BINARY_DIR}/isoloopConfigVersion.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/isoloop_dependencies.cmake"
  DESTINATION "${isoloop_package_folder}" COMPONENT development)

# A static library leaves it to the program to link what it needs.
set(isoloop_links "")
set(isoloop_needs "")
if(isoloop_is_static)
  set(isoloop_links " -lopenvdb")
  set(isoloop_needs "tbb libpng libtiff-4 zlib")
endif()
file(RELATIVE_PATH isoloop_up "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
configure_file("${PROJECT_SOURCE_DIR}/cmake/isoloop.pc.in" "${PROJECT_BINARY_DIR}/isoloop.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/isoloop.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig"
  COMPONENT development)
