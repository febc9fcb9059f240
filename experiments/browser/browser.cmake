# What runs in a page: the session with a page as its laboratory, linked so that it can wait.
impetus_room(drawing USES impetus_run)
file(GLOB page_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/browser/*.cpp)
add_executable(impetus_page ${page_sources})
target_link_libraries(impetus_page PRIVATE impetus_lines impetus_drawing)
target_compile_definitions(impetus_page PRIVATE
  "IMPETUS_PAGE_COMPILER=\"${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} of emscripten ${EMSCRIPTEN_VERSION}\"")
target_compile_options(impetus_page PRIVATE -Wno-gnu-zero-variadic-macro-arguments
  -Wno-dollar-in-identifier-extension)  # of emscripten's own macros
# Whatever may wait is rewritten, at a quarter of the page's size; what calls a pointer counts as if it
# might. What never does is named: the engine, and all that only reads and checks settings.
set(never_waits ${CMAKE_CURRENT_SOURCE_DIR}/browser/never_waits.json)
target_link_options(impetus_page PRIVATE -O3 -sASYNCIFY=1 -sASYNCIFY_REMOVE=@${never_waits}
  -sASYNCIFY_STACK_SIZE=65536 -sALLOW_MEMORY_GROWTH=1 -sMODULARIZE=1 -sEXPORT_NAME=createImpetus -sENVIRONMENT=web
  -sFORCE_FILESYSTEM=1 -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2
  -sEXPORTED_RUNTIME_METHODS=ccall,FS,allocateUTF8 -sEXPORTED_FUNCTIONS=_malloc,_free)
set_target_properties(impetus_page PROPERTIES OUTPUT_NAME impetus LINK_DEPENDS ${never_waits})
