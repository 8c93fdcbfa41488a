from launch import LaunchDescription
from launch.substitutions import Command, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    description = Command(['xacro ', PathJoinSubstitution([FindPackageShare('swing_cell'), 'urdf', 'cell.urdf.xacro'])])
    parameters = [{'robot_description': description}]
    return LaunchDescription([
        Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=parameters),
    ])
