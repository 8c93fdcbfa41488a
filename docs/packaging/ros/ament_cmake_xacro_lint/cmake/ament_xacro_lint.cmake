# Add a test that checks the robot descriptions of the package.
#
# ament_xacro_lint([PATH...] [TESTNAME name] [EXCLUDE pattern...] [ARGS option...])
#
# PATH     files and folders; default: the source folder
# TESTNAME default: xacro_lint
# EXCLUDE  files and folders of which nothing is reported
# ARGS     options of `xacro-lint check`, such as --fail-level error
function(ament_xacro_lint)
  cmake_parse_arguments(ARG "" "TESTNAME" "EXCLUDE;ARGS" ${ARGN})
  if(NOT ARG_TESTNAME)
    set(ARG_TESTNAME "xacro_lint")
  endif()

  find_program(ament_xacro_lint_BIN NAMES "ament_xacro_lint")
  if(NOT ament_xacro_lint_BIN)
    message(FATAL_ERROR "the program `ament_xacro_lint` is missing: build the package ament_xacro_lint")
  endif()

  set(result_file "${AMENT_TEST_RESULTS_DIR}/${PROJECT_NAME}/${ARG_TESTNAME}.xunit.xml")
  set(command "${ament_xacro_lint_BIN}" "--xunit-file" "${result_file}" "--testname" "${PROJECT_NAME}.${ARG_TESTNAME}")
  list(APPEND command ${ARG_UNPARSED_ARGUMENTS})
  if(ARG_EXCLUDE)
    list(APPEND command "--exclude" ${ARG_EXCLUDE})
  endif()
  if(ARG_ARGS)
    # everything after it belongs to xacro-lint
    list(APPEND command "--args" ${ARG_ARGS})
  endif()

  file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/ament_xacro_lint")
  ament_add_test(
    "${ARG_TESTNAME}"
    COMMAND ${command}
    OUTPUT_FILE "${CMAKE_BINARY_DIR}/ament_xacro_lint/${ARG_TESTNAME}.txt"
    RESULT_FILE "${result_file}"
    WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
  set_tests_properties("${ARG_TESTNAME}" PROPERTIES LABELS "xacro_lint;linter")
endfunction()
