# SPDX-License-Identifier: MIT
# Puts a report of shd-shootout beside the pages, as shootout.html. The target docs runs this script:
#   cmake -DREPORT=... -DDEFAULT_REPORT=... -DPROGRAM=... -DSCRATCH=... -DTO=... -P add_shootout.cmake
# REPORT is the choice of the user, DEFAULT_REPORT that of examples/shootout.sh. Without either, PROGRAM makes a quick one.
if(REPORT)
  if(NOT EXISTS ${REPORT})
    message(FATAL_ERROR "SHD_SHOOTOUT_REPORT: ${REPORT} is missing")
  endif()
  set(found ${REPORT})
elseif(EXISTS ${DEFAULT_REPORT})
  set(found ${DEFAULT_REPORT})
elseif(EXISTS ${PROGRAM})
  execute_process(COMMAND ${PROGRAM} --quick -o ${SCRATCH} RESULT_VARIABLE status OUTPUT_QUIET)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${PROGRAM} --quick failed: ${status}")
  endif()
  set(found ${SCRATCH}/shootout.html)
else()
  message(STATUS "No report of the filter shoot-out: examples/shootout.sh makes one, then build docs again")
  return()
endif()
file(MAKE_DIRECTORY ${TO})
configure_file(${found} ${TO}/shootout.html COPYONLY)
message(STATUS "Filter shoot-out: ${found}")
