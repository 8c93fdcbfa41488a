find_package(ament_cmake_test QUIET REQUIRED)

include("${ament_cmake_xacro_lint_DIR}/ament_xacro_lint.cmake")

ament_register_extension("ament_lint_auto" "ament_cmake_xacro_lint" "ament_cmake_xacro_lint_lint_hook.cmake")
