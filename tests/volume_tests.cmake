isoloop_add_tests(isoloop_volume_tests
  SOURCES
    volume_atomic_file_test.cpp
    volume_curve_distance_test.cpp
    volume_engine_block_test.cpp
    volume_file_kind_test.cpp
    volume_memory_limit_test.cpp
    volume_raw_test.cpp
    volume_read_test.cpp
    volume_shape_field_test.cpp
    volume_shapes_test.cpp
    volume_vdb_test.cpp
    volume_volume_test.cpp
    volume_write_test.cpp
  LIBRARIES isoloop::volume OpenVDB::openvdb TBB::tbb)
