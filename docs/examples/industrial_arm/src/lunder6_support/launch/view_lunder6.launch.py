"""Show the arm with sliders for its joints."""
from launch import LaunchDescription
from launch.substitutions import Command, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    model = PathJoinSubstitution([FindPackageShare('lunder6_support'), 'urdf', 'lunder6.xacro'])
    description = {'robot_description': ParameterValue(Command(['xacro ', model]), value_type=str)}
    return LaunchDescription([
        Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[description]),
        Node(package='joint_state_publisher_gui', executable='joint_state_publisher_gui'),
    ])
