# The package `impetus` for Python: its files and the module _impetus, in build/python/impetus, and in
# the Debian package.
find_package(Python 3.11 REQUIRED COMPONENTS Interpreter Development.Module)
find_package(pybind11 REQUIRED)
set(package ${CMAKE_BINARY_DIR}/python/impetus)
file(GLOB python_sources CONFIGURE_DEPENDS python/*.cpp)
pybind11_add_module(impetus_python NO_EXTRAS ${python_sources})
set_target_properties(impetus_python PROPERTIES OUTPUT_NAME _impetus
  LIBRARY_OUTPUT_DIRECTORY ${package})
target_link_libraries(impetus_python PRIVATE impetus_flags impetus_files impetus_store impetus_study
  impetus_observers impetus_exports impetus_provenance)

file(GLOB package_files CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/impetus/*.py
  ${CMAKE_CURRENT_LIST_DIR}/impetus/*.pyi ${CMAKE_CURRENT_LIST_DIR}/impetus/py.typed)
add_custom_command(OUTPUT ${CMAKE_BINARY_DIR}/python/copied
  COMMAND ${CMAKE_COMMAND} -E copy ${package_files} ${package}
  COMMAND ${CMAKE_COMMAND} -E touch ${CMAKE_BINARY_DIR}/python/copied
  DEPENDS ${package_files})
add_custom_target(impetus_python_files ALL DEPENDS ${CMAKE_BINARY_DIR}/python/copied)

install(TARGETS impetus_python LIBRARY DESTINATION lib/python3/dist-packages/impetus COMPONENT program)
install(FILES ${package_files} DESTINATION lib/python3/dist-packages/impetus COMPONENT program)
