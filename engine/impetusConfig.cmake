# For find_package(impetus): the engine as impetus::engine.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.4 NO_MODULE)
include(${CMAKE_CURRENT_LIST_DIR}/impetus_engine_targets.cmake)
