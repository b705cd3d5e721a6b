isoloop_add_tests(isoloop_core_tests
  SOURCES
    core/analysis/analysis_test.cpp
    core/tighten/basis_exchange_test.cpp
    core/surface/betti_test.cpp
    core/z2/bit_column_test.cpp
    core/sizes/bounded_search_test.cpp
    core/sizes/bucket_queue_test.cpp
    core/loops/certificate_test.cpp
    core/repair/change_effect_test.cpp
    core/repair/homology_map_test.cpp
    core/sizes/closest_test.cpp
    core/sizes/point_tree_test.cpp
    core/octree/ranked_bits_test.cpp
    core/cube/connectivity_test.cpp
    core/cube/cube_interior_test.cpp
    core/scan/blocks_test.cpp
    core/scan/cube_sweep_test.cpp
    core/scan/parting_test.cpp
    core/cube/cube_test.cpp
    core/cube/ties_test.cpp
    core/base/disjoint_sets_test.cpp
    core/engines/dual_pass_test.cpp
    core/surface/edge_index_test.cpp
    core/surface/edge_set_test.cpp
    core/loops/features_test.cpp
    core/sizes/geodesic_size_test.cpp
    core/curves/geodesic_test.cpp
    core/complex/flat_complex_test.cpp
    core/complex/grid_complex_test.cpp
    core/complex/octree_complex_test.cpp
    core/octree/octree_test.cpp
    core/loops/killing_border_test.cpp
    core/z2/label_test.cpp
    core/grid/lattice_test.cpp
    core/grid/level_test.cpp
    core/grid/vec3_test.cpp
    core/tighten/loop_matching_test.cpp
    core/loops/loop_search_test.cpp
    core/library/library_test.cpp
    core/loops/loops_test.cpp
    core/repair/membrane_test.cpp
    core/base/memory_budget_test.cpp
    core/analysis/octree_analysis_test.cpp
    core/analysis/open_boundary_test.cpp
    core/analysis/shorten_below_test.cpp
    core/complex/order_test.cpp
    core/loops/pair_loops_test.cpp
    core/engines/pair_test.cpp
    core/base/per_thread_test.cpp
    core/base/potentials_test.cpp
    core/scan/plateau_test.cpp
    core/scan/proposal_test.cpp
    core/scan/sized_sets_test.cpp
    core/repair/repair_round_test.cpp
    core/repair/repair_test.cpp
    core/base/compressed_rows_test.cpp
    core/base/run_both_test.cpp
    core/scan/scan_test.cpp
    core/tighten/shortest_basis_test.cpp
    core/cube/voxel_sides_test.cpp
    core/curves/sleeve_test.cpp
    core/engines/spanning_forest_test.cpp
    core/tighten/straighten_test.cpp
    core/sizes/surface_hierarchy_test.cpp
    core/surface/surface_order_test.cpp
    core/surface/surface_test.cpp
    core/base/threads_test.cpp
    core/curves/triangle_fans_test.cpp
    core/repair/vertex_cut_test.cpp
    core/sizes/vertex_pairs_test.cpp
    core/repair/voxel_values_test.cpp
    core/z2/z2_basis_test.cpp
    core/z2/z2_vector_test.cpp
    core/engines/zero_labels_test.cpp
    oracles/cube_geometry.cpp
    oracles/exact_basis.cpp
    oracles/explicit_complex.cpp
    docs_test.cpp
    layers_test.cpp
    oracles/literal_pair.cpp
    oracles/random_volumes.cpp
    oracles/refined_cube.cpp
    oracles/refined_field.cpp
    oracles/slow_killing.cpp
    oracles/slow_reduction.cpp
    oracles/swept_cube.cpp
    oracles/swept_volume.cpp
    oracles/tetrahedra.cpp
  LIBRARIES isoloop::core TBB::tbb)
target_compile_definitions(isoloop_core_tests PRIVATE ISOLOOP_SOURCE="${PROJECT_SOURCE_DIR}")

# Ten thousand random volumes through both engines and repaired to genus 0, five hundred beside the
# least length that loops can have, millions of cubes and sixty fields beside their refinements, and
# scans of real volumes beside 256 counts each: minutes, so neither built nor run by default.
#   cmake --build --preset release --target isoloop_slow_tests
#   build/release/tests/isoloop_slow_tests
add_executable(isoloop_slow_tests EXCLUDE_FROM_ALL
  core/complex/octree_complex_slow_test.cpp
  core/engines/pair_slow_test.cpp
  core/repair/repair_slow_test.cpp
  core/scan/scan_slow_test.cpp
  core/tighten/shortest_basis_slow_test.cpp
  core/cube/topology_slow_test.cpp
  oracles/cube_geometry.cpp
  oracles/exact_basis.cpp
  oracles/random_volumes.cpp
  oracles/refined_cube.cpp
  oracles/refined_field.cpp
  oracles/swept_cube.cpp
  oracles/swept_volume.cpp)
target_link_libraries(isoloop_slow_tests PRIVATE
  isoloop::core isoloop::volume isoloop_options TBB::tbb GTest::gtest_main)
target_compile_definitions(isoloop_slow_tests PRIVATE
  ISOLOOP_TEST_DATA="${PROJECT_SOURCE_DIR}/../shared/data")
