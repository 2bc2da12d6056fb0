# SPDX-License-Identifier: MIT
# Run by CPack after it has written the packages.
execute_process(COMMAND ${CPACK_SHD_FINISH} ${CPACK_PACKAGE_FILES} COMMAND_ERROR_IS_FATAL ANY)
