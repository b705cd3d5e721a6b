# What the two libraries link. Read by the build, and by isoloopConfig.cmake, whose users link it too
# where isoloop is static. ${isoloop_required}: REQUIRED or empty.

find_package(TBB 2021.5 CONFIG ${isoloop_required} COMPONENTS tbb)

# A function, since FindOpenVDB sets BUILD_SHARED_LIBS in its caller. TBB was found before it:
# Debian's FindOpenVDB stops with an error otherwise.
function(isoloop_find_openvdb)
  find_path(OPENVDB_MODULE_DIR FindOpenVDB.cmake PATH_SUFFIXES
    lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/OpenVDB lib64/cmake/OpenVDB lib/cmake/OpenVDB)
  mark_as_advanced(OPENVDB_MODULE_DIR)
  if(OPENVDB_MODULE_DIR)
    list(APPEND CMAKE_MODULE_PATH "${OPENVDB_MODULE_DIR}")
  endif()
  find_package(OpenVDB 9.0 ${isoloop_required} COMPONENTS openvdb)
  set(OpenVDB_VERSION "${OpenVDB_VERSION}" PARENT_SCOPE)
endfunction()

# Of isoloop::volume alone.
macro(isoloop_find_volume_dependencies)
  find_package(ZLIB ${isoloop_required})
  find_package(TIFF 4.5 ${isoloop_required})
  find_package(PNG 1.6 ${isoloop_required})
  isoloop_find_openvdb()
endmacro()
