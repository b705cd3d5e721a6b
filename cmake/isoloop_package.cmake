# Debian packages of a build with the Python module: isoloop (the command, with pages and completions
# made from its help), libisoloop-dev and python3-isoloop. packaging/build_packages makes them.
find_package(Python 3.9 REQUIRED COMPONENTS Interpreter)
set(help_folder "${PROJECT_BINARY_DIR}/from_help")
add_custom_command(OUTPUT "${help_folder}/bash/isoloop"
  COMMAND "${Python_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/packaging/from_help.py"
    "$<TARGET_FILE:isoloop>" "${help_folder}"
  COMMAND sh -c "gzip -9nf '${help_folder}'/man/*.1"
  DEPENDS isoloop "${PROJECT_SOURCE_DIR}/packaging/from_help.py"
  VERBATIM)
add_custom_target(isoloop_pages ALL DEPENDS "${help_folder}/bash/isoloop")
install(DIRECTORY "${help_folder}/man/" DESTINATION share/man/man1 COMPONENT command)
install(FILES "${help_folder}/bash/isoloop" DESTINATION share/bash-completion/completions
  COMPONENT command)
install(FILES "${help_folder}/zsh/_isoloop" DESTINATION share/zsh/vendor-completions
  COMPONENT command)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME isoloop)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_CONTACT "the isoloop maintainers <isoloop@localhost.localdomain>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL command development python)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# isoloop_debian(COMPONENT NAME SECTION DEPENDS summary...): further summaries are lines of text.
function(isoloop_debian component name section depends summary)
  string(TOUPPER "${component}" upper)
  set(folder "${PROJECT_BINARY_DIR}/debian/${name}")
  configure_file("${PROJECT_SOURCE_DIR}/packaging/copyright" "${folder}/copyright" COPYONLY)
  set(package "${name}")
  configure_file("${PROJECT_SOURCE_DIR}/packaging/changelog.in" "${folder}/changelog" @ONLY)
  execute_process(COMMAND gzip -9nf "${folder}/changelog" COMMAND_ERROR_IS_FATAL ANY)
  install(FILES "${folder}/copyright" "${folder}/changelog.gz" DESTINATION "share/doc/${name}"
    COMPONENT ${component})
  list(JOIN ARGN "\n" text)
  foreach(item "PACKAGE_NAME;${name}" "PACKAGE_SECTION;${section}" "PACKAGE_DEPENDS;${depends}"
      "DESCRIPTION;${summary}\n${text}")
    list(POP_FRONT item key)
    set(CPACK_DEBIAN_${upper}_${key} "${item}" PARENT_SCOPE)
  endforeach()
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${summary}\n${text}" PARENT_SCOPE)
endfunction()

math(EXPR next_python "${Python_VERSION_MINOR} + 1")
isoloop_debian(command isoloop science ""
  "handles and tunnels of solids in volumes, found and proved"
  "Reads CT and MRI volumes, level sets, label maps and meshes, counts components,"
  "tunnels and cavities, and draws a loop round every handle and tunnel of the"
  "iso-surface, which is proved to be one.")
isoloop_debian(development libisoloop-dev libdevel
  "libtbb-dev, libopenvdb-dev, libtiff-dev, libpng-dev, zlib1g-dev, libboost-dev, libboost-iostreams-dev"
  "handles and tunnels of solids in volumes - static libraries and headers"
  "isoloop::core finds loops in spans of numbers, isoloop::volume reads and writes"
  "volumes. CMake finds them by find_package(isoloop), others by pkg-config.")
isoloop_debian(python python3-isoloop python
  "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next_python}), python3-numpy"
  "handles and tunnels of solids in volumes - Python module"
  "The module isoloop counts components, tunnels and cavities of NumPy arrays,"
  "finds and proves every handle and tunnel loop, and repairs them away.")
include(CPack)
