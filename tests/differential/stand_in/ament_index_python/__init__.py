"""Stand-in for ROS 2's package index: just what `$(find)` of xacro asks for."""
