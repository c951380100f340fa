# SPDX-License-Identifier: BSD-3-Clause
# Writes the manual page, which is what the program tells by --help.
#   cmake -D OCTET=<program> -D VERSION=<version> -D PAGE=<file> -P ManPage.cmake
function(help_of text)
  execute_process(COMMAND ${OCTET} ${ARGN} --help RESULT_VARIABLE result OUTPUT_VARIABLE told)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${OCTET} ${ARGN} --help: ${result}")
  endif()
  set(${text} "${told}" PARENT_SCOPE)
endfunction()
# A section of lines as they are. No line may begin with what roff takes for a request.
function(section title text)
  string(REPLACE "\\" "\\e" text "${text}")
  string(REPLACE "-" "\\-" text "${text}")
  string(REGEX REPLACE "(^|\n)([.'])" "\\1\\\\&\\2" text "${text}")
  file(APPEND ${PAGE} ".SH ${title}\n.nf\n${text}.fi\n")
endfunction()

help_of(whole)
string(REGEX REPLACE "^Octet: ([^\n]*).*" "\\1" first "${whole}")
file(WRITE ${PAGE} ".TH OCTET 1 \"\" \"octet ${VERSION}\"\n.SH NAME\noctet \\- ${first}\n")
section(USE "${whole}")
string(REGEX MATCH "\nSubcommands:\n(  [^\n]*\n)*" commands "${whole}")
string(REGEX MATCHALL "\n  [a-z]+" commands "${commands}")
foreach(command IN LISTS commands)
  string(STRIP "${command}" command)
  help_of(text ${command})
  # Without what the first section ends with.
  string(REGEX REPLACE "\nLengths on the command line.*" "" text "${text}")
  string(TOUPPER ${command} title)
  section("OCTET ${title}" "${text}")
endforeach()
