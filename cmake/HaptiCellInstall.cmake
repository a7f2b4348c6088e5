# SPDX-License-Identifier: Apache-2.0
# install(EXPORT): another project can say find_package(HaptiCell) and link hapticell::engine or hapticell::collision.
include(CMakePackageConfigHelpers)

install(TARGETS hapticell_engine hapticell_interface EXPORT HaptiCellEngineTargets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT HaptiCellEngineTargets NAMESPACE hapticell:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/HaptiCell)
get_property(hapticell_libraries GLOBAL PROPERTY HAPTICELL_LIBRARIES)
install(TARGETS ${hapticell_libraries} EXPORT HaptiCellTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT HaptiCellTargets NAMESPACE hapticell:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/HaptiCell)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/HaptiCellConfig.cmake.in
  ${PROJECT_BINARY_DIR}/HaptiCellConfig.cmake INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/HaptiCell)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/HaptiCellConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/HaptiCellConfig.cmake ${PROJECT_BINARY_DIR}/HaptiCellConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/HaptiCell)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/config/ DESTINATION ${CMAKE_INSTALL_DATADIR}/hapticell
  PATTERN "*.h" EXCLUDE PATTERN "*.cpp" EXCLUDE PATTERN "CMakeLists.txt" EXCLUDE PATTERN "README.md" EXCLUDE)
