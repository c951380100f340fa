# SPDX-License-Identifier: BSD-3-Clause
# Installs the build, then configures, builds and runs tests/app/consumer against the installed tree alone.
#   cmake -D BUILD=<build tree> -D SOURCE=<consumer> -D COMPILER=<c++> -P consumer.cmake
set(work ${BUILD}/consumer)
file(REMOVE_RECURSE ${work}/installed ${work}/build)
include(${CMAKE_CURRENT_LIST_DIR}/step.cmake)
step(${CMAKE_COMMAND} --install ${BUILD} --prefix ${work}/installed)
step(${CMAKE_COMMAND} -S ${SOURCE} -B ${work}/build -G Ninja -D CMAKE_BUILD_TYPE=Release
     -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_PREFIX_PATH=${work}/installed)
step(${CMAKE_COMMAND} --build ${work}/build)
step(${work}/build/consumer)
message(STATUS "${output}")
step(${work}/installed/bin/octet --version)
if(C_API)
  step(${work}/build/in_c ${SOURCE}/../../../models/box.step)
endif()
