# The Debian package: `cmake --build build --target package`, then `apt install ./build/impetus_*.deb`.
#
#   bin/impetus
#   share/impetus/   protocols, stimuli, experiments/observers and languages, analysis: as in a clone
#   lib/python3/dist-packages/impetus/   of a build with IMPETUS_PYTHON
#   share/doc/impetus/
#
# Only the component `program`: the engine as a library is installed by `cmake --install`.
include(GNUInstallDirs)
set(data ${CMAKE_INSTALL_DATADIR}/impetus)
install(TARGETS impetus RUNTIME COMPONENT program)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/protocols ${CMAKE_SOURCE_DIR}/stimuli
  DESTINATION ${data} COMPONENT program)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/experiments/observers ${CMAKE_SOURCE_DIR}/experiments/languages
  DESTINATION ${data}/experiments COMPONENT program FILES_MATCHING PATTERN "*.json")
install(DIRECTORY ${CMAKE_SOURCE_DIR}/analysis DESTINATION ${data} COMPONENT program
  PATTERN pictures EXCLUDE)
install(FILES ${CMAKE_SOURCE_DIR}/README.md ${CMAKE_SOURCE_DIR}/CHANGELOG.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright
  COMPONENT program)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME impetus)
set(CPACK_PACKAGE_CONTACT "The founders of Impetus <impetus@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY
  "Experiments on how believable an approximated collision looks")
set(CPACK_PACKAGE_DESCRIPTION "Shows physically simulated collisions under exact control, records \
what the participant did and what the screen showed, replays any recorded trial bit for bit, and \
turns a study file into statistics and figures.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_CMAKE_PROJECTS "${CMAKE_BINARY_DIR};impetus;program;/")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "fonts-dejavu-core")
# Chinese, Japanese and Korean letters; films, but for folders of pictures; eye trackers of Pupil Labs.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "fonts-noto-cjk | fonts-wqy-microhei, ffmpeg, libzmq5")
# Studies run without R; reports and figures need it.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "r-base-core, r-cran-rsqlite, r-cran-ordinal, r-cran-lme4, \
r-cran-afex, r-cran-emmeans, r-cran-ggplot2, r-cran-glmmtmb, r-cran-commonmark, \
r-cran-mcmc, r-cran-coda")
if(IMPETUS_PYTHON)
  string(APPEND CPACK_DEBIAN_PACKAGE_RECOMMENDS ", python3-pandas")
endif()
include(CPack)
