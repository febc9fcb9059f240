# Tells CTest of every suite in a program of tests, after each of its builds: one process a suite, because
# starting two thousand takes minutes, and tests of a suite share what takes seconds to make.
#
# Usage: cmake -DPROGRAM=… -DFOLDER=… -DOUT=… -DPROPERTIES=… -P list_suites.cmake
# SPDX-License-Identifier: MIT
execute_process(COMMAND ${PROGRAM} --gtest_list_tests WORKING_DIRECTORY ${FOLDER}
  OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\n[A-Za-z0-9_/]+\\. *[#\n]" suites "${listed}")
if(NOT suites)
  message(FATAL_ERROR "${PROGRAM}: expected suites of tests, got none")
endif()
set(told "")
foreach(suite ${suites})
  string(REGEX MATCH "[A-Za-z0-9_/]+" suite "${suite}")
  string(APPEND told "add_test([[${suite}]] [[${PROGRAM}]] [[--gtest_filter=${suite}.*]])\n"
    "set_tests_properties([[${suite}]] PROPERTIES WORKING_DIRECTORY [[${FOLDER}]] ${PROPERTIES})\n")
endforeach()
file(WRITE ${OUT} "${told}")
