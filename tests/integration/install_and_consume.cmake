# cmake -DBUILD_DIR= -DCONSUMER_DIR= -DWORK_DIR= -DGENERATOR= -DCOMPILER= -DSANITIZE= -DEXPECTED= -P install_and_consume.cmake
# Installs BUILD_DIR into a fresh prefix, builds CONSUMER_DIR against it, runs it and matches what it prints.
file(REMOVE_RECURSE ${WORK_DIR})
list(JOIN SANITIZE " " flags)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    string(REGEX REPLACE "-- Installing:[^\n]*\n" "" output "${output}")
    message(FATAL_ERROR "${ARGN}\nfailed (${result}):\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/prefix)
run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${CONSUMER_DIR} -B ${WORK_DIR}/build -DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix
    -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=${flags}")
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build)
run(${WORK_DIR}/build/consumer)
if(NOT output MATCHES "${EXPECTED}")
  message(FATAL_ERROR "the consumer printed '${output}', expected what matches '${EXPECTED}'")
endif()
