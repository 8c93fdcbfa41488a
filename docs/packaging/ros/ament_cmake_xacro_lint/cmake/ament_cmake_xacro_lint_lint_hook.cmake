# run by ament_lint_auto for packages that hold descriptions
file(GLOB_RECURSE _descriptions FOLLOW_SYMLINKS "*.xacro" "*.urdf" "*.xacro.xml" "*.urdf.xml")
if(_descriptions)
  message(STATUS "Added test 'xacro_lint' to check robot descriptions")
  if(AMENT_LINT_AUTO_FILE_EXCLUDE)
    message(STATUS "Configured 'xacro_lint' exclude dirs and/or files: ${AMENT_LINT_AUTO_FILE_EXCLUDE}")
  endif()
  ament_xacro_lint(EXCLUDE ${AMENT_LINT_AUTO_FILE_EXCLUDE})
endif()
