# Made anew in every build, so a recording always names the commit it was made with; alone, so that a
# new commit compiles one file.
set_source_files_properties(provenance/build_name.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
set(build_info ${CMAKE_BINARY_DIR}/embedded/build_info/build_info.hpp)
add_custom_target(impetus_build_info
  COMMAND ${CMAKE_COMMAND} -DOUTPUT=${build_info} -DSOURCE=${CMAKE_SOURCE_DIR}
          -DVERSION=${PROJECT_VERSION}
          "-DCOMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
          "-DFLAGS=${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}} $<JOIN:$<TARGET_PROPERTY:impetus_flags,INTERFACE_COMPILE_OPTIONS>, >"
          -P ${CMAKE_CURRENT_LIST_DIR}/build_info.cmake
  BYPRODUCTS ${build_info})
add_dependencies(impetus_provenance impetus_build_info)
target_include_directories(impetus_provenance PRIVATE ${CMAKE_BINARY_DIR}/embedded/build_info)
