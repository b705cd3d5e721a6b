isoloop_add_tests(isoloop_core_tests
  SOURCES
    core_betti_test.cpp
    core_cube_test.cpp
    core_dual_pass_test.cpp
    core_surface_test.cpp
    explicit_complex.cpp
    random_volumes.cpp
  LIBRARIES isoloop::core TBB::tbb)
