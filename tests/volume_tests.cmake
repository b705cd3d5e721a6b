isoloop_add_tests(isoloop_volume_tests
  SOURCES
    volume_atomic_file_test.cpp
    volume_bmp_test.cpp
    volume_child_process_test.cpp
    volume_crop_test.cpp
    volume_curve_distance_test.cpp
    volume_dicom_test.cpp
    volume_engine_block_test.cpp
    volume_file_kind_test.cpp
    volume_labels_test.cpp
    volume_length_unit_test.cpp
    volume_memory_limit_test.cpp
    volume_mesh_test.cpp
    volume_mesh_untidy_test.cpp
    volume_meta_image_test.cpp
    volume_nifti_test.cpp
    volume_npy_test.cpp
    volume_nrrd_test.cpp
    volume_patch_test.cpp
    volume_placement_test.cpp
    volume_png_test.cpp
    volume_raw_test.cpp
    volume_read_test.cpp
    volume_shape_field_test.cpp
    volume_shapes_test.cpp
    volume_slice_folder_test.cpp
    volume_slice_names_test.cpp
    volume_stored_voxels_test.cpp
    volume_tiff_planes_test.cpp
    volume_tiff_test.cpp
    volume_vdb_message_test.cpp
    volume_vdb_test.cpp
    volume_volume_test.cpp
    volume_voxelize_test.cpp
    volume_vti_test.cpp
    volume_write_test.cpp
  LIBRARIES isoloop::volume isoloop_vdb_decode OpenVDB::openvdb TBB::tbb TIFF::TIFF ZLIB::ZLIB)

add_executable(isoloop_child_for_tests child_for_tests.cpp)
target_link_libraries(isoloop_child_for_tests PRIVATE isoloop::volume isoloop_options)
target_compile_definitions(isoloop_volume_tests PRIVATE
  ISOLOOP_CHILD_FOR_TESTS="$<TARGET_FILE:isoloop_child_for_tests>")
add_dependencies(isoloop_volume_tests isoloop_child_for_tests)
