# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DSOURCE=... -DHEADER=... -P commit.cmake: writes the header that names the commit of the sources, with a `+`
# where they differ from it, and nothing where git or a commit is missing. Touched only where that has changed.
execute_process(COMMAND git -C ${SOURCE} rev-parse --verify --quiet HEAD
                OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
execute_process(COMMAND git -C ${SOURCE} status --porcelain OUTPUT_VARIABLE changes ERROR_QUIET)
if(commit AND changes)
  string(APPEND commit "+")
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "#define TOUCHSTONE_COMMIT \"${commit}\"\n" @ONLY)
