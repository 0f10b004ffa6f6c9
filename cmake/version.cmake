# Run at each build: cmake -DSOURCE=… -DVERSION=… -DTARGET=… -P version.cmake.
# Writes TARGET only when it changes.
execute_process(COMMAND git --no-optional-locks -C ${SOURCE} describe --always --abbrev=12 --match= --dirty=+
                OUTPUT_VARIABLE COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT COMMIT)
  set(COMMIT unknown)
endif()
configure_file(${SOURCE}/engine/scene/version.cpp.in ${TARGET} @ONLY)
