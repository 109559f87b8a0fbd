# SPDX-License-Identifier: GPL-3.0-or-later
# At installation: the program writes its manual pages and completion scripts. `touchstone_program`: the program;
# `touchstone_emulator`: what runs it, if it is of another architecture; `folder`: where to install; `man`, `data`: the
# folders below for manuals and data. A program that was not built has none. A variable named `program` would hide the
# component of that name from CMake's generated scripts.
if(NOT EXISTS ${touchstone_program})
  message(STATUS "No manual pages and completion: ${touchstone_program} is not built")
  return()
endif()
function(run file)
  get_filename_component(parent ${folder}/${file} DIRECTORY)
  file(MAKE_DIRECTORY ${parent})
  execute_process(COMMAND ${touchstone_emulator} ${touchstone_program} ${ARGN} OUTPUT_FILE ${folder}/${file} COMMAND_ERROR_IS_FATAL ANY)
  message(STATUS "Installing: ${folder}/${file}")
endfunction()
execute_process(COMMAND ${touchstone_emulator} ${touchstone_program} manual --force --output ${folder}/${man}/man1 OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
message(STATUS "Installing: ${folder}/${man}/man1/touchstone*.1")
run(${data}/bash-completion/completions/touchstone completion bash)
run(${data}/zsh/site-functions/_touchstone completion zsh)
