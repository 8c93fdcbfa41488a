"""Publish the cell; `stylus:=0.08` fits the long stylus."""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    model = PathJoinSubstitution([FindPackageShare('measuring_cell'), 'urdf', 'measuring_cell.xacro'])
    text = Command(['xacro ', model, ' stylus:=', LaunchConfiguration('stylus')])
    return LaunchDescription([
        DeclareLaunchArgument('stylus', default_value='0.05'),
        Node(package='robot_state_publisher', executable='robot_state_publisher',
             parameters=[{'robot_description': ParameterValue(text, value_type=str)}]),
    ])
