"""Publish the robot and start its controllers."""
from launch import LaunchDescription
from launch.substitutions import Command, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    model = PathJoinSubstitution([FindPackageShare('pick_arm_description'), 'urdf', 'pick_arm.urdf.xacro'])
    robot = {'robot_description': ParameterValue(Command(['xacro ', model]), value_type=str)}
    controllers = PathJoinSubstitution([FindPackageShare('pick_arm_bringup'), 'config', 'controllers.yaml'])
    return LaunchDescription([
        Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[robot]),
        Node(package='controller_manager', executable='ros2_control_node', parameters=[robot, controllers]),
        Node(package='controller_manager', executable='spawner',
             arguments=['joint_state_broadcaster', 'arm_controller', 'gripper_controller']),
    ])
