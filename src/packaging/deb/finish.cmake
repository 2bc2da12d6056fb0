# SPDX-License-Identifier: MIT
# Run by CPack after it has written the packages, and before it copies those of its own list to the folder of the build.
execute_process(COMMAND ${CPACK_SHD_FINISH} ${CPACK_PACKAGE_FILES} COMMAND_ERROR_IS_FATAL ANY)
list(GET CPACK_PACKAGE_FILES 0 first)
get_filename_component(folder ${first} DIRECTORY)
if(NOT folder STREQUAL CPACK_PACKAGE_DIRECTORY)
  file(GLOB debug_packages ${folder}/*-dbgsym_*.deb)
  file(COPY ${debug_packages} DESTINATION ${CPACK_PACKAGE_DIRECTORY})
endif()
