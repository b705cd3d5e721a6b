get_filename_component(isoloop_public_headers "${CMAKE_CURRENT_LIST_DIR}/../include" ABSOLUTE)

# isoloop_library(NAME source...): isoloop_NAME, known to its users as isoloop::NAME. They see the
# public headers.
function(isoloop_library name)
  add_library(isoloop_${name} ${ARGN})
  add_library(isoloop::${name} ALIAS isoloop_${name})
  target_compile_features(isoloop_${name} PUBLIC cxx_std_20)
  target_include_directories(isoloop_${name} PUBLIC
    "$<BUILD_INTERFACE:${isoloop_public_headers}>")
  target_link_libraries(isoloop_${name} PRIVATE "$<BUILD_INTERFACE:isoloop_options>")
  set_target_properties(isoloop_${name} PROPERTIES
    EXPORT_NAME ${name} VERSION "${PROJECT_VERSION}" SOVERSION "${PROJECT_VERSION_MAJOR}")
  # Stages and readers that are alike have functions of the same name, each its own.
  set_target_properties(isoloop_${name} PROPERTIES UNITY_BUILD OFF)
endfunction()
