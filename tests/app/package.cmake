# SPDX-License-Identifier: BSD-3-Clause
# Makes the Debian packages, unpacks them, and runs what they hold: the program, and the Python package by the
# link to it.
#   cmake -D BUILD=<build tree> -D MODELS=<sample parts> -D PYTHON=<with numpy, or nothing> -P package.cmake
set(work ${BUILD}/package_test)
file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${work})
function(step)
  execute_process(COMMAND ${ARGV} WORKING_DIRECTORY ${work} RESULT_VARIABLE result OUTPUT_VARIABLE output
                  ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGV}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()
function(expect text)
  if(NOT output MATCHES "${text}")
    message(FATAL_ERROR "no '${text}' in:\n${output}")
  endif()
endfunction()

step(cpack --config ${BUILD}/CPackConfig.cmake -B ${work}/made)
file(GLOB program ${work}/made/octet_*.deb)
file(GLOB library ${work}/made/liboctet-dev_*.deb)
step(dpkg-deb -x ${program} ${work}/root)
step(dpkg-deb -x ${library} ${work}/root)
# Every shared library that the program asks for is named by a package.
step(dpkg-deb -f ${program} Depends)
expect("libocct-data-exchange-.*libtbb12")
step(dpkg-deb -f ${library} Depends)
expect("octet \\(= ")
foreach(file bin/octet libexec/octet/octet-reader lib/liboctet_app.a lib/cmake/octet/octetConfig.cmake
             include/octet/app/mesh_part.h lib/python3/dist-packages/octet/__init__.py
             share/freecad/Mod/Octet/Init.py share/doc/octet/LICENSE share/man/man1/octet.1
             share/bash-completion/completions/octet lib/liboctet.so.0 lib/liboctet.so include/octet.h
             lib/pkgconfig/octet.pc)
  if(NOT EXISTS ${work}/root/usr/${file})
    message(FATAL_ERROR "the packages lack /usr/${file}")
  endif()
endforeach()
file(STRINGS ${work}/root/usr/share/man/man1/octet.1 output)
expect("octet .- CAD part in.*OCTET MESH.*.-.-target.-elements N")
file(WRITE ${work}/complete.sh ". ${work}/root/usr/share/bash-completion/completions/octet\n"
                               "COMP_WORDS=(${work}/root/usr/bin/octet mesh --tar) COMP_CWORD=2; _octet\n"
                               "echo \"\${COMPREPLY[@]}\"\n"
                               "COMP_WORDS=(${work}/root/usr/bin/octet i) COMP_CWORD=1; _octet\n"
                               "echo \"\${COMPREPLY[@]}\"\n")
step(bash complete.sh)
expect("^--target-elements\ninfo improve\n$")
step(${work}/root/usr/bin/octet mesh ${MODELS}/bracket.step -o bracket.msh --size 8)
expect("status   complete")
if(PYTHON)
  file(WRITE ${work}/try.py "import octet\nfrom octet.program import find_program\nprint(find_program())\n"
                            "print(octet.mesh('${MODELS}/bracket.step', size=8).report['status'])\n")
  set(packages ${work}/root/usr/lib/python3/dist-packages)
  step(${CMAKE_COMMAND} -E env --unset=OCTET PYTHONPATH=${packages} ${PYTHON} try.py)
  expect("${work}/root/usr/bin/octet\ncomplete")
endif()
