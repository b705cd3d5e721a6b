isoloop_add_tests(isoloop_core_tests
  SOURCES
    core_analysis_test.cpp
    core_basis_exchange_test.cpp
    core_betti_test.cpp
    core_bit_column_test.cpp
    core_bounded_search_test.cpp
    core_bucket_queue_test.cpp
    core_certificate_test.cpp
    core_class_passage_test.cpp
    core_closest_test.cpp
    core_connectivity_test.cpp
    core_cube_interior_test.cpp
    core_cube_sweep_test.cpp
    core_cube_test.cpp
    core_ties_test.cpp
    core_disjoint_sets_test.cpp
    core_dual_pass_test.cpp
    core_edge_index_test.cpp
    core_edge_set_test.cpp
    core_features_test.cpp
    core_geodesic_size_test.cpp
    core_geodesic_test.cpp
    core_grid_complex_test.cpp
    core_killing_border_test.cpp
    core_label_test.cpp
    core_lattice_test.cpp
    core_level_test.cpp
    core_loop_matching_test.cpp
    core_loop_search_test.cpp
    core_loops_test.cpp
    core_membrane_test.cpp
    core_memory_budget_test.cpp
    core_open_boundary_test.cpp
    core_order_test.cpp
    core_pair_loops_test.cpp
    core_pair_test.cpp
    core_per_thread_test.cpp
    core_plateau_test.cpp
    core_repair_test.cpp
    core_rows_test.cpp
    core_run_both_test.cpp
    core_scan_test.cpp
    core_shortest_basis_test.cpp
    core_sides_test.cpp
    core_sleeve_test.cpp
    core_spanning_forest_test.cpp
    core_straighten_test.cpp
    core_surface_hierarchy_test.cpp
    core_surface_order_test.cpp
    core_surface_test.cpp
    core_threads_test.cpp
    core_triangle_fans_test.cpp
    core_vertex_cut_test.cpp
    core_vertex_pairs_test.cpp
    core_voxel_values_test.cpp
    core_z2_basis_test.cpp
    core_zero_labels_test.cpp
    cube_geometry.cpp
    exact_basis.cpp
    explicit_complex.cpp
    layers_test.cpp
    literal_pair.cpp
    random_volumes.cpp
    refined_cube.cpp
    refined_field.cpp
    slow_killing.cpp
    slow_reduction.cpp
    swept_cube.cpp
    swept_volume.cpp
  LIBRARIES isoloop::core TBB::tbb)
target_compile_definitions(isoloop_core_tests PRIVATE ISOLOOP_SOURCE="${PROJECT_SOURCE_DIR}")

# Ten thousand random volumes through both engines and repaired to genus 0, five hundred beside the
# least length that loops can have, millions of cubes and sixty fields beside their refinements, and
# scans of real volumes beside 256 counts each: minutes, so neither built nor run by default.
#   cmake --build --preset release --target isoloop_slow_tests
#   build/release/tests/isoloop_slow_tests
add_executable(isoloop_slow_tests EXCLUDE_FROM_ALL
  core_pair_slow_test.cpp
  core_repair_slow_test.cpp
  core_scan_slow_test.cpp
  core_shortest_basis_slow_test.cpp
  core_topology_slow_test.cpp
  cube_geometry.cpp
  exact_basis.cpp
  random_volumes.cpp
  refined_cube.cpp
  refined_field.cpp
  swept_cube.cpp
  swept_volume.cpp)
target_link_libraries(isoloop_slow_tests PRIVATE
  isoloop::core isoloop::volume isoloop_options TBB::tbb GTest::gtest_main)
target_compile_definitions(isoloop_slow_tests PRIVATE
  ISOLOOP_TEST_DATA="${PROJECT_SOURCE_DIR}/../shared/data")
