isoloop_add_tests(isoloop_volume_tests
  SOURCES
    volume/base/atomic_file_test.cpp
    volume/slices/bmp_test.cpp
    volume/base/child_process_test.cpp
    volume/voxels/crop_test.cpp
    volume/shapes/curve_distance_test.cpp
    volume/formats/dicom_test.cpp
    volume/shapes/engine_block_test.cpp
    volume/base/file_kind_test.cpp
    volume/voxels/labels_test.cpp
    volume/voxels/length_unit_test.cpp
    volume/base/memory_limit_test.cpp
    volume/mesh_topology/mesh_counts_test.cpp
    volume/mesh_topology/mesh_crossing_test.cpp
    volume/mesh/mesh_test.cpp
    volume/mesh_topology/mesh_tree_test.cpp
    volume/mesh/mesh_untidy_test.cpp
    volume/mesh/mesh_weld_test.cpp
    volume/formats/meta_image_test.cpp
    volume/formats/nifti_test.cpp
    volume/formats/npy_test.cpp
    volume/formats/nrrd_test.cpp
    volume/files/patch_test.cpp
    volume/voxels/placement_test.cpp
    volume/slices/png_test.cpp
    volume/formats/raw_test.cpp
    volume/files/read_test.cpp
    volume/shapes/shape_field_test.cpp
    volume/shapes/shapes_test.cpp
    volume/slices/slice_folder_test.cpp
    volume/slices/slice_names_test.cpp
    volume/voxels/stored_voxels_test.cpp
    volume/slices/tiff_planes_test.cpp
    volume/slices/tiff_test.cpp
    volume/vdb/vdb_message_test.cpp
    volume/vdb/vdb_test.cpp
    volume/voxels/volume_test.cpp
    volume/voxelize/voxelize_auto_test.cpp
    volume/voxelize/voxelize_test.cpp
    volume/formats/vti_test.cpp
    volume/files/write_test.cpp
  LIBRARIES isoloop::volume isoloop_vdb_decode OpenVDB::openvdb TBB::tbb TIFF::TIFF ZLIB::ZLIB)

add_executable(isoloop_child_for_tests samples/child_for_tests.cpp)
target_link_libraries(isoloop_child_for_tests PRIVATE isoloop::volume isoloop_options)
target_compile_definitions(isoloop_volume_tests PRIVATE
  ISOLOOP_CHILD_FOR_TESTS="$<TARGET_FILE:isoloop_child_for_tests>")
add_dependencies(isoloop_volume_tests isoloop_child_for_tests)
