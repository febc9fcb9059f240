# The libraries that a page needs are headers: they are linked into a folder of their own, for beside
# them in /usr/include lie the headers of this machine's C library, which a page must not see.
set(linked ${CMAKE_BINARY_DIR}/linked)
file(MAKE_DIRECTORY ${linked})
foreach(header nlohmann valijson xxhash.h)
  if(NOT EXISTS /usr/include/${header})
    message(FATAL_ERROR "expected /usr/include/${header}: nlohmann-json3-dev, libvalijson-dev and "
                        "libxxhash-dev bring what a page needs")
  endif()
  file(CREATE_LINK /usr/include/${header} ${linked}/${header} SYMBOLIC)
endforeach()
add_library(impetus_linked_headers INTERFACE)
target_include_directories(impetus_linked_headers SYSTEM INTERFACE ${linked})
add_library(nlohmann_json::nlohmann_json ALIAS impetus_linked_headers)
add_library(xxhash INTERFACE)  # whole in its header
target_link_libraries(xxhash INTERFACE impetus_linked_headers)
target_compile_definitions(xxhash INTERFACE XXH_INLINE_ALL XXH_NO_STREAM)
